"""Tests sessions of a wheel on its rail: their steps have the answers of wheelrail.solve, and they behave like other
sessions."""

from __future__ import annotations

import asyncio
import json
import math
import pickle
import threading

import numpy as np
import pytest

from contactd import (
    Aborted,
    AsyncClient,
    Cancelled,
    FailedPrecondition,
    InvalidArgument,
    NotFound,
    ResourceExhausted,
    SolverSettings,
    StepSolution,
    WheelRailStepSolution,
)
from contactd.wheel_rail import (
    ConeProfile,
    PatchRules,
    ProfilePoints,
    RailDeviation,
    Track,
    WheelRailFriction,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)
from support.daemons import eventually
from support.sessions import open_session

COARSE = WheelRailSetup(dx=0.8, dy=0.8)
#: Allowed differences of forces over the vertical one: the tolerances of the search for its height, and of the
#solvers.
CLOSE = 5e-6


def at(y: float, Fz: float | None = 1e4, z: float = 0.0, **more) -> WheelRailState:
    position = WheelsetPosition(y=y, z=z, yaw=2e-3 * math.cos(y), roll=-5e-5 * y)
    velocity = WheelsetVelocity(x=2000, y=10 * y, pitch=-2000 / 460)
    return WheelRailState(position=position, velocity=velocity, Fz=Fz, **more)


def agree(one, other, within: float = CLOSE):
    of_one, of_other = one.forces.track, other.forces.track
    size = max(1e4, abs(of_other.Fy), abs(of_other.Fz))  # prescribed heights may cause more than the usual load
    for name in ("Fx", "Fy", "Fz"):
        assert getattr(of_one, name) == pytest.approx(getattr(of_other, name), abs=within * size), name
    assert len(one.patches) == len(other.patches)
    for patch, expected in zip(one.patches, other.patches):
        assert patch.place.grid.shape == expected.place.grid.shape
        assert patch.place.reference.y == pytest.approx(expected.place.reference.y, abs=1e-3)
        assert patch.solution.pmax == pytest.approx(expected.solution.pmax, rel=1e-4)


@pytest.fixture
def wheel(shared):
    with shared.wheel_rail_session(COARSE) as session:
        yield session


SETUPS = {
    "coarse": COARSE,
    "left": COARSE.replace(side="left"),
    "fastsim": COARSE.replace(model="fastsim"),
    "frictionless": COARSE.replace(friction=None),
    "conformal": COARSE.replace(conformal="half_space"),
    "searched on a mesh": COARSE.replace(patches=PatchRules(search="mesh")),
    "roller": COARSE.replace(track=Track(roller_radius=500)),
}


@pytest.mark.parametrize("setup", SETUPS.values(), ids=list(SETUPS))
def test_steps_answer_what_the_method_without_state_does(shared, setup):
    sign = -1 if setup.side == "left" else 1
    states = [at(sign * y, Fz=1e4 + 500 * y) for y in (0.0, 0.4, 2.0, -3.0, 6.8, 7.2)]
    states += [at(0.1, Fz=None, z=0.21), at(0.1, Fz=None, z=-5.0)]
    with shared.wheel_rail_session(setup) as session:
        for number, state in enumerate(states, 1):
            solution = session.step(state)
            assert isinstance(solution, WheelRailStepSolution)
            assert (solution.step, session.step_number) == (number, number)
            agree(solution, shared.wheel_rail(setup, state, fields=[]))


@pytest.mark.parametrize("model", ["hertz", "fastsim"])
def test_at_a_given_height_a_simplified_model_answers_to_the_last_bit(shared, model):
    setup = COARSE.replace(model=model, friction=None if model == "hertz" else WheelRailFriction(0.3))
    state = at(1.0, Fz=None, z=0.21)
    with shared.wheel_rail_session(setup) as session:
        session.step(at(0.0))
        one, other = session.step(state, fields=["pressure"]), shared.wheel_rail(setup, state, fields=["pressure"])
    assert one.forces == other.forces
    np.testing.assert_array_equal(one.patches[0].solution.pressure, other.patches[0].solution.pressure)


