"""Tests builders that fail, are killed, or run behind a launcher."""

import os
import shutil
import signal
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from contactd import InternalError
from support.daemons import BIN, eventually
from support.problems import CATTANEO, GRID, LONG, QUICK, STEEL


def script(folder, *lines):
    path = Path(folder) / "builder"
    path.write_text("\n".join(["#!/bin/sh", *lines, ""]))
    path.chmod(0o755)
    return path


def build_failure(client, ics=QUICK):
    with pytest.raises(InternalError) as caught:
        client.get_ic(STEEL, GRID, ics)
    assert caught.value.reason == "BUILD_FAILED"
    return caught.value.message


def test_a_killed_builder_fails_its_callers_and_nothing_else(daemon, client, background):
    first = background(client.get_ic, STEEL, GRID, LONG)
    eventually(daemon.builders)
    second = background(client.solve, CATTANEO.replace(upper=STEEL, grid=GRID, ics=LONG))
    eventually(lambda: any(job.kind == "build" and job.callers == 2 for job in client.jobs()))
    os.kill(daemon.builders()[0], signal.SIGKILL)
    for caller in (first, second):
        with pytest.raises(InternalError, match="signal 9") as caught:
            caller.result()
        assert caught.value.reason == "BUILD_FAILED"
    assert client.solve(CATTANEO).converged
    assert client.get_ic(STEEL, GRID, QUICK).origin == "built"
    counters = client.info().counters
    assert (counters["builds_failed"], counters["builds_finished"]) == (1, 1)


def test_a_failed_build_is_tried_again_by_the_next_request(daemons):
    program = script(daemons.folder, f'[ -e "$0.ran" ] && exec {BIN / "contactd-ic"} "$@"', ': > "$0.ran"', "exit 1")
    daemon = daemons.start(builds={"program": str(program)})
    with daemon.client() as client:
        build_failure(client)
        assert client.get_ic(STEEL, GRID, QUICK).origin == "built"
    Path(f"{program}.ran").unlink()
    program.unlink()


def test_a_builder_that_does_not_exist_is_named(daemons):
    with daemons.start(builds={"program": "/nonexistent/contactd-ic"}).client() as client:
        assert "builds.program is /nonexistent/contactd-ic; it cannot be started: No such file" in build_failure(client)
        assert client.health() == "serving"


def test_a_launcher_that_does_not_exist_is_named(daemons):
    with daemons.start(builds={"launcher": ["no-such-launcher", "-np", "2"]}).client() as client:
        assert "builds.launcher begins with no-such-launcher; it cannot be started" in build_failure(client)


def test_a_builder_that_its_launcher_does_not_find_is_named(daemons):
    with daemons.start(builds={"program": "no-such-builder", "launcher": ["setsid", "--wait"]}).client() as client:
        message = build_failure(client)
    assert "builds.program is no-such-builder, started by setsid; it cannot be started: " in message
    assert "CONTACTD_IC" in message and 'pip install "contactd[daemon]"' in message and "directory The" not in message


def test_the_words_of_a_failing_builder_reach_the_caller(daemons):
    program = script(daemons.folder, "echo chatter", 'echo "the licence has expired" >&2', "exit 3")
    with daemons.start(builds={"program": str(program)}).client() as client:
        message = build_failure(client)
    assert "status 3" in message
    assert "the licence has expired" in message
    program.unlink()


def test_a_builder_that_writes_no_table_has_failed(daemons):
    program = script(daemons.folder, "exit 0")
    with daemons.start(builds={"program": str(program)}).client() as client:
        build_failure(client)
    program.unlink()


def test_a_builder_that_writes_rubbish_has_failed_and_the_rubbish_is_not_served(daemons):
    lines = ['while [ "$1" != --output ]; do shift; done', 'head -c 4096 /dev/zero > "$2"']
    program = script(daemons.folder, *lines)
    with daemons.start(builds={"program": str(program)}).client() as client:
        build_failure(client)
        build_failure(client)
    program.unlink()
    for path in (daemons.folder / "daemon" / "store").glob("*.h5"):
        path.unlink()


def test_a_solve_that_misses_its_tolerance_is_a_failed_build(client):
    message = build_failure(client, replace(QUICK, solver="amg_pcg", max_iterations=1))
    assert "converge" in message or "residual" in message


def test_a_launcher_is_put_before_the_builder(daemons):
    with daemons.start(builds={"launcher": ["env", "CONTACTD_TEST=1"]}).client() as client:
        assert client.get_ic(STEEL, GRID, QUICK).origin == "built"


@pytest.mark.skipif(shutil.which("mpirun") is None, reason="mpirun is not installed")
def test_two_processes_build_the_same_table(daemons, client):
    launcher = ["mpirun", "-np", "2", "--oversubscribe"]
    with daemons.start("parallel", builds={"launcher": launcher}).client() as parallel:
        table = parallel.get_ic(STEEL, GRID, QUICK)
    reference = client.get_ic(STEEL, GRID, QUICK)
    assert table.evidence.processes == 2
    np.testing.assert_allclose(table.array, reference.array, rtol=0, atol=1e-6 * np.abs(reference.array).max())


@pytest.mark.skipif(shutil.which("mpirun") is None, reason="mpirun is not installed")
def test_cancelling_a_parallel_build_ends_all_its_processes(daemons, background):
    daemon = daemons.start(builds={"launcher": ["mpirun", "-np", "2", "--oversubscribe"]})
    with daemon.client() as client:
        caller = background(client.get_ic, STEEL, GRID, LONG)
        eventually(lambda: len(daemon.builders()) >= 3)
        client.cancel_job(client.jobs()[0].job)
        assert caller.exception() is not None
        eventually(lambda: not daemon.builders(), "builders are still there")
