"""Tests layered bodies through a daemon: tables, solves, sessions, and refusals."""

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    Client,
    ContactProblem,
    Friction,
    Grid,
    InvalidArgument,
    Layer,
    LayeredBody,
    LineContact,
    Material,
    Paraboloid,
    RigidBody,
    Rolling,
    SemiAxes,
    StressBlock,
    load_table,
    save_table,
)

STEEL = Material(G=82000, nu=0.28)
RUBBER = LayeredBody([Layer(thickness=2, G=1, nu=0.5)], base=RigidBody())
STEEL_IN_LAYERS = LayeredBody([Layer(0.2, STEEL.G, STEEL.nu), Layer(1, STEEL.G, STEEL.nu)], base=STEEL)
SLAB = {"slab": {"thickness": 100, "width": 100}}
GRID = Grid.centred(20, 20, 3, 3)
BALL = {"grid": GRID, "gap": Paraboloid(50, 50)}
ROLLING = Friction(0.3, rolling=Rolling(xi=1e-3, phi=1e-4))


def test_a_table_states_its_error_and_is_kept_in_memory(shared):
    table = shared.get_ic(STEEL_IN_LAYERS, GRID, AnalyticIcs(load_shape="bilinear"))
    exact = shared.get_ic(STEEL, GRID, AnalyticIcs(load_shape="bilinear"))
    assert table.array == pytest.approx(exact.array, abs=1e-9 * exact["zz"][0, 0])
    assert table.evidence.errors_estimated
    assert 0 < table.evidence.errors.zz.largest < 1e-8
    assert table.spec.material == STEEL_IN_LAYERS
    again = shared.get_ic(table.spec.material, table.spec.grid, table.spec.ics)
    assert again.origin == "memory"
    assert again.key == table.key != exact.key
    assert np.array_equal(again.array, table.array)


def test_a_table_is_saved_and_exported_with_its_layers(shared, tmp_path):
    table = shared.get_ic(RUBBER, GRID, AnalyticIcs())
    save_table(tmp_path / "table.npz", table)
    assert load_table(tmp_path / "table.npz").spec.material == RUBBER
    (tmp_path / "table.h5").write_bytes(shared.export_ic(RUBBER, GRID, AnalyticIcs()))
    exported = load_table(tmp_path / "table.h5")
    assert exported.spec.material == RUBBER
    assert np.array_equal(exported.array, table.array)


@pytest.mark.parametrize("friction", [None, ROLLING, Friction(0.3, rigid_shift=(1e-3, 0))])
def test_layers_of_steel_are_steel(shared, friction):
    steel = shared.solve(**BALL, upper=STEEL, Fn=1000, friction=friction)
    for bodies in ({"upper": STEEL, "lower": STEEL_IN_LAYERS}, {"upper": STEEL_IN_LAYERS}):
        layered = shared.solve(**BALL, **bodies, Fn=1000, friction=friction)
        assert layered.converged
        assert layered.pressure == pytest.approx(steel.pressure, abs=1e-6 * steel.pmax)
        assert layered.Fx == pytest.approx(steel.Fx, rel=1e-4, abs=1e-3)


def test_layers_meet_every_other_body(shared):
    coated = LayeredBody([Layer(0.05, G=5, nu=0.2)], base=Material(0.5, 0.5))
    for upper in (RigidBody(), STEEL, coated, RUBBER):
        solution = shared.solve(**BALL, upper=upper, lower=RUBBER, approach=0.02, friction=ROLLING)
        assert solution.converged
        assert solution.Fn > 0
        assert solution.evidence.ics["lower"].evidence.source == "analytic"


def test_a_session_steps_on_layers(shared):
    with shared.session(**BALL, upper=RigidBody(), lower=RUBBER, friction=Friction(0.3, rigid_shift=(0.01, 0))) as session:
        first = session.step(Fn=1)
        second = session.step(Fn=2)
    assert first.converged and second.converged
    assert abs(second.Fx) > abs(first.Fx) > 0


@pytest.mark.parametrize(
    ("problem", "field", "word"),
    [
        ({"lower": LayeredBody([Layer(0, 1, 0.5)], RigidBody())}, "bodies.lower.ics.layers[0].thickness", "is 0"),
        ({"lower": LayeredBody([Layer(-1, 1, 0.5)], RigidBody())}, "bodies.lower.ics.layers[0].thickness", "-1"),
        ({"lower": LayeredBody([Layer(1, 1, 0.6)], RigidBody())}, "bodies.lower.ics.layers[0].nu", "0.6"),
        ({"lower": LayeredBody([], RigidBody())}, "bodies.lower.ics.layers", "at least 1"),
        ({"lower": LayeredBody([Layer(1, 1, 0.5)] * 21, RigidBody())}, "bodies.lower.ics.layers", "at most 20"),
        ({"lower": LayeredBody([Layer(1, 1, 0.5)], Material(1e12, 0.3))}, "bodies.lower.ics.base.G", "rigid base"),
        ({"lower": LayeredBody([Layer(1e-9, 1, 0.5)], RigidBody())}, "bodies.lower.ics.layers[0].thickness", "thinner"),
        ({"lower": RUBBER, "model": "hertz"}, "model", "half-spaces only"),
        ({"lower": RUBBER, "gap": SemiAxes(1, 1)}, "gap.semi_axes", "layers"),
        ({"lower": RUBBER, "ics": AnalyticIcs(line_contact=LineContact(100))}, "bodies.lower.ics.line_contact", "layered"),
    ],
)
def test_what_layers_cannot_be_is_refused_by_name(shared_daemon, problem, field, word):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument, match=word) as refused:
        client.solve(**{**BALL, "upper": STEEL, "Fn": 1, **problem})
    assert refused.value.violations[0].field == field


