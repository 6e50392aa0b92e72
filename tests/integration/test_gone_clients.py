"""Tests requests of clients that have disconnected, which are not computed because nobody can receive the answer."""

import pytest
import zmq

from contactd import Cancelled, TimeoutExpired
from support.daemons import eventually
from support.metrics import metric
from support.problems import CATTANEO_PARAMS, ENDLESS, GRID, LONG, STEEL
from support.raw import RawClient
from support.sessions import OPEN


@pytest.fixture(params=["ipc", "tcp"])
def busy(request, daemons, background):
    """Provides a daemon whose only worker is busy, and a client of it."""
    endpoint = {"endpoint": "tcp://127.0.0.1:*"} if request.param == "tcp" else {}
    daemon = daemons.start(workers=1, **endpoint)
    with daemon.client() as client:
        endless = background(client.solve, ENDLESS)
        eventually(lambda: [job.state for job in client.jobs()] == ["running"])
        yield daemon, client
        for job in client.jobs():
            client.cancel_job(job.job)
        with pytest.raises(Cancelled):
            endless.result()


def running(client):
    return next(job.job for job in client.jobs() if job.state == "running")


def queued(client):
    return [job for job in client.jobs() if job.state == "queued"]


def test_waiting_solves_are_listed_and_can_be_cancelled(busy):
    daemon, client = busy
    with daemon.raw() as raw:
        raw.send("contact.solve", CATTANEO_PARAMS)
        raw.send("contact.solve_many", {"problems": [CATTANEO_PARAMS] * 2})
        eventually(lambda: len(queued(client)) == 2)
        assert [(job.kind, job.callers) for job in queued(client)] == [("solve", 1)] * 2
        for job in queued(client):
            client.cancel_job(job.job)
            answer = raw.receive()
            assert (answer.status, answer.reason) == ("CANCELLED", "JOB_CANCELLED")
        assert queued(client) == []
        assert client.info().queue["solves_waiting"] == 0


def test_waiting_requests_of_a_client_that_has_gone_are_dropped(busy):
    daemon, client = busy
    before = client.info().counters["solves"]
    with daemon.raw() as raw:
        for _ in range(10):
            raw.send("contact.solve", CATTANEO_PARAMS)
        raw.send("contact.solve", {**CATTANEO_PARAMS, "previous": {"pressure": [[0.0] * 40] * 40}, "x": "y" * 100_000})
        eventually(lambda: len(queued(client)) >= 10)
    eventually(lambda: queued(client) == [], "requests of a client that has gone still wait")
    eventually(lambda: metric(client, "contactd_open_requests") == 1)
    assert client.info().queue["solves_waiting"] == 0
    assert client.info().counters["solves"] == before
    assert metric(client, "contactd_request_errors_total", reason="CLIENT_GONE") >= 10


def test_more_requests_than_are_read_at_once_are_dropped_with_their_client(busy):
    daemon, client = busy
    connections = metric(client, "contactd_connections")
    with daemon.raw() as raw:
        raw.socket.setsockopt(zmq.LINGER, 5000)
        for _ in range(200):
            raw.send("contact.solve", CATTANEO_PARAMS)
        eventually(lambda: len(queued(client)) > 0)
        raw.socket.close()  # sends pending messages before it disconnects
    eventually(lambda: metric(client, "contactd_connections") == connections)
    eventually(lambda: queued(client) == [])
    assert client.info().queue["solves_waiting"] == 0


def test_a_running_solve_ends_with_its_client(daemons):
    daemon = daemons.start(workers=1)
    with daemon.client() as client:
        with daemon.raw() as raw:
            raw.send("contact.solve", {**CATTANEO_PARAMS, "friction": {"mu": 0.4, "rolling": ROLLING}})
            eventually(lambda: [job.state for job in client.jobs()] == ["running"])
        eventually(lambda: client.jobs() == ())
        eventually(lambda: client.info().queue["solves_running"] == 0)


