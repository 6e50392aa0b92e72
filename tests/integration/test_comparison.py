"""Compares all contact models for one case: results, errors, and reasons of refusals."""

import asyncio
import warnings

import numpy as np
import pytest

import contactd
from contactd import (
    AsyncClient,
    ContactProblem,
    ContactWarning,
    Friction,
    Grid,
    InterfacialLayer,
    InvalidArgument,
    KineticFriction,
    Material,
    ModelComparison,
    Paraboloid,
    Rolling,
    SimplifiedSettings,
)
from contactd.values.contact_params import problem_params
from contactd.values.generated.evidence import Model
from contactd.values.wheel_rail.comparison import combinations
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

STEEL = Material(82000, 0.28)
PROBLEM = ContactProblem(
    grid=Grid.centred(24, 24, 12, 10), upper=STEEL, gap=Paraboloid(460, 300), Fn=30000,
    friction=Friction(0.35, rolling=Rolling(xi=1.1e-3, eta=-7e-4, phi=1e-4, dq=0.5)),
)  # fmt: skip


@pytest.fixture(scope="module")
def found(shared_daemon):
    with shared_daemon.client() as client:
        return client.compare(PROBLEM)


def test_each_model_answers_what_it_answers_alone(shared, found):
    for one in found.computed:
        alone = shared.solve(PROBLEM.replace(model=one.model, normal_model=one.normal_model))
        assert (one.solution.Fx, one.solution.Fy, one.solution.pmax) == (alone.Fx, alone.Fy, alone.pmax), one.name
        np.testing.assert_array_equal(one.solution.pressure, alone.pressure)
        assert one.solution.converged
        assert one.seconds > 0


def test_all_combinations_are_there():
    words = {f"{normal}+{model}" for normal in ("kp", "kpec", "analyn") for model in Model.__args__}
    expected = set(Model.__args__) | {word for word in words if not word.endswith("hertz")}
    assert set(combinations()) == expected


def test_errors_are_those_against_the_full_theory(found):
    full, quick = found["full"], found["fastsim"]
    bound = 0.35 * full.solution.Fn
    assert quick.errors.Fx == (quick.solution.Fx - full.solution.Fx) / bound
    assert quick.errors.Fy == (quick.solution.Fy - full.solution.Fy) / bound
    assert quick.errors.force == np.hypot(quick.errors.Fx, quick.errors.Fy)
    assert quick.errors.pmax == quick.solution.pmax / full.solution.pmax - 1
    apart = np.count_nonzero((quick.solution.pressure > 0) != (full.solution.pressure > 0))
    assert quick.errors.patch == apart / full.solution.elements.contact
    assert full.errors.force == full.errors.patch == 0
    assert 0 < quick.errors.force < 0.06
    assert found["polach"].errors.Mz == pytest.approx(-full.solution.Mz / (bound * np.sqrt(full.solution.area.contact / np.pi)))


def test_a_model_that_refuses_says_why(shared, found):
    assert found["hertz"].solution is None
    assert "spin" in found["hertz"].refusal
    assert found["hertz"] in found.refused
    layered = PROBLEM.replace(friction=Friction(0.35, rolling=Rolling(xi=1e-3, dq=0.5), layer=InterfacialLayer(1e-5)))
    alone = shared.compare(layered, models=["fastsim", "kpec+full"])
    assert [one.name for one in alone.models] == ["full", "fastsim", "kpec+full"]
    assert alone["fastsim"].refusal.startswith("friction.layer")
    assert alone["full"].solution.converged


def test_a_case_that_no_model_computes_is_an_error(shared):
    rising = Friction(0.2, kinetic=KineticFriction(mu=0.3, slip_velocity=10), rolling=Rolling(xi=1e-3))
    with pytest.raises(InvalidArgument, match=r"friction\.kinetic\.mu"):
        shared.compare(PROBLEM.replace(friction=rising))
    with pytest.raises(ValueError, match="models has 'fastest'; it must contain names from full, hertz"):
        shared.compare(PROBLEM, models=["fastest"])
    with pytest.raises(ValueError, match="repeats is 0"):
        shared.compare(PROBLEM, repeats=0)
    with pytest.raises(TypeError, match="problem is 3"):
        shared.compare(3)


