"""Tests contact.solve and contact.solve_many: forces, rolling, rigid bodies, simplified models, histories and
batches."""

import math

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    Client,
    ContactProblem,
    Estimate,
    Friction,
    Grid,
    InvalidArgument,
    KineticFriction,
    LineContact,
    Material,
    Paraboloid,
    RigidBody,
    Rolling,
    SemiAxes,
    SolverSettings,
    StatusError,
    StressBlock,
    load_table,
    save_table,
)
from support.problems import CATTANEO, CATTANEO_PARAMS, STEEL

SOFT = Material(G=200, nu=0.42)
FRICTIONLESS = CATTANEO.replace(friction=None)
#: A wheel on a rail, 25 x 25 elements: semi-axes of about 6 and 4 mm.
ROLLING = ContactProblem(
    grid=Grid.centred(25, 25, 15, 10),
    upper=STEEL,
    gap=SemiAxes(6, 4),
    Fn=80_000,
    friction=Friction(0.3, rolling=Rolling(xi=5e-4, velocity=20_000)),
)


#: A rolling cylinder on a plane, with forces per 7 mm.
LINE = ContactProblem(
    grid=Grid.centred(400, 1, 2.4, 7),
    upper=STEEL,
    gap=Paraboloid(100),
    Fn=7000,
    ics=AnalyticIcs(line_contact=LineContact(100)),
    friction=Friction(0.3, rolling=Rolling(xi=1e-3)),
)


def test_the_approach_of_a_force_gives_the_force_back(shared):
    by_approach = shared.solve(FRICTIONLESS)
    by_force = shared.solve(FRICTIONLESS.replace(Fn=by_approach.Fn))
    assert by_approach.approach == 0.02
    assert by_force.approach == pytest.approx(0.02, rel=1e-5)
    assert by_force.Fn == pytest.approx(by_approach.Fn, rel=1e-6)
    assert by_force.pmax == pytest.approx(by_approach.pmax, rel=1e-4)


@pytest.mark.parametrize("model", ["full", "hertz", "fastsim"])
def test_derivatives_are_differences_of_solutions(shared, model):
    problem = ROLLING.replace(
        model=model,
        gap=Paraboloid(500, 300),
        normal=SolverSettings(tolerance=1e-11),
        tangential=SolverSettings(tolerance=1e-10),
        derivatives=True,
    )
    by = shared.solve(problem).derivatives
    step = 1e-7

    def force(change):
        return shared.solve(problem.replace(friction=Friction(0.3, rolling=Rolling(xi=5e-4 + change)))).Fx

    assert by.Fx.xi == pytest.approx((force(step) - force(-step)) / (2 * step), rel=1e-4)
    assert (by.Fx.phi is None) == (model == "hertz")
    assert by.Fx.Fn < 0
    assert by.approach.Fn > 0
    assert by.Fn is None


def test_no_force_is_no_contact(shared):
    solution = shared.solve(FRICTIONLESS.replace(Fn=0))
    assert solution.converged
    assert (solution.Fn, solution.elements.contact, solution.elements.border) == (0, 0, 0)


def test_semi_axes_are_those_of_the_contact(shared):
    grid = Grid.centred(80, 80, 2.4, 2.4)
    solution = shared.solve(grid=grid, upper=SOFT, gap=SemiAxes(1, 0.5), Fn=10)
    inside = solution.element_division != 0
    assert np.abs(grid.x[inside.any(axis=0)]).max() == pytest.approx(1, abs=1.5 * grid.dx)
    assert np.abs(grid.y[inside.any(axis=1)]).max() == pytest.approx(0.5, abs=1.5 * grid.dy)
    assert solution.pmax == pytest.approx(1.5 * 10 / (np.pi * 1 * 0.5), rel=5e-3)


def test_contact_at_the_border_is_counted_and_warned_of(shared):
    solution = shared.solve(FRICTIONLESS.replace(grid=Grid.centred(20, 20, 1.2, 1.2)))
    assert solution.elements.border == 4 * 19
    assert any("border" in warning for warning in solution.warnings)
    assert shared.solve(FRICTIONLESS).warnings == ()