def test_steps_that_follow_each_other_need_fewer_solves(shared, wheel):
    states = [at(2 + 0.01 * i) for i in range(12)]
    kept = sum(wheel.step(state).force.iterations for state in states)
    alone = sum(shared.wheel_rail(COARSE, state, fields=[]).force.iterations for state in states)
    assert kept < alone


def test_arrays_come_as_asked_for(wheel):
    assert not hasattr(wheel.step(at(0.0)).patches[0].solution, "pressure")
    (patch,) = wheel.step(at(0.0), fields="pressure", gap=True).patches
    assert patch.solution.pressure.shape == patch.gap.shape == patch.place.grid.shape
    assert not hasattr(patch.solution, "traction_x")


@pytest.mark.parametrize(("y", "z"), [(0.0, 0.25), (6.8, 0.25), (0.0, -5.0)], ids=["tread", "flange", "lifted"])
@pytest.mark.parametrize("model", ["full", "hertz", "fastsim"])
def test_a_step_without_patches_tells_all_else(shared, model, y, z):
    setup = COARSE.replace(model=model, friction=None if model == "hertz" else WheelRailFriction(0.3))
    state = at(y, Fz=None, z=z)
    with shared.wheel_rail_session(setup) as one, shared.wheel_rail_session(setup) as other:
        whole, short = one.step(state), other.step(state, patches=False)
    assert short.contacts == len(whole.patches)
    assert whole.contacts is None
    for name in ("z", "pitch_rate", "forces", "warnings", "converged", "clearance", "frictional_power", "step"):
        assert getattr(short, name) == getattr(whole, name), name
    powers = [patch.solution.frictional_power for patch in whole.patches if patch.solution.frictional_power is not None]
    assert short.frictional_power == (pytest.approx(sum(powers)) if powers else None)
    assert f"contacts {short.contacts}" in repr(short)
    with pytest.raises(AttributeError, match=r"this answer has no patches, because its step was called with patches=False"):
        short.patches  # noqa: B018


def test_the_step_after_one_without_patches_goes_on_from_it(shared):
    with shared.wheel_rail_session(COARSE) as one, shared.wheel_rail_session(COARSE) as other:
        one.step(at(1.0))
        other.step(at(1.0), patches=False)
        assert other.step(at(1.1)).forces == one.step(at(1.1)).forces


def test_an_answer_without_patches_is_pickled_and_not_saved(wheel):
    short = wheel.step(at(1.0), patches=False)
    again = pickle.loads(pickle.dumps(short))
    assert (again.forces, again.contacts) == (short.forces, 1)
    with pytest.raises(AttributeError, match="this answer has no patches"):
        short.to_dict()
    with pytest.raises(AttributeError, match="this answer has no patches"):
        short.plot()


@pytest.mark.parametrize(("asked", "field"), [({"fields": "pressure"}, "fields"), ({"gap": True}, "wheelrail.gap")])
def test_arrays_of_patches_that_are_left_out_are_refused(wheel, asked, field):
    with pytest.raises(InvalidArgument, match="wheelrail.patches excludes them") as raised:
        wheel.step(at(1.0), patches=False, **asked)
    assert raised.value.violations[0].field == field
    assert wheel.step(at(1.0)).step == 1


def test_friction_may_change_from_step_to_step(shared, wheel):
    wet = WheelRailFriction([(-1.0, 0.05), (0.0, 0.15)])
    dry, less, again = wheel.step(at(3.0)), wheel.step(at(3.0), friction=wet), wheel.step(at(3.0))
    agree(dry, again)
    agree(less, shared.wheel_rail(COARSE.replace(friction=wet), at(3.0), fields=[]))
    assert abs(less.forces.track.Fx) < abs(dry.forces.track.Fx) or less.forces.track.Fy != dry.forces.track.Fy


def test_rails_deviate_from_step_to_step(shared, wheel):
    state = at(1.0, rail=RailDeviation(y=0.7, z=0.2, z_velocity=5))
    wheel.step(at(1.0))
    agree(wheel.step(state), shared.wheel_rail(COARSE, state, fields=[]))