def test_options_of_simplified_go_to_the_models_that_have_them(shared):
    problem = PROBLEM.replace(model="polach", simplified=SimplifiedSettings(k_adhesion=0.6, k_slip=0.4))
    found = shared.compare(problem, models=["fastsim", "polach"])
    assert found["polach"].left_out == ()
    assert found["fastsim"].left_out == ("k_adhesion", "k_slip")
    assert found["polach"].solution.Fx == shared.solve(problem).Fx
    assert found["full"].solution.Fx == shared.solve(PROBLEM).Fx


def test_a_case_of_a_simplified_model_is_one_of_half_spaces(shared):
    params = problem_params(PROBLEM)
    del params["ics"]
    assert shared.compare({**params, "model": "fastsim"}, models=["fastsim"])["full"].solution.Fx == shared.solve(PROBLEM).Fx


def test_without_friction_pressures_are_compared(shared):
    found = shared.compare(PROBLEM.replace(friction=None))
    assert [one.name for one in found.models] == ["full", "hertz", "kp+full", "kpec+full", "analyn+full"]
    assert found["hertz"].errors.force is None
    assert abs(found["hertz"].errors.pmax) < 0.01 < abs(found["kp+full"].errors.pmax)


def test_where_forces_are_prescribed_creepages_are_compared(shared):
    rolling = Rolling(eta=-7e-4, dq=0.5, force=(-3000, None))
    found = shared.compare(PROBLEM.replace(friction=Friction(0.35, rolling=rolling)), models=["fastsim"])
    xi = [found[name].solution.motion.xi for name in ("full", "fastsim")]
    assert found["fastsim"].errors.creepage == pytest.approx(abs(xi[1] - xi[0]) / np.hypot(xi[0], 7e-4))
    assert found["fastsim"].errors.Fx == pytest.approx(0, abs=1e-5)


def test_warnings_say_which_model_they_are_of(shared):
    concave = 1e-3 * PROBLEM.grid.x[None, :] ** 2 + 1e-5 * PROBLEM.grid.y[:, None] ** 4
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        shared.compare(PROBLEM.replace(gap=concave), models=["analyn+fastsim"])
    (given,) = [one.message for one in caught if isinstance(one.message, ContactWarning)]
    assert any(sentence.startswith("analyn+fastsim: ") for sentence in given.sentences)


def test_a_wheel_on_its_rail_is_compared(shared):
    setup = WheelRailSetup(dx=0.6, dy=0.6)
    state = WheelRailState(Fz=80e3, position=WheelsetPosition(y=3, yaw=0.002), velocity=WheelsetVelocity(x=20e3, pitch=-43.478))
    found = shared.compare_wheel_rail(setup, state, models=["hertz", "fastsim", "kpec+full"])
    full, quick = found["full"].solution, found["fastsim"].solution
    alone = shared.wheel_rail(setup.replace(model="fastsim"), state)
    assert quick.forces == alone.forces
    normal = sum(patch.solution.Fn for patch in full.patches)
    assert found["fastsim"].errors.Fx == (quick.forces.track.Fx - full.forces.track.Fx) / (0.3 * normal)
    assert found["fastsim"].errors.approach == quick.z - full.z
    assert "spin" in found["hertz"].refusal
    assert abs(found["kpec+full"].errors.Fy) < 0.05


def test_the_answer_in_process_is_the_same(found):
    with contactd.local(in_process=True) as client:
        here = client.compare(PROBLEM)
    assert [one.name for one in here.models] == [one.name for one in found.models]
    for one, other in zip(here.models, found.models):
        assert one.refusal == other.refusal
        assert one.errors == other.errors


def test_an_asynchronous_client_compares_too(shared_daemon, found):
    async def compared() -> ModelComparison:
        async with AsyncClient(shared_daemon.endpoint) as client:
            return await client.compare(PROBLEM, models=["fastsim"])

    assert asyncio.run(compared())["fastsim"].errors == found["fastsim"].errors


def test_news_come_model_by_model(shared):
    stages = []
    shared.compare(PROBLEM, models=["fastsim"], repeats=1, on_progress=lambda progress: stages.append((progress.stage, progress.fraction)))
    assert stages == [("full", 0), ("fastsim", 0.5)]


def test_it_shows_itself(found):
    assert "fastsim force off by" in repr(found)
    assert "hertz" in found._repr_html_()
    with pytest.raises(KeyError):
        found["fastest"]
