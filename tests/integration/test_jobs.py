"""Tests job.list and job.cancel, and timeouts of calls that wait for jobs."""

from dataclasses import replace

import pytest

from contactd import (
    Cancelled,
    DeadlineExceeded,
    FemIcs,
    NotFound,
    TimeoutExpired,
)
from support.daemons import eventually
from support.faults import script
from support.problems import CATTANEO, ENDLESS, GRID, LONG, QUICK, STEEL


def assert_cancelled(future):
    with pytest.raises(Cancelled) as caught:
        future.result()
    assert caught.value.reason == "JOB_CANCELLED"


def running_build(client):
    (job,) = (job for job in client.jobs() if job.kind == "build" and job.state == "running")
    return job


def test_an_idle_daemon_has_no_jobs(client):
    assert client.jobs() == ()


def test_a_cancelled_build_ends_for_every_caller_also_those_who_came_later(daemon, client, background):
    first = background(client.get_ic, STEEL, GRID, LONG)
    eventually(daemon.builders)
    later = background(client.get_ic, replace(STEEL, G=1), replace(GRID, nx=3), LONG)
    eventually(lambda: running_build(client).callers == 2)
    client.cancel_job(running_build(client).job)
    assert_cancelled(first)
    assert_cancelled(later)
    eventually(lambda: not daemon.builders(), "the builder is still there", seconds=5)
    eventually(lambda: client.jobs() == (), "the job is still there")
    assert client.info().counters["builds_cancelled"] == 1
    assert daemon.tables() == []


def test_a_listed_build_says_how_many_seconds_are_left_and_what_memory_it_takes(daemons, background):
    report = '{"stage": "factorisation", "fraction": 0.3, "seconds_left": 12.5, "memory_bytes": 8.7e8}'
    program = script(daemons.folder, f"echo '{report}'", "exec sleep 60")
    with daemons.start(builds={"program": str(program)}).client() as client:
        waiting = background(client.get_ic, STEEL, GRID, QUICK)
        eventually(lambda: any(job.seconds_left == 12.5 for job in client.jobs()))
        assert client.jobs()[0].memory_bytes == 870_000_000
        client.cancel_job(running_build(client).job)
        assert_cancelled(waiting)
    program.unlink()


def test_a_build_says_what_memory_it_will_take_before_it_takes_it(client):
    seen = []
    client.get_ic(STEEL, GRID, QUICK, on_progress=seen.append)
    stated = {progress.memory_bytes for progress in seen if progress.stage != "queued"}
    assert len(stated) == 1, "one estimate, in each report of the builder"
    assert 65e6 < stated.pop() < 1e9


def test_progress_names_the_job_that_can_be_cancelled(client):
    seen = []

    def cancel(progress):
        seen.append(progress)
        if len(seen) == 1:
            client.cancel_job(progress.job)

    with pytest.raises(Cancelled):
        client.get_ic(STEEL, GRID, LONG, on_progress=cancel)
    assert seen[0].job.startswith("build-")


def test_a_build_reports_stages_whose_fraction_grows(client):
    seen = []
    client.get_ic(STEEL, GRID, FemIcs("paper-test3", L_over_h=80), on_progress=seen.append)
    fractions = [progress.fraction for progress in seen]
    assert len({progress.stage for progress in seen if progress.stage}) >= 3
    assert fractions == sorted(fractions)
    assert 0 <= fractions[0] < fractions[-1] <= 1


def test_a_request_after_a_cancelled_build_builds_anew(daemon, client, background):
    first = background(client.get_ic, STEEL, GRID, LONG)
    eventually(daemon.builders)
    client.cancel_job(running_build(client).job)
    second = background(client.get_ic, STEEL, GRID, LONG)
    assert_cancelled(first)
    eventually(lambda: client.info().counters["builds_started"] == 2)
    client.cancel_job(running_build(client).job)
    assert_cancelled(second)


def test_a_queued_build_is_listed_and_can_be_cancelled(daemon, client, background):
    running = background(client.get_ic, STEEL, GRID, LONG)
    eventually(daemon.builders)
    waiting = background(client.get_ic, STEEL, GRID, QUICK)
    eventually(lambda: len(client.jobs()) == 2)
    (queued,) = (job for job in client.jobs() if job.state == "queued")
    assert client.info().queue["builds_waiting"] == 1
    client.cancel_job(queued.job)
    assert_cancelled(waiting)
    assert not running.done()
    client.cancel_job(running_build(client).job)
    assert_cancelled(running)


def test_cancelling_the_build_cancels_the_solve_that_waits_for_it(daemon, client, background):
    solve = background(client.solve, CATTANEO.replace(grid=GRID, ics=LONG))
    eventually(daemon.builders)
    assert sorted(job.kind for job in client.jobs()) == ["build", "solve"]
    client.cancel_job(running_build(client).job)
    assert_cancelled(solve)
    eventually(lambda: client.jobs() == ())


def test_a_running_solve_can_be_cancelled(client, background):
    solve = background(client.solve, ENDLESS)
    eventually(lambda: any(job.kind == "solve" and job.state == "running" for job in client.jobs()))
    client.cancel_job(client.jobs()[0].job)
    assert_cancelled(solve)
    assert client.solve(CATTANEO).converged


@pytest.mark.parametrize("job", ["build-999", "x", "solve-0"])
def test_a_job_that_does_not_exist_cannot_be_cancelled(shared, job):
    with pytest.raises(NotFound) as caught:
        shared.cancel_job(job)
    assert caught.value.reason == "JOB_UNKNOWN"


def test_a_build_goes_on_when_its_caller_ran_out_of_time(client):
    ics = FemIcs("paper-test3", L_over_h=160)
    client.health()  # is connected, so that the time is that of the request
    with pytest.raises(TimeoutExpired):
        client.get_ic(STEEL, GRID, ics, timeout=0.1)
    assert client.get_ic(STEEL, GRID, ics).origin in ("built", "memory")
    assert client.info().counters["builds_started"] == 1


def test_the_daemon_says_when_a_deadline_has_passed(daemon):
    with daemon.raw() as raw:
        answer = raw.ask("ic.get", LONG_PARAMS, timeout_ms=50)
        assert (answer.status, answer.reason) == ("DEADLINE_EXCEEDED", "DEADLINE_PASSED")
        for job in raw.ask("job.list").result["jobs"]:
            raw.ask("job.cancel", {"job": job["job"]})
    assert issubclass(DeadlineExceeded, TimeoutExpired)


LONG_PARAMS = {
    "material": {"G": 82000, "nu": 0.28},
    "grid": {"nx": 6, "ny": 6, "dx": 0.8, "dy": 0.8},
    "ics": {"source": "fem", "preset": "paper-test1", "L_over_h": 1000},
}
