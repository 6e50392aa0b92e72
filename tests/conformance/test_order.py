"""Tests the order of work. One worker is busy while requests are queued; an endless one at the wrong position would be
noticed."""

import numpy as np
import pytest

from conformance.queues import line_up
from conformance.requests import ENDLESS, SOLVE, STRESS
from conformance.wire import CANCELLED, INVALID_ARGUMENT, OK, RESOURCE_EXHAUSTED

PASSED_OVER = 16


@pytest.fixture
def busy(start):
    """Provides a daemon with one worker, which a first peer keeps busy until it cancels."""
    daemon = start(workers=1)
    with daemon.peer() as first:
        name = first.send("contact.solve", ENDLESS)
        assert first.message().progress["stage"]
        daemon.release = lambda: first.cancel(name)
        with daemon.peer() as daemon.onlooker:
            yield daemon


def test_clients_take_turns(busy):
    with busy.peer() as greedy, busy.peer() as modest:
        endless = line_up(busy.onlooker, greedy, "contact.solve", ENDLESS, times=3)
        line_up(busy.onlooker, modest, "contact.subsurface", STRESS)
        busy.release()
        assert greedy.message().id == endless[0]
        # The first request of the greedy client runs, and is ended; then the other client has its turn.
        greedy.cancel(endless[0])
        assert modest.reply().code == OK
        greedy.cancel(endless[1])
        greedy.cancel(endless[2])


@pytest.mark.parametrize(("first", "then"), [("low", "normal"), ("normal", "high"), ("low", "high")])
def test_a_higher_priority_goes_first(busy, first, then):
    with busy.peer() as patient, busy.peer() as urgent:
        endless = line_up(busy.onlooker, patient, "contact.solve", ENDLESS, priority=first)
        line_up(busy.onlooker, urgent, "contact.subsurface", STRESS, priority=then)
        busy.release()
        assert urgent.reply().code == OK
        patient.cancel(endless)


def test_many_problems_are_low_and_others_normal_unless_they_say_so(busy):
    with busy.peer() as batch, busy.peer() as single:
        endless = line_up(busy.onlooker, batch, "contact.solve_many", {"problems": [ENDLESS]})
        line_up(busy.onlooker, single, "contact.subsurface", STRESS)
        busy.release()
        assert single.reply().code == OK
        batch.cancel(endless)


def test_a_step_overtakes_a_batch_that_runs(start):
    daemon = start(workers=1)
    friction = {"mu": 0.3, "rolling": {"xi": 0.002, "eta": 0.001, "phi": 0.01}}
    problem = {**SOLVE, "grid": {"nx": 100, "ny": 100, "dx": 0.024, "dy": 0.024}, "friction": friction}
    with daemon.peer() as batch, daemon.peer() as step:
        many = batch.send("contact.solve_many", {"problems": [problem] * 100})
        assert batch.message().progress["stage"] == "batch"
        assert step.ask("contact.solve", SOLVE, priority="high").code == OK
        batch.send("request.cancel", {"id": many})
        assert batch.reply().reason == "REQUEST_CANCELLED", "the batch was through before the step"


def test_what_waits_for_a_peer_that_has_gone_is_dropped(busy):
    with busy.peer() as leaves:
        line_up(busy.onlooker, leaves, "contact.solve", ENDLESS, times=3)
    while busy.onlooker.ask("server.info").result["queue"]["solves_waiting"] > 0:
        pass  # within the time limit of a test
    with busy.peer() as stays:
        line_up(busy.onlooker, stays, "contact.subsurface", STRESS)
        busy.release()
        assert stays.reply().code == OK


def test_waiting_solves_are_jobs(busy):
    with busy.peer() as waits:
        line_up(busy.onlooker, waits, "contact.solve", ENDLESS)
        running, queued = busy.onlooker.ask("job.list").result["jobs"]
        assert [job["state"] for job in (running, queued)] == ["running", "queued"]
        assert busy.onlooker.ask("job.cancel", {"job": queued["job"]}).code == OK
        assert waits.reply().reason == "JOB_CANCELLED"


def test_nothing_starves(busy):
    with busy.peer() as patient, busy.peer() as urgent:
        line_up(busy.onlooker, patient, "contact.subsurface", STRESS, priority="low")
        line_up(busy.onlooker, urgent, "contact.subsurface", STRESS, times=PASSED_OVER, priority="high")
        endless = line_up(busy.onlooker, urgent, "contact.solve", ENDLESS, priority="high")
        busy.release()
        assert patient.reply().code == OK
        assert [urgent.reply().code for _ in range(PASSED_OVER)] == [OK] * PASSED_OVER
        urgent.cancel(endless)


def refused(reply, name):
    assert (reply.code, reply.reason) == (RESOURCE_EXHAUSTED, "QUEUE_FULL")
    assert name in reply.text
    return reply.details["retry_delay_ms"] > 0


def test_requests_that_wait_are_bounded(start):
    daemon = start(limits={"max_queue": 2})
    with daemon.peer() as peer, daemon.peer() as other:
        names = [peer.send("health.watch"), other.send("contact.solve", ENDLESS)]
        assert other.message().progress["stage"]
        assert peer.message().progress["state"]
        assert refused(peer.ask("contact.solve", SOLVE), "max_queue)")
        assert peer.ask("server.health").code == OK  # answered immediately, so there are never too many
        peer.cancel(names[0])
        assert peer.ask("contact.solve", SOLVE).code == OK
        other.cancel(names[1])


def test_requests_of_one_client_are_bounded(start):
    daemon = start(limits={"max_queue_per_client": 2})
    with daemon.peer() as greedy, daemon.peer() as other:
        names = [greedy.send("health.watch"), greedy.send("health.watch")]
        assert refused(greedy.ask("contact.solve", SOLVE), "max_queue_per_client")
        assert other.ask("contact.solve", SOLVE).code == OK
        greedy.cancel(names[0])
        assert greedy.ask("contact.solve", SOLVE).code == OK


def test_bytes_of_requests_that_wait_are_bounded(start):
    daemon = start(workers=1, limits={"max_queue_bytes": 80_000})
    gap = np.zeros((80, 80))
    params = {**ENDLESS, "gap": {"array": {"$array": {"frame": 1, "dtype": "<f8", "shape": [80, 80]}}}}
    with daemon.peer() as peer:
        first = peer.send("contact.solve", params, gap.tobytes())
        assert peer.message().progress["stage"]
        assert refused(peer.ask("contact.solve", params, gap.tobytes()), "max_queue_bytes")
        small = peer.send("contact.solve", SOLVE)  # served between the turns of the long one, or after it
        cancel = peer.send("request.cancel", {"id": first})
        replies = {reply.id: reply.code for reply in (peer.reply(), peer.reply(), peer.reply())}
        assert replies == {first: CANCELLED, small: OK, cancel: OK}


def test_a_request_larger_than_the_bound_is_let_in_alone(start):
    daemon = start(limits={"max_queue_bytes": 1024})
    listed = {**SOLVE, "gap": {"array": [[0.0123456789] * 6] * 5}, "previous": {"pressure": [[0.0123456789] * 6] * 5}}
    with daemon.peer() as peer:
        assert peer.ask("contact.solve", {**listed, "initial": {"pressure": [[0.01234567] * 6] * 5}}).code in (
            OK, INVALID_ARGUMENT,
        )  # fmt: skip
