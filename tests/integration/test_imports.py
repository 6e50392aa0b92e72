"""Tests imported tables: which users they serve, reports about them, and refusals."""

import hashlib
import io
import math
import os
import warnings

import h5py
import numpy as np
import pytest

from contactctl.table_files import import_files
from contactd import ContactProblem, Friction, Grid, InvalidArgument, Paraboloid, TableFileError
from contactd.files.ic_files import import_params
from contactd.values.contact_params import table_params
from support.problems import GRID, QUICK, STEEL

HEADER = b"contactd ic table, format 1, sha256 of the bytes after this block: "
TABLE = "influence_coefficients"
SHAPE = (3, 3, GRID.ny, GRID.nx)
PROBLEM = ContactProblem(
    grid=GRID, upper=STEEL, ics=QUICK, gap=Paraboloid(300), Fn=1e4, friction=Friction(mu=0.3, rigid_shift=(1e-3, 0))
)


@pytest.fixture(scope="module")
def exported(shared_daemon):
    with shared_daemon.client() as client:
        return client.export_ic(STEEL, GRID, QUICK)


@pytest.fixture
def importer(daemons):
    """Provides a client of a daemon that builds nothing, so that all its answers use imported tables."""
    with daemons.start(builds={"program": "/bin/false"}).client() as client:
        yield client


def sealed(image: bytes) -> bytes:
    """Returns a file of this content with a valid digest, which any writer can compute."""
    digest = hashlib.sha256(image).hexdigest().encode()
    return (HEADER + digest + b"\n").ljust(512, b"\0") + image


def changed(content: bytes, change) -> bytes:
    image = io.BytesIO(content[512:])
    with h5py.File(image, "r+") as file:
        change(file)
    return sealed(image.getvalue())


def quietly(call, *args, **keywords):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return call(*args, **keywords)


# --- whom they serve --------------------------------------------------------------------------------------------------


def test_every_solution_says_that_its_table_was_imported(importer, exported):
    imported = importer.import_ic(exported)
    assert imported.new
    assert imported.ics.evidence.imported
    solution = quietly(importer.solve, PROBLEM)
    assert solution.evidence.ics["upper"].evidence.imported
    says = [warning for warning in solution.warnings if "imported" in warning]
    assert len(says) == 1
    assert imported.ics.key[:12] in says[0]
    with importer.session(PROBLEM) as session:
        for _ in range(2):
            step = quietly(session.step)
            assert any("imported" in warning for warning in step.warnings)


def test_an_imported_table_serves_its_importer_after_a_restart_too(daemons, exported):
    first = daemons.start(builds={"program": "/bin/false"})
    with first.client() as client:
        key = client.import_ic(exported).ics.key
    first.stop()
    with daemons.start(builds={"program": "/bin/false"}).client() as client:
        table = client.get_ic(STEEL, GRID, QUICK)
        assert (table.key, table.origin, table.evidence.imported) == (key, "disk", True)
        assert client.get_ic(STEEL, GRID, QUICK).origin == "memory"
        assert [stored.key for stored in client.stored_ics()] == [key]
        assert client.delete_ic(key) == 1
        assert list(client.stored_ics()) == []


def test_what_the_daemon_builds_itself_serves_before_what_was_imported(daemon, exported):
    with daemon.client() as client:
        client.import_ic(exported)
        larger = Grid(GRID.nx + 4, GRID.ny + 4, GRID.dx, GRID.dy)
        assert client.get_ic(STEEL, larger, QUICK).origin == "built"
        table = client.get_ic(STEEL, GRID, QUICK)
        assert not table.evidence.imported


# --- what is refused --------------------------------------------------------------------------------------------------


def test_a_table_that_errs_by_more_than_it_states_is_refused(importer, exported):
    def scale(file):
        file[TABLE][...] *= 1.5

    with pytest.raises(InvalidArgument, match="relative to the closed form") as refused:
        importer.import_ic(changed(exported, scale))
    assert refused.value.violations[0].field == "datasets"
    assert list(importer.stored_ics()) == []


def test_the_daemon_takes_no_file(raw, exported):
    reply = raw.ask("ic.import", {"file": {"$array": {"frame": 1, "dtype": "|u1", "shape": [len(exported)]}}}, exported)
    assert reply.status == "INVALID_ARGUMENT"
    assert {"attributes", "datasets", "file"} & set(reply.fields)


def replaced(**how):
    def change(file):
        del file[TABLE]
        file.create_dataset(TABLE, **how)

    return change


def external(file):
    replaced(shape=SHAPE, dtype="<f8", external=[("/etc/passwd", 0, 8 * math.prod(SHAPE))])(file)


def linked(file):
    del file[TABLE]
    file[TABLE] = h5py.ExternalLink("/etc/passwd", "/")


def virtual(file):
    layout = h5py.VirtualLayout(shape=SHAPE, dtype="<f8")
    layout[...] = h5py.VirtualSource("/etc/passwd", "data", shape=SHAPE)
    del file[TABLE]
    file.create_virtual_dataset(TABLE, layout)


