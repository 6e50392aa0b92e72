"""Tests requests and answers with a fake daemon: timeouts, late and malformed answers, interrupts, progress."""

import json
import os
import signal
import threading
import time

import numpy as np
import pytest

from contactd import (
    Client,
    ConnectionFailed,
    FemIcs,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    Progress,
    ProtocolError,
    TimeoutExpired,
)
from support import answers
from support.fake_server import FakeServer

STEEL, GRID = Material(82000, 0.28), Grid(3, 2, 1, 1)


@pytest.fixture
def fake(tmp_path):
    """fake(script) starts a server and returns it with a client of it."""
    servers, clients = [], []

    def start(script, **options):
        servers.append(FakeServer(tmp_path, script))
        clients.append(Client(servers[-1].endpoint, **{"timeout": 5, **options}))
        return servers[-1], clients[-1]

    yield start
    for client in clients:
        client.close()
    for server in servers:
        server.__exit__()


def healthy(request):
    return [request.result({"state": "serving"})]


def test_a_request_says_version_method_and_timeout(fake):
    server, client = fake(healthy)
    assert client.health(timeout=2.5) == "serving"
    envelope = server.requests[0].envelope
    assert envelope["contactd"] == 1
    assert envelope["method"] == "server.health"
    assert envelope["timeout_ms"] == 2500
    assert envelope["params"] == {}


def test_every_request_has_an_id_of_its_own(fake):
    server, client = fake(healthy)
    client.health()
    client.health()
    assert server.requests[0].id != server.requests[1].id


def test_no_answer_in_time_is_a_timeout(fake):
    _, client = fake(lambda request: [])
    with pytest.raises(TimeoutExpired, match=r"server\.health"):
        client.health(timeout=0.05)


def test_a_late_answer_is_not_taken_for_the_next_one(fake):
    late = []

    def script(request):
        if request.method == "server.info":
            late.append(request.result({"state": "late"}))
            return []
        return [*late, request.result({"state": "serving"})]

    _, client = fake(script)
    with pytest.raises(TimeoutExpired):
        client.info(timeout=0.05)
    assert client.health() == "serving"


def test_progress_of_another_call_is_not_reported(fake):
    def script(request):
        stranger = request.progress(job="build-9")
        stranger[0] = stranger[0].replace(request.id.encode(), b"stranger")
        result, frame = answers.table(2, 3)
        return [stranger, request.progress(), request.result(result, frame)]

    _, client = fake(script)
    seen = []
    client.get_ic(STEEL, GRID, FemIcs(), on_progress=seen.append)
    assert seen == [Progress(job="build-1", stage="pcg", fraction=0.5)]


def test_progress_without_a_callback_is_passed_over(fake):
    _, client = fake(lambda request: [request.progress(), request.result({"state": "serving"})])
    assert client.health() == "serving"


def test_a_callback_may_use_the_client(fake):
    def script(request):
        if request.method == "job.cancel":
            return [request.result({"job": "build-1"})]
        result, frame = answers.table(2, 3)
        return [request.progress(), request.result(result, frame)]

    server, client = fake(script)
    client.get_ic(STEEL, GRID, FemIcs(), on_progress=lambda progress: client.cancel_job(progress.job))
    assert [request.method for request in server.requests] == ["ic.get", "job.cancel"]


def test_an_exception_of_a_callback_reaches_the_caller_and_the_client_stays_usable(fake):
    def fail(progress):
        raise LookupError("of the callback")

    _, client = fake(lambda request: [request.progress(), request.result({"state": "serving"})])
    with pytest.raises(LookupError):
        client.get_ic(STEEL, GRID, FemIcs(), on_progress=fail)
    assert client.health() == "serving"


def test_an_interrupt_leaves_the_client_usable(fake):
    def script(request):
        if request.method == "ic.get":
            os.kill(os.getpid(), signal.SIGINT)
            return []
        return healthy(request)

    _, client = fake(script)
    with pytest.raises(KeyboardInterrupt):
        client.get_ic(STEEL, GRID, FemIcs())
    assert client.health() == "serving"


@pytest.mark.timeout(20)
def test_an_interrupt_that_ends_no_wait_is_noticed_soon(fake):
    def script(request):
        if request.method == "ic.get":
            # The signal reaches this thread, so the caller keeps waiting for its socket.
            signal.pthread_kill(threading.get_ident(), signal.SIGINT)
            return []
        return healthy(request)

    _, client = fake(script)
    with pytest.raises(KeyboardInterrupt):
        client.get_ic(STEEL, GRID, FemIcs())
    assert client.health() == "serving"


def test_calls_of_several_threads_run_side_by_side(fake):
    both_there = threading.Event()
    first = []

    def script(request):
        # The first request is answered after the second one has arrived.
        if not first:
            first.append(request)
            return []
        both_there.set()
        stolen = first[0].result({"state": "first"})
        return [stolen, request.result({"state": "second"})]

    # Answers go to the identity of the last request, so only the first caller must time out.
    _, client = fake(script)
    outcome = []

    def ask():
        try:
            client.health(timeout=0.5)
        except TimeoutExpired:
            outcome.append("timeout")

    thread = threading.Thread(target=ask)
    thread.start()
    while not first:
        time.sleep(0.005)
    assert client.health() == "second"
    thread.join()
    assert both_there.is_set()
    assert outcome == ["timeout"]


