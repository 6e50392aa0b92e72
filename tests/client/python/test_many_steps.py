"""Tests steps of several sessions in one message: requests, refusals, and access of threads."""

import os
import threading

import numpy as np
import pytest

from contactd import (
    Client,
    ConnectionFailed,
    ContactdError,
    FailedPrecondition,
    Grid,
    InvalidArgument,
    Material,
    NotFound,
    ProtocolError,
    Session,
    StepSolution,
    TimeoutExpired,
)
from support import answers
from support.fake_server import FakeServer
from support.processes import in_fork
from support.sessions import STEP, opened

# The server of these tests runs in a thread of the parent; the children never use it.
pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")

GRID = Grid(3, 2, 1, 1)
OK = {"code": 0, "name": "OK", "message": ""}
FAILED = {"code": 9, "name": "FAILED_PRECONDITION", "message": "Too much."}
TOO_MUCH = 1e9


class Fake:
    """Provides a daemon that accepts all steps except those with excessive forces, and three sessions of one
    client."""

    def __init__(self, folder):
        self.opened = 0
        self.meanwhile = lambda request: None
        self.server = FakeServer(folder, self.answer)
        self.client = Client(self.server.endpoint, timeout=5)
        self.sessions = [self.open() for _ in range(3)]

    def open(self, client=None):
        return (client or self.client).session(grid=GRID, upper=Material(1, 0))

    def answer(self, request):
        if request.method == "session.open":
            self.opened += 1
            return [request.result(opened(name=f"{self.opened:032x}"))]
        if request.method == "server.info":
            return [request.result({**answers.INFO, "limits": {**answers.INFO["limits"], "max_frames": 64}})]
        if (instead := self.meanwhile(request)) is not None:
            return instead
        if request.method != "session.step_many":
            return [request.result({"state": "state-1", "step": 0})]
        return [request.result({"steps": [self.taken(step) for step in request.params["steps"]]})]

    def taken(self, step):
        if step.get("Fn") == TOO_MUCH:
            return {"status": FAILED}
        return {"status": OK, "result": {**STEP, "step": step["step"]}}

    @property
    def asked(self):
        """Returns the steps of each message."""
        return [r.params["steps"] for r in self.server.requests if r.method == "session.step_many"]

    def numbers(self):
        return [[step["step"] for step in steps] for steps in self.asked]


@pytest.fixture
def fake(tmp_path):
    started = Fake(tmp_path)
    with started.server, started.client:
        yield started


def all_of(fake, *inputs):
    return fake.client.step_many(list(zip(fake.sessions, inputs, strict=False)))


def test_steps_say_what_single_ones_do_and_are_answered_in_order(fake):
    inputs = [{"Fn": 1, "mu": 0.3, "xi": 1e-3}, {"approach": 0.1, "force": (None, 2)}, {"Fn": 3, "rigid_shift": (1, 0)}]
    solutions = all_of(fake, *inputs)
    assert all(isinstance(solution, StepSolution) for solution in solutions)
    assert [session.step_number for session in fake.sessions] == [1, 1, 1]
    for session, said in zip(fake.sessions, inputs, strict=True):
        fake.meanwhile = lambda request: [request.result({**STEP, "step": 2})]
        session.step(**said)
    single = [request.params for request in fake.server.requests if request.method == "session.step"]
    assert [{**step, "step": 2} for step in fake.asked[0]] == single


def test_no_steps_ask_nothing():
    with Client("ipc:///nowhere") as client:
        assert client.step_many([]) == []


def test_a_step_that_fails_is_an_exception_among_solutions(fake):
    first, second, third = all_of(fake, {"Fn": 1}, {"Fn": TOO_MUCH}, {"Fn": 3})
    assert isinstance(second, FailedPrecondition)
    assert (first.step, third.step) == (1, 1)
    assert [session.step_number for session in fake.sessions] == [1, 0, 1]
    all_of(fake, {"Fn": 1}, {"Fn": 2}, {"Fn": 3})
    assert fake.numbers() == [[1, 1, 1], [2, 1, 2]]


def test_all_are_tried_again_those_that_failed_too(fake):
    all_of(fake, {"Fn": 1}, {"Fn": TOO_MUCH}, {"Fn": 3})
    all_of(fake, *[{"Fn": 1, "again": True}] * 3)
    assert fake.numbers() == [[1, 1, 1], [1, 1, 1]]
    assert all(step["again"] for step in fake.asked[1])
    assert [session.step_number for session in fake.sessions] == [1, 1, 1]


@pytest.mark.parametrize(
    ("wrong", "error", "problem"),
    [
        ({"gap": np.full((2, 3), np.nan)}, InvalidArgument, r"steps\[1\]\.gap\.array"),
        ({"rigid_slip": 3}, TypeError, "rigid_slip"),
    ],
)
def test_steps_that_never_left_were_all_asked_for(fake, wrong, error, problem):
    all_of(fake, *[{"Fn": 1}] * 3)
    with pytest.raises(error, match=problem):
        all_of(fake, {"Fn": 1}, wrong, {"Fn": 1})
    all_of(fake, *[{"Fn": 1, "again": True}] * 3)
    assert fake.numbers() == [[1, 1, 1], [2, 2, 2]]


def test_an_array_of_several_steps_is_sent_once(fake):
    gap, other = np.ones((2, 3)), np.ones((2, 3))
    all_of(fake, {"gap": gap}, {"gap": other}, {"gap": gap, "mu": other})
    frames = [step["gap"]["array"]["$array"]["frame"] for step in fake.asked[0]]
    assert frames == [1, 2, 1]
    assert fake.asked[0][2]["friction"]["mu"]["$array"]["frame"] == 2