def test_derivatives_and_a_longitudinal_force_come_as_without_a_session(shared, wheel):
    state = at(1.0, Fx=200.0, derivatives=True)
    wheel.step(at(1.1))
    one, other = wheel.step(state), shared.wheel_rail(COARSE, state, fields=[])
    assert one.forces.wheelset.Fx == pytest.approx(200, abs=0.02)
    stiffness = one.derivatives.position.z.Fz
    assert stiffness == pytest.approx(other.derivatives.position.z.Fz, rel=1e-3)


# --- as sessions of contacts ------------------------------------------------------------------------------------------


def content_of(answer):
    """Returns the values that do not depend on the clock."""

    def bare(value):
        if isinstance(value, dict):
            return {name: bare(part) for name, part in value.items() if name != "seconds"}
        return [bare(part) for part in value] if isinstance(value, list) else value

    return bare(answer.result), answer.frames


def step_params(session: str, step: int, y: float = 1.0, **more):
    state = {"position": {"y": y}, "velocity": {"x": 2000, "pitch": -4.3}, "Fz": 1e4}
    return {"session": session, "step": step, "wheelrail": {"state": state}, "fields": ["pressure"], **more}


@pytest.fixture
def name(raw):
    session = raw.ask("session.open", {"wheelrail": {"setup": {"dx": 0.8, "dy": 0.8, "friction": {"mu": 0.3}}}}).result
    yield session["session"]
    raw.ask("session.close", {"session": session["session"]})


def test_restore_gives_the_same_answers_bit_for_bit(raw, name):
    raw.ask("session.step", step_params(name, 1, 0.5))
    state = {"session": name, "state": raw.ask("session.save", {"session": name}).result["state"]}
    first = [content_of(raw.ask("session.step", step_params(name, 2 + i, 1.0 + i))) for i in range(3)]
    assert raw.ask("session.restore", state).result == {"step": 1}
    assert [content_of(raw.ask("session.step", step_params(name, 2 + i, 1.0 + i))) for i in range(3)] == first
    assert raw.ask("session.forget", state).result == {"states": 0}


def test_a_step_asked_for_again_is_answered_byte_for_byte_and_others_are_refused(raw, name):
    first = raw.ask("session.step", step_params(name, 1))
    again = raw.ask("session.step", step_params(name, 1))
    assert (again.result, again.frames) == (first.result, first.frames)
    assert raw.ask("session.step", step_params(name, 1, 2.0)).reason == "STEP_DIFFERS"
    assert raw.ask("session.step", step_params(name, 3)).reason == "STEP_OUT_OF_ORDER"


def test_a_step_tried_again_starts_where_the_one_before_did(raw, name):
    raw.ask("session.step", step_params(name, 1))
    alone = content_of(raw.ask("session.step", step_params(name, 2, 3.0)))
    raw.ask("session.step", step_params(name, 2, 5.0, again=True))
    assert content_of(raw.ask("session.step", step_params(name, 2, 3.0, again=True))) == alone


def test_who_joins_goes_on_where_the_other_was(shared, wheel):
    wheel.step(at(0.0))
    other = shared.join_wheel_rail_session(wheel.name)
    assert (other.step_number, other.side, other.lease_seconds) == (1, "right", wheel.lease_seconds)
    assert other.step(at(0.5)).step == 2
    with pytest.raises(FailedPrecondition):
        wheel.step(at(0.7))
    with pytest.raises(InvalidArgument, match="name belongs to the session of a wheel on its rail"):
        shared.join_session(wheel.name)
    with open_session(shared) as contact, pytest.raises(InvalidArgument, match="name belongs to the session of a contact"):
        shared.join_wheel_rail_session(contact.name)


def test_sessions_are_listed_and_end(shared):
    with shared.wheel_rail_session(COARSE, lease=100) as session:
        assert shared.sessions()[-1].elements == 0
        patches = session.step(at(0.0)).patches
        summary = shared.sessions()[-1]
        assert summary.elements == sum(patch.place.grid.nx * patch.place.grid.ny for patch in patches)
        assert (summary.step, summary.lease_seconds) == (1, 100)
        before = summary.bytes
        session.save()
        assert shared.sessions()[-1].bytes > before
    with pytest.raises(NotFound):
        session.step(at(0.0))


