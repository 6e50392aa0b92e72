"""Tests that client and daemon comply with the limits published by server.info."""

import os
import re
import signal
import threading

import numpy as np
import pytest
import zmq

from contactd import AnalyticIcs, Client, Grid, InvalidArgument, ResourceExhausted
from support.daemons import eventually
from support.problems import CATTANEO, CATTANEO_PARAMS, ENDLESS, GRID, LONG, QUICK, STEEL


@pytest.fixture
def strict(daemons):
    return daemons.start(limits={"max_frame_bytes": 4096, "max_frames": 3, "max_message_bytes": 6000})


@pytest.mark.parametrize(
    "frames",
    [[bytes(4097)], [b"", b"", b""], [bytes(4000), bytes(4000)]],
    ids=["frame bytes", "frames", "message bytes"],
)
def test_a_message_beyond_the_limits_is_refused_in_words(strict, frames):
    with strict.raw() as raw:
        answer = raw.ask("server.health", {}, *frames)
        assert (answer.status, answer.reason) == ("INVALID_ARGUMENT", "LIMIT_EXCEEDED")
        assert raw.ask("server.health").status == "OK"


def test_the_client_refuses_before_it_sends(strict):
    problem = CATTANEO.replace(gap=np.zeros((40, 40)))
    with strict.client() as client:
        with pytest.raises(InvalidArgument, match="at most 4096") as caught:
            client.solve(problem)
        assert caught.value.reason == "LIMIT_EXCEEDED"
        assert client.info().counters["solves"] == 0


def test_a_frame_beyond_all_measure_costs_its_sender_only(strict):
    with strict.raw() as careless, strict.client() as client:
        careless.send("server.health", {}, bytes(1_000_000))
        assert not careless.socket.poll(300)
        assert client.health() == "serving"


def test_a_grid_beyond_the_limit_is_refused(daemons):
    with daemons.start(limits={"max_grid_elements": 100}).client() as client:
        client.solve(CATTANEO.replace(grid=Grid.centred(10, 10, 2.4, 2.4)))
        with pytest.raises(InvalidArgument, match=r"grid\.nx"):
            client.solve(CATTANEO.replace(grid=Grid.centred(11, 10, 2.4, 2.4)))


@pytest.mark.parametrize(("nx", "ny"), [(101, 1), (1, 5_000_000), (10**12, 10**12), (11, 10)])
def test_every_grid_beyond_the_limit_hears_of_the_limit(daemons, nx, ny):
    grid = {"nx": nx, "ny": ny, "dx": 1, "dy": 1}
    many = {"problems": [CATTANEO_PARAMS, {**CATTANEO_PARAMS, "grid": grid}]}
    table = {"material": {"G": 1, "nu": 0}, "grid": grid, "ics": {"source": "analytic"}}
    with daemons.start(limits={"max_grid_elements": 100}).raw() as raw:
        for method, params in (("contact.solve", {**CATTANEO_PARAMS, "grid": grid}), ("ic.get", table)):
            answer = raw.ask(method, params)
            assert answer.reason == "LIMIT_EXCEEDED"
            assert re.search(r"\b100\b", answer.message)
            assert "(limits.max_grid_elements)" in answer.message
        assert "(limits.max_grid_elements)" in raw.ask("contact.solve_many", many).message


def test_a_full_queue_refuses_for_now(daemons, background):
    daemon = daemons.start(limits={"max_queue": 1})
    with daemon.client() as client:
        first = background(client.get_ic, STEEL, GRID, LONG)
        eventually(daemon.builders)
        with pytest.raises(ResourceExhausted) as caught:
            client.get_ic(STEEL, GRID, QUICK)
        assert caught.value.reason == "QUEUE_FULL"
        assert caught.value.retry_delay > 0
        assert client.health() == "serving"
        client.cancel_job(client.jobs()[0].job)
        assert first.exception() is not None
        assert client.get_ic(STEEL, GRID, QUICK).origin == "built"


def test_a_client_that_vanishes_disturbs_nobody(daemon, client):
    for _ in range(20):
        with daemon.raw() as raw:
            raw.send("contact.solve", CATTANEO_PARAMS)
    assert client.solve(CATTANEO).converged


def test_an_interrupted_wait_leaves_client_and_daemon_usable(daemon):
    def interrupt():
        with daemon.client() as watcher:
            eventually(watcher.jobs)
        os.kill(os.getpid(), signal.SIGINT)

    with Client(daemon.endpoint, timeout=50) as client:
        killer = threading.Thread(target=interrupt)
        killer.start()
        with pytest.raises(KeyboardInterrupt):
            client.get_ic(STEEL, GRID, LONG)
        killer.join()
        (job,) = client.jobs()
        client.cancel_job(job.job)
        assert client.solve(CATTANEO).converged


def test_a_req_socket_gets_its_answer_and_no_progress(daemon):
    params = {"material": {"G": 1, "nu": 0.3}, "grid": {"nx": 4, "ny": 4, "dx": 1, "dy": 1}}
    ics = {"source": "fem", "preset": "paper-test2", "order": 1, "L_over_h": 40}
    with daemon.raw(zmq.REQ) as raw:
        assert raw.ask("ic.get", {**params, "ics": ics}).result["origin"] == "built"
        assert raw.ask("server.health").result["state"] == "serving"


def test_a_table_that_is_too_large_for_a_message_comes_in_pieces(daemons, shared):
    grid = Grid(20, 16, 0.8, 0.8)
    whole = shared.get_ic(STEEL, grid, AnalyticIcs())
    small = daemons.start("small", limits={"max_frame_bytes": 3000})
    with small.client() as client:
        pieces = client.get_ic(STEEL, grid, AnalyticIcs())
        assert client.info().counters["closed_form"] == 1
    assert (pieces.array == whole.array).all()
    assert (pieces.key, pieces.spec) == (whole.key, whole.spec)


def test_a_solve_that_no_caller_waits_for_any_more_ends(client):
    class Enough(Exception):
        pass

    def stop(progress):
        raise Enough

    with pytest.raises(Enough):
        client.solve(ENDLESS, on_progress=stop)
    eventually(lambda: client.info().queue["solves_running"] == 0)
    assert client.jobs() == ()
