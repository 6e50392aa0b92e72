"""Tests builders that stop, hang, take too long or run out of memory, and tables whose builds fail repeatedly."""

import os
import shutil
import signal
from dataclasses import replace
from pathlib import Path

import pytest

from contactd import FailedPrecondition, FemIcs, Grid, InternalError, InvalidArgument, NotFound, ResourceExhausted
from support.daemons import BIN, eventually
from support.faults import LONG_FAULTS, script
from support.problems import CATTANEO, GRID, LONG, QUICK, STEEL


def failure(client, kind=InternalError, ics=QUICK, grid=GRID):
    with pytest.raises(kind) as caught:
        client.get_ic(STEEL, grid, ics)
    return caught.value


def test_a_stopped_builder_is_noticed_and_ended(daemons, background):
    daemon = daemons.start(builds={"stall_seconds": 2})
    with daemon.client() as client:
        caller = background(client.get_ic, STEEL, GRID, LONG)
        eventually(lambda: any(job.fraction > 0 for job in client.jobs()))
        os.kill(daemon.builders()[0], signal.SIGSTOP)
        with pytest.raises(InternalError, match="no progress for 2 s"):
            caller.result()
        assert daemon.builders() == []
        assert client.get_ic(STEEL, GRID, QUICK).origin == "built"


@pytest.mark.skipif(not LONG_FAULTS or shutil.which("mpirun") is None, reason="needs mpirun, and ./dev faults")
@pytest.mark.parametrize("which", [0, -1], ids=["the first", "the last"])
def test_a_stopped_process_among_several_is_noticed_and_all_are_ended(daemons, background, which):
    builds = {"launcher": ["mpirun", "-np", "2", "--oversubscribe"], "stall_seconds": 5}
    daemon = daemons.start(builds=builds)
    with daemon.client() as client:
        caller = background(client.get_ic, STEEL, GRID, LONG)
        eventually(lambda: any(job.fraction > 0 for job in client.jobs()))
        processes = [pid for pid in daemon.builders() if program_of(pid).endswith("/contactd-ic")]
        assert len(processes) == 2
        os.kill(processes[which], signal.SIGSTOP)
        with pytest.raises(InternalError, match="no progress for 5 s"):
            caller.result()
        eventually(lambda: daemon.builders() == [], "processes are left behind")


def program_of(pid):
    return Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")[0].decode()


def test_a_builder_that_works_is_not_taken_for_a_stopped_one(daemons, background):
    daemon = daemons.start(builds={"stall_seconds": 2})
    with daemon.client() as client:
        caller = background(client.get_ic, STEEL, GRID, LONG)
        eventually(daemon.builders)
        with pytest.raises(TimeoutError):
            caller.result(timeout=4)
        client.cancel_job(client.jobs()[0].job)
        assert caller.exception() is not None


def test_a_builder_that_never_says_a_word_is_ended(daemons):
    program = script(daemons.folder, "exec sleep 600")
    with daemons.start(builds={"program": str(program), "stall_seconds": 1}).client() as client:
        assert "made no progress for 1 s" in failure(client).message
    program.unlink()


def test_what_a_builder_refuses_is_the_clients_mistake_and_not_put_into_quarantine(daemons):
    refusal = '{"error": {"field": "ics.section", "message": "ics.section curves too much", "problem": "curves too much", "kind": "invalid_argument"}}'
    program = script(daemons.folder, f"echo '{refusal}'; exit 2")
    with daemons.start(builds={"program": str(program)}).client() as client:
        for _ in range(3):
            error = failure(client, InvalidArgument)
            assert error.message == "ics.section curves too much"
            assert [(broken.field, broken.description) for broken in error.violations] == [("ics.section", "curves too much")]
    program.unlink()


def test_a_builder_that_misunderstands_the_daemon_is_no_mistake_of_the_client(daemons):
    refusal = '{"error": {"field": "--output", "message": "--output is folder; it does not exist", "kind": ""}}'
    program = script(daemons.folder, f"echo '{refusal}'; exit 2")
    with daemons.start(builds={"program": str(program)}).client() as client:
        assert "--output is folder" in failure(client).message
    program.unlink()