def test_a_rigid_body_halves_the_compliance(shared):
    elastic = shared.solve(FRICTIONLESS)
    rigid = shared.solve(FRICTIONLESS.replace(lower=RigidBody()))
    assert rigid.Fn == pytest.approx(2 * elastic.Fn, rel=1e-5)
    assert set(rigid.evidence.ics) == {"upper"}


def test_two_rigid_bodies_are_refused(shared):
    with pytest.raises(InvalidArgument, match="rigid"):
        shared.solve(FRICTIONLESS.replace(upper=RigidBody(), lower=RigidBody()))


def test_dissimilar_bodies_take_friction_and_tell_of_the_outer_iteration(shared):
    solution = shared.solve(CATTANEO.replace(lower=RigidBody()))
    assert solution.converged
    assert solution.evidence.outer.converged
    bound = 0.4 * solution.pressure
    assert (np.hypot(solution.traction_x, solution.traction_y) <= bound + 1e-5 * solution.pmax).all()


def test_the_shift_of_a_force_is_found(shared):
    shifted = shared.solve(CATTANEO)
    pulled = shared.solve(CATTANEO.replace(friction=Friction(0.4, force=(shifted.Fx, None))))
    assert pulled.Fx == pytest.approx(shifted.Fx, rel=1e-4)
    assert pulled.motion.rigid_shift[0] == pytest.approx(0.00817, rel=1e-3)
    assert pulled.motion.rigid_shift[1] == 0
    assert pulled.motion.force == (shifted.Fx, None)
    assert pulled.evidence.force.converged


def test_a_force_beyond_friction_is_refused_by_name(shared):
    with pytest.raises(InvalidArgument, match=r"friction\.force") as caught:
        shared.solve(CATTANEO.replace(friction=Friction(0.4, force=(5, None))))
    assert caught.value.violations[0].field == "friction.force"


def test_a_rotation_gives_a_moment_and_no_force(shared):
    solution = shared.solve(CATTANEO.replace(friction=Friction(0.4, (0, 0), rotation=0.01)))
    assert solution.Mz < 0
    assert solution.Fx == pytest.approx(0, abs=1e-4)
    x, y = np.meshgrid(CATTANEO.grid.x, CATTANEO.grid.y)
    moment = ((x * solution.traction_y - y * solution.traction_x) * 0.06**2).sum()
    assert solution.Mz == pytest.approx(moment, rel=1e-9)


def test_friction_tells_slip_work_and_motion(shared):
    solution = shared.solve(CATTANEO)
    slip = np.hypot(solution.slip_x, solution.slip_y)
    assert (slip[solution.element_division == 0] == 0).all()
    assert slip[solution.element_division == 1].max() < 1e-4 * slip.max()
    assert solution.frictional_work > 0
    assert solution.frictional_power is None
    assert solution.motion.rigid_shift == (0.00817, 0)
    assert shared.solve(FRICTIONLESS).slip_x is None


def test_a_step_starts_where_the_one_before_ended(shared):
    there = shared.solve(CATTANEO)
    unmoved = shared.solve(CATTANEO.replace(friction=Friction(0.4, (0, 0)), previous=there))
    assert unmoved.Fx == pytest.approx(there.Fx, rel=1e-3)
    # After a shift back to the origin, friction holds it on the other side (Mindlin and Deresiewicz).
    back = shared.solve(CATTANEO.replace(friction=Friction(0.4, (-0.00817, 0)), previous=there))
    bound = 0.4 * there.Fn
    remaining = (1 + there.Fx / bound) ** (2 / 3)  # 1 minus the shift over that of full slip
    there_and_half_back = bound * (1 - ((1 + remaining) / 2) ** 1.5)
    assert back.Fx == pytest.approx(there.Fx + 2 * there_and_half_back, rel=0.03)
    previous = Estimate(pressure=there.pressure, traction_x=there.traction_x, traction_y=there.traction_y)
    again = shared.solve(CATTANEO.replace(friction=Friction(0.4, (0, 0)), previous=previous))
    assert again.Fx == unmoved.Fx


