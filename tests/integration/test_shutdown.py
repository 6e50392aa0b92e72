"""SIGTERM and SIGINT end the daemon in order, whatever it is doing."""

import signal

import pytest

from contactd import Grid, SolverSettings, Unavailable
from support.daemons import eventually
from support.problems import CATTANEO, GRID, LONG, QUICK, STEEL

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
    # The solve is a job as well, and which of the three comes first is left to chance.
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
    endless = SolverSettings(tolerance=1e-300, max_iterations=1_000_000)
    problem = CATTANEO.replace(grid=Grid.centred(320, 320, 2.4, 2.4), normal=endless)
    caller = background(client.solve, problem)
    eventually(lambda: any(job.state == "running" for job in client.jobs()))
    assert end(daemon, signal.SIGTERM) == 0
    with pytest.raises(Unavailable):
        caller.result()


def test_a_second_signal_changes_nothing(daemon, client, background):
    caller = background(client.get_ic, STEEL, GRID, LONG)
    eventually(daemon.builders)
    daemon.process.send_signal(signal.SIGTERM)
    assert end(daemon, signal.SIGTERM) == 0
    assert caller.exception() is not None
