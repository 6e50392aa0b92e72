"""Tests one client in many processes and threads: the answers equal those of sequential calls."""

import multiprocessing
import os
import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from contactd import Client, ContactdError, Friction
from support.processes import PROBLEM, force_at, in_fork
from support.sessions import open_session

APPROACHES = [0.005 + 0.001 * n for n in range(16)]
# The children use no data of the threads that run here.
forks = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")


@pytest.fixture
def plain(shared_daemon):
    """Uses the client first, so that it has connections to be inherited."""
    with Client(shared_daemon.endpoint) as client:
        client.health()
        yield client


@pytest.fixture
def expected(plain):
    return [force_at(plain, approach) for approach in APPROACHES]


@forks
@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_a_pool_of_processes_shares_a_client(plain, expected, method):
    with multiprocessing.get_context(method).Pool(4) as pool:
        found = pool.starmap(force_at, [(plain, approach) for approach in APPROACHES])
    assert found == expected
    assert force_at(plain, APPROACHES[0]) == expected[0]


_inherited: Client


def _force_by_the_inherited_client(approach):
    return force_at(_inherited, approach)


@forks
def test_a_forked_pool_uses_the_client_that_it_inherited(plain, expected):
    global _inherited
    _inherited = plain
    with multiprocessing.get_context("fork").Pool(4) as pool:
        assert pool.map(_force_by_the_inherited_client, APPROACHES) == expected


def test_threads_share_a_client(plain, expected):
    with ThreadPoolExecutor(8) as threads:
        assert list(threads.map(lambda approach: force_at(plain, approach), APPROACHES * 4)) == expected * 4


@forks
def test_threads_and_processes_share_a_client(plain, expected):
    """While threads send requests, processes are forked that also send some."""
    with ThreadPoolExecutor(4) as threads:
        asked = [threads.submit(force_at, plain, approach) for approach in APPROACHES]
        assert [in_fork(lambda a=approach: force_at(plain, a)) for approach in APPROACHES[:6]] == expected[:6]
        assert [future.result() for future in asked] == expected


@forks
def test_a_session_goes_on_in_a_forked_process_that_joins_it(plain):
    friction = Friction(mu=0.4, rigid_shift=(0, 0))
    with plain.session(PROBLEM.replace(friction=friction)) as session, plain.session(
        PROBLEM.replace(friction=friction)
    ) as alone:
        forces = [alone.step(rigid_shift=(0.002, 0)).Fx for _ in range(3)]
        assert session.step(rigid_shift=(0.002, 0)).Fx == forces[0]
        refused = in_fork(lambda: session.step(rigid_shift=(0.002, 0)))
        assert type(refused) is ContactdError
        handed_on = in_fork(lambda: plain.join_session(session.name).step(rigid_shift=(0.002, 0)).Fx)
        assert handed_on == forces[1]
        with pytest.raises(ContactdError, match="STEP_DIFFERS|STEP_OUT_OF_ORDER"):
            session.step(rigid_shift=(0.001, 0))
        again = plain.join_session(session.name)
        assert (again.step_number, again.step(rigid_shift=(0.002, 0)).Fx) == (2, forces[2])


def test_threads_that_share_a_session_take_each_step_once(plain):
    """Each call takes a separate step, or is refused."""
    with open_session(plain) as session:
        taken, refused = [], []

        def step():
            for _ in range(10):
                try:
                    taken.append(session.step(rigid_shift=(1e-4, 0)).step)
                except ContactdError as error:
                    refused.append(str(error))

        threads = [threading.Thread(target=step) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert sorted(taken) == list(range(1, len(taken) + 1))
        assert len(taken) + len(refused) == 40
        assert all("takes one step at a time" in text for text in refused)


@forks
def test_a_forked_process_leaves_the_daemon_running(daemon, client):
    def leave():
        with daemon:
            return os.getpid()

    assert in_fork(leave) != os.getpid()
    assert client.health() == "serving"


def test_a_client_counts_the_limits_that_the_daemon_tells(plain):
    limits = plain.info().limits
    assert limits.max_grid_elements >= 1_000_000
    assert limits.max_sessions > 0