def test_a_coefficient_per_element_is_that_coefficient(shared):
    one = shared.solve(CATTANEO)
    per_element = shared.solve(CATTANEO.replace(friction=Friction(np.full((40, 40), 0.4), (0.00817, 0))))
    np.testing.assert_array_equal(per_element.traction_x, one.traction_x)


@pytest.mark.parametrize("law", ["linear", "exponential"])
def test_kinetic_friction_lowers_the_force(shared, law):
    static = shared.solve(CATTANEO.replace(friction=Friction(0.4, (0.05, 0))))
    kinetic = KineticFriction(mu=0.2, slip_velocity=0.05, law=law)
    falling = shared.solve(CATTANEO.replace(friction=Friction(0.4, (0.05, 0), kinetic=kinetic)))
    assert falling.converged
    assert 0.2 * falling.Fn <= -falling.Fx < 0.95 * -static.Fx


def test_rolling_has_its_forces_power_and_slip(shared):
    solution = shared.solve(ROLLING)
    assert solution.converged
    assert solution.Fn == pytest.approx(80_000, rel=1e-6)
    assert -0.3 * solution.Fn < solution.Fx < 0
    assert solution.elements.adhesion > 0
    assert solution.elements.slip > 0
    assert solution.frictional_power > 0
    assert solution.frictional_work is None
    assert (solution.motion.kind, solution.motion.xi) == ("steady", 5e-4)
    assert solution.motion.dq == ROLLING.grid.dx


def test_a_slender_contact_rotated_by_a_right_angle_has_the_same_force(shared):
    along = ROLLING.replace(grid=Grid.centred(25, 25, 13.2, 1.32), gap=SemiAxes(6, 0.6))
    rotated = along.replace(
        grid=Grid.centred(25, 25, 1.32, 13.2),
        gap=SemiAxes(0.6, 6),
        friction=Friction(0.3, rolling=Rolling(eta=5e-4, chi=np.pi / 2)),
    )
    assert shared.solve(rotated).Fy == pytest.approx(shared.solve(along).Fx, rel=1e-5)


def test_a_step_far_above_the_contact_is_warned_of(shared):
    far = shared.solve(ROLLING.replace(friction=Friction(0.3, rolling=Rolling(xi=5e-4, dq=20))))
    assert any("friction.rolling.dq is 20 mm" in warning for warning in far.warnings)
    assert shared.solve(ROLLING).warnings == ()


def test_elements_as_large_as_the_contact_are_warned_of(shared):
    lost = shared.solve(FRICTIONLESS.replace(grid=Grid(40, 40, 2.4, 2.4)))
    assert lost.elements.contact == 0
    assert any("narrower than the elements" in warning for warning in lost.warnings)
    found = shared.solve(FRICTIONLESS.replace(grid=Grid(40, 40, 2.4, 2.4), Fn=9.2))
    assert any("2 elements across" in warning for warning in found.warnings)
    assert found.evidence.discretisation.force_error > 0.4
    fine = shared.solve(FRICTIONLESS)
    assert fine.evidence.discretisation.source == "hertz"
    assert fine.evidence.discretisation.force_error < 5e-3


def test_the_creepages_of_forces_are_found(shared):
    asked = shared.solve(ROLLING)
    friction = Friction(0.3, rolling=Rolling(force=(asked.Fx, None)))
    found = shared.solve(ROLLING.replace(friction=friction))
    assert found.Fx == pytest.approx(asked.Fx, rel=1e-3)
    assert found.motion.xi == pytest.approx(5e-4, rel=1e-2)


