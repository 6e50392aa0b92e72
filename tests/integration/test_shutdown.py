"""Tests that SIGTERM and SIGINT end the daemon in order at any time: accepted requests are finished within their time,
or answered."""

import signal

import pytest

from contactd import Cancelled, Grid, Unavailable
from support.daemons import eventually
from support.metrics import metric
from support.problems import CATTANEO, CATTANEO_PARAMS, ENDLESS, GRID, LONG, QUICK, STEEL

LARGE_TABLE = {
    "material": {"G": 82000, "nu": 0.28},
    "grid": {"nx": 300, "ny": 300, "dx": 0.8, "dy": 0.8},
    "ics": {"source": "analytic"},
}
SIGNALS = pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGINT], ids=lambda s: s.name)


def end(daemon, ending):
    daemon.process.send_signal(ending)
    return daemon.process.wait(20)


@SIGNALS
def test_an_idle_daemon_ends_with_status_zero(daemon, ending):
    assert end(daemon, ending) == 0


@SIGNALS
def test_a_daemon_that_has_worked_ends_with_status_zero(daemon, client, ending):
    client.solve(CATTANEO)
    client.get_ic(STEEL, GRID, QUICK)
    assert end(daemon, ending) == 0


@SIGNALS
def test_a_building_daemon_ends_its_builder_and_tells_its_callers(daemon, client, background, ending):
    callers = [background(client.get_ic, STEEL, GRID, LONG) for _ in range(2)]
    callers.append(background(client.solve, CATTANEO.replace(grid=GRID, upper=STEEL, ics=LONG)))
    # The solve is also a job, and the order of the three is random.
    eventually(lambda: any(job.kind == "build" and job.callers == 3 for job in client.jobs()))
    eventually(daemon.builders)
    assert end(daemon, ending) == 0
    for caller in callers:
        with pytest.raises(Unavailable) as caught:
            caller.result()
        assert caught.value.reason == "STOPPING"
    assert daemon.builders() == []
    assert daemon.tables() == []


def test_a_queued_build_is_given_up(daemon, client, background):
    callers = [background(client.get_ic, STEEL, GRID, LONG)]
    eventually(daemon.builders)
    callers.append(background(client.get_ic, STEEL, GRID, QUICK))
    eventually(lambda: len(client.jobs()) == 2)
    assert end(daemon, signal.SIGTERM) == 0
    for caller in callers:
        with pytest.raises(Unavailable):
            caller.result()


def test_a_running_solve_is_given_up(daemon, client, background):
    caller = background(client.solve, ENDLESS)
    eventually(lambda: any(job.state == "running" for job in client.jobs()))
    assert end(daemon, signal.SIGTERM) == 0
    with pytest.raises(Unavailable):
        caller.result()


def test_a_second_signal_ends_the_wait_for_what_was_accepted(daemons, background):
    daemon = daemons.start(shutdown={"drain_seconds": 600})
    with daemon.client() as client:
        caller = background(client.solve, ENDLESS)
        eventually(lambda: any(job.state == "running" for job in client.jobs()))
        daemon.process.send_signal(signal.SIGTERM)
        eventually(lambda: client.health() == "stopping")
        assert not caller.done()
        assert end(daemon, signal.SIGINT) == 0
        with pytest.raises(Unavailable):
            caller.result()


@SIGNALS
def test_what_was_accepted_is_finished_and_what_is_new_is_refused(daemons, background, ending):
    daemon = daemons.start(shutdown={"drain_seconds": 600})
    with daemon.client() as client:
        caller = background(client.get_ic, STEEL, GRID, LONG)
        eventually(lambda: any(job.state == "running" for job in client.jobs()))
        accepted = background(client.solve, CATTANEO.replace(grid=GRID, upper=STEEL, ics=LONG))
        eventually(lambda: any(job.callers == 2 for job in client.jobs()))
        daemon.process.send_signal(ending)
        eventually(lambda: client.health() == "stopping")
        with pytest.raises(Unavailable) as caught:
            client.solve(CATTANEO)
        assert caught.value.reason == "STOPPING"
        for job in client.jobs():  # the client may still cancel its request, after which none is left to wait for
            if job.kind == "build":
                client.cancel_job(job.job)
        for future in (caller, accepted):
            with pytest.raises(Cancelled):
                future.result()
    assert daemon.process.wait(20) == 0


def test_a_solve_that_was_accepted_is_answered_before_the_end(daemons, background):
    daemon = daemons.start(shutdown={"drain_seconds": 600}, workers=1)
    with daemon.client() as client:
        large = CATTANEO.replace(grid=Grid.centred(320, 320, 2.4, 2.4))
        callers = [background(client.solve, large) for _ in range(4)]
        eventually(lambda: len(client.jobs()) >= 1)
        eventually(lambda: metric(client, "contactd_open_requests") == 4)
        daemon.process.send_signal(signal.SIGTERM)
        assert all(caller.result().converged for caller in callers)
    assert daemon.process.wait(20) == 0


def test_what_is_not_finished_in_time_is_cancelled_with_an_answer(daemons, background):
    daemon = daemons.start(shutdown={"drain_seconds": 1})
    with daemon.client() as client:
        callers = [background(client.solve, ENDLESS), background(client.get_ic, STEEL, GRID, LONG)]
        eventually(lambda: sum(job.state == "running" for job in client.jobs()) == 2)
        assert end(daemon, signal.SIGTERM) == 0
        for caller in callers:
            with pytest.raises(Unavailable):
                caller.result()


def test_every_request_of_a_flood_is_answered(daemons):
    daemon = daemons.start(shutdown={"drain_seconds": 600}, limits={"max_queue_per_client": 256})
    with daemon.raw() as raw:
        sent = {raw.send("contact.solve", CATTANEO_PARAMS) for _ in range(200)}
        answers = [raw.receive()]
        daemon.process.send_signal(signal.SIGTERM)
        answers += [raw.receive() for _ in range(len(sent) - 1)]
    assert {answer.envelope["id"] for answer in answers} == sent
    assert {answer.status for answer in answers} <= {"OK", "UNAVAILABLE"}
    assert daemon.process.wait(20) == 0


def test_a_client_that_does_not_read_holds_the_end_up_for_seconds_only(daemons):
    daemon = daemons.start(shutdown={"drain_seconds": 600})
    with daemon.raw() as raw:
        for _ in range(8):
            raw.send("ic.get", LARGE_TABLE)
        with daemon.client() as other:
            eventually(lambda: metric(other, "contactd_open_requests") == 0)
        assert end(daemon, signal.SIGTERM) == 0
