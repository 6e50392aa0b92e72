"""Tests how Python reads and sends profiles in files."""

from __future__ import annotations

from dataclasses import replace

import pytest

import contactd
from contactd import InvalidArgument
from contactd.files.profile_text import read_profile_text
from contactd.values.profiles import profile_params
from contactd.wheel_rail import ProfileFile
from support import schemas

TEXT = "y;z\n-20;3,5\n0;0\n20;3,5\n"


def test_a_file_is_read_when_it_is_named_and_its_folder_is_not_sent(tmp_path):
    path = tmp_path / "head.csv"
    path.write_text(TEXT)
    given = ProfileFile(path, unit=25.4, mirror_z=False, smoothing_length=5)
    path.unlink()
    sent = profile_params(given, "setup.rail")
    assert sent == {"file": {"name": "head.csv", "text": TEXT, "unit": 25.4, "mirror_z": False, "smoothing_length": 5}}
    schemas.check("wheelrail.solve.params", {"setup": {"rail": sent}, "state": {}})
    assert replace(given, mirror_z=True).text == TEXT


def test_content_needs_no_file():
    assert profile_params(ProfileFile("C:\\data\\a.whl", text=b"0 0\n"), "setup.wheel") == {"file": {"name": "a.whl", "text": "0 0\n"}}
    assert ProfileFile("a.whl", text="% Stra\xdfe".encode("latin-1")).text == "% Stra\xdfe"
    assert contactd.ProfileFile is ProfileFile


def test_it_shows_itself_without_its_text():
    assert repr(ProfileFile("a.whl", text="0 0\n", shift_z=1.5)) == "ProfileFile('a.whl', shift_z=1.5)"
    assert repr(ProfileFile("a.whl", text="0 0\n")) == "ProfileFile('a.whl')"


def test_what_cannot_be_read_is_an_error_of_the_system(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"none\.whl"):
        ProfileFile(tmp_path / "none.whl")
    with pytest.raises(IsADirectoryError):
        ProfileFile(tmp_path)
    large = tmp_path / "large.csv"
    large.write_bytes(b" " * ((2 << 20) + 1))
    with pytest.raises(OSError, match="at most 2097152"):
        ProfileFile(large)


def test_a_file_whose_reading_fails_is_named():
    """Reads behind a hole of the address space, where a file of /proc can be opened but not read."""
    with pytest.raises(OSError, match="Input/output error: '/proc/self/mem'"):
        ProfileFile("/proc/self/mem")


def test_an_empty_file_is_an_invalid_argument(tmp_path):
    (tmp_path / "head.csv").touch()
    with pytest.raises(InvalidArgument, match=r"^file = .*head\.csv: the file is empty\. Give a file"):
        read_profile_text(tmp_path / "head.csv")
    with pytest.raises(InvalidArgument, match="the file is empty"):
        ProfileFile(tmp_path / "head.csv")