def test_rolling_the_other_way_turns_the_solution(shared):
    ahead = shared.solve(ROLLING)
    rotated = shared.solve(ROLLING.replace(friction=Friction(0.3, rolling=Rolling(xi=5e-4, chi=np.pi, velocity=20_000))))
    assert rotated.Fx == pytest.approx(ahead.Fx, rel=1e-3)
    np.testing.assert_allclose(rotated.traction_x[:, ::-1], ahead.traction_x, atol=1e-3 * ahead.pmax)


def test_transient_rolling_reaches_the_steady_state(shared):
    steady = shared.solve(ROLLING)
    rolling = Rolling(xi=5e-4, kind="transient", steps=60, velocity=20_000)
    transient = shared.solve(ROLLING.replace(friction=Friction(0.3, rolling=rolling)))
    assert transient.Fx == pytest.approx(steady.Fx, rel=2e-2)
    first = shared.solve(ROLLING.replace(friction=Friction(0.3, rolling=Rolling(xi=5e-4, kind="transient"))))
    assert abs(first.Fx) < 0.5 * abs(steady.Fx)
    further = ROLLING.replace(friction=Friction(0.3, rolling=Rolling(xi=5e-4, kind="transient")), previous=first)
    assert abs(shared.solve(further).Fx) > abs(first.Fx)


@pytest.mark.parametrize("model", ["hertz", "fastsim"])
def test_simplified_models_agree_with_the_full_one(shared, model):
    full, simplified = shared.solve(ROLLING), shared.solve(ROLLING.replace(model=model))
    assert simplified.approach == pytest.approx(full.approach, rel=1e-2)
    assert simplified.pmax == pytest.approx(full.pmax, rel=2e-2)
    assert simplified.evidence.ics == {}
    if model == "fastsim":
        assert simplified.Fx == pytest.approx(full.Fx, rel=0.15)


def test_simplified_models_need_curvatures(shared):
    with pytest.raises(InvalidArgument, match="gap"):
        shared.solve(CATTANEO.replace(model="hertz", gap=np.zeros((40, 40))))


def test_fastsim_refuses_an_ellipse_beyond_kalkers_table(shared):
    slender = ROLLING.replace(gap=SemiAxes(0.1, 10), grid=Grid.centred(25, 25, 0.25, 25), model="fastsim")
    with pytest.raises(InvalidArgument, match="gap results in a contact ellipse.* 0.1 mm along.* 10 mm.* 1/32 to 32.*full"):
        shared.solve(slender)
    assert shared.solve(slender.replace(model="hertz")).converged


def test_a_line_contact_has_hertz_pressure_and_carters_force(shared):
    P, G, nu = 1000, STEEL.G, STEEL.nu
    a = np.sqrt(4 * P * 100 * (1 - nu) / (np.pi * G))
    problem = LINE.replace(Fn=7 * P)
    solution = shared.solve(problem)
    assert solution.warnings == ()
    assert solution.pmax == pytest.approx(2 * P / (np.pi * a), rel=1e-3)
    assert solution.Fx == pytest.approx(-7 * 0.3 * P * (1 - (1 - 1e-3 * 100 / (0.3 * a)) ** 2), rel=2e-3)
    assert solution.evidence.ics["upper"].origin in ("closed_form", "memory")


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"grid": Grid.centred(40, 3, 2.4, 7)}, "grid.ny is 3; a line contact"),
        ({"gap": Paraboloid(100, 100)}, "gap.paraboloid.Ry is 100; a line contact"),
        ({"ics": AnalyticIcs(line_contact=LineContact(2))}, "ics.line_contact.datum is 2; it must be at least"),
        ({"friction": Friction(0.3, rolling=Rolling(phi=1e-4))}, "friction.rolling.phi is .*; a line contact"),
    ],
)
def test_what_changes_along_y_is_no_line_contact(shared, changes, says):
    with pytest.raises(InvalidArgument, match=says):
        shared.solve(LINE.replace(**changes))


