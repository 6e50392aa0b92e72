"""Tests steps of sessions: their solutions, and that each number is answered once."""

import numpy as np
import pytest

from contactd import (
    Aborted,
    Cancelled,
    ConnectionFailed,
    Friction,
    Grid,
    InvalidArgument,
    Paraboloid,
    Rolling,
    SolverSettings,
    TimeoutExpired,
)
from support.daemons import eventually
from support.problems import CATTANEO, QUICK, STEEL
from support.sessions import ENDLESS, GRID, OPEN, open_session, take

FIELDS = ("pressure", "traction_x", "traction_y")


def problem(**changes):
    return CATTANEO.replace(grid=GRID, **changes)


def close_to(array, other):
    return np.abs(array - other).max() <= 1e-5 * np.abs(other).max()


# --- steps -----------------------------------------------------------------------------------------------------------


def test_a_step_answers_what_a_solve_does_without_the_arrays_that_nobody_asked_for(shared):
    solution = shared.solve(problem(friction=Friction(mu=0.4, rigid_shift=(0.004, 0))))
    with open_session(shared) as session:
        step = session.step(rigid_shift=(0.004, 0), fields=["pressure", "element_division"])
    assert (step.step, step.approach, step.Fn, step.Fx) == (1, solution.approach, solution.Fn, solution.Fx)
    assert step.motion == solution.motion
    assert step.area == solution.area
    np.testing.assert_array_equal(step.pressure, solution.pressure)
    np.testing.assert_array_equal(step.element_division, solution.element_division)
    assert not hasattr(step, "traction_x")
    assert not hasattr(step, "slip_x")


def test_shifts_follow_each_other_as_a_chain_of_solves_does(shared):
    shifts = [0.006, 0.001, -0.004, -0.004, 0.002]
    previous = None
    with open_session(shared) as session:
        for shift in shifts:
            step = session.step(rigid_shift=(shift, 0), fields=FIELDS)
            solution = shared.solve(problem(friction=Friction(mu=0.4, rigid_shift=(shift, 0)), previous=previous))
            previous = solution
            assert close_to(step.traction_x, solution.traction_x)
        memory = shared.solve(problem(friction=Friction(mu=0.4, rigid_shift=(sum(shifts), 0))))
    assert not close_to(step.traction_x, memory.traction_x), "hysteresis: the way matters"


def test_steps_of_transient_rolling_are_one_solve_with_many_steps(shared):
    rolling = Rolling(kind="transient", xi=2e-3, eta=1e-3, phi=1e-4)
    whole = shared.solve(problem(friction=Friction(mu=0.4, rolling=Rolling(**{**vars(rolling), "steps": 9}))))
    with open_session(shared, friction=Friction(mu=0.4, rolling=rolling)) as session:
        for _ in range(3):
            step = session.step(fields=FIELDS, steps=3)
    assert close_to(step.traction_x, whole.traction_x)
    assert close_to(step.traction_y, whole.traction_y)
    assert step.Fx == pytest.approx(whole.Fx, rel=1e-6)


def test_a_step_changes_load_gap_friction_and_motion_for_itself_only(shared):
    h = (GRID.x[None, :] ** 2 + GRID.y[:, None] ** 2) / 80
    with open_session(shared, friction=Friction(mu=0.4, rolling=Rolling(xi=1e-3))) as session:
        first = session.step()
        other = session.step(Fn=5, gap=h, mu=np.full(GRID.shape, 0.2), xi=-1e-3, dq=0.06, velocity=2)
        again = session.step()
    assert other.Fn == pytest.approx(5, rel=1e-6)
    assert other.motion == Rolling(xi=-1e-3, dq=0.06, spin_offset=0, steps=1, velocity=2)
    alone = shared.solve(
        problem(Fn=5, gap=h, friction=Friction(mu=0.2, rolling=Rolling(xi=-1e-3, dq=0.06, velocity=2)))
    )
    assert other.Fx == pytest.approx(alone.Fx, rel=1e-5)
    assert again.Fx == pytest.approx(first.Fx, rel=1e-5)


def test_a_step_has_the_derivatives_of_a_solve(shared):
    rolling = Rolling(xi=1e-3, kind="transient")
    with open_session(shared, friction=Friction(mu=0.4, rolling=rolling), derivatives=True) as session:
        first = session.step(fields=FIELDS)
        plain = session.step(derivatives=False, fields=FIELDS)
        third = session.step()
    assert plain.derivatives is None
    alone = shared.solve(problem(friction=Friction(mu=0.4, rolling=rolling), previous=plain, derivatives=True))
    assert third.derivatives.Fx.xi == pytest.approx(alone.derivatives.Fx.xi, rel=1e-4)
    assert third.derivatives.Fx.mu == pytest.approx(alone.derivatives.Fx.mu, rel=1e-3)
    assert first.derivatives.Fx.xi < 0


