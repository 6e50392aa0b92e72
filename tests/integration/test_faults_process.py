"""Tests faults of the daemon's or a client's process: no descriptor left, SIGTERM under load, a wrong clock."""

import contextlib
import signal

import pytest

from contactd import InternalError
from support.daemons import eventually
from support.faults import clock_shim, python_with, start_as
from support.problems import CATTANEO, CATTANEO_PARAMS, GRID, QUICK, STEEL


def test_a_daemon_without_file_descriptors_serves_on_and_recovers(daemons):
    daemon = start_as(daemons, "prlimit", "--nofile=48:48")
    with daemon.client() as client, contextlib.ExitStack() as crowd:
        assert client.solve(CATTANEO).converged
        for _ in range(60):
            crowd.enter_context(daemon.raw()).send("server.health")
        with pytest.raises(InternalError):
            client.get_ic(STEEL, GRID, QUICK)
        assert client.solve(CATTANEO).converged
        crowd.close()
        eventually(lambda: can_build(client))
        assert client.quarantined_ics() == ()
    with daemon.client() as another:
        assert another.health() == "serving"


def can_build(client):
    try:
        return client.get_ic(STEEL, GRID, QUICK).origin in ("built", "disk")
    except InternalError:
        return False


def test_nothing_accepted_is_lost_when_the_daemon_is_told_to_end_under_load(daemons):
    daemon = daemons.start()
    sent = []
    with contextlib.ExitStack() as stack:
        raws = [stack.enter_context(daemon.raw()) for _ in range(20)]
        table = {"material": {"G": 82000, "nu": 0.28}, "grid": {"nx": 6, "ny": 6, "dx": 0.8, "dy": 0.8}}
        for number, raw in enumerate(raws):
            for n in range(10):
                if n == 5:
                    fem = {"source": "fem", "preset": "paper-test1", "L_over_h": 1000 + number}
                    sent.append((raw, raw.send("ic.get", {**table, "ics": fem})))
                else:
                    sent.append((raw, raw.send("contact.solve", CATTANEO_PARAMS)))
        with daemon.client() as client:
            eventually(lambda: client.info().counters["requests"] > len(sent))  # accepted, all of them
        daemon.process.send_signal(signal.SIGTERM)
        answers = {(raw, answer.envelope["id"]): answer for raw, _ in sent for answer in [raw.receive()]}
        assert set(answers) == set(sent)  # each exactly one
        assert {answer.status for answer in answers.values()} <= {"OK", "UNAVAILABLE"}
        assert any(answer.status == "UNAVAILABLE" for answer in answers.values())
        assert daemon.process.wait(20) == 0
    assert daemon.builders() == []


def test_a_client_whose_clock_is_wrong_is_served_and_its_timeouts_hold(daemon, daemons):
    shim, mark = clock_shim(daemons.folder), daemons.folder / "always"
    mark.touch()
    program = (
        "import sys, time; sys.path.insert(0, sys.argv[2]); import contactd;"
        "from support.problems import CATTANEO, GRID, LONG, STEEL\n"
        "with contactd.Client(sys.argv[1], timeout=20) as client:\n"
        "    print(time.gmtime().tm_year, client.solve(CATTANEO).converged)\n"
        "    try: client.get_ic(STEEL, GRID, LONG, timeout=0.5)\n"
        "    except contactd.TimeoutExpired: print('in time')\n"
        "    client.cancel_job(client.jobs()[0].job)\n"
    )
    environment = {"LD_PRELOAD": str(shim), "CLOCK_SET_BACK": str(mark)}
    tests = str(__file__).rsplit("/", 2)[0]
    here = python_with({}, "-c", "import time; print(time.gmtime().tm_year)")
    year, converged, rest = python_with(environment, "-c", program, daemon.endpoint, tests).split(maxsplit=2)
    assert int(year) <= int(here) - 9
    assert (converged, rest.strip()) == ("True", "in time")
    shim.unlink()
    mark.unlink()
