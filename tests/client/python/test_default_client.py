"""Tests the client of the package's functions."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest

import contactd
from contactd import ConnectionFailed, DaemonFailed, Paraboloid, steel
from contactd.local import InProcessClient
from contactd.transport import shared_client
from support.processes import in_fork

BALL = Paraboloid(50, 50)


@pytest.fixture(autouse=True)
def fresh(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Each test opens the default client itself, and closes it."""
    monkeypatch.delenv("CONTACTD_ENDPOINT", raising=False)
    contactd.default_client().close()
    yield
    monkeypatch.delenv("CONTACTD_ENDPOINT", raising=False)
    contactd.default_client().close()


def test_it_solves_in_process_and_is_one_for_all_calls():
    assert isinstance(contactd.default_client(), InProcessClient)
    assert contactd.solve(BALL, steel, Fn=100).converged
    assert contactd.default_client() is contactd.default_client()


def test_the_environment_names_a_daemon(monkeypatch, shared_daemon):
    in_process = contactd.solve(BALL, steel, Fn=100)
    contactd.default_client().close()
    monkeypatch.setenv("CONTACTD_ENDPOINT", shared_daemon.endpoint)
    assert contactd.default_client().endpoint == shared_daemon.endpoint
    by_daemon = contactd.solve(BALL, steel, Fn=100)
    assert (by_daemon.pressure == in_process.pressure).all()
    assert by_daemon.grid == in_process.grid


def test_a_daemon_that_is_not_there_is_no_reason_to_solve_elsewhere(monkeypatch, tmp_path):
    monkeypatch.setenv("CONTACTD_ENDPOINT", f"ipc://{tmp_path}/nobody")
    contactd.default_client().connect_timeout = 0.1
    with pytest.raises(ConnectionFailed):
        contactd.solve(BALL, steel, Fn=100)


def test_a_closed_one_is_opened_again():
    first = contactd.default_client()
    first.close()
    assert contactd.solve(BALL, steel, Fn=100).converged
    assert contactd.default_client() is not first


def test_threads_share_one():
    with ThreadPoolExecutor(8) as pool:
        clients = list(pool.map(lambda _: contactd.default_client(), range(32)))
        forces = list(pool.map(lambda force: contactd.solve(BALL, steel, Fn=force).Fn, [10.0, 20.0, 30.0] * 4))
    assert len({id(client) for client in clients}) == 1
    assert forces == pytest.approx([10, 20, 30] * 4)


def test_a_forked_process_opens_its_own():
    before = contactd.solve(BALL, steel, Fn=100)

    def in_child() -> tuple[float, int]:
        pressure = contactd.solve(BALL, steel, Fn=100).pmax
        contactd.default_client().close()
        return pressure, os.getpid()

    pressure, child = in_fork(in_child)
    assert (pressure, child != os.getpid()) == (before.pmax, True)
    assert contactd.solve(BALL, steel, Fn=100).pmax == before.pmax


def test_a_process_forked_while_another_thread_opens_it_does_not_wait_for_that_thread():
    held = shared_client._holder.lock

    def in_child() -> bool:
        solved = contactd.solve(BALL, steel, Fn=100).converged
        contactd.default_client().close()
        return solved

    with held:
        assert in_fork(in_child)


def test_without_anything_that_solves_the_sentence_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "contactd_local", None)
    monkeypatch.setenv("PATH", "")
    with pytest.raises(DaemonFailed, match=r'pip install "contactd\[daemon\]"'):
        contactd.solve(BALL, steel, Fn=100)
    monkeypatch.undo()


def test_it_is_closed_when_the_program_ends():
    code = (
        "import atexit\n"
        "found = []\n"
        "atexit.register(lambda: print('closed', found[0].is_closed))\n"
        "import contactd\n"
        "found.append(contactd.default_client())\n"
        "print(contactd.solve(contactd.Paraboloid(50, 50), contactd.steel, Fn=100).converged)\n"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=False)
    assert ended.stdout.splitlines() == ["True", "closed True"], ended.stderr
    assert not ended.stderr
