"""Many daemons behind one address, and a study on several workers."""

import contextlib
import importlib.util
import json
import subprocess
import sys
from pathlib import Path

import pytest
import zmq

from contactd import Cancelled, Unavailable
from support.daemons import BIN, CheckedClient, eventually, processes_with
from support.problems import CATTANEO, CATTANEO_PARAMS, GRID, LONG, QUICK, STEEL
from support.raw import RawClient

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
