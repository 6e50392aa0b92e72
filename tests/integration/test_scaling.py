"""Tests many daemons at one address, and a study on several workers."""

import contextlib
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
import zmq

import contactd
from contactd import Cancelled, NotFound, Unavailable
from support.daemons import BIN, CheckedClient, eventually, processes_with
from support.faults import NAMESPACE, needs_namespaces
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
        return False  # the proxy has not received it yet
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
    assert sum(row.split()[3] == "built" for row in rows) == 4  # each table once, for any order of requests


STUDY = """\
problem:
  grid: {nx: 20, ny: 20, dx: 0.12, dy: 0.12}
  bodies: {upper: {G: 200, nu: 0.42}}
  ics: {source: fem, preset: paper-test2, order: 1, L_over_h: 40}
  gap: {paraboloid: {Rx: 50, Ry: 50}}
vary: {approach: {from: 5e-3, to: 2e-2, count: 9}}
answers: [forces.Fn, evidence.ics.upper.origin]
"""


@contextlib.contextmanager
def a_store_with_one_table():
    """Provides a folder whose store contains the table of the study, readable by other users."""
    with tempfile.TemporaryDirectory(prefix="study-", dir="/tmp") as name:
        folder = Path(name)
        folder.chmod(0o755)
        (folder / "study.yaml").write_text(STUDY)
        (folder / "rows").mkdir()
        (folder / "rows").chmod(0o777)
        with contactd.local(in_process=True, folder=folder) as client:
            client.get_ic(contactd.Material(G=200, nu=0.42), contactd.Grid(20, 20, 0.12, 0.12),
                          contactd.FemIcs(preset="paper-test2", order=1, L_over_h=40))  # fmt: skip
        yield folder


def by_permission(folder):
    """The folder is not writable, not even for root without capabilities."""
    (folder / "store").chmod(0o555)
    return ["setpriv", "--inh-caps=-all", "--bounding-set=-all"] if os.geteuid() == 0 else []


def by_mount(folder):
    needs_namespaces()
    return [*NAMESPACE, "sh", "-c", f'mount --bind -o ro "{folder}/store" "{folder}/store" && exec "$@"', "sh"]


def state_of(folder):
    """Its owner may still set the times of files."""
    return {path.name: path.read_bytes() for path in (folder / "store").rglob("*") if path.is_file()}


@pytest.mark.parametrize("forbid", [by_permission, by_mount])
def test_processes_that_may_only_read_the_store_solve_a_study_with_its_tables(monkeypatch, forbid):
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in sys.path if path))
    with a_store_with_one_table() as folder:
        before = state_of(folder)
        command = [*forbid(folder), sys.executable, "-m", "contactctl", "--local", "--json", "--folder", folder, "study",
                   folder / "study.yaml", "--rows", folder / "rows" / "all"]  # fmt: skip
        tasks = [subprocess.Popen([*command, "--share", f"{i}/3"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                 for i in range(3)]  # fmt: skip
        ended = [task.communicate(timeout=50) for task in tasks]
        assert [task.returncode for task in tasks] == [0, 0, 0], ended
        rows = [row["answers"] for out, _ in ended for row in json.loads(out)["rows"]]
        assert state_of(folder) == before
        (folder / "store").chmod(0o755)
    assert len({row["forces.Fn"] for row in rows}) == 9
    assert {row["evidence.ics.upper.origin"] for row in rows} == {"disk", "memory"}


def test_a_store_that_may_only_be_read_serves_new_tables_from_memory(monkeypatch):
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in sys.path if path))
    with a_store_with_one_table() as folder:
        before = state_of(folder)
        study = folder / "rows" / "other.yaml"
        study.write_text(STUDY.replace("0.42", "0.3"))
        command = [*by_permission(folder), sys.executable, "-m", "contactctl", "--local", "--json", "--folder", folder]
        ended = subprocess.run([*command, "study", study], capture_output=True, text=True, timeout=50)
        assert ended.returncode == 0, ended.stderr
        rows = [row["answers"] for row in json.loads(ended.stdout)["rows"]]
        assert state_of(folder) == before
        (folder / "store").chmod(0o755)
    assert {row["evidence.ics.upper.origin"] for row in rows} == {"built", "memory"}
