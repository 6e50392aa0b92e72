"""Tests contact.subsurface: stresses inside the bodies of a solution."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import (
    Client,
    ContactProblem,
    Estimate,
    FemIcs,
    Friction,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    RigidBody,
    SemiAxes,
    StressBlock,
    TimeoutExpired,
)
from support.daemons import eventually

#: Hertz's contact on a circle of radius 1, nu = 0.3.
HERTZ = ContactProblem(Grid.centred(121, 121, 2.4, 2.4), Material(82000, 0.3), SemiAxes(1, 1), Fn=1000)
P0 = 1.5 * 1000 / np.pi
#: The same in 21 x 21 elements, with friction.
SHIFTED = HERTZ.replace(grid=Grid.centred(21, 21, 2.4, 2.4), friction=Friction(0.3, (1e-3, 2e-4)))
COMPONENTS = ["xx", "yy", "zz", "xy", "xz", "yz", "von_mises"]
PARAMS = {
    "grid": {"nx": 2, "ny": 1, "dx": 1, "dy": 1},
    "nu": 0.3,
    "pressure": [[1, 2]],
    "traction_x": [[0.1, 0]],
    "block": {"x": [0], "y": [0], "z": [0, -1]},
}
#: The maximum number of points in a message, without a raster, which take hours.
ENDLESS = StressBlock(np.sqrt(np.arange(1, 1001)), np.sqrt(np.arange(1, 1001)), [-1, -2])


@pytest.fixture(scope="module")
def hertz(shared_daemon):
    with shared_daemon.client() as client:
        return client.solve(HERTZ)


@pytest.fixture(scope="module")
def shifted(shared_daemon):
    with shared_daemon.client() as client:
        return client.solve(SHIFTED)


def test_stresses_on_the_axis_agree_with_hertz(shared, hertz):
    depth = np.arange(0, 3, 0.01)
    stress = shared.subsurface(HERTZ, hertz, block=StressBlock(0, 0, -depth))
    zz = stress.zz[:, 0, 0] / P0
    assert stress.zz.shape == (300, 1, 1)
    np.testing.assert_allclose(zz, -1 / (1 + depth**2), atol=2e-3)
    assert stress.largest.von_mises == pytest.approx(0.62 * P0, rel=5e-3)
    assert stress.largest.depth == pytest.approx(0.48, abs=0.021)
    assert (stress.largest.x, stress.largest.y, stress.largest.z) == (0, 0, -stress.largest.depth)
    shear = np.abs(stress.zz - stress.xx).max() / 2
    assert shear == pytest.approx(0.31 * P0, rel=5e-3)


def test_the_largest_stress_is_the_largest_of_the_array(shared, shifted):
    block = StressBlock(SHIFTED.grid.x, SHIFTED.grid.y, [-0.1, -0.5, -1])
    stress = shared.subsurface(SHIFTED, shifted, block=block)
    place = np.unravel_index(stress.von_mises.argmax(), stress.von_mises.shape)
    assert stress.largest.von_mises == stress.von_mises[place]
    assert (stress.largest.z, stress.largest.y, stress.largest.x) == tuple(
        axis[n] for axis, n in zip([block.z, block.y, block.x], place, strict=True)
    )


@pytest.mark.parametrize(("body", "sign"), [("lower", -1), ("upper", 1)])
def test_at_the_surface_the_stresses_are_the_tractions_on_the_body(shared, shifted, body, sign):
    surface = StressBlock(SHIFTED.grid.x, SHIFTED.grid.y, 0)
    stress = shared.subsurface(SHIFTED, shifted, body=body, block=surface)
    tolerance = 1e-9 * shifted.pmax
    np.testing.assert_allclose(stress.zz[0], -shifted.pressure, atol=tolerance)
    np.testing.assert_allclose(stress.xz[0], sign * shifted.traction_x, atol=tolerance)
    np.testing.assert_allclose(stress.yz[0], sign * shifted.traction_y, atol=tolerance)
    assert np.abs(shifted.traction_x).max() > 0.1 * shifted.pmax


@pytest.mark.parametrize("body", ["lower", "upper"])
def test_a_block_holds_the_stresses_of_its_points(shared, shifted, body):
    block = StressBlock([*SHIFTED.grid.x[3:9], 0.05], SHIFTED.grid.y[::-3], [-0.3, 0, -2.5])
    z, y, x = np.meshgrid(block.z, block.y, block.x, indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    of_block = shared.subsurface(SHIFTED, shifted, body=body, block=block)
    of_points = shared.subsurface(SHIFTED, shifted, body=body, points=points)
    for name in COMPONENTS:
        expected = getattr(of_points, name)
        assert expected.shape == (len(points),)
        np.testing.assert_allclose(getattr(of_block, name).ravel(), expected, atol=1e-10 * shifted.pmax)
    assert of_block.largest.von_mises == pytest.approx(of_points.largest.von_mises)
    for name in ("x", "y", "z", "depth"):
        assert getattr(of_block.largest, name) == getattr(of_points.largest, name)


def test_frames_and_lists_give_the_same(raw):
    listed = raw.ask("contact.subsurface", PARAMS, arrays="list").result
    pressure, axis = np.array([1.0, 2.0]).tobytes(), np.array([0.0, -1.0]).tobytes()
    params = {
        **PARAMS,
        "pressure": {"$array": {"frame": 1, "dtype": "<f8", "shape": [1, 2]}},
        "block": {"x": [0], "y": [0], "z": {"$array": {"frame": 2, "dtype": "<f8", "shape": [2]}}},
    }
    framed = raw.ask("contact.subsurface", params, pressure, axis)
    assert framed.array("von_mises").tolist() == listed["von_mises"]
    assert (listed["shape"], np.shape(listed["stress"]["xz"])) == ([2, 1, 1], (2, 1, 1))
    assert framed.result["largest"] == listed["largest"]


def test_stresses_are_bitwise_the_same_again(shared, shifted):
    block = StressBlock(SHIFTED.grid.x, SHIFTED.grid.y + 0.01, [-0.2, -0.4])
    first, again = (shared.subsurface(SHIFTED, shifted, block=block) for _ in range(2))
    for name in COMPONENTS:
        np.testing.assert_array_equal(getattr(first, name), getattr(again, name))


def test_without_contact_there_is_no_stress(shared):
    apart = SHIFTED.replace(gap=Paraboloid(50, 50), Fn=0)
    stress = shared.subsurface(apart, shared.solve(apart), points=[[0, 0, 0], [1, 1, -1]])
    assert stress.von_mises.tolist() == [0, 0]
    assert (stress.largest.von_mises, stress.largest.depth) == (0, 0)


def test_beside_a_rigid_body_the_elastic_one_has_stresses(shared, shifted):
    problem = SHIFTED.replace(upper=RigidBody(), lower=SHIFTED.upper)
    with pytest.raises(InvalidArgument, match="rigid"):
        shared.subsurface(problem, shifted, body="upper", points=[[0, 0, -1]])
    beside = shared.subsurface(problem, shifted, points=[[0, 0, -1]])
    assert beside.zz[0] == shared.subsurface(SHIFTED, shifted, points=[[0, 0, -1]]).zz[0] < 0


def test_inside_a_block_there_is_no_closed_form(shared, shifted):
    problem = SHIFTED.replace(ics=FemIcs(body="block", L_over_h=40))
    with pytest.raises(InvalidArgument, match="ics.body is block, .* half-space"):
        shared.subsurface(problem, shifted, points=[[0, 0, -1]])
    of_fem = shared.subsurface(SHIFTED.replace(ics=FemIcs()), shifted, points=[[0, 0, -1]])
    assert of_fem.zz[0] == shared.subsurface(SHIFTED, shifted, points=[[0, 0, -1]]).zz[0]


def test_stresses_are_a_job_that_reports_and_can_be_cancelled(client, background):
    seen = []

    def cancel(progress):
        seen.append(progress)
        (job,) = client.jobs()
        assert (job.kind, job.state, job.job) == ("subsurface", "running", progress.job)
        client.cancel_job(job.job)

    loaded = Estimate(np.random.default_rng(1).random(HERTZ.grid.shape))
    asked = background(client.subsurface, HERTZ, loaded, block=ENDLESS, on_progress=cancel)
    assert type(asked.exception()).__name__ == "Cancelled"
    assert seen[0].stage == "subsurface"
    assert 0 <= seen[0].fraction < 1
    eventually(lambda: client.jobs() == (), "the work goes on", seconds=5)
    eventually(lambda: client.info().queue["solves_running"] == 0, "the worker does not come back", seconds=5)


def test_stresses_end_at_the_timeout_of_their_caller(client):
    loaded = Estimate(np.random.default_rng(1).random(HERTZ.grid.shape))
    with pytest.raises(TimeoutExpired):
        client.subsurface(HERTZ, loaded, block=ENDLESS, timeout=0.5)
    assert client.health() == "serving"
    eventually(lambda: client.info().queue["solves_running"] == 0, "the work goes on", seconds=5)


def test_a_daemon_that_ends_does_not_wait_for_stresses(daemon, background):
    loaded = Estimate(np.random.default_rng(1).random(HERTZ.grid.shape))
    with Client(daemon.endpoint) as client:
        asked = background(client.subsurface, HERTZ, loaded, block=ENDLESS)
        eventually(client.jobs)
        assert daemon.stop() == 0
        assert asked.exception() is not None


def test_the_number_of_points_is_limited(daemons):
    with daemons.start(limits={"max_array_elements": 70}).client() as client:
        flat = ContactProblem(Grid(2, 1, 1, 1), Material(1, 0.3), SemiAxes(1, 1), Fn=1)
        loaded = Estimate(np.ones((1, 2)))
        assert client.subsurface(flat, loaded, block=StressBlock(range(5), [0, 1], -1)).zz.shape == (1, 2, 5)
        with pytest.raises(InvalidArgument, match=r"block has 11 points; at most 10 .*max_array_elements") as caught:
            client.subsurface(flat, loaded, block=StressBlock(range(11), 0, -1))
        assert caught.value.reason == "LIMIT_EXCEEDED"
        with pytest.raises(InvalidArgument, match="points has 11 points; at most 10"):
            client.subsurface(flat, loaded, points=-np.ones((11, 3)))


def test_few_points_far_apart_take_no_memory(daemon, client):
    loaded = Estimate(np.random.default_rng(1).random((150, 150)))
    problem = HERTZ.replace(grid=Grid(150, 150, 1, 1))
    before = peak_memory(daemon)
    stress = client.subsurface(problem, loaded, block=StressBlock([0, 12_000], np.arange(150), -1))
    assert stress.zz.shape == (1, 150, 2)
    assert peak_memory(daemon) - before < 80e6


def peak_memory(daemon):
    """Bytes."""
    with open(f"/proc/{daemon.process.pid}/status") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmHWM"))


@pytest.mark.parametrize(
    ("changes", "reason", "field"),
    [
        ({"nu": 0.6}, "FIELD_INVALID", "nu"),
        ({"nu": None}, "FIELD_INVALID", "nu"),
        ({"body": "both"}, "FIELD_INVALID", "body"),
        ({"points": [[0, 0, -1]]}, "FIELD_INVALID", "block"),
        ({"pressure": [[1]]}, "ARRAY_INVALID", "pressure"),
        ({"pressure": [[1, 1e300]]}, "ARRAY_INVALID", "pressure"),
        ({"traction_y": {"$array": {"frame": 1, "dtype": "<f8", "shape": [1, 2]}}}, "ARRAY_INVALID", "traction_y"),
        ({"grid": {"nx": 4000000, "ny": 4000000, "dx": 1, "dy": 1}}, "LIMIT_EXCEEDED", "grid.nx"),
        ({"grid": {"nx": 2, "ny": 1, "dx": 1, "dy": 0}}, "FIELD_INVALID", "grid.dy"),
        ({"block": {"x": [0], "y": [0], "z": [1]}}, "FIELD_INVALID", "block.z"),
        ({"block": {"x": [], "y": [0], "z": [0]}}, "FIELD_INVALID", "block.x"),
        ({"block": {"x": [1e300], "y": [0], "z": [0]}}, "FIELD_INVALID", "block.x"),
        ({"block": {"x": [0], "z": [0]}}, "FIELD_INVALID", "block.y"),
        ({"block": {"x": "everywhere", "y": [0], "z": [0]}}, "FIELD_INVALID", "block.x"),
    ],
)
def test_nonsense_is_refused_by_name(raw, changes, reason, field):
    answer = raw.ask("contact.subsurface", {**PARAMS, **changes})
    assert (answer.status, answer.reason, answer.fields) == ("INVALID_ARGUMENT", reason, [field])


@pytest.mark.parametrize(
    ("points", "reason"),
    [
        ([], "ARRAY_INVALID"),
        ([[0, 0]], "ARRAY_INVALID"),
        ([[0, 0, 1]], "FIELD_INVALID"),
        ([[0, 0, -1e300]], "FIELD_INVALID"),
        ([[0, 0, None]], "ARRAY_INVALID"),
        ({"$array": {"frame": 1, "dtype": "<f8", "shape": [4000000, 3]}}, "LIMIT_EXCEEDED"),
        ({"$array": {"frame": 1, "dtype": "<f8", "shape": [0, 3]}}, "ARRAY_INVALID"),
    ],
)
def test_points_outside_of_the_body_are_refused(raw, points, reason):
    params = {name: value for name, value in PARAMS.items() if name != "block"}
    answer = raw.ask("contact.subsurface", {**params, "points": points})
    assert (answer.status, answer.reason, answer.fields) == ("INVALID_ARGUMENT", reason, ["points"])


def test_an_array_that_is_not_finite_is_not_sent(shared, shifted):
    with pytest.raises(InvalidArgument, match=r"block\.z"):
        shared.subsurface(SHIFTED, shifted, block=StressBlock(0, 0, [-1, np.nan]))


@pytest.mark.parametrize("size", [1e-12, 1e-3, 1e12])
@pytest.mark.parametrize("at", [0, 1e-300, 1, 1e12, 1e50])
def test_sizes_of_any_order_give_finite_stresses(raw, size, at):
    grid = {"nx": 2, "ny": 1, "dx": size, "dy": 1 / size}
    params = {**PARAMS, "grid": grid, "block": {"x": [0, at], "y": [0, -at], "z": [0, -at]}}
    answer = raw.ask("contact.subsurface", params, arrays="list")
    assert answer.status == "OK", answer.message


def test_invariants_are_those_of_the_components(shared, shifted):
    at = {"points": [[0, 0, -0.5], [0.3, -0.2, -0.1]]}
    plain = shared.subsurface(SHIFTED, shifted, **at)
    assert plain.tresca is None
    stress = shared.subsurface(SHIFTED, shifted, invariants=True, **at)
    tensors = np.array([[stress.xx, stress.xy, stress.xz], [stress.xy, stress.yy, stress.yz], [stress.xz, stress.yz, stress.zz]])
    principal = np.linalg.eigvalsh(np.moveaxis(tensors, 2, 0))
    for name, values in (("principal_3", principal[:, 0]), ("principal_2", principal[:, 1]), ("principal_1", principal[:, 2])):
        np.testing.assert_allclose(getattr(stress, name), values, atol=1e-10)
    np.testing.assert_allclose(stress.tresca, principal[:, 2] - principal[:, 0], atol=1e-10)
    np.testing.assert_allclose(stress.hydrostatic, principal.mean(1), atol=1e-10)


def test_the_surface_displaces_by_what_the_solution_says(shared):
    problem = SHIFTED.replace(displacements=True)
    solution = shared.solve(problem)
    block = StressBlock(problem.grid.x, problem.grid.y, 0)
    lower = shared.subsurface(problem, solution, block=block, displacements=True)
    upper = shared.subsurface(problem, solution, body="upper", block=block, displacements=True)
    scale = np.abs(solution.displacement_z).max()
    # Both bodies are displaced inwards, each along -z of its own frame.
    np.testing.assert_allclose(-(lower.displacement_z + upper.displacement_z)[0], solution.displacement_z, atol=1e-9 * scale)
    np.testing.assert_allclose((upper.displacement_x - lower.displacement_x)[0], solution.displacement_x, atol=1e-9 * scale)
    np.testing.assert_allclose((upper.displacement_y - lower.displacement_y)[0], solution.displacement_y, atol=1e-9 * scale)


def test_displacements_are_those_of_half_spaces(shared, shifted):
    with pytest.raises(InvalidArgument, match="not a half-space"):
        shared.subsurface(SHIFTED.replace(lower=RigidBody()), shifted, nu=0.3, points=[[0, 0, -1]], displacements=True)
