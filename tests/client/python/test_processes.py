"""Tests clients, sessions and daemons in forked processes, in pickles and in several threads."""

import copy
import os
import pickle
import sys
import threading

import pytest
import zmq.auth

from contactd import (
    Client,
    ConnectionFailed,
    ContactdError,
    DaemonFailed,
    Grid,
    LocalDaemon,
    Material,
    NotFound,
)
from support.fake_server import FakeServer
from support.processes import in_fork
from support.sessions import opened

# The server of these tests runs in a thread of the parent; the children never use it.
pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")

GRID, MATERIAL = Grid(3, 2, 1, 1), Material(1, 0)


def serving(request):
    return [request.result({"state": "serving"})]


def test_a_client_used_before_a_fork_is_used_on_both_sides_of_it(fake):
    server, client = fake(serving)
    assert client.health() == "serving"
    assert [in_fork(client.health) for _ in range(3)] == ["serving"] * 3
    assert client.health() == "serving"
    assert len(server.requests) == 5


def test_threads_of_a_forked_process_share_the_client(fake):
    _, client = fake(serving)
    client.health()

    def ask_from_threads():
        states = []
        threads = [threading.Thread(target=lambda: states.append(client.health())) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return states

    assert in_fork(ask_from_threads) == ["serving"] * 8


def test_a_fork_while_another_thread_waits_for_an_answer_disturbs_neither(fake):
    asked, go_on = threading.Event(), threading.Event()

    def script(request):
        if request.method == "server.describe":
            asked.set()
            go_on.wait(5)
        return serving(request)

    _, client = fake(script)
    waiting = threading.Thread(target=client.describe)
    waiting.start()
    asked.wait(5)
    client.timeout = 1.0
    outcome = in_fork(lambda: (client.close(), "closed")[1])
    go_on.set()
    waiting.join()
    assert outcome == "closed"
    assert client.health() == "serving"


def test_a_child_that_closes_the_client_leaves_the_parents_alone(fake):
    _, client = fake(serving)
    client.health()
    in_fork(client.close)
    assert client.health() == "serving"


def test_a_progress_callback_that_forks_and_returns_in_the_child_ends_the_call_there(fake):
    def script(request):
        return [request.progress(), request.result({"a": 1})]

    _, client = fake(script)
    outcomes = []
    reading, writing = os.pipe()
    child = -1

    def fork(progress):
        nonlocal child
        child = os.fork()

    params = {"ics": {"source": "fem"}}
    try:
        outcomes.append(client.call("ic.get", params, on_progress=fork))
    except BaseException as error:
        if child == 0:
            os.write(writing, type(error).__name__.encode())
            os._exit(0)
        raise
    if child == 0:
        os.write(writing, b"answered")
        os._exit(0)
    os.waitpid(child, 0)
    assert os.read(reading, 100) == ConnectionFailed.__name__.encode()
    assert outcomes == [{"a": 1}]
    os.close(reading)
    os.close(writing)


def test_a_client_that_is_pickled_connects_where_it_arrives(fake):
    server, client = fake(serving)
    client.health()
    with pickle.loads(pickle.dumps(client)) as arrived, copy.copy(client) as copied:
        assert (arrived.endpoint, arrived.timeout, arrived.build_timeout) == (server.endpoint, 5, 3600)
        assert arrived.health() == copied.health() == "serving"
    assert client.health() == "serving"


def test_a_pickled_client_names_its_key_files_and_holds_no_key(tmp_path, monkeypatch):
    zmq.auth.create_certificates(tmp_path, "daemon")
    _, own = zmq.auth.create_certificates(tmp_path, "alice")
    os.chmod(own, 0o600)
    monkeypatch.chdir(tmp_path)
    with Client("ipc:///nowhere", server_key="daemon.key", own_key="alice.key_secret") as client:
        text = pickle.dumps(client)
        assert client._curve is not None
        assert client._curve.secret not in text
        assert client._curve.secret.decode() not in repr(client) + repr(vars(client))
    monkeypatch.chdir("/")
    with pickle.loads(text) as arrived:
        assert arrived._curve == client._curve
    os.unlink(own)
    with pytest.raises(ValueError, match="alice.key_secret cannot be read"):
        pickle.loads(text)


def test_errors_arrive_whole_from_another_process(fake):
    details = {"reason": "JOB_UNKNOWN", "violations": [{"field": "job", "description": "is gone"}]}
    _, client = fake(lambda request: [request.failure(5, "No such job.", **details)])

    error = in_fork(lambda: client.cancel_job("build-1"))

    assert isinstance(error, NotFound)
    assert (error.reason, error.message, error.violations[0].field) == ("JOB_UNKNOWN", "No such job.", "job")


# --- sessions --------------------------------------------------------------------------------------------------------


def sessions(request):
    if request.method == "session.open":
        return [request.result(opened())]
    return [request.result({"state": "state-1", "step": 0})]


@pytest.fixture
def session(fake):
    server, client = fake(sessions)
    return server, client.session(grid=GRID, upper=MATERIAL)


def test_a_session_belongs_to_the_process_that_opened_it(session):
    server, opened = session

    def end_it():
        with opened:
            pass

    for act in (opened.step, opened.save, opened.close):
        error = in_fork(act)
        assert type(error) is ContactdError
        assert f"process {os.getpid()}" in str(error)
        assert "join_session(session.name)" in str(error)
    assert in_fork(end_it) is None
    assert [request.method for request in server.requests] == ["session.open"]


def test_a_session_is_handed_on_by_its_name_and_not_in_a_pickle(session):
    _, opened = session
    with pytest.raises(TypeError, match=r"pass session\.name, and join it by client\.join_session"):
        pickle.dumps(opened)


def test_two_threads_do_not_take_the_same_step(tmp_path):
    begun, go_on = threading.Event(), threading.Event()

    def script(request):
        if request.method == "session.save":
            begun.set()
            go_on.wait(5)
        return sessions(request)

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        opened = client.session(grid=GRID, upper=MATERIAL)
        saving = threading.Thread(target=opened.save)
        saving.start()
        begun.wait(5)
        with pytest.raises(ContactdError, match="in another thread or around this progress callback"):
            opened.step()
        go_on.set()
        saving.join()
        opened.save()
        assert [request.method for request in server.requests] == ["session.open", "session.save", "session.save"]


# --- daemons ---------------------------------------------------------------------------------------------------------


def test_a_forked_process_does_not_end_its_parents_daemon(tmp_path):
    program = tmp_path / "program"
    ready = """print('{"ready": true, "endpoint": "ipc:///tmp/x", "pid": 1}', flush=True)"""
    program.write_text(f"#!{sys.executable}\nimport time\n{ready}\ntime.sleep(60)\n")
    program.chmod(0o755)

    with LocalDaemon(program) as daemon:

        def leave():
            with daemon:
                pass

        assert in_fork(leave) is None
        error = in_fork(daemon.stop)
        assert isinstance(error, DaemonFailed)
        assert f"process {os.getpid()}, and only that process can end it" in str(error)
        assert daemon.process.poll() is None
        assert daemon.folder.exists()
        with pytest.raises(TypeError, match="pass its endpoint"):
            pickle.dumps(daemon)
    assert not daemon.folder.exists()