@pytest.mark.parametrize("failure", [ConnectionFailed, TimeoutExpired])
def test_steps_whose_answer_does_not_come_are_asked_for_again(fake, monkeypatch, failure):
    exchange, lost = Client._exchange, []

    def lossy(self, request):
        reply = exchange(self, request)
        if request.method == "session.step_many" and not lost:
            lost.append(reply)
            raise failure("lost")
        return reply

    monkeypatch.setattr(Client, "_exchange", lossy)
    all_of(fake, {"gap": np.ones((2, 3))}, {"Fn": 1, "again": True}, {"Fn": 1})
    assert fake.numbers() == [[1, 1, 1]] * 2
    assert fake.asked[0] == fake.asked[1], "the daemon knows it by all that it says"


def test_a_session_that_wants_no_retries_gets_none_and_the_same_steps_go_on(fake):
    fake.sessions[1].retries = 0
    fake.meanwhile = lambda request: []
    with pytest.raises(TimeoutExpired):
        fake.client.step_many([(session, {"Fn": 1}) for session in fake.sessions], timeout=0.05)
    fake.meanwhile = lambda request: None
    all_of(fake, *[{"Fn": 1}] * 3)
    assert fake.asked[0] == fake.asked[1]
    assert len(fake.asked) == 2


def test_a_session_stands_once(fake):
    first, second, _ = fake.sessions
    with pytest.raises(InvalidArgument, match=r"steps\[2\]\.session is also that of steps\[0\]") as refused:
        fake.client.step_many([(first, {}), (second, {}), (first, {})])
    assert refused.value.violations[0].field == "steps[2].session"
    assert fake.asked == []


def test_a_session_of_another_client_is_refused(fake):
    with Client(fake.server.endpoint) as other:
        own = fake.open(other)
        with pytest.raises(InvalidArgument, match=r"steps\[1\]\.session belongs to another client"):
            fake.client.step_many([(fake.sessions[0], {}), (own, {})])
    assert fake.asked == []


@pytest.mark.parametrize(
    ("step", "problem"),
    [
        (lambda session: session, r"steps\[0\] must be a session and the input of its step, such as \(session, \{\"Fn\": 9e3\}\)"),
        (lambda session: (session, 3), r"steps\[0\] must be"),
        (lambda session: (session.name, {}), r"steps\[0\] must be [^0]*\(session"),
        (lambda session: (session, {"Fm": 1, "timeout": 3}), r"steps\[0\] has Fm, timeout, which Session\.step does not"),
    ],
)
def test_what_is_no_step_of_a_session_is_refused(fake, step, problem):
    with pytest.raises(TypeError, match=problem):
        fake.client.step_many([step(fake.sessions[0])])
    assert fake.asked == []


@pytest.mark.parametrize(
    "result",
    [{}, {"steps": []}, {"steps": [1, 2, 3]}, {"steps": [{"status": OK}] * 3},
     {"steps": [{"status": OK, "result": {}}] * 3}],
)  # fmt: skip
def test_answers_that_are_none_break_the_protocol(fake, result):
    fake.meanwhile = lambda request: [request.result(result)]
    with pytest.raises(ProtocolError):
        all_of(fake, {}, {}, {})


def test_arrays_that_were_asked_for_and_are_not_there_break_the_protocol(fake):
    with pytest.raises(ProtocolError, match="lacks the requested pressure"):
        all_of(fake, {"fields": "pressure"})


# --- threads and processes -------------------------------------------------------------------------------------------


def test_a_session_that_is_in_use_holds_up_the_whole_and_leaves_none_locked(fake):
    begun, go_on = threading.Event(), threading.Event()

    def wait_in_save(request):
        if request.method == "session.save":
            begun.set()
            go_on.wait(5)

    fake.meanwhile = wait_in_save
    saving = threading.Thread(target=fake.sessions[2].save)
    saving.start()
    begun.wait(5)
    with pytest.raises(ContactdError, match="in another thread or around this progress callback"):
        all_of(fake, {}, {}, {})
    go_on.set()
    saving.join()
    assert fake.asked == []
    assert [solution.step for solution in all_of(fake, {}, {}, {})] == [1, 1, 1]


def test_sessions_take_no_other_step_meanwhile(fake):
    begun, go_on = threading.Event(), threading.Event()

    def wait(request):
        begun.set()
        go_on.wait(5)

    fake.meanwhile = wait
    stepping = threading.Thread(target=all_of, args=(fake, {}, {}, {}))
    stepping.start()
    begun.wait(5)
    for session in fake.sessions:
        with pytest.raises(ContactdError, match="in another thread"):
            session.step()
        with pytest.raises(ContactdError, match="in another thread"):
            fake.client.step_many([(session, {})])
    go_on.set()
    stepping.join()
    assert fake.numbers() == [[1, 1, 1]]


def test_sessions_belong_to_the_process_that_opened_them(fake):
    error = in_fork(lambda: all_of(fake, {}, {}, {}))
    assert type(error) is ContactdError
    assert f"process {os.getpid()}" in str(error)
    assert fake.asked == []
    assert len(all_of(fake, {}, {}, {})) == 3


def test_a_client_that_was_closed_takes_no_steps_and_leaves_none_locked(fake):
    fake.client.close()
    for _ in range(2):
        with pytest.raises(ConnectionFailed, match="closed"):
            all_of(fake, {}, {})


def test_an_error_of_the_whole_moves_no_session(fake):
    fake.meanwhile = lambda request: [request.failure(5, "Gone.")]
    with pytest.raises(NotFound):
        all_of(fake, {}, {}, {})
    assert [session.step_number for session in fake.sessions] == [0, 0, 0]
    assert isinstance(fake.sessions[0], Session)
