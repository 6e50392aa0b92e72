"""Tests that files made to hang HDF5's library, to crash it or to exhaust memory affect a separate process only."""

import hashlib
import subprocess
import sys
import time

import numpy as np
import pytest

from contactd import ContactdError, ContactProblem, Grid, Paraboloid, SavedFileError, TableFileError, load, load_table
from contactd.files import hdf5_process
from contactd.files.hdf5_process import read_apart
from contactd.files.ic_contents import FileContents, contents_of, file_of
from support import readers

h5py = pytest.importorskip("h5py")

PROBLEM = ContactProblem(grid=Grid(2, 2, 1, 1), gap=Paraboloid(50), approach=0.1)


def endless(content: bytes, text: bytes) -> bytes:
    """Does the same with a long text followed by zeros: endless objects of size zero in a heap of HDF5."""
    said = len(text).to_bytes(8, "little") + text
    assert said in content
    return content.replace(said, (len(text) + 0x200).to_bytes(8, "little") + text)


def endless_table() -> bytes:
    contents = FileContents({"contactd_format": 2, "spec/source": "analytic"}, {"influence_coefficients": np.ones((3, 3, 1, 1))})
    head, image = file_of(contents)[:512], endless(file_of(contents)[512:], b"analytic")
    before = head.partition(b": ")[0]
    return (before + b": " + hashlib.sha256(image).hexdigest().encode()).ljust(512, b"\0") + image


@pytest.fixture
def soon(monkeypatch):
    """A hanging process is ended after some seconds; a started one is ready before."""
    monkeypatch.setattr(hdf5_process, "SECONDS", 5.0)


def test_a_table_that_hangs_hdf5_is_given_up(tmp_path, soon):
    (tmp_path / "table.h5").write_bytes(endless_table())
    start = time.monotonic()
    with pytest.raises(TableFileError, match=r"table\.h5: reading it takes longer than 5 s"):
        load_table(tmp_path / "table.h5")
    assert time.monotonic() - start < 30


def test_a_problem_that_hangs_hdf5_is_given_up(tmp_path, soon):
    path = tmp_path / "problem.h5"
    PROBLEM.save(path)
    path.write_bytes(endless(path.read_bytes(), b"Paraboloid"))
    with pytest.raises(SavedFileError, match=r"problem\.h5: reading it takes longer than 5 s"):
        load(path)


# --- readers that do what HDF5 may do ---------------------------------------------------------------------------------


def test_what_is_told_arrives_as_it_was():
    told = read_apart(readers.tells_all, b"content")
    np.testing.assert_array_equal(told["array"], [[0, 1, 2], [3, 4, 5]])
    assert told["mapping"][:4] == [1, 0.1, "text", None]
    assert (told["mapping"][4][0].dtype, told["list"]) == (np.uint8, {"": "content"})


@pytest.mark.parametrize(
    ("read", "says"),
    [
        (readers.takes_memory, "it takes more memory than any file of contactd"),
        (readers.ends, "the HDF5 library crashes while reading it, by the signal SIGSEGV"),
        (readers.gives_objects, "it contains arrays of object; arrays of contactd contain numbers"),
    ],
)
def test_what_goes_wrong_is_told(read, says):
    with pytest.raises(ValueError, match=says):
        read_apart(read, b"")


def test_a_process_that_does_not_start_is_no_fault_of_the_file(monkeypatch):
    with pytest.raises(ContactdError, match="that reads HDF5 files failed: .*No module named 'nowhere'"):
        read_apart(readers.cannot_start, b"")
    monkeypatch.setattr(sys, "executable", "/nowhere/python")
    with pytest.raises(ContactdError, match="which cannot be started"):
        read_apart(readers.tells_all, b"")
    monkeypatch.setattr(sys, "executable", "")
    with pytest.raises(ContactdError, match="sys.executable is not set"):
        read_apart(readers.tells_all, b"")


def test_scripts_need_no_guard_and_no_home(tmp_path):
    PROBLEM.save(tmp_path / "problem.h5")
    script = f"import sys; sys.path[:] = {sys.path!r}; import contactd; print(contactd.load('problem.h5').approach)"
    ran = subprocess.run(
        [sys.executable, "-"], input=script, cwd=tmp_path, env={"HOME": "/nowhere"}, capture_output=True, text=True, timeout=50
    )
    assert (ran.stdout, ran.stderr) == ("0.1\n", "")


def test_a_table_of_a_stranger_is_checked_before_a_process_starts(monkeypatch):
    monkeypatch.setattr(sys, "executable", "/nowhere/python")
    with pytest.raises(TableFileError, match="does not match its digest"):
        contents_of(endless_table()[:-1], "the file")