def test_a_step_that_misses_its_tolerance_leaves_the_session_where_it_was(shared):
    hopeless = COARSE.replace(force=SolverSettings(tolerance=1e-14, max_iterations=2))
    with shared.wheel_rail_session(hopeless) as session:
        with pytest.raises(Aborted, match="the search for z after 2 iterations"):
            session.step(at(1.0))
        assert session.step(at(1.0, Fz=None, z=0.2)).step == 1
    with shared.wheel_rail_session(hopeless, accept_unconverged=True) as session:
        assert not session.step(at(1.0)).converged


def test_limits_hold_for_these_sessions_too(daemons):
    daemon = daemons.start(sessions={"max_sessions": 1})
    with daemon.client() as client, client.wheel_rail_session(COARSE):
        with pytest.raises(ResourceExhausted, match="the largest number allowed"):
            client.wheel_rail_session(COARSE)


def test_contacts_and_wheels_step_in_one_message(shared):
    left = COARSE.replace(side="left")
    with (
        shared.wheel_rail_session(COARSE) as one,
        open_session(shared) as contact,
        shared.wheel_rail_session(left) as two,
        shared.wheel_rail_session(COARSE) as alone,
    ):
        steps = [(one, {"state": at(1.0)}), (contact, {"rigid_shift": (0.001, 0)}), (two, {"state": at(1.0, z=50, Fz=None)})]
        right, shifted, refused = shared.step_many(steps)
        assert right.forces == alone.step(at(1.0)).forces
        assert isinstance(shifted, StepSolution)
        assert isinstance(refused, InvalidArgument)
        assert refused.violations[0].field == "wheelrail.state.position.z"
        assert (one.step_number, contact.step_number, two.step_number) == (1, 1, 0)
        answers = shared.step_many([(one, {"state": at(1.2), "again": True}), (two, {"state": at(-1.2)})])
        assert [answer.step for answer in answers] == [1, 1]
        with pytest.raises(TypeError, match=r"steps\[0\] has Fn, which WheelRailSession.step does not support"):
            shared.step_many([(one, {"Fn": 1})])


def test_the_same_calls_are_awaited(shared_daemon, shared):
    async def run():
        async with AsyncClient(shared_daemon.endpoint) as client, await client.wheel_rail_session(COARSE) as session:
            first = await session.step(at(1.0))
            (second,) = await client.step_many([(session, {"state": at(1.1)})])
            joined = await client.join_wheel_rail_session(session.name)
            return first, second, joined.step_number

    first, second, number = asyncio.run(run())
    assert (first.step, second.step, number) == (1, 2, 2)
    agree(second, shared.wheel_rail(COARSE, at(1.1), fields=[]))


def test_a_running_step_ends_with_its_session(shared):
    endless = WheelRailSetup(dx=0.05, dy=0.05, force=SolverSettings(tolerance=1e-15, max_iterations=1000))
    session = shared.wheel_rail_session(endless)
    raised: list[BaseException] = []

    def step():
        try:
            session.step(at(1.0, derivatives=True))
        except BaseException as error:
            raised.append(error)

    thread = threading.Thread(target=step)
    thread.start()
    eventually(lambda: any(job.kind == "step" and job.state == "running" for job in shared.jobs()))
    session.close()
    thread.join()
    assert isinstance(raised[0], Cancelled)


# --- mistakes ---------------------------------------------------------------------------------------------------------

MISTAKES = [
    ({"setup": {"track": {"gauge": -1}}}, "wheelrail.setup.track.gauge"),
    ({"setup": {"dx": 0}}, "wheelrail.setup.dx"),
    ({"setup": {"side": "middle"}}, "wheelrail.setup.side"),
    ({"setup": {"rail": {"points": [[0, 0]]}}}, "wheelrail.setup.rail.points"),
    ({"setup": {"dy": 1e300}}, "wheelrail.setup.dy"),
    ({"set_up": {}}, "wheelrail"),
]


