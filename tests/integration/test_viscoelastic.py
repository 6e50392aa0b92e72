"""Tests bodies of the standard linear solid through a daemon: solves, sessions at several speeds, files, and
refusals."""

import dataclasses

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactProblem,
    ContactWarning,
    FemIcs,
    Friction,
    Grid,
    InvalidArgument,
    Layer,
    LayeredBody,
    Material,
    Paraboloid,
    RigidBody,
    Rolling,
    StressBlock,
    ViscoelasticBody,
    from_dict,
    load,
    save,
    to_dict,
)

NYLON = ViscoelasticBody(G=1143, nu=0.4, f=1, tau=5e-3)
BALL = {"grid": Grid.centred(20, 20, 16, 16), "gap": Paraboloid(50, 50), "Fn": 2000}


def rolling(velocity=1000.0, **motion):
    return Friction(0.3, rolling=Rolling(xi=2e-3, velocity=velocity, **motion))


def test_a_ball_that_creeps_resists_rolling(shared):
    solution = shared.solve(**BALL, upper=NYLON, friction=rolling())
    assert solution.converged
    resistance = solution.rolling_resistance
    assert 0.01 < resistance.force / solution.Fn < 0.1
    assert resistance.power == pytest.approx(1000 * resistance.force)
    assert resistance.force == pytest.approx(solution.Fn * resistance.centre_of_pressure / 50, rel=1e-6)
    assert resistance.moment == pytest.approx(solution.Fn * resistance.centre_of_pressure)
    assert resistance.defect < 0.02
    back = shared.solve(**BALL, upper=NYLON, friction=Friction(0.3, rolling=Rolling(xi=-2e-3, chi=np.pi, velocity=1000)))
    assert back.pressure == pytest.approx(solution.pressure[:, ::-1], abs=1e-6 * solution.pmax)


def test_limits_of_creep_are_elastic(shared):
    for body, elastic in (
        (dataclass_with(NYLON, tau=0), Material(1143 / 2, 0.4)), (dataclass_with(NYLON, f=0), Material(1143, 0.4))
    ):  # fmt: skip
        creeps = shared.solve(**BALL, upper=body, friction=rolling())
        assert np.array_equal(creeps.pressure, shared.solve(**BALL, upper=elastic, friction=rolling()).pressure)
        assert creeps.rolling_resistance.force == pytest.approx(0, abs=1e-6)


def dataclass_with(body, **changes):
    return ViscoelasticBody(**{**{each.name: getattr(body, each.name) for each in dataclasses.fields(body)}, **changes})


def test_bodies_that_creep_meet_others(shared):
    for lower in (RigidBody(), Material(900, 0.2), dataclass_with(NYLON, f=3, tau=1e-3), NYLON):
        assert shared.solve(**BALL, upper=NYLON, lower=lower, friction=rolling()).converged
    hats = shared.solve(**BALL, upper=NYLON, ics=AnalyticIcs(load_shape="bilinear"), friction=rolling())
    assert hats.pmax == pytest.approx(shared.solve(**BALL, upper=NYLON, friction=rolling()).pmax, rel=0.05)


def test_a_session_rolls_at_several_speeds(shared):
    slow, fast = (shared.solve(**BALL, upper=NYLON, friction=rolling(velocity)) for velocity in (200, 5000))
    assert fast.pmax > 1.1 * slow.pmax
    with shared.session(**BALL, upper=NYLON, friction=rolling(200)) as session:
        for velocity, alone in ((200, slow), (5000, fast), (200, slow)):
            step = session.step(friction=rolling(velocity))
            assert step.pmax == pytest.approx(alone.pmax, rel=1e-6)
            assert step.rolling_resistance.force == pytest.approx(alone.rolling_resistance.force, rel=1e-4)


def test_a_problem_is_saved_with_its_bodies(shared, tmp_path):
    problem = ContactProblem(**BALL, upper=NYLON, lower=Material(900, 0.2), friction=rolling())
    solution = shared.solve(problem)
    for value in (problem, solution):
        save(tmp_path / "value.h5", value)
    assert from_dict(to_dict(problem)).upper == NYLON
    assert load(tmp_path / "value.h5").rolling_resistance == solution.rolling_resistance
    assert NYLON.E == pytest.approx(2 * 1143 * 1.4)
    assert ViscoelasticBody(E=NYLON.E, nu=0.4, f=1, tau=5e-3) == NYLON


def test_stresses_of_bodies_that_creep_are_those_of_their_tractions(shared):
    problem = ContactProblem(**BALL, upper=NYLON, friction=rolling())
    solution = shared.solve(problem)
    block = StressBlock(0, 0, np.linspace(-5, 0, 6))
    elastic = problem.replace(upper=Material(1143, 0.4))
    found, expected = (shared.subsurface(one, solution, body="lower", block=block) for one in (problem, elastic))
    assert np.array_equal(found.von_mises, expected.von_mises)
    with pytest.raises(InvalidArgument, match="is viscoelastic"):
        shared.subsurface(problem, solution, body="lower", block=block, displacements=True)


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"friction": None}, "friction"),
        ({"friction": Friction(0.3, rigid_shift=(1e-3, 0))}, "friction.rolling"),
        ({"friction": rolling(kind="transient")}, "friction.rolling.kind"),
        ({"friction": rolling(chi=0.5)}, "friction.rolling.chi"),
        ({"derivatives": True}, "derivatives"),
        ({"model": "fastsim"}, "model"),
        ({"lower": LayeredBody([Layer(2, G=1, nu=0.5)], base=RigidBody())}, "bodies.lower.ics.body"),
        ({"ics": FemIcs(accuracy=1e-2)}, "bodies.upper.ics.source"),
    ],
)
def test_what_is_not_known_is_refused_by_its_field(shared, changes, field):
    with pytest.raises(InvalidArgument) as refused:
        shared.solve(**{**BALL, "upper": NYLON, "friction": rolling(), **changes})
    assert [violation.field for violation in refused.value.violations] == [field]


def test_a_velocity_that_was_left_out_is_warned_of(shared):
    with pytest.warns(ContactWarning, match=r"velocity is 1 mm/s"):
        shared.solve(**BALL, upper=dataclass_with(NYLON, tau=5), friction=Friction(0.3, rolling=Rolling(xi=2e-3)))