def test_requests_of_others_stay(busy):
    daemon, client = busy
    with daemon.raw() as stays:
        stays.send("contact.solve", CATTANEO_PARAMS)
        with daemon.raw() as leaves:
            leaves.send("contact.solve", CATTANEO_PARAMS)
            eventually(lambda: len(queued(client)) == 2)
        eventually(lambda: len(queued(client)) == 1)
        client.cancel_job(running(client))
        assert stays.receive().status == "OK"


@pytest.mark.parametrize("ending", ["cancels", "runs out of time", "goes"])
def test_a_build_counts_the_callers_that_still_wait(daemon, client, background, ending):
    first = background(client.get_ic, STEEL, GRID, LONG)
    eventually(daemon.builders)
    params = {"material": {"G": 1, "nu": STEEL.nu}, "grid": {"nx": 6, "ny": 6, "dx": 0.8, "dy": 0.8}}
    params["ics"] = {"source": "fem", "preset": "paper-test1", "order": 2, "L_over_h": 1000}
    with daemon.raw() as raw:
        name = raw.send("ic.get", params, timeout_ms=500 if ending == "runs out of time" else 60_000)
        if ending != "runs out of time":
            eventually(lambda: [job.callers for job in client.jobs()] == [2])
        if ending == "cancels":
            raw.send("request.cancel", {"id": name})
        if ending == "runs out of time":
            assert raw.receive().status == "DEADLINE_EXCEEDED"
        if ending != "goes":
            eventually(lambda: [job.callers for job in client.jobs()] == [1])
    eventually(lambda: [job.callers for job in client.jobs()] == [1])
    assert len(daemon.builders()) == 1
    client.cancel_job(client.jobs()[0].job)
    with pytest.raises(Cancelled):
        first.result()


def test_a_build_without_callers_goes_on_and_says_so(daemon, client):
    with pytest.raises(TimeoutExpired):
        client.get_ic(STEEL, GRID, LONG, timeout=4)  # begins to build within this time, also on a busy machine
    eventually(lambda: [job.callers for job in client.jobs()] == [0])
    assert len(daemon.builders()) == 1
    client.cancel_job(client.jobs()[0].job)


ROLLING = {"kind": "transient", "xi": 1e-3, "steps": 100_000}


def test_a_step_that_runs_is_finished_and_heard_by_who_comes_back(daemon, client):
    rolling = {"mu": 0.4, "rolling": {**ROLLING, "steps": 3000}}
    with daemon.raw() as raw:
        session = raw.ask("session.open", {**OPEN, "friction": rolling}).result["session"]
        raw.send("session.step", {"session": session, "step": 1})
        raw.send("session.step", {"session": session, "step": 2})
        eventually(lambda: sorted(job.state for job in client.jobs()) == ["queued", "running"])
    eventually(lambda: [job.state for job in client.jobs()] == ["running"], "the waiting step was not dropped")
    with daemon.raw() as raw:
        answer = raw.ask("session.step", {"session": session, "step": 1})
        assert answer.result["step"] == 1
        assert raw.ask("session.close", {"session": session}).result == {"step": 1}
    solves = sum(metric(client, "contactd_solves_total", converged=converged) for converged in ("true", "false"))
    assert solves == 1


def test_a_client_that_chose_its_identity_gets_its_answer_when_it_is_back(busy):
    daemon, client = busy
    connections = metric(client, "contactd_connections")

    def connected():
        raw = RawClient(daemon.endpoint)
        raw.socket.close()
        raw.socket = raw._context.socket(zmq.DEALER)  # the identity must be set before connecting
        raw.socket.setsockopt(zmq.IDENTITY, b"mine")
        raw.socket.setsockopt(zmq.LINGER, 0)
        raw.socket.connect(daemon.endpoint)
        return raw

    with connected() as raw:
        raw.send("contact.solve", CATTANEO_PARAMS, id="before")
        eventually(lambda: len(queued(client)) == 1)
    eventually(lambda: metric(client, "contactd_connections") == connections)
    with connected() as raw:
        raw._methods["before"] = "contact.solve"
        assert raw.ask("server.health").result["state"] == "serving"
        (job,) = queued(client)
        client.cancel_job(job.job)
        answer = raw.receive()
        assert (answer.envelope["id"], answer.reason) == ("before", "JOB_CANCELLED")