@pytest.mark.parametrize(("wheelrail", "field"), MISTAKES, ids=[field for _, field in MISTAKES])
def test_a_set_up_that_cannot_be_used_opens_nothing(raw, wheelrail, field):
    before = len(raw.ask("session.list", {}).result["sessions"])
    answer = raw.ask("session.open", {"wheelrail": wheelrail})
    assert answer.status == "INVALID_ARGUMENT"
    violation = answer.envelope["status"]["details"]["violations"][0]["field"]
    assert violation.startswith(field)
    assert len(raw.ask("session.list", {}).result["sessions"]) == before


def violation_of(answer) -> str:
    assert answer.status == "INVALID_ARGUMENT", answer.envelope
    return str(answer.envelope["status"]["details"]["violations"][0]["field"])


def test_openings_and_steps_are_of_one_kind(raw, name, session):
    assert violation_of(raw.ask("session.open", {"wheelrail": {}, "grid": {"nx": 1, "ny": 1, "dx": 1, "dy": 1}})) == "grid"
    assert violation_of(raw.ask("session.step", {"session": name, "step": 1, "approach": 0.1})) == "wheelrail"
    assert violation_of(raw.ask("session.step", step_params(session, 1))) == "wheelrail"
    assert violation_of(raw.ask("session.step", step_params(name, 1, Fn=3.0))) == "Fn"
    assert raw.ask("session.step", step_params(name, 1)).status == "OK"


STEPS = [
    ({"state": {"position": {"z": 20}}}, "wheelrail.state.position.z"),
    ({"state": {"Fz": -1}}, "wheelrail.state.Fz"),
    ({"state": {"position": {"y": 1e300}}}, "wheelrail.state.position.y"),
    ({"state": {}, "friction": {"mu": []}}, "wheelrail.friction.mu"),
    ({"state": {}, "friction": {"mu": [{"angle": 1, "mu": 0.1}, {"angle": 0, "mu": 0.1}]}}, "wheelrail.friction.mu"),
    ({"friction": {"mu": 0.3}}, "wheelrail.state"),
    ({"state": {}, "gap": "yes"}, "wheelrail.gap"),
    ({"state": {}, "patches": 0}, "wheelrail.patches"),
]


@pytest.mark.parametrize(("wheelrail", "field"), STEPS, ids=[field for _, field in STEPS])
def test_a_step_that_cannot_be_taken_is_refused_by_name_and_moves_nothing(raw, name, wheelrail, field):
    answer = raw.ask("session.step", {"session": name, "step": 1, "wheelrail": wheelrail})
    assert violation_of(answer).startswith(field)
    assert raw.ask("session.info", {"session": name}).result["step"] == 0


def test_a_patch_of_too_many_elements_is_refused_by_name(daemons):
    daemon = daemons.start(limits={"max_grid_elements": 100})
    with daemon.client() as client, client.wheel_rail_session(COARSE) as session:
        with pytest.raises(InvalidArgument, match="^wheelrail.setup.dx and dy result in a patch of"):
            session.step(at(0.0))
        assert session.step_number == 0


def test_numbers_that_are_none_are_refused(raw, name):
    text = json.dumps({"session": name, "step": 1, "wheelrail": {"state": {"Fz": math.nan}}})
    answer = raw.ask("session.step", json.loads(text.replace("NaN", "null")))
    assert violation_of(answer) == "wheelrail.state.Fz"


def test_profiles_of_points_are_sent_with_the_opening_only(shared):
    y = np.linspace(-30, 30, 601)
    arc = ProfilePoints(np.column_stack([y, 300 - np.sqrt(300**2 - y**2)]))
    setup = COARSE.replace(wheel=ConeProfile(-0.05), rail=arc, track=Track(rail_origin=(750, 0)))
    with shared.wheel_rail_session(setup) as session:
        for state in (at(0.0), at(1.0)):
            agree(session.step(state), shared.wheel_rail(setup, state, fields=[]))
