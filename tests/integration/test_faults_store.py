"""Tests that an unusable store causes a warning but no failure, and that several daemons can share one store."""

import os
import random
import shutil
import signal
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from contactd import InternalError, Material, TimeoutExpired
from support.daemons import BIN, eventually
from support.faults import (
    LONG_FAULTS,
    clock_shim,
    in_namespace,
    mounted_store,
    script,
    start_as,
    start_with_mount,
)
from support.problems import CATTANEO, GRID, LONG, QUICK, STEEL


def steel(nu):
    return replace(STEEL, nu=nu)


def warnings(client):
    return client.call("server.health")["warnings"]


def unsaved(table):
    return [warning for warning in table.evidence.warnings if "could not be stored" in warning]


def expect_unsaved(client, nu, why):
    table = client.get_ic(steel(nu), GRID, QUICK)
    assert table.origin == "built"
    assert any(why in warning for warning in unsaved(table))
    assert client.get_ic(steel(nu), GRID, QUICK).origin == "memory"
    assert any(why in warning for warning in warnings(client))
    return table


def recovers(client, nu):
    """Sends a request after the store can be used again; its answer has no warning any more."""
    return unsaved(client.get_ic(steel(nu), GRID, QUICK)) == [] and warnings(client) == []


def test_a_full_disk_keeps_the_new_table_in_memory_until_there_is_room(daemons):
    daemon = start_with_mount(daemons, "-t", "tmpfs", "-o", "size=256k", "none")
    store = mounted_store(daemon)
    with daemon.client() as client:
        assert client.get_ic(steel(0.25), GRID, QUICK).origin == "built"
        with pytest.raises(OSError, match="No space"), (store / "filler").open("wb", buffering=0) as filler:
            while True:
                filler.write(bytes(4096))
        expect_unsaved(client, 0.3, "No space left on device")
        assert [path.name for path in store.iterdir() if path.suffix == ".tmp"] == []
        assert client.get_ic(steel(0.25), GRID, QUICK).origin == "memory"
        (store / "filler").unlink()
        eventually(lambda: recovers(client, 0.3))
        assert len(list(store.glob("*.h5"))) == 2


def test_a_read_only_folder_serves_what_is_in_it_and_builds_for_the_memory(daemons):
    with daemons.start().client() as client:
        client.get_ic(steel(0.25), GRID, QUICK)
    store = daemons.folder / "daemon" / "store"
    daemons.stop_all()
    daemon = start_with_mount(daemons, "--bind", "-o", "ro", str(store))
    with daemon.client() as client:
        assert any("Read-only file system" in warning for warning in warnings(client))
        assert client.get_ic(steel(0.25), GRID, QUICK).origin == "disk"
        expect_unsaved(client, 0.3, "Read-only file system")
        in_namespace(daemon, "mount", "-o", "remount,rw,bind", str(store))
        eventually(lambda: recovers(client, 0.3))
    assert len(daemon.tables()) == 2


def test_a_folder_that_is_deleted_is_made_again(daemon, client):
    client.get_ic(steel(0.25), GRID, QUICK)
    shutil.rmtree(daemon.store)
    assert client.get_ic(steel(0.25), GRID, QUICK).origin == "memory"
    assert client.get_ic(steel(0.3), GRID, QUICK).origin == "built"
    assert client.solve(CATTANEO).converged
    assert len(daemon.tables()) == 1


def test_a_folder_that_is_no_folder_any_more_costs_a_warning(daemon, client):
    shutil.rmtree(daemon.store)
    daemon.store.write_text("in the way")
    expect_unsaved(client, 0.3, "Not a directory")
    daemon.store.unlink()
    eventually(lambda: recovers(client, 0.3))
    assert len(daemon.tables()) == 1


def test_a_table_that_cannot_be_read_is_built_again(daemons):
    with daemons.start().client() as client:
        client.get_ic(STEEL, GRID, QUICK)
    daemons.stop_all()
    (path,) = (daemons.folder / "daemon" / "store").glob("*.h5")
    path.unlink()
    path.mkdir()  # root may read everything else
    with daemons.start().client() as client:
        table = client.get_ic(STEEL, GRID, QUICK)
        assert table.origin == "built"
        assert unsaved(table)
    path.rmdir()