def test_a_build_that_takes_too_long_is_ended(daemons):
    with daemons.start(builds={"max_seconds": 1}).client() as client:
        assert "took longer than 1 s" in failure(client, ics=LONG).message


def test_a_build_without_memory_says_so_in_plain_words(daemons):
    daemon = daemons.start(builds={"max_memory_bytes": 700_000_000})
    with daemon.client() as client:
        error = failure(client, ResourceExhausted, FemIcs("paper-test1", order=2, L_over_h=1000, solver="amg_pcg"))
        assert error.reason == "BUILD_OUT_OF_MEMORY"
        assert "700000000 bytes (builds.max_memory_bytes)" in error.message
        assert client.get_ic(STEEL, GRID, QUICK).origin == "built"


#: Builds of some 60 MB, 0.4 and 1.2 GB.
SIZES = {
    "small": FemIcs(accuracy=1e-2),
    "medium": FemIcs(order=2, f=1.2, solver="direct"),
    "large": FemIcs(order=2, f=1.05, solver="direct"),
}
TO_BUILD = 300  # seconds that the largest of them may take on a busy machine
MIB = 1 << 20
LIMITS = [64, 128, 256, 380, 512, 600, 768, 1024, 2048, 4096]
SWEEP = [(size, limit) for size in SIZES for limit in LIMITS] if LONG_FAULTS else [("small", 64), ("medium", 256)]


@pytest.mark.timeout(TO_BUILD + 60)
@pytest.mark.parametrize(("size", "limit"), SWEEP)
def test_a_build_with_little_memory_ends_with_a_table_or_says_so(daemons, background, size, limit):
    daemon = daemons.start(builds={"max_memory_bytes": limit * MIB})
    with daemon.client() as client:
        caller = background(client.get_ic, STEEL, GRID, SIZES[size])
        error = caller.exception(timeout=TO_BUILD)
        if error is None:
            assert size == "small" or limit > (256 if size == "medium" else 768)
        else:
            assert (type(error), error.reason) == (ResourceExhausted, "BUILD_OUT_OF_MEMORY")
            assert f"{limit * MIB} bytes (builds.max_memory_bytes)" in error.message
            assert limit < 4096
        assert daemon.builders() == []


def test_a_build_that_would_take_far_too_much_is_refused_with_what_would_be_right(client):
    error = failure(client, ResourceExhausted, FemIcs(order=6, f=1.01))
    assert error.reason == "BUILD_OUT_OF_MEMORY"
    assert "10712397 unknowns" in error.message
    assert "Use order 3" in error.message or "Use order 2" in error.message
    assert error.violations[0].field == "ics"
    assert client.quarantined_ics() == ()


def test_the_kernel_would_end_a_builder_before_anything_else(daemon, client, background):
    caller = background(client.get_ic, STEEL, GRID, LONG)
    eventually(lambda: any(job.fraction > 0 for job in client.jobs()))
    (builder,) = daemon.builders()
    assert Path(f"/proc/{builder}/oom_score_adj").read_text().strip() == "1000"
    client.cancel_job(client.jobs()[0].job)
    assert caller.exception() is not None


@pytest.mark.skipif(not LONG_FAULTS, reason="takes two minutes")
@pytest.mark.timeout(TO_BUILD + 60)
@pytest.mark.parametrize("kilobytes", [450_000, 520_000])
def test_a_builder_that_spins_without_getting_on_is_ended(daemons, background, kilobytes):
    # OpenBLAS requests address space repeatedly when none is left.
    program = script(daemons.folder, f"ulimit -v {kilobytes}", f'exec {BIN / "contactd-ic"} "$@"')
    daemon = daemons.start(builds={"program": str(program), "stall_seconds": 2})
    with daemon.client() as client:
        error = background(client.get_ic, STEEL, GRID, SIZES["medium"]).exception(timeout=TO_BUILD)
        assert error is not None
        assert "made no progress" in error.message or "memory" in error.message
        assert daemon.builders() == []
    program.unlink()


