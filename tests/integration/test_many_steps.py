"""Tests steps of several sessions in one message, by a real daemon."""

import threading
from contextlib import ExitStack

import numpy as np
import pytest

from contactd import (
    Aborted,
    Client,
    ConnectionFailed,
    Friction,
    InvalidArgument,
    NotFound,
    Rolling,
    SolverSettings,
    StepSolution,
    TimeoutExpired,
)
from support.daemons import eventually
from support.sessions import ENDLESS, GRID, open_session

FIELDS = ["element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y"]
ROLLING = Friction(mu=0.3, rolling=Rolling(kind="transient"))


@pytest.fixture
def opened(shared):
    """opened(n, ...) returns n sessions of `shared`."""
    with ExitStack() as sessions:
        yield lambda count, **changes: [sessions.enter_context(open_session(shared, **changes)) for _ in range(count)]


def same(one, other):
    assert (one.step, one.forces, one.approach, one.motion, one.area) == (
        other.step, other.forces, other.approach, other.motion, other.area
    )  # fmt: skip
    for name in FIELDS:
        array, expected = getattr(one, name, None), getattr(other, name, None)
        assert (array is None) == (expected is None)
        assert array is None or array.tobytes() == expected.tobytes()


def test_steps_of_many_sessions_are_those_of_each_alone_to_the_last_bit(shared, opened):
    kinds = [{}, {"friction": ROLLING}, {"friction": None}, {"model": "fastsim", "friction": Friction(0.3, rolling=Rolling())}]
    together, alone = ([opened(1, **kind)[0] for kind in kinds] for _ in range(2))
    gap = (GRID.x[None, :] ** 2 + GRID.y[:, None] ** 2) / 90
    rounds = [
        [{"rigid_shift": (0.004, 0)}, {"xi": 1e-3}, {"Fn": 5}, {"xi": 1e-3, "fields": "pressure"}],
        [{"rigid_shift": (-0.001, 0.002)}, {"xi": 1e-3, "eta": 1e-3, "steps": 2}, {"approach": 0.01}, {"eta": 1e-3}],
        [{"force": (-2.0, None)}, {"gap": gap, "Fn": 6, "xi": 2e-3}, {"gap": gap}, {"phi": 0.1, "fields": FIELDS}],
    ]
    for inputs in rounds:
        inputs = [{"fields": FIELDS, **step_input} for step_input in inputs]
        for one, session, step_input in zip(shared.step_many(zip(together, inputs)), alone, inputs):
            assert isinstance(one, StepSolution)
            same(one, session.step(**step_input))


def test_eighty_sessions_step_in_one_message_in_order(shared, opened):
    sessions = opened(80, friction=None)
    loads = [1 + 0.1 * i for i in range(80)]
    solutions = shared.step_many([(session, {"Fn": load}) for session, load in zip(sessions, loads)])
    assert [solution.Fn for solution in solutions] == pytest.approx(loads, rel=1e-5)


def test_one_that_fails_stays_where_it_was_and_the_others_step(shared, opened):
    good, bad, gone = opened(3)
    (strict,) = opened(1, tangential=SolverSettings(max_iterations=1, tolerance=1e-12))
    gone.close()
    shift, too_far = {"rigid_shift": (0.004, 0)}, {"friction": Friction(mu=0.4, rolling=Rolling(dq=1e9))}
    answers = shared.step_many([(good, shift), (bad, too_far), (gone, shift), (strict, shift)])
    assert [type(answer) for answer in answers] == [StepSolution, InvalidArgument, NotFound, Aborted]
    assert answers[1].violations[0].field == "friction.rolling.dq"
    assert (answers[2].reason, answers[3].reason) == ("SESSION_UNKNOWN", "NOT_CONVERGED")
    assert [shared.join_session(session.name).step_number for session in (good, bad, strict)] == [1, 0, 0]
    still = {"rigid_shift": (0, 0)}
    answers = shared.step_many([(good, still), (bad, still), (strict, still)])
    assert [answer.step for answer in answers] == [2, 1, 1]