def test_a_material_beside_layers_is_refused(shared_daemon):
    layers = {"source": "analytic", **RUBBER.params()}
    grid = {"nx": 2, "ny": 2, "dx": 1, "dy": 1}
    client = Client(shared_daemon.endpoint)
    with client, pytest.raises(InvalidArgument, match="layers have their own materials") as refused:
        client.call("ic.get", {"material": {"G": 1, "nu": 0.5}, "grid": grid, "ics": layers})
    assert refused.value.violations[0].field == "material"
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument) as refused:
        client.call("ic.get", {"grid": grid, "ics": {**layers, "body": "half_space"}})
    assert "ics.body" in {violation.field for violation in refused.value.violations}


def test_stresses_in_layers_of_steel_are_those_in_steel(shared):
    problem = ContactProblem(**BALL, upper=STEEL, lower=STEEL_IN_LAYERS, Fn=1000, friction=ROLLING)
    solution = shared.solve(problem)
    block = StressBlock(GRID.x[::4], 0, [0, -0.1, -0.2, -0.5, -1.5])
    layered = shared.subsurface(problem, solution, body="lower", block=block)
    steel = shared.subsurface(problem.replace(lower=STEEL), solution, body="lower", block=block)
    for name in ("xx", "yy", "zz", "xy", "xz", "yz", "von_mises"):
        assert getattr(layered, name) == pytest.approx(getattr(steel, name), abs=1e-9 * solution.pmax)
    assert layered.largest.von_mises == pytest.approx(steel.largest.von_mises)


def test_stresses_are_those_of_the_body_that_is_asked_for(shared):
    problem = ContactProblem(**BALL, upper=STEEL, lower=RUBBER, Fn=1)
    solution = shared.solve(problem)
    points = [[0, 0, 0], [0, 0, -1], [0, 0, -2]]
    rubber = shared.subsurface(problem, solution, body="lower", points=points)
    steel = shared.subsurface(problem, solution, body="upper", points=points)
    assert rubber.zz[0] == pytest.approx(steel.zz[0])  # the pressure
    assert abs(rubber.zz[2] - steel.zz[2]) > 0.01 * solution.pmax
    with pytest.raises(InvalidArgument, match="has layers with their own values") as refused:
        shared.subsurface(problem, solution, body="lower", points=points, nu=0.5)
    assert refused.value.violations[0].field == "nu"


def test_points_below_a_rigid_base_are_refused(shared, shared_daemon):
    problem = ContactProblem(**BALL, upper=STEEL, lower=RUBBER, Fn=1)
    solution = shared.solve(problem)
    with pytest.raises(InvalidArgument, match="the layers end at z = -2") as refused:
        shared.subsurface(problem, solution, body="lower", points=[[0, 0, -1], [0, 0, -2.5]])
    assert refused.value.violations[0].field == "points"
    params = {"grid": {"nx": 1, "ny": 1, "dx": 1, "dy": 1}, "nu": 0.3, "pressure": [[1]], "points": [[0, 0, -1]]}
    thin = LayeredBody([Layer(1e-9, 1, 0.5)], RigidBody())
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument, match="thinner") as refused:
        client.call("contact.subsurface", {**params, "ics": {"source": "analytic", **thin.params()}})
    assert refused.value.violations[0].field == "ics.layers[0].thickness"


def test_stresses_below_a_uniform_body_are_refused(shared):
    problem = ContactProblem(
        **BALL, upper=RigidBody(), lower=STEEL, lower_ics=AnalyticIcs(body="longitudinally_uniform", section=SLAB), Fn=1000
    )
    solution = shared.solve(problem)
    with pytest.raises(InvalidArgument, match="half-space"):
        shared.subsurface(problem, solution, body="lower", points=[[0, 0, -1]])


@pytest.mark.parametrize(
    "bodies",
    [
        {"upper": STEEL_IN_LAYERS, "ics": AnalyticIcs(line_contact=LineContact(datum=100))},
        {"upper": STEEL, "lower": STEEL_IN_LAYERS, "upper_ics": AnalyticIcs(line_contact=LineContact(datum=100))},
    ],
)
def test_a_line_contact_of_layers_is_refused_with_the_way_round_it(shared, shared_daemon, bodies):
    problem = {"grid": Grid.centred(64, 1, 1.92, 20), "gap": Paraboloid(Rx=100), "Fn": 1e4}
    way = r"one row of long elements.*grid.dy at least ten times the length of the contact"
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument, match=way):
        client.solve(**problem, **bodies)
    row = {name: value for name, value in bodies.items() if name in ("upper", "lower")}
    solution = shared.solve(**problem, **row)
    # By Hertz, pmax = sqrt(F E*/(pi R)) for the force F per length, E* = G/(1 - nu) for two equal bodies.
    modulus = STEEL.G / (1 - STEEL.nu)
    assert solution.pmax == pytest.approx((1e4 / 20 * modulus / (np.pi * 100)) ** 0.5, rel=5e-3)
    assert solution.warnings == ()