@pytest.mark.timeout(300)  # factorises for twenty seconds on an idle machine
def test_a_long_factorisation_is_no_stall(daemons, background):
    daemon = daemons.start(builds={"stall_seconds": 1})
    with daemon.client() as client:
        ics = FemIcs(order=2, f=1.07, solver="direct")  # factorisations of more than a second each
        table = background(client.get_ic, STEEL, GRID, ics).result(timeout=300)
        assert table.evidence.solver == "direct"


def test_a_build_that_failed_twice_is_answered_at_once_until_told_otherwise(daemons):
    runs = daemons.folder / "runs"
    program = script(
        daemons.folder,
        f"echo run >> {runs}",
        f'[ -e {daemons.folder}/repaired ] && exec {BIN / "contactd-ic"} "$@"',
        'echo "the mesh is tangled" >&2; exit 1',
    )
    with daemons.start(builds={"program": str(program)}).client() as client:
        for _ in range(2):
            assert failure(client).reason == "BUILD_FAILED"
        refused = failure(client, FailedPrecondition)
        assert refused.reason == "BUILD_QUARANTINED"
        assert "the mesh is tangled" in refused.message
        assert 3000 < refused.retry_delay <= 3600
        larger = failure(client, FailedPrecondition, grid=replace(GRID, nx=9))
        assert larger.reason == "BUILD_QUARANTINED"
        with pytest.raises(FailedPrecondition):
            client.solve(CATTANEO.replace(upper=STEEL, grid=Grid(6, 6, 0.8, 0.8), ics=QUICK))
        assert runs.read_text().count("run") == 2
        assert failure(client, grid=replace(GRID, nx=5)).reason == "BUILD_FAILED"

        (daemons.folder / "repaired").touch()
        (entry,) = client.quarantined_ics()
        assert (entry.nx, entry.ny, entry.failures) == (6, 6, 2)
        assert client.delete_ic(entry.key) == 0
        assert client.get_ic(STEEL, GRID, QUICK).origin == "built"
        assert client.quarantined_ics() == ()
    for path in (runs, program, daemons.folder / "repaired"):
        path.unlink()


def test_a_larger_bound_of_iterations_is_tried_although_a_smaller_one_is_in_quarantine(client):
    bounded = replace(QUICK, solver="amg_pcg", max_iterations=1)
    for _ in range(2):
        assert failure(client, ics=bounded).reason == "BUILD_FAILED"
    assert failure(client, FailedPrecondition, bounded).reason == "BUILD_QUARANTINED"
    assert client.get_ic(STEEL, GRID, replace(bounded, max_iterations=1000)).origin == "built"


def test_a_quarantine_expires(daemons):
    program = script(daemons.folder, "exit 1")
    config = {"program": str(program), "max_failures": 1, "quarantine_seconds": 1}
    with daemons.start(builds=config).client() as client:
        assert failure(client).reason == "BUILD_FAILED"
        assert failure(client, FailedPrecondition).reason == "BUILD_QUARANTINED"
        eventually(lambda: client.quarantined_ics() == ())
        assert failure(client).reason == "BUILD_FAILED"
    program.unlink()


def test_cancelled_builds_are_no_failures(daemons, background):
    daemon = daemons.start(builds={"max_failures": 1})
    with daemon.client() as client:
        for _ in range(2):
            caller = background(client.get_ic, STEEL, GRID, LONG)
            eventually(daemon.builders)
            client.cancel_job(client.jobs()[0].job)
            assert caller.exception().reason == "JOB_CANCELLED"


def test_a_table_can_be_listed_and_deleted(client):
    key = client.get_ic(STEEL, GRID, QUICK).key
    (stored,) = client.stored_ics()
    assert (stored.key, stored.nx, stored.ny) == (key, 6, 6)
    assert client.delete_ic(key) == 1
    assert list(client.stored_ics()) == []
    assert client.get_ic(STEEL, GRID, QUICK).origin == "built"
    with pytest.raises(NotFound, match="ic.list"):
        client.delete_ic("0" * 64)
