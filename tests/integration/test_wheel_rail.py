"""Tests wheelrail.solve and wheelrail.geometry: a published benchmark, and mistakes of users."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from contactd import Client, InvalidArgument, Material, RigidBody, SolverSettings, TimeoutExpired
from contactd.wheel_rail import (
    ArcProfile,
    ConeProfile,
    PatchRules,
    ProfilePoints,
    Rail60E1,
    RailDeviation,
    Track,
    WheelRailFriction,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)

RIGHT = WheelRailSetup(side="right")
COARSE = RIGHT.replace(dx=0.8, dy=0.8)
#: The Manchester contact benchmark, A-2.2: S1002 on 60E1 at 1/40, 10 kN per wheel, mu 0.3, elements of 0.2 mm.
MU_FN = 0.3 * 1e4
#: Half-length of the centred contact (mm): the spin at its edge is its largest creepage.
RADIUS = math.sqrt(1291 * 0.04 / math.pi)


def rolling(y=0.0, roll=0.0, yaw=0.0, pitch=-4.3481181, Fz: float | None = 1e4, **more):
    velocity = WheelsetVelocity(x=2000, pitch=pitch)
    return WheelRailState(position=WheelsetPosition(y=y, roll=roll, yaw=yaw, **more), velocity=velocity, Fz=Fz)


CENTRED = rolling()
FLANGE = rolling(8, -0.008606, 0.0192, -4.2534857)


def test_a_centred_wheel_agrees_with_the_benchmark(shared):
    solution = shared.wheel_rail(RIGHT, CENTRED, fields=[])
    (patch,) = solution.patches
    at, creepages = patch.place.reference, patch.place.creepages
    assert solution.converged
    assert solution.warnings == ()
    assert solution.z == pytest.approx(0.1981, abs=1e-4)
    assert (at.x, at.y, at.z) == pytest.approx((0, 751.8726, 0.1252), abs=0.01)
    assert at.angle == pytest.approx(-0.029, abs=2e-4)
    assert (creepages.xi, creepages.phi) == pytest.approx((-5.665e-5, 6.302e-5), abs=1e-3 * 6.302e-5 * RADIUS)
    assert patch.solution.forces.Fn == pytest.approx(9997, rel=1e-3)
    assert patch.solution.pmax == pytest.approx(338.3, rel=4e-3)
    assert patch.solution.elements.contact == pytest.approx(1291, abs=3)
    track = solution.forces.track
    assert track.Fz == pytest.approx(1e4, rel=1e-5)
    assert (track.Fx, track.Fy) == pytest.approx((0.2783, 36.24), abs=1e-3 * MU_FN)


def test_a_wheel_on_its_flange_agrees_with_the_benchmark(shared):
    solution = shared.wheel_rail(RIGHT, FLANGE, fields=[])
    (patch,) = solution.patches
    at, place, forces = patch.place.reference, patch.place, patch.solution.forces
    mu_fn = 0.3 * 12720
    assert solution.z == pytest.approx(-6.2615, abs=1e-3)
    assert (at.x, at.y, at.z) == pytest.approx((-0.9036, 719.8316, 8.0092), abs=0.01)
    assert at.angle == pytest.approx(-0.9501, abs=2e-4)
    expected = (0.02127, 0.033, 0.001701)
    creepages = place.creepages
    assert (creepages.xi, creepages.eta, creepages.phi) == pytest.approx(expected, abs=1e-3 * 0.033)
    assert forces.Fn == pytest.approx(12720, rel=1e-3)
    assert (forces.Fx, forces.Fy) == pytest.approx((-2070, -3195), abs=1e-3 * mu_fn)
    assert patch.solution.pmax == pytest.approx(2634, rel=4e-3)
    assert solution.forces.track.Fy == pytest.approx(8493, abs=1e-3 * mu_fn + 1e-3 * 12720)


def test_a_left_wheel_is_a_right_one_in_a_mirror(shared):
    right = shared.wheel_rail(COARSE, FLANGE, fields=[])
    mirrored = rolling(-8, 0.008606, -0.0192, -4.2534857)
    left = shared.wheel_rail(COARSE.replace(side="left"), mirrored, fields=[])
    assert left.z == right.z
    assert left.forces.track.Fy == -right.forces.track.Fy
    assert left.forces.track.Fx == right.forces.track.Fx
    assert left.patches[0].place.reference.angle == -right.patches[0].place.reference.angle


def test_arrays_come_as_asked_for(shared):
    patch = shared.wheel_rail(COARSE, CENTRED, gap=True).patches[0]
    solution, grid = patch.solution, patch.place.grid
    assert solution.pressure.shape == grid.shape
    assert solution.slip_x is not None
    assert patch.gap is not None
    assert patch.gap.min() == 0
    assert solution.pressure.sum() * grid.dx * grid.dy == pytest.approx(solution.forces.Fn, rel=1e-10)
    some = shared.wheel_rail(COARSE, CENTRED, fields="pressure").patches[0]
    assert not hasattr(some.solution, "traction_x") and some.gap is None
    np.testing.assert_array_equal(some.solution.pressure, solution.pressure)


def test_an_equal_set_up_is_answered_the_same(shared):
    first, again = (shared.wheel_rail(COARSE, CENTRED) for _ in range(2))
    assert first.forces == again.forces
    np.testing.assert_array_equal(first.patches[0].solution.traction_y, again.patches[0].solution.traction_y)


def test_a_wheel_above_its_rail_is_an_answer(shared):
    solution = shared.wheel_rail(RIGHT, rolling(Fz=None, z=-1))
    assert solution.patches == ()
    assert solution.converged
    assert solution.clearance == pytest.approx(1.182, abs=0.01)
    assert solution.forces.track.Fz == 0


def test_a_wheel_beside_its_rail_is_an_answer(shared):
    solution = shared.wheel_rail(RIGHT, WheelRailState(position=WheelsetPosition(y=2000)))
    assert solution.clearance is None
    assert solution.warnings[0].startswith("No part of the wheel is above the rail")


def test_a_longitudinal_force_is_brought_by_the_pitch_rate(shared):
    state = WheelRailState(velocity=WheelsetVelocity(x=2000), Fz=1e4, Fx=500)
    solution = shared.wheel_rail(COARSE, state, fields=[])
    assert solution.converged
    assert solution.pitch_search is not None
    assert solution.forces.wheelset.Fx == pytest.approx(500, abs=0.1)
    assert solution.pitch_rate == pytest.approx(-2000 / 460, rel=0.01)


def test_derivatives_are_differences_of_solutions(shared):
    fine = SolverSettings(1e-10)
    setup = COARSE.replace(dx=0.4, dy=0.4, normal=fine, tangential=fine)
    at = {"roll": 0, "yaw": 0.007, "Fz": None, "z": 0.2}
    asked = rolling(3, **at)
    solution = shared.wheel_rail(setup, dataclasses.replace(asked, derivatives=True), fields=[])
    assert solution.derivatives is not None
    step = 1e-4
    up, down = (shared.wheel_rail(setup, rolling(3, **at | {"z": 0.2 + dz}), fields=[]) for dz in (step, -step))
    slope = (up.forces.track.Fz - down.forces.track.Fz) / (2 * step)
    assert solution.derivatives.position.z.Fz == pytest.approx(slope, rel=0.02)
    assert solution.derivatives.position.z.Fz > 0


def test_slices_that_are_alike_make_a_rail_that_does_not_vary(shared):
    track = Track(rail_origin=(752, 0))
    one = shared.wheel_rail(COARSE.replace(track=track), CENTRED, fields=[])
    slices = [(-500.0, Rail60E1(1 / 40)), (0.0, Rail60E1(1 / 40)), (500.0, Rail60E1(1 / 40))]
    many = shared.wheel_rail(COARSE.replace(track=track, rail_slices=slices), CENTRED, fields=[])
    assert many.z == pytest.approx(one.z, abs=1e-3)
    assert many.forces.track.Fy == pytest.approx(one.forces.track.Fy, abs=10)


@pytest.mark.parametrize("model", ["full", "hertz", "fastsim"])
def test_every_model_knows_wheels_on_rails(shared, model):
    friction = None if model == "hertz" else WheelRailFriction(0.3)  # it knows no spin
    solution = shared.wheel_rail(COARSE.replace(model=model, friction=friction), rolling(3, yaw=0.007))
    assert solution.converged
    assert solution.forces.track.Fz == pytest.approx(1e4, rel=1e-5)


def test_a_cone_on_an_arc_touches_where_it_must(shared):
    cone = RIGHT.replace(wheel=ConeProfile(-0.05), rail=ArcProfile(300), track=Track(rail_origin=(750, 0)), model="hertz")
    shifts = [-3.0, 0.0, 2.5]
    geometries = shared.wheel_rail_geometry(cone, [rolling(y) for y in shifts])
    for shift, geometry in zip(shifts, geometries, strict=True):
        (place,) = geometry.places
        assert place.reference.angle == pytest.approx(-math.atan(0.05), abs=1e-4)
        assert place.reference.y == pytest.approx(750 - 300 * math.sin(math.atan(0.05)), abs=0.05)
        assert place.radii.rail_across == pytest.approx(300, rel=1e-3)
        assert place.radii.wheel_across is None
        assert place.radii.wheel_along == pytest.approx(460, rel=1e-2)
        assert geometry.clearance is not None
        assert geometry.clearance < 0
        assert shift is not None


def test_a_rail_is_straight_along_where_a_part_of_it_begins(shared):
    y = np.linspace(-40, 40, 161)
    head = ProfilePoints(np.column_stack([y, y**2 / 600]))
    features = {True: (-1, 40, 999), False: (0, 40, 999)}
    slices = [(x, head, features[x < -50]) for x in (-303.0, -203.0, -103.0, -3.0, 97.0, 197.0)]
    track = Track(rail_origin=(750, 0))
    setup = COARSE.replace(wheel=ConeProfile(-0.025), rail_slices=slices, rail_spline="cubic", track=track)
    (patch,) = shared.wheel_rail(setup, rolling(0.0)).patches
    assert patch.place.reference.y == pytest.approx(742.5, abs=0.05)
    assert patch.place.radii.rail_along is None


def test_points_make_the_same_profile_as_their_formula(shared):
    y = np.linspace(-30, 30, 601)
    arc = ProfilePoints(np.column_stack([y, 300 - np.sqrt(300**2 - y**2)]))
    cone = COARSE.replace(wheel=ConeProfile(-0.05), track=Track(rail_origin=(750, 0)))
    by_formula = shared.wheel_rail(cone.replace(rail=ArcProfile(300, ends=(-30, 30))), CENTRED, fields=[])
    by_points = shared.wheel_rail(cone.replace(rail=arc), CENTRED, fields=[])
    assert by_points.z == pytest.approx(by_formula.z, abs=1e-6)
    assert by_points.forces.track.Fy == pytest.approx(by_formula.forces.track.Fy, abs=0.1)


@pytest.mark.parametrize(
    ("setup", "state", "field"),
    [
        ({"track": Track(gauge=0)}, {}, "setup.track.gauge"),
        ({"dx": 0}, {}, "setup.dx"),
        ({"patches": PatchRules(distance_combine=9)}, {}, "setup.patches.distance_separate"),
        ({"friction": WheelRailFriction([(0, 0.3), (-1, 0.1)])}, {}, "setup.friction.mu[1].angle"),
        ({"friction": WheelRailFriction(-0.1)}, {}, "setup.friction.mu"),
        ({"rail": ProfilePoints([[0, 0]])}, {}, "setup.rail.points"),
        ({"rail": ProfilePoints([[0, 0], [1, math.nan], [2, 0]])}, {}, "setup.rail.points"),
        ({"wheel": ArcProfile(10)}, {}, "setup.wheel.arc"),
        ({"wheel": ConeProfile(0.05, ends=(3, 2))}, {}, "setup.wheel.cone.ends"),
        ({"rail": Rail60E1(5)}, {}, "setup.rail.rail_60e1.inclination"),
        ({"upper": RigidBody(), "lower": RigidBody()}, {}, "setup.bodies"),
        ({"upper": Material(G=-1, nu=0.3)}, {}, "setup.bodies.upper.G"),
        ({"model": "hertz"}, {"Fz": 1e4, "velocity": WheelsetVelocity(x=2000, pitch=-4.3)}, "setup.model"),
        ({"rail_slices": [(0, Rail60E1()), (1, Rail60E1())]}, {}, "setup.track.rail_origin"),
        ({"rigid_slip": "surfaces", "model": "fastsim"}, {}, "setup.rigid_slip"),
        ({}, {"Fz": 0}, "state.Fz"),
        ({}, {"position": WheelsetPosition(z=10)}, "state.position.z"),
        ({}, {"position": WheelsetPosition(roll=2)}, "state.position.roll"),
        ({}, {"rail": RailDeviation(y=math.inf)}, "state.rail.y"),
        ({}, {"Fx": 5.0, "Fz": 1e4}, "state.Fx"),
        ({"dx": 0.001, "dy": 0.001}, {"Fz": 1e5}, "setup.dx"),
    ],
)
def test_bad_input_is_named_by_its_field(shared_daemon, setup, state, field):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument) as caught:
        client.wheel_rail(RIGHT.replace(**setup), WheelRailState(**state))
    assert caught.value.violations[0].field.startswith(field), caught.value


HEAD = [(-36, 14), (-26, 2), (-10, 0.2), (0, 0), (10, 0.2), (26, 2), (36, 14)]


@pytest.mark.parametrize(
    ("setup", "state", "words"),
    [
        ({"rail": ProfilePoints([*HEAD[:2], (10, 3), (12, -1), (-20, -1), *HEAD[2:]])}, {}, ("cross themselves", "mm", "order the points")),
        ({"rail": ProfilePoints([HEAD[i] for i in (3, 6, 0, 4, 1, 5, 2)])}, {}, ("setup.rail.points", "follow the profile from one end to the other")),
        ({"rail": ProfilePoints(HEAD[:1])}, {}, ("setup.rail.points", "has 1 entries", "needs at least two")),
        ({}, {"position": WheelsetPosition(z=10)}, ("state.position.z", "mm inside the rail", "lift the wheelset, or prescribe Fz")),
        ({"track": Track(gauge=40)}, {}, ("setup.track.gauge", "is 40", "the rails would overlap")),
        ({"track": Track(gauge=1.435, gauge_height=0.014)}, {}, ("setup.track.gauge_height", "0.014", "check the unit")),
        ({"wheel": ProfilePoints([(y / 1000, z / 1000) for y, z in HEAD])}, {}, ("setup.wheel.points", "less than 1 mm", "check their unit")),
        ({"rail": ProfilePoints(HEAD, unit=1000)}, {}, ("setup.rail.points", "72000 mm", "check their unit")),
        ({"rail": ProfilePoints(HEAD, mirror_z=True)}, {}, ("setup.rail.points", "change mirror_z")),
        ({"rail": ProfilePoints(HEAD[2:])}, {}, ("setup.track.gauge_height", "y < 0", "change mirror_y")),
        ({}, {"position": WheelsetPosition(yaw=1.4)}, ("state.position.yaw", "1.4")),
    ],
)  # fmt: skip
def test_a_refusal_names_field_and_place_and_says_what_to_do(shared_daemon, setup, state, words):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument) as caught:
        client.wheel_rail(COARSE.replace(**setup), WheelRailState(**state))
    assert all(word in str(caught.value) for word in words), caught.value


@pytest.mark.parametrize(
    ("state", "sentence"),
    [
        ({"position": WheelsetPosition(yaw=0.2)}, "Give angles in rad, not in degrees. If it is in degrees, it is 0.003491 rad."),
        ({"velocity": WheelsetVelocity(x=72, pitch=-0.1565)}, "Give velocities in mm/s, not in m/s or km/h."),
        ({"velocity": WheelsetVelocity(x=20, pitch=-43.4)}, "velocity.pitch is close to -velocity.x/nominal_radius, in rad/s"),
        ({"position": WheelsetPosition(y=300)}, "check position.y, track.gauge"),
    ],
)
def test_what_may_be_in_other_units_is_solved_with_a_warning(shared, state, sentence):
    solution = shared.wheel_rail(COARSE, WheelRailState(**{"velocity": CENTRED.velocity, "Fz": 1e4, **state}), fields=[])
    assert any(sentence in warning for warning in solution.warnings), solution.warnings


def test_a_bad_state_of_many_is_named(shared):
    with pytest.raises(InvalidArgument) as caught:
        shared.wheel_rail_geometry(RIGHT, [CENTRED, rolling(Fz=None, z=10)])
    assert caught.value.violations[0].field == "states[1].position.z"


def test_a_patch_beyond_the_limit_of_grids_is_refused(daemons):
    daemon = daemons.start(limits={"max_grid_elements": 400})
    with daemon.client() as client:
        assert client.wheel_rail(RIGHT.replace(dx=1, dy=1), CENTRED).converged
        for model in ("full", "fastsim"):
            with pytest.raises(InvalidArgument) as caught:
                client.wheel_rail(RIGHT.replace(model=model), CENTRED)
            assert caught.value.reason == "LIMIT_EXCEEDED"
            assert "limits.max_grid_elements" in str(caught.value)


def test_a_solve_beyond_its_deadline_ends(shared):
    with pytest.raises(TimeoutExpired):
        shared.wheel_rail(RIGHT.replace(dx=0.03, dy=0.03), FLANGE, timeout=0.05)
    assert shared.wheel_rail(COARSE, CENTRED).converged
