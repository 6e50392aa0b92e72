"""Many daemons behind one address, and a study on several workers."""

import contextlib
import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest
import zmq

from contactd import Cancelled, NotFound, Unavailable
from support.daemons import BIN, CheckedClient, eventually, processes_with
from support.problems import CATTANEO, CATTANEO_PARAMS, GRID, LONG, QUICK, STEEL
from support.raw import RawClient
from support.sessions import open_session

APPROACHES = [0.02, 0.021, 0.022]
EXAMPLES = Path(__file__).parents[2] / "client" / "python" / "examples"


@contextlib.contextmanager
def proxy_for(*daemons):
    program = [sys.executable, EXAMPLES / "proxy.py", "tcp://127.0.0.1:*", *(daemon.endpoint for daemon in daemons)]
    process = subprocess.Popen(program, stdout=subprocess.PIPE, text=True)
    try:
        yield json.loads(process.stdout.readline())["endpoint"]
    finally:
        process.terminate()
        assert process.wait(20) == 0
        process.stdout.close()


def requests(daemon):
    with daemon.client() as client:
        return client.info().counters["solves"]


def test_clients_behind_a_proxy_are_spread_over_the_daemons(daemons):
    shared = {"folder": str(daemons.folder / "store")}
    pair = [daemons.start(name, store=shared) for name in ("first", "second")]
    with proxy_for(*pair) as endpoint, contextlib.ExitStack() as stack:
        clients = [stack.enter_context(CheckedClient(endpoint, timeout=50)) for _ in range(4)]
        for client in clients:
            assert client.solve(CATTANEO).converged
        assert [requests(daemon) for daemon in pair] == [2, 2]
        assert {client.get_ic(STEEL, GRID, QUICK).origin for client in clients} <= {"built", "disk", "memory"}
        assert sum(len(daemon.tables()) for daemon in pair) == 0  # in the shared folder
        for kind in (zmq.DEALER, zmq.REQ):
            with RawClient(endpoint, kind) as raw:
                assert raw.ask("contact.solve", CATTANEO_PARAMS, arrays="list").status == "OK"
                assert raw.ask("contact.solve", {}).reason == "FIELD_INVALID"


def test_progress_and_cancellation_pass_through_the_proxy(daemons, background):
    with proxy_for(daemons.start()) as endpoint, CheckedClient(endpoint, timeout=50) as client:
        stages = []
        caller = background(client.get_ic, STEEL, GRID, LONG, on_progress=lambda progress: stages.append(progress.stage))
        eventually(lambda: len(stages) > 1)
        client.cancel_job(client.jobs()[0].job)
        with pytest.raises(Cancelled):
            caller.result()


def test_a_daemon_that_goes_away_behind_the_proxy_is_replaced(daemons, background):
    shared = {"folder": str(daemons.folder / "store")}
    pair = [daemons.start(name, store=shared) for name in ("first", "second")]
    with proxy_for(*pair) as endpoint, CheckedClient(endpoint, timeout=50) as client:
        caller = background(client.get_ic, STEEL, GRID, LONG)
        eventually(lambda: processes_with(shared["folder"] + "/"))
        (busy,) = [daemon for daemon in pair if jobs(daemon)]
        busy.kill()
        with pytest.raises(Unavailable):
            caller.result()
        (left,) = [daemon for daemon in pair if daemon is not busy]
        before = requests(left)
        assert client.solve(CATTANEO).converged
        assert requests(left) == before + 1


def test_sessions_of_clients_of_their_own_stay_with_their_daemons(daemons):
    pair = [daemons.start(name) for name in ("first", "second")]
    with pair[0].client() as direct, open_session(direct) as session:
        expected = [session.step(approach=approach).forces for approach in APPROACHES]
    with proxy_for(*pair) as endpoint, contextlib.ExitStack() as stack:
        clients = [stack.enter_context(CheckedClient(endpoint, timeout=50)) for _ in pair]
        sessions = [stack.enter_context(open_session(client)) for client in clients]
        for approach, forces in zip(APPROACHES, expected):
            assert [session.step(approach=approach).forces for session in sessions] == [forces, forces]
        assert [len(sessions_of(daemon)) for daemon in pair] == [1, 1]
        saved = sessions[0].save()
        sessions[0].restore(saved)
        assert sessions[0].step(approach=APPROACHES[-1]).step == saved.step + 1


def test_a_session_ends_with_its_daemon_and_a_new_one_gets_another(daemons):
    pair = [daemons.start(name) for name in ("first", "second")]
    with proxy_for(*pair) as endpoint, CheckedClient(endpoint, timeout=50) as client:
        session = open_session(client)
        assert session.step().step == 1
        (busy,) = [daemon for daemon in pair if sessions_of(daemon)]
        busy.kill()
        eventually(lambda: is_unknown(session))
        with open_session(client) as another:
            assert another.step().step == 1


def is_unknown(session):
    try:
        session.step()
    except Unavailable:
        return False  # the proxy has not heard of it yet
    except NotFound as error:
        return error.reason == "SESSION_UNKNOWN"
    return False


def sessions_of(daemon):
    with daemon.client() as client:
        return client.sessions()


def jobs(daemon):
    with daemon.client() as client:
        return client.jobs()


@pytest.mark.skipif(importlib.util.find_spec("distributed") is None, reason="dask.distributed is not installed")
def test_a_study_runs_on_two_dask_workers():
    program = [sys.executable, EXAMPLES / "study_dask.py", "--bin", BIN]
    output = subprocess.run(program, check=True, capture_output=True, text=True, timeout=50).stdout
    head, *rows = output.splitlines()
    assert "Fn" in head
    assert len(rows) == 16
    forces = [float(row.split()[2]) for row in rows]
    assert all(force > 0 for force in forces)
    assert {row.split()[3] for row in rows} <= {"built", "disk", "memory"}
    assert sum(row.split()[3] == "built" for row in rows) == 4  # each table once, whoever asked first