def unwritten(file):
    space = h5py.h5s.create(h5py.h5s.SCALAR)
    del file["evidence"].attrs["version"]
    h5py.h5a.create(file["evidence"].id, b"version", h5py.h5t.py_create(h5py.string_dtype(), logical=True), space)


def soft(file):
    file["evidence/soft"] = h5py.SoftLink("/spec")


def circular(file):
    file["spec/circle"] = file["/"]


HOSTILE = {
    "external storage": external,
    "an external link": linked,
    "a virtual dataset": virtual,
    "a soft link": soft,
    "a circle": circular,
    "a string that was not written": unwritten,
    "chunks that take gigabytes": replaced(shape=(3, 3, 20_000, 20_000), dtype="<f8", chunks=(1, 1, 100, 100)),
    "packed": replaced(shape=SHAPE, dtype="<f8", compression="gzip"),
    "single precision": replaced(shape=SHAPE, dtype="<f4"),
    "no data": replaced(shape=SHAPE, dtype="<f8"),
}


#: h5py reads an unwritten string as empty.
READ = {name: change for name, change in HOSTILE.items() if change is not unwritten}


@pytest.mark.parametrize("change", READ.values(), ids=READ.keys())
def test_a_hostile_file_is_refused_where_it_is_read(exported, change):
    with pytest.raises(TableFileError, match="the file"):
        import_params(changed(exported, change))


@pytest.mark.parametrize("change", HOSTILE.values(), ids=HOSTILE.keys())
def test_a_hostile_file_in_the_store_is_set_aside(daemons, exported, change, shared):
    key = shared.get_ic(STEEL, GRID, QUICK).key
    daemon = daemons.start(builds={"program": "/bin/false"})
    stored = daemon.store / f"{key}.{GRID.nx}x{GRID.ny}.h5"
    stored.write_bytes(changed(exported, change))
    with daemon.client() as client:
        with pytest.raises(Exception, match="builder"):
            client.get_ic(STEEL, GRID, QUICK)
        assert client.info().counters["tables_set_aside"] == 1
        assert client.health() == "serving"
    assert not stored.exists()


def test_a_fifo_in_the_store_holds_nobody_up(daemons, shared):
    key = shared.get_ic(STEEL, GRID, QUICK).key
    daemon = daemons.start()
    fifo = daemon.store / f"{key}.{GRID.nx}x{GRID.ny}.h5"
    os.mkfifo(fifo)
    os.mkfifo(daemon.store / f"{key}.lock")
    with daemon.client() as client:
        assert client.get_ic(STEEL, GRID, QUICK, timeout=60).origin == "built"
        assert client.health() == "serving"
    fifo.unlink(missing_ok=True)
    (daemon.store / f"{key}.lock").unlink()


# --- by other ways ----------------------------------------------------------------------------------------------------


def test_contents_go_from_daemon_to_daemon_without_hdf5(raw, shared, daemons):
    given = raw.ask("ic.export", {**table_params(STEEL, GRID, QUICK), "format": "contents"})
    contents = {name: given.result[name] for name in ("attributes", "datasets")}
    other = daemons.start(builds={"program": "/bin/false"})
    with other.raw() as second:
        taken = second.ask("ic.import", contents, *given.frames)
        assert (taken.status, taken.result["new"]) == ("OK", True)
        assert second.ask("ic.import", contents, *given.frames).result["new"] is False
    with other.client() as client:
        expected = shared.get_ic(STEEL, GRID, QUICK)
        np.testing.assert_allclose(client.get_ic(STEEL, GRID, QUICK).array, expected.array, rtol=1e-14)


def stored_file(daemon, exported_from):
    """Returns a file of the store of a daemon that has built the table."""
    exported_from.get_ic(STEEL, GRID, QUICK)
    return next(path for path in daemon.tables() if path.name.endswith(f".{GRID.nx}x{GRID.ny}.h5"))


def test_contactctl_writes_a_file_of_its_own_into_a_store(shared, shared_daemon, daemons):
    built = stored_file(shared_daemon, shared)
    daemon = daemons.start(builds={"program": "/bin/false"})
    (imported,) = import_files([str(built)], str(daemon.store))
    assert imported["new"]
    with daemon.client() as client:
        table = client.get_ic(STEEL, GRID, QUICK)
        assert table.evidence.imported
        np.testing.assert_array_equal(table.array, shared.get_ic(STEEL, GRID, QUICK).array)


def test_contactctl_copies_no_hostile_file_into_a_store(shared, shared_daemon, tmp_path):
    built = stored_file(shared_daemon, shared)
    (tmp_path / "store").mkdir()
    file = tmp_path / built.name
    file.write_bytes(changed(built.read_bytes(), external))
    with pytest.raises(TableFileError, match="other files"):
        import_files([str(file)], str(tmp_path / "store"))
    assert list((tmp_path / "store").iterdir()) == []
