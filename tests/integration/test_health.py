"""Tests that server.health answers while everything else is busy."""

import time

from support.daemons import eventually
from support.problems import ENDLESS, GRID, LONG, STEEL


def test_health_answers_while_a_build_and_two_large_solves_run(daemon, client, background):
    work = [background(client.get_ic, STEEL, GRID, LONG)]
    eventually(client.jobs)  # the solves occupy all workers, so a build would not even begin
    work += [background(client.solve, ENDLESS) for _ in range(2)]
    # One of two workers never takes large solves.
    eventually(lambda: sum(job.state == "running" for job in client.jobs()) == 2)
    latencies = []
    for _ in range(50):
        start = time.perf_counter()
        assert client.health() == "serving"
        latencies.append(1000 * (time.perf_counter() - start))
    assert not any(future.done() for future in work)
    print(f"health beside three jobs: median {sorted(latencies)[25]:.2f} ms, largest {max(latencies):.2f} ms")
    for job in client.jobs():
        client.cancel_job(job.job)
    for future in work:
        assert future.exception() is not None


def test_a_builder_or_launcher_that_is_missing_is_said_at_the_start_and_while_it_is(daemons):
    program = daemons.folder / "builder"
    daemon = daemons.start(builds={"program": str(program), "launcher": ["no-such-launcher", "-n", "2"]})
    with daemon.client() as client:
        first, second = client.call("server.health")["warnings"]
        assert first.startswith(f"builds.program is {program}, which is not an executable program")
        assert second.startswith('builds.launcher starts with "no-such-launcher", which is not on PATH')
        assert first in daemon.log
        assert second.replace('"', "") in daemon.log.replace('\\"', "").replace('"', "")
        program.write_text("#!/bin/sh\n")
        program.chmod(0o755)
        assert client.call("server.health")["warnings"] == [second]
    program.unlink()


def test_a_daemon_that_has_all_it_needs_has_no_warnings(daemon, client):
    assert client.call("server.health")["warnings"] == []
    assert "warning" not in daemon.log


def test_a_store_that_cannot_be_written_to_is_said_at_the_start(daemons):
    daemon = daemons.start(store={"folder": "/proc/self"})
    with daemon.client() as client:
        (warning,) = client.call("server.health")["warnings"]
    assert "folder is not writable" in warning
    assert "/proc/self" in daemon.log, "the log says where, and nobody else"
    assert "/proc/self" not in warning