def test_the_table_of_a_line_contact_is_answered_but_not_exported(shared, tmp_path):
    table = shared.get_ic(STEEL, LINE.grid, LINE.ics)
    assert table.spec.ics.line_contact == LineContact(100)
    dx, far = LINE.grid.dx, 100 * LINE.grid.dx
    expected = (1 - STEEL.nu) / (np.pi * STEEL.G) * dx * np.log(100 / far)
    assert table["zz"][0, 100] == pytest.approx(expected, rel=1e-4)
    save_table(tmp_path / "line.npz", table)
    assert load_table(tmp_path / "line.npz").spec == table.spec
    for kind in ("hdf5", "contact"):
        with pytest.raises(InvalidArgument, match="ics.line_contact"):
            shared.export_ic(STEEL, LINE.grid, LINE.ics, kind)


def test_below_a_roller_the_largest_shear_is_that_of_handbooks(shared):
    """Uses Norton's example: a steel wheel of 12 in on a flat rail, 0.875 in wide, 5000 lbf (inch, pound): 0.304 p0 at
    0.786 a."""
    steel, force, width, radius = Material(G=30e6 / 2.56, nu=0.28), 5000.0, 0.875, 6.0
    a = math.sqrt(8 * force / width * radius * (1 - 0.28**2) / 30e6 / math.pi)
    line = AnalyticIcs(line_contact=LineContact(datum=100))
    roller = ContactProblem(grid=Grid.centred(120, 1, 2.4 * a, width), upper=steel, gap=Paraboloid(Rx=radius), Fn=force, ics=line)
    solution = shared.solve(roller)
    assert solution.pmax == pytest.approx(70243, rel=1e-3)
    for body in ("lower", "upper"):
        stress = shared.subsurface(roller, solution, body=body, block=StressBlock(x=0, y=[0, 3], z=-np.linspace(0.005, 0.1, 96)))
        shear = abs(stress.xx - stress.zz)[:, 0, 0] / 2
        assert shear.max() == pytest.approx(21354, rel=0.015)  # 0.304 stands for 0.3003
        assert shear.max() == pytest.approx(0.30028 * 70243, rel=1e-3)
        assert 0.005 + 0.001 * shear.argmax() == pytest.approx(0.041, abs=0.001)
        assert stress.yy == pytest.approx(0.28 * (stress.xx + stress.zz))
        assert (stress.xx[:, 0] == stress.xx[:, 1]).all()


def test_stresses_below_a_line_contact_are_asked_for_as_one(shared):
    with pytest.raises(InvalidArgument, match="^grid.ny is 3"):
        rows = LINE.replace(grid=Grid.centred(40, 3, 2.4, 7))
        shared.subsurface(rows, Estimate(pressure=np.ones((3, 40))), points=[[0, 0, -1]])


def test_elements_that_are_too_long_are_refused_with_what_would_be_right(shared):
    long = FRICTIONLESS.replace(grid=Grid(10, 1, 0.01, 100))
    assert shared.solve(long).converged
    with pytest.raises(InvalidArgument, match=r"grid\.dy gives .*; it must lie in \[0.001, 1000\]. .*line_contact"):
        shared.solve(long.replace(ics=AnalyticIcs(load_shape="bilinear")))
    with pytest.raises(InvalidArgument, match=r"grid\.dy gives .*; it must lie in \[1e-6, 1e6\]. .*line_contact"):
        shared.solve(long.replace(grid=Grid(10, 1, 1e-4, 1000)))


def test_many_problems_are_answered_in_their_order(shared):
    approaches = [0.005, 0.02, 0.01, 0.015]
    together = shared.solve_many(FRICTIONLESS.replace(approach=approach) for approach in approaches)
    alone = [shared.solve(FRICTIONLESS.replace(approach=approach)) for approach in approaches]
    for many, one in zip(together, alone, strict=True):
        assert many.converged
        np.testing.assert_array_equal(many.pressure, one.pressure)