def test_the_least_recently_used_tables_go_when_the_budget_is_full(daemons):
    with daemons.start().client() as client:
        for nu in (0.1, 0.2, 0.3):
            client.get_ic(steel(nu), GRID, QUICK)
        keys = {nu: client.get_ic(steel(nu), GRID, QUICK).key for nu in (0.1, 0.2, 0.3)}
        size = next(client.stored_ics()).bytes
    daemons.stop_all()
    budget = {"disk_budget_bytes": 3 * size + size // 2, "memory_budget_bytes": 0}
    store = daemons.folder / "daemon" / "store"
    for path in store.glob("*.h5"):  # as if a clock had been far ahead when they were written
        os.utime(path, (4e9, 4e9 + path.name.startswith(keys[0.1])))
    with daemons.start(store=budget).client() as client:
        client.get_ic(steel(0.2), GRID, QUICK)
        client.get_ic(steel(0.3), GRID, QUICK)
        assert client.get_ic(steel(0.4), GRID, QUICK).origin == "built"
        left = {stored.key for stored in client.stored_ics()}
        assert keys[0.1] not in left
        assert {keys[0.2], keys[0.3]} < left
        assert len(left) == 3


class Shelf:
    """Creates a store with room for three tables, and its expected contents: the least recently used first."""

    def __init__(self, folder):
        self.folder = folder
        self.keys = {}
        self.expected = []

    def stored(self):
        return {path.name.partition(".")[0] for path in self.folder.glob("*.h5")}

    def use(self, client, nu):
        """Requests a table, and waits until the store has recorded it."""
        before = time.time()
        table = client.get_ic(steel(nu), GRID, QUICK)
        assert table.origin == "built" if nu not in self.expected else table.origin in ("memory", "disk")
        self.keys[nu] = table.key
        self.expected = [*(known for known in self.expected if known != nu), nu][-3:]
        if table.origin == "memory":
            (path,) = self.folder.glob(f"{table.key}.*.h5")
            eventually(lambda: path.stat().st_mtime >= before, "its use from memory was not noted")
        assert self.stored() == {self.keys[known] for known in self.expected}


@pytest.mark.parametrize("legacy", [False, True], ids=["", "with times in the year 2174"])
def test_three_daemons_in_turns_evict_what_was_used_least_recently(daemons, legacy):
    with daemons.start("first").client() as client:
        client.get_ic(steel(0.1), GRID, QUICK)
        size = next(client.stored_ics()).bytes
    daemons.stop_all()
    shelf = Shelf(daemons.folder / "first" / "store")
    (path,) = shelf.folder.glob("*.h5")
    if legacy:
        os.utime(path, (6437664000, 6437664000.5))
    store = {"folder": str(shelf.folder), "disk_budget_bytes": 3 * size + size // 2}
    shelf.expected = [0.1]
    shelf.keys = {0.1: path.name.partition(".")[0]}

    first = daemons.start("first", store=store)
    with first.client() as client:
        for nu in (0.2, 0.3, 0.1, 0.2):  # 0.2 from memory
            shelf.use(client, nu)
    second = daemons.start("second", store=store)
    with second.client() as client:
        for nu in (0.4, 0.1, 0.4):  # 0.3 goes
            shelf.use(client, nu)
        first.stop()
        third = daemons.start("third", store=store)
        with third.client() as other:
            shelf.use(other, 0.2)
            shelf.use(client, 0.1)  # from the memory of the second one
            shelf.use(other, 0.3)  # 0.4 goes
            shelf.use(client, 0.2)
    second.stop()
    with daemons.start("first", store=store).client() as client:
        shelf.use(client, 0.4)  # 0.1 goes
        third.stop()
        shelf.use(client, 0.1)  # 0.3 goes


def test_uses_from_memory_are_noted_at_the_end_of_a_daemon(daemons):
    first = daemons.start()
    with first.client() as client:
        for nu in (0.1, 0.2, 0.1):
            client.get_ic(steel(nu), GRID, QUICK)
    before = [path.stat().st_mtime_ns for path in first.tables()]
    with first.client() as client:
        keys = [client.get_ic(steel(nu), GRID, QUICK).key for nu in (0.2, 0.1)]
    first.stop()
    times = {path.name.partition(".")[0]: path.stat().st_mtime_ns for path in first.tables()}
    assert max(before) < times[keys[0]] < times[keys[1]]


def counting_builder(daemons):
    runs = daemons.folder / "runs"
    return runs, script(daemons.folder, f"echo run >> {runs}; sleep 0.3", f'exec {BIN / "contactd-ic"} "$@"')


def test_two_daemons_that_are_asked_for_one_table_build_it_once(daemons, background):
    runs, program = counting_builder(daemons)
    shared = {"store": {"folder": str(daemons.folder / "store")}, "builds": {"program": str(program)}}
    clients = [daemons.start(name, **shared).client() for name in ("first", "second")]
    for nu in (0.1, 0.2, 0.3):
        callers = [background(client.get_ic, steel(nu), GRID, QUICK) for client in clients]
        tables = [caller.result() for caller in callers]
        assert sorted(table.origin for table in tables) == ["built", "disk"]
        np.testing.assert_array_equal(tables[0].array, tables[1].array)
    for client in clients:
        client.close()
    assert runs.read_text().count("run") == 3
    runs.unlink()
    program.unlink()


@pytest.mark.parametrize("blow", ["SIGKILL", *(["SIGSTOP"] if LONG_FAULTS else [])])
def test_a_daemon_that_is_no_more_does_not_keep_another_from_building(daemons, background, blow):
    shared = {"store": {"folder": str(daemons.folder / "store")}, "builds": {"stall_seconds": 2}}
    first, second = (daemons.start(name, **shared) for name in ("first", "second"))
    with first.client(build_timeout=10) as doomed, second.client() as client:
        callers = [background(doomed.get_ic, STEEL, GRID, LONG)]
        eventually(lambda: list((daemons.folder / "store").glob("*.lock")))
        callers.append(background(client.get_ic, STEEL, GRID, LONG))
        eventually(lambda: any(job.stage == "waiting" for job in client.jobs()))
        os.kill(first.pid, getattr(signal, blow))
        eventually(lambda: client.info().counters["builds_started"] == 1, "the second daemon does not build", 30)
        client.cancel_job(client.jobs()[0].job)
        assert [caller.exception() is None for caller in callers] == [False, False]
    if blow == "SIGSTOP":  # it continues with its build and its lock
        os.kill(first.pid, signal.SIGCONT)
        with first.client() as client:
            assert client.solve(CATTANEO).converged
            (job,) = client.jobs()
            client.cancel_job(job.job)
            eventually(lambda: client.jobs() == ())
            assert not list((daemons.folder / "store").glob("*.lock"))


@pytest.mark.timeout(600 if LONG_FAULTS else 60)
def test_a_daemon_killed_at_any_moment_serves_whole_tables_afterwards(daemons, background):
    ratios = [0.01 * n for n in range(10, 22 if LONG_FAULTS else 16)]
    with daemons.start("reference").client() as client:
        expected = {nu: client.get_ic(steel(nu), GRID, QUICK).array for nu in ratios}
    moments = random.Random(1)
    for _ in range(20 if LONG_FAULTS else 4):
        daemon = daemons.start()
        assert not [path for path in daemon.store.iterdir() if path.suffix in (".tmp", ".lock")]
        with daemon.client(timeout=30, build_timeout=30) as client:
            moments.shuffle(ratios)
            callers = [background(client.get_ic, steel(nu), GRID, QUICK) for nu in ratios]
            if daemon.process.poll() is None:
                eventually(lambda: client.info().counters["builds_started"] > 0)
            try:
                callers[-1].result(timeout=moments.uniform(0, 0.8))
            except TimeoutError:
                pass
            daemon.kill()
            for caller in callers:
                if caller.exception() is None:
                    assert caller.result().array.shape == (3, 3, 6, 6)
        eventually(lambda: not daemon.builders(), "a builder outlived its daemon")  # noqa: B023
        for path in daemon.tables():
            if moments.random() < 0.3:
                path.unlink()  # so that there is a table to build again
    with daemons.start().client() as client:
        for nu in ratios:
            np.testing.assert_array_equal(client.get_ic(steel(nu), GRID, QUICK).array, expected[nu])
        assert client.info().counters["tables_set_aside"] == 0


def test_ten_thousand_tables_are_no_burden_at_the_start(daemons):
    with daemons.start().client() as client:
        client.get_ic(STEEL, GRID, QUICK)
    daemons.stop_all()
    (table,) = (daemons.folder / "daemon" / "store").glob("*.h5")
    for n in range(10_000):
        os.link(table, table.with_name(f"{n:064x}.6x6.h5"))
    daemon = daemons.start(store={"disk_budget_bytes": 10**12})
    stat = Path(f"/proc/{daemon.pid}/stat").read_text()
    ticks = [int(field) for field in stat.rpartition(")")[2].split()[11:13]]
    assert sum(ticks) / os.sysconf("SC_CLK_TCK") < 2  # processor time, independent of the load of the machine
    with daemon.client() as client:
        assert client.get_ic(STEEL, GRID, QUICK).origin == "disk"
        assert client.get_ic(steel(0.1), GRID, QUICK).origin == "built"
        assert len(list(client.stored_ics())) == 10_002


def test_a_clock_that_is_set_back_changes_nothing(daemons, background):
    shim, mark = clock_shim(daemons.folder), daemons.folder / "now"
    daemon = start_as(daemons, "env", f"LD_PRELOAD={shim}", f"CLOCK_SET_BACK={mark}", store={"disk_budget_bytes": 10**9})
    with daemon.client() as client:
        client.get_ic(steel(0.25), GRID, QUICK)
        caller = background(client.get_ic, STEEL, GRID, LONG, timeout=2)
        eventually(daemon.builders)
        mark.touch()
        assert client.solve(CATTANEO).converged
        with pytest.raises(TimeoutExpired):
            caller.result()
        client.cancel_job(client.jobs()[0].job)
        assert client.get_ic(steel(0.3), GRID, QUICK).origin == "built"
        assert len(list(client.stored_ics())) == 2
        assert 0 < client.info().uptime_seconds < 60
    daemon.stop()
    lines = [line for line in daemon.log.splitlines() if "method=" in line]
    assert lines[0][:4] != lines[-1][:4], "the clock was not set back"
    for path in (shim, mark):
        path.unlink()


def test_the_error_of_a_builder_that_cannot_be_started_is_no_failure_of_the_table(daemons):
    config = {"program": "/nonexistent/contactd-ic", "max_failures": 1}
    with daemons.start(builds=config).client() as client:
        for _ in range(2):
            with pytest.raises(InternalError, match="No such file"):
                client.get_ic(Material(1, 0.3), GRID, QUICK)
