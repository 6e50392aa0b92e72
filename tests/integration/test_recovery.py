"""Tests files after a crash or damage: they are served if complete, and otherwise set aside and built again."""

import hashlib
from dataclasses import replace

import h5py
import numpy as np
import pytest

from contactd import ContactdError
from support.daemons import eventually
from support.problems import GRID, LONG, QUICK, STEEL


@pytest.fixture
def stored(daemons):
    """Provides a table in the store of a daemon that has ended."""
    daemon = daemons.start()
    with daemon.client() as client:
        table = client.get_ic(STEEL, GRID, QUICK)
    daemon.stop()
    (path,) = daemon.tables()
    return path, table


def truncate(path):
    path.write_bytes(path.read_bytes()[:-100])


def empty(path):
    path.write_bytes(b"")


def shorten_to_the_header(path):
    path.write_bytes(path.read_bytes()[:512])


def flip_a_bit_of_the_data(path):
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)


def flip_a_bit_of_the_digest(path):
    data = bytearray(path.read_bytes())
    data[100] ^= 1
    path.write_bytes(data)


def replace_by_rubbish(path):
    path.write_bytes(bytes(range(256)) * 64)


def with_attribute(path, group, name, value):
    """Puts another value into the HDF5 of a table, and the corresponding digest into the header."""
    with h5py.File(path, "r+") as file:
        file[group].attrs[name] = value
    whole = path.read_bytes()
    header, content = whole[:512], whole[512:]
    title = header[: header.index(b": ") + 2]
    path.write_bytes((title + hashlib.sha256(content).hexdigest().encode() + b"\n").ljust(512, b"\0") + content)


def put_many_values_where_one_belongs(path):
    with_attribute(path, "spec", "nu", np.full(5000, 0.3))


def put_a_number_where_a_text_belongs(path):
    with_attribute(path, "evidence", "source", 3)


def name_an_axis_that_is_none(path):
    with_attribute(path, "evidence/load_case_0", "load_axis", 7)


@pytest.mark.parametrize(
    "damage",
    [
        truncate, empty, shorten_to_the_header, flip_a_bit_of_the_data, flip_a_bit_of_the_digest, replace_by_rubbish,
        put_many_values_where_one_belongs, put_a_number_where_a_text_belongs, name_an_axis_that_is_none,
    ],
    ids=lambda damage: damage.__name__,
)
def test_a_damaged_table_is_set_aside_reported_and_built_again(daemons, stored, damage):
    path, undamaged = stored
    damage(path)
    daemon = daemons.start()
    with daemon.client() as client:
        table = client.get_ic(STEEL, GRID, QUICK)
        assert client.info().counters["tables_set_aside"] == 1
    assert table.origin == "built"
    np.testing.assert_allclose(table.array, undamaged.array, rtol=1e-12, atol=1e-12 * undamaged.array.max())
    (aside,) = (daemon.store / "quarantine").iterdir()
    assert aside.name.startswith(path.name)
    assert path.name in daemon.log


def test_a_table_under_a_wrong_name_is_not_served(daemons, stored):
    path, _ = stored
    path.rename(path.with_name(path.name.replace("6x6", "9x9")))
    with daemons.start().client() as client:
        assert client.get_ic(STEEL, replace(GRID, nx=8), QUICK).origin == "built"
        assert client.info().counters["tables_set_aside"] == 1


def test_a_daemon_killed_during_a_build_leaves_no_builder_and_no_table(daemons, background):
    daemon = daemons.start()
    with daemon.client() as client:
        caller = background(client.get_ic, STEEL, GRID, LONG)
        eventually(daemon.builders)
        daemon.kill()
        with pytest.raises(ContactdError):
            caller.result()
    eventually(lambda: not daemon.builders(), "the builder outlived the daemon")
    assert daemon.tables() == []
    restarted = daemons.start()
    with restarted.client() as client:
        assert client.get_ic(STEEL, GRID, QUICK).origin == "built"
        eventually(lambda: client.jobs() == (), "the job is still there")


def test_leftovers_of_a_crash_are_swept_at_the_start(daemons, stored):
    path, _ = stored
    leftover = path.with_name(path.name + ".4194304-0.tmp")
    leftover.write_bytes(path.read_bytes()[:1000])
    daemon = daemons.start()
    assert not leftover.exists()
    with daemon.client() as client:
        assert client.get_ic(STEEL, GRID, QUICK).origin == "disk"


def test_other_files_in_the_store_are_left_alone(daemons, stored):
    path, _ = stored
    note = path.with_name("quarantine") / "note.txt"
    note.parent.mkdir(exist_ok=True)
    note.write_text("mine")
    with daemons.start().client() as client:
        assert client.get_ic(STEEL, GRID, QUICK).origin == "disk"
    assert note.read_text() == "mine"