def test_nobody_listening_is_a_failed_connection(tmp_path):
    with Client(f"ipc://{tmp_path}/nobody", connect_timeout=0.05) as client, pytest.raises(ConnectionFailed):
        client.health()


@pytest.mark.parametrize("endpoint", ["nonsense", "tcp://127.0.0.1", "carrier-pigeon://x"])
def test_an_endpoint_that_is_none_is_a_failed_connection(endpoint):
    with Client(endpoint) as client, pytest.raises(ConnectionFailed, match=r"not a valid endpoint .* have the form tcp://"):
        client.health()


def test_a_daemon_that_dies_during_a_call_is_noticed_at_once(tmp_path):
    server = FakeServer(tmp_path, lambda request: [])
    closing = threading.Thread(target=lambda: (_until(lambda: server.requests), server.__exit__()))
    closing.start()
    with Client(server.endpoint, timeout=30) as client, pytest.raises(ConnectionFailed, match="disconnected during"):
        client.health()
    closing.join()


def test_a_daemon_that_was_restarted_between_two_calls_answers(tmp_path):
    with FakeServer(tmp_path, healthy) as server, Client(server.endpoint, timeout=5) as client:
        assert client.health() == "serving"
        server.__exit__()
        # The client's socket notices the disconnection after a moment; requests sent before are lost, and reported as
        # lost.
        _until(lambda: client._connections._idle[0]._monitor.poll(0))
        with FakeServer(tmp_path, healthy):
            assert client.health() == "serving"


def test_a_closed_client_refuses_calls(fake):
    _, client = fake(healthy)
    client.health()
    client.close()
    with pytest.raises(ConnectionFailed, match="closed"):
        client.health()


@pytest.mark.parametrize("timeout", [0, -1, float("nan"), 86_401])
def test_a_timeout_out_of_range_is_refused(fake, timeout):
    _, client = fake(healthy)
    with pytest.raises(ValueError, match="timeout"):
        client.health(timeout=timeout)


@pytest.mark.parametrize(
    "answer",
    [
        b"no json",
        b"\xff\xfe",
        b"[]",
        b"{}",
        b'{"contactd": 2, "id": "ID", "status": {"code": 0, "name": "OK", "message": ""}, "result": {}}',
        b'{"contactd": 1, "id": "ID", "status": {"code": 0, "name": "OK", "message": ""}}',
        b'{"contactd": 1, "id": "ID", "status": {"code": 0, "name": "OK", "message": ""}, "result": []}',
        b'{"contactd": 1, "id": "ID", "status": {"message": ""}, "result": {}}',
        b'{"contactd": 1, "id": "ID", "status": 3, "result": {}}',
        b'{"contactd": 1, "id": "ID", "status": {"code": 3, "message": "", "details": {"violations": [1]}}}',
        b'{"contactd": 1, "id": "ID", "status": {"code": 0, "name": "OK", "message": ""}, "result": {"state": 1}}',
        b'{"contactd": 1, "id": "ID", "status": {"code": 0, "name": "OK", "message": ""}, "result": {"state": "serving", "n": NaN}}',
    ],
)
def test_a_malformed_answer_breaks_the_protocol_and_the_client_stays_usable(fake, answer):
    spoilt = iter([True])
    _, client = fake(
        lambda request: [[answer.replace(b"ID", request.id.encode())]] if next(spoilt, False) else healthy(request)
    )
    with pytest.raises(ProtocolError):
        client.health()
    assert client.health() == "serving"


def test_an_error_without_an_id_is_the_answer_to_the_call_under_way(fake):
    def script(request):
        text = request.failure(3, "The envelope is no JSON.", reason="NOT_JSON", violations=[])[0]
        return [[json.dumps({**json.loads(text), "id": None}).encode()]]

    _, client = fake(script)
    with pytest.raises(InvalidArgument, match="NOT_JSON"):
        client.health()


def test_limits_of_the_daemon_are_asked_once_and_kept(fake):
    def script(request):
        if request.method == "server.info":
            return [request.result(answers.INFO)]
        return [request.result(*answers.solution(2, 3))]

    server, client = fake(script)
    with pytest.raises(InvalidArgument, match="at most 1000") as caught:
        client.solve(grid=Grid(40, 40, 1, 1), upper=STEEL, gap=np.zeros((40, 40)), approach=0.1)
    assert caught.value.reason == "LIMIT_EXCEEDED"
    for _ in range(2):
        client.solve(grid=GRID, upper=STEEL, gap=np.zeros((2, 3)), approach=0.1)
    client.solve(grid=GRID, upper=STEEL, gap=Paraboloid(50, 50), approach=0.1)
    assert [request.method for request in server.requests] == ["server.info"] + ["contact.solve"] * 3


def test_values_that_are_not_finite_are_never_sent(fake):
    server, client = fake(healthy)
    with pytest.raises(InvalidArgument, match="approach"):
        client.solve(grid=GRID, upper=STEEL, gap=Paraboloid(50, 50), approach=float("nan"))
    assert server.requests == []


def _until(condition):
    while not condition():
        time.sleep(0.005)