def test_a_step_in_another_direction_rolls_by_the_size_of_an_element_there(shared):
    grid = Grid.centred(24, 20, 2.4, 1.2)
    with open_session(shared, grid=grid, friction=Friction(mu=0.4, rolling=Rolling(xi=1e-3))) as session:
        along = session.step()
        across = session.step(xi=0, eta=1e-3, chi=np.pi / 2)
        ahead = session.step(phi=1e-3, spin_offset=1 / 6)
    assert along.motion.dq == grid.dx
    assert across.motion.dq == grid.dy
    assert ahead.motion.spin_offset == 1 / 6
    friction = Friction(mu=0.4, rolling=Rolling(eta=1e-3, chi=np.pi / 2))
    alone = shared.solve(CATTANEO.replace(grid=grid, friction=friction))
    assert across.Fy == pytest.approx(alone.Fy, rel=1e-5)
    assert across.evidence.discretisation.rolling_error > 0


def test_the_distance_of_a_time_step_is_no_dq(shared):
    friction = Friction(mu=0.4, rolling=Rolling(xi=1e-3, kind="transient"))
    with open_session(shared, friction=friction) as session:
        assert session.step().warnings == ()
        far = session.step(dq=20)
    assert any("friction.rolling.dq is 20 mm" in warning for warning in far.warnings)
    assert far.evidence.discretisation.rolling_error > 1


def test_a_force_found_before_is_where_the_next_search_starts(shared):
    with open_session(shared, friction=Friction(mu=0.4, rolling=Rolling(force=(-2.0, None)))) as session:
        cold = session.step()
        warm = session.step()
        free = session.step(force=(None, None))
    assert warm.Fx == pytest.approx(-2, rel=1e-5)
    assert warm.evidence.force.iterations < cold.evidence.force.iterations
    assert free.motion.xi == 0, "as the session was opened"
    assert free.motion.force is None


def test_what_session_open_leaves_out_every_step_must_name(shared):
    with open_session(shared, gap=None, approach=None, friction=None) as session:
        with pytest.raises(InvalidArgument, match="approach is missing"):
            session.step(gap=Paraboloid(50, 50))
        with pytest.raises(InvalidArgument, match="gap is missing"):
            session.step(Fn=5)
        with pytest.raises(InvalidArgument, match=r"friction\.mu is missing"):
            session.step(Fn=5, gap=Paraboloid(50, 50), rigid_shift=(0, 0))
        assert session.step(Fn=5, gap=Paraboloid(50, 50)).step == 1


def test_sessions_of_simplified_models_take_steps(shared):
    with open_session(shared, model="fastsim", friction=Friction(mu=0.4, rolling=Rolling())) as session:
        assert session.step(xi=1e-3).Fx < session.step(xi=0).Fx


def test_opening_waits_for_the_tables_and_steps_for_none(client):
    stages = []
    with open_session(
        client, grid=Grid(6, 6, 0.4, 0.4), upper=STEEL, ics=QUICK, on_progress=lambda p: stages.append(p.job)
    ) as session:
        assert session.ics["upper"].origin == "built"
        built = client.info().counters
        session.step(approach=1e-4)
        after = client.info().counters
    assert stages
    changed = {name for name in built if after[name] != built[name]} - {"requests", "solves"}
    assert not changed, "a step looks for no table"


# --- numbers ---------------------------------------------------------------------------------------------------------


def test_the_same_number_is_answered_again_byte_for_byte(raw, session):
    take(raw, session, 1)
    first = take(raw, session, 2, fields=["traction_x"])
    again = take(raw, session, 2, fields=["traction_x"])
    assert (again.result, again.frames) == (first.result, first.frames)


def test_the_same_number_while_it_runs_gets_the_same_answer(shared_daemon, raw, session):
    with shared_daemon.raw() as other:
        raw.send("session.step", {"session": session, "step": 1})
        other.send("session.step", {"session": session, "step": 1})
        first, second = raw.receive(), other.receive()
    assert first.result == second.result
    assert take(raw, session, 2).status == "OK"


@pytest.mark.parametrize("number", [1, 3, 7])
def test_another_number_is_refused_and_the_expected_one_told(raw, session, number):
    if number == 1:
        take(raw, session, 1)
        take(raw, session, 2)
    answer = take(raw, session, number)
    assert (answer.status, answer.reason, answer.fields) == ("FAILED_PRECONDITION", "STEP_OUT_OF_ORDER", ["step"])
    assert f"it must be {3 if number == 1 else 1}" in answer.message


def test_the_same_number_with_another_request_is_refused(raw, session):
    take(raw, session, 1)
    answer = take(raw, session, 1, approach=0.01)
    assert (answer.status, answer.reason) == ("FAILED_PRECONDITION", "STEP_DIFFERS")
    assert take(raw, session, 2).status == "OK"