def test_of_many_problems_a_bad_one_fails_alone(shared):
    bad = [
        CATTANEO.replace(gap=np.zeros((3, 3))),
        CATTANEO.replace(friction=Friction(0.4, force=(1e6, None))),
        CATTANEO.replace(upper=RigidBody(), lower=RigidBody()),
    ]
    answers = shared.solve_many([CATTANEO, *bad, CATTANEO])
    assert [isinstance(answer, StatusError) for answer in answers] == [False, True, True, True, False]
    fields = [answer.violations[0].field for answer in answers[1:-1]]
    assert fields == ["gap.array", "friction.force", "bodies.lower"]
    assert answers[0].Fx == answers[-1].Fx


def test_of_many_problems_one_that_breaks_the_schema_is_named(shared_daemon):
    with Client(shared_daemon.endpoint) as client, pytest.raises(InvalidArgument) as caught:
        client.solve_many([CATTANEO, CATTANEO.replace(upper=Material(200, 0.6))])
    assert [violation.field for violation in caught.value.violations] == ["problems[1].bodies.upper.nu"]


def test_many_problems_may_share_their_frames(shared_daemon):
    gap = (np.arange(6.0).reshape(2, 3) - 2) ** 2 / 50
    reference = {"$array": {"frame": 1, "dtype": "<f8", "shape": [2, 3]}}
    params = {**CATTANEO_PARAMS, "grid": {"nx": 3, "ny": 2, "dx": 0.5, "dy": 0.5}, "gap": {"array": reference}}
    with shared_daemon.raw() as raw:
        many = raw.ask("contact.solve_many", {"problems": [params, params]}, gap.tobytes(), arrays="list")
        one = raw.ask("contact.solve", params, gap.tobytes(), arrays="list")
    for solution in many.result["solutions"]:
        assert solution["status"]["code"] == 0
        assert solution["result"]["pressure"] == one.result["pressure"]


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"Fn": 1}, "Fn"),
        ({"model": "exact"}, "model"),
        ({"gap": {"semi_axes": {"a": 0, "b": 1}}}, "gap.semi_axes.a"),
        ({"friction": {"mu": 0.4}}, "friction.rigid_shift"),
        ({"friction": {"mu": 0.4, "force": [None, None]}}, "friction.force"),
        ({"friction": {"mu": 0.4, "rolling": {}, "rotation": 1}}, "friction.rotation"),
        ({"friction": {"mu": [[0.4]], "rolling": {}}}, "friction.mu"),
        ({"previous": {"pressure": [[1.0]]}}, "previous.pressure"),
        ({"bodies": {"upper": {"rigid": True, "nu": 0}}}, "bodies.upper.nu"),
    ],
)
def test_what_does_not_fit_is_named(raw, changes, field):
    answer = raw.ask("contact.solve", {**CATTANEO_PARAMS, **changes})
    assert answer.status == "INVALID_ARGUMENT"
    assert answer.fields == [field]


def test_a_paraboloid_may_be_a_cylinder_under_a_force(shared):
    solution = shared.solve(FRICTIONLESS.replace(gap=Paraboloid(Rx=50), Fn=9))
    assert solution.Fn == pytest.approx(9, rel=1e-6)
    assert (solution.element_division[:, 20] != 0).all()


def test_the_same_request_has_the_same_answer_to_the_last_bit(daemons):
    dissimilar = CATTANEO.replace(lower=RigidBody())
    transient = ROLLING.replace(friction=Friction(0.3, rolling=Rolling(xi=1e-3, kind="transient", steps=5)))
    problems = [ROLLING, CATTANEO, dissimilar, transient] * 3
    answers = []
    for workers in (1, 3):
        with daemons.start(f"with-{workers}", workers=workers).client() as client:
            answers.append([client.solve(problem) for problem in problems])
            answers.append(client.solve_many(problems))
    for other in answers[1:]:
        for solution, expected in zip(other, answers[0], strict=True):
            for name in ("pressure", "traction_x", "traction_y", "slip_x"):
                np.testing.assert_array_equal(getattr(solution, name), getattr(expected, name))