def test_the_whole_is_tried_again_until_all_please(shared, opened):
    first, second, straight = opened(3)
    refused = {"friction": Friction(mu=0.4, rolling=Rolling(dq=1e9))}
    shared.step_many([(first, {"rigid_shift": (0.003, 0)}), (second, {"rigid_shift": (0.003, 0)})])
    shared.step_many([(first, {"rigid_shift": (0.002, 0)}), (second, refused)])
    for shift in (-0.001, 0.001):
        step_input = {"rigid_shift": (shift, 0), "fields": FIELDS, "again": True}
        tried = shared.step_many([(first, step_input), (second, step_input)])
    straight.step(rigid_shift=(0.003, 0))
    expected = straight.step(rigid_shift=(0.001, 0), fields=FIELDS)
    for solution in tried:
        same(solution, expected)


def test_single_steps_and_steps_of_many_take_turns(shared, opened):
    one, two = opened(2)
    shared.step_many([(one, {}), (two, {})])
    one.step()
    state = two.save()
    assert [answer.step for answer in shared.step_many([(one, {}), (two, {})])] == [3, 2]
    two.restore(state)
    assert [answer.step for answer in shared.step_many([(one, {"again": True}), (two, {})])] == [3, 2]


def test_a_lost_answer_is_heard_again_and_not_solved_again(shared, opened, monkeypatch):
    sessions = opened(3)
    gap = (GRID.x[None, :] ** 2 + GRID.y[:, None] ** 2) / 90
    replies, exchange = [], Client._exchange

    def lossy(self, request):
        reply = exchange(self, request)
        if request.method != "session.step_many":
            return reply
        replies.append(reply)
        if len(replies) == 1:
            raise ConnectionFailed("lost")
        return reply

    monkeypatch.setattr(Client, "_exchange", lossy)
    step_input = {"gap": gap, "fields": ["pressure"]}
    solutions = shared.step_many([(session, step_input) for session in sessions])
    monkeypatch.undo()
    assert [solution.step for solution in solutions] == [1, 1, 1]
    assert replies[0].result == replies[1].result, "the seconds that it took, too"
    assert list(replies[0].frames) == list(replies[1].frames)
    assert shared.step_many([(sessions[0], {})])[0].step == 2


def test_when_the_whole_is_too_late_the_same_steps_go_on_and_others_by_again(client):
    with open_session(client) as quick, open_session(client, friction=ENDLESS) as slow:
        with pytest.raises(TimeoutExpired):
            client.step_many([(quick, {}), (slow, {})], timeout=0.5)
        eventually(lambda: not client.jobs())
        assert client.join_session(quick.name).step_number == 1, "it had its turn"
        assert quick.step_number == 0, "no answer has come"
        assert [answer.step for answer in client.step_many([(quick, {}), (slow, {"steps": 1})])] == [1, 1]
        answers = client.step_many([(quick, {"approach": 0.01, "again": True}), (slow, {"steps": 2, "again": True})])
        assert [answer.step for answer in answers] == [1, 1]


def test_threads_step_sessions_of_their_own_at_the_same_time(shared, opened):
    groups = [opened(3) for _ in range(6)]
    shifts = np.linspace(-0.004, 0.004, 7)
    forces = [[] for _ in groups]

    def drive(group, found):
        for shift in shifts:
            answers = shared.step_many([(session, {"rigid_shift": (shift, 0)}) for session in group])
            found.append([answer.Fx for answer in answers])

    threads = [threading.Thread(target=drive, args=pair) for pair in zip(groups, forces)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    (alone,) = opened(1)
    expected = [[alone.step(rigid_shift=(shift, 0)).Fx] * 3 for shift in shifts]
    assert forces == [expected] * len(groups)
