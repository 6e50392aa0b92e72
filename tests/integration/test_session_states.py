"""Tests sessions: saved states, leases, ends and limits."""

import pytest

from contactd import Cancelled, Grid, NotFound, ResourceExhausted, TimeoutExpired
from support.daemons import eventually
from support.problems import LONG, STEEL
from support.sessions import ENDLESS, OPEN, open_session, take

FIELDS = ["pressure", "traction_x", "traction_y"]

# --- states ----------------------------------------------------------------------------------------------------------


def test_restore_goes_back_as_often_as_wanted_and_gives_the_same_answers_bit_for_bit(raw, session):
    def steps(first):
        shifts = [0.004, -0.002, 0.001]
        answers = [
            take(raw, session, first + i, friction={"rigid_shift": [shift, 0]}, fields=FIELDS)
            for i, shift in enumerate(shifts)
        ]
        for answer in answers:
            for evidence in answer.result["evidence"].values():
                if isinstance(evidence, dict):  # not the keyword of a solver
                    evidence.pop("seconds", None)  # the discretisation has none
        return [(answer.result, answer.frames) for answer in answers]

    take(raw, session, 1)
    saved = raw.ask("session.save", {"session": session}).result
    assert saved["step"] == 1
    first = steps(2)
    for _ in range(2):
        state = {"session": session, "state": saved["state"]}
        assert raw.ask("session.restore", state).result == {"step": 1}
        assert steps(2) == first
    assert raw.ask("session.forget", state).result == {"states": 0}
    answer = raw.ask("session.restore", state)
    assert (answer.status, answer.reason) == ("NOT_FOUND", "STATE_UNKNOWN")
    assert raw.ask("session.forget", state).reason == "STATE_UNKNOWN"
    assert take(raw, session, 5).status == "OK", "still where the steps led"


def test_a_restored_step_is_answered_again_under_its_number(raw, session):
    first = take(raw, session, 1)
    saved = raw.ask("session.save", {"session": session}).result
    take(raw, session, 2)
    raw.ask("session.restore", {"session": session, "state": saved["state"]})
    assert take(raw, session, 1).result == first.result


def test_the_client_counts_on_from_a_restored_state(shared):
    with open_session(shared) as session:
        start = session.save()
        session.step(rigid_shift=(0.004, 0))
        there = session.save()
        assert (start.step, there.step) == (0, 1)
        session.restore(start)
        assert session.step(rigid_shift=(0.001, 0)).step == 1
        session.restore(there)
        assert session.step().step == 2
        session.forget(start)
        with pytest.raises(NotFound):
            session.restore(start)
        for wrong in (session.restore, session.forget):
            with pytest.raises(TypeError, match="state is 'yesterday'; it must be of type SavedState"):
                wrong("yesterday")


# --- the end of sessions, and limits ---------------------------------------------------------------------------------


def test_a_session_ends_when_nobody_uses_it_for_its_lease(daemon, client):
    idle, used = open_session(client, lease=0.3), open_session(client, lease=0.3)
    assert idle.lease_seconds == 0.3

    def expired():
        used.step()
        return len(client.sessions()) == 1

    eventually(expired)
    with pytest.raises(NotFound) as refused:
        idle.step()
    assert refused.value.reason == "SESSION_EXPIRED"
    assert used.step().step > 1
    eventually(lambda: not client.sessions())
    with pytest.raises(NotFound):
        used.close()


def test_a_closed_session_is_unknown(shared):
    session = open_session(shared)
    session.step()
    session.close()
    for use in (session.step, session.save, session.close):
        with pytest.raises(NotFound) as refused:
            use()
        assert refused.value.reason == "SESSION_UNKNOWN"


def test_closing_cancels_the_step_that_runs(client, background):
    session = open_session(client, friction=ENDLESS)
    running = background(session.step)
    eventually(lambda: [job.state for job in client.jobs()] == ["running"])
    session.close()
    with pytest.raises(Cancelled):
        running.result()
    eventually(lambda: not client.jobs())
    assert not client.sessions()


def test_names_are_not_listed_and_cannot_be_guessed(raw):
    names = [raw.ask("session.open", OPEN).result["session"] for _ in range(5)]
    listed = raw.ask("session.list").envelope
    assert len(set(names)) == 5
    assert all(len(name) == 32 and name not in str(listed) for name in names)
    for name in names:
        raw.ask("session.close", {"session": name})


def test_sessions_states_and_their_bytes_are_limited(daemons):
    limits = {"max_sessions": 2, "max_states": 1, "max_bytes": 3_000_000}
    daemon = daemons.start(sessions=limits)
    with daemon.client() as client:
        assert client.call("server.info")["limits"]["max_sessions"] == 2
        with open_session(client) as first, open_session(client):
            with pytest.raises(ResourceExhausted, match=r"limits\.max_sessions"):
                open_session(client)
            state = first.save()
            with pytest.raises(ResourceExhausted, match=r"limits\.max_session_states"):
                first.save()
            first.forget(state)
            first.save()
            assert first.step().step == 1
        with pytest.raises(ResourceExhausted, match=r"limits\.max_session_bytes") as refused:
            open_session(client, grid=Grid.centred(40, 60, 2.4, 2.4))
        assert refused.value.reason == "SESSION_LIMIT"
        assert not client.sessions()


def test_a_build_that_takes_too_long_opens_no_session(client):
    with pytest.raises(TimeoutExpired):
        open_session(client, upper=STEEL, ics=LONG, timeout=0.5)
    assert not client.sessions()
    for job in client.jobs():
        client.cancel_job(job.job)