@pytest.mark.parametrize(
    ("changes", "fields"),
    [
        ({"step": 0}, ["step"]),
        ({"step": 1.5}, ["step"]),
        ({"step": -3}, ["step"]),
        ({"session": ""}, ["session"]),
        ({"session": 7}, ["session"]),
        ({"approach": 0.01, "Fn": 1}, ["approach"]),
        ({"fields": ["pressures"]}, ["fields[0]"]),
        ({"friction": {"force": [1e9, None]}}, ["friction.force"]),
        ({"friction": {"mu": -1}}, ["friction.mu"]),
        ({"friction": {"rolling": {"dq": 1e9}}}, ["friction.rolling.dq"]),
        ({"gap": {"array": [[1.0]]}}, ["gap.array"]),
        ({"gap": {}}, ["gap"]),
        ({"grid": OPEN["grid"]}, ["grid"]),
        ({"bodies": {}}, ["bodies"]),
    ],
)
def test_a_step_that_cannot_be_used_leaves_the_session_as_it_was(raw, session, changes, fields):
    answer = raw.ask("session.step", {"session": session, "step": 1, **changes})
    assert (answer.status, answer.fields) == ("INVALID_ARGUMENT", fields), answer.envelope
    assert take(raw, session, 1).status == "OK"


@pytest.mark.parametrize(
    ("changes", "fields"),
    [
        ({"lease_seconds": 0}, ["lease_seconds"]),
        ({"lease_seconds": 1e6}, ["lease_seconds"]),
        ({"Fn": 1}, ["approach"]),
        ({"friction": {}}, ["friction.mu"]),
        ({"friction": {"mu": 1, "kinetic": {"mu": 2, "slip_velocity": 1}}}, ["friction.kinetic.mu"]),
        ({"bodies": {"upper": {"G": 200, "nu": 0.7}}}, ["bodies.upper.nu"]),
        ({"gap": {"array": [[0.0]]}}, ["gap.array"]),
        ({"initial": {}}, ["initial"]),
        ({"grid": {"nx": 4_000_000, "ny": 4, "dx": 1, "dy": 1}}, ["grid.nx"]),
    ],
)
def test_a_session_that_cannot_be_used_is_not_opened(raw, changes, fields):
    before = len(raw.ask("session.list").result["sessions"])
    answer = raw.ask("session.open", {**OPEN, **changes})
    assert (answer.status, answer.fields) == ("INVALID_ARGUMENT", fields), answer.envelope
    assert len(raw.ask("session.list").result["sessions"]) == before


def test_a_step_that_does_not_converge_leaves_the_session_as_it_was(shared):
    with open_session(shared, tangential=SolverSettings(max_iterations=1, tolerance=1e-12)) as session:
        with pytest.raises(Aborted, match="tangential after 1 iterations") as refused:
            session.step(rigid_shift=(0.004, 0))
        assert refused.value.reason == "NOT_CONVERGED"
        assert session.step(rigid_shift=(0, 0)).step == 1
    with open_session(
        shared, tangential=SolverSettings(max_iterations=1, tolerance=1e-12), accept_unconverged=True
    ) as session:
        assert not session.step(rigid_shift=(0.004, 0)).converged


def test_a_step_past_its_deadline_or_cancelled_leaves_the_session_as_it_was(client, background):
    with open_session(client, friction=ENDLESS) as session:
        session.retries = 0
        with pytest.raises(TimeoutExpired):
            session.step(timeout=0.3)
        eventually(lambda: not client.jobs())
        running = background(session.step)
        eventually(lambda: [job.state for job in client.jobs()] == ["running"])
        (job,) = client.jobs()
        assert job.kind == "step"
        client.cancel_job(job.job)
        with pytest.raises(Cancelled):
            running.result()
        assert [s.step for s in client.sessions()] == [0]
        assert session.step(steps=1).step == 1


def test_two_clients_on_one_session_take_turns(shared_daemon, raw, session):
    with shared_daemon.raw() as other:
        for step in range(1, 9, 2):
            assert take(raw, session, step).result["step"] == step
            assert take(other, session, step + 1).result["step"] == step + 1


def test_a_session_survives_its_client(shared_daemon, raw):
    with shared_daemon.raw() as doomed:
        name = doomed.ask("session.open", OPEN).result["session"]
        assert take(doomed, name, 1).status == "OK"
        doomed.send("session.step", {"session": name, "step": 2})
    answer = take(raw, name, 2)  # solved already, or now
    assert answer.result["step"] == 2
    assert raw.ask("session.close", {"session": name}).result == {"step": 2}


def test_the_answer_is_asked_for_again_when_it_does_not_come(shared, monkeypatch):
    with open_session(shared) as session:
        calls, exchange = [], type(shared)._exchange

        def lossy(self, request):
            reply = exchange(self, request)
            calls.append(request.envelope["params"].get("step"))
            if len(calls) == 1:
                raise ConnectionFailed("lost")
            return reply

        monkeypatch.setattr(type(shared), "_exchange", lossy)
        assert session.step(rigid_shift=(0.001, 0)).step == 1
        assert calls == [1, 1]
        monkeypatch.undo()
        assert session.step().step == 2
