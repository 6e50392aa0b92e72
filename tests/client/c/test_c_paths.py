"""Tests the constants of contactd/paths.h: paths that the library has, and keywords that fields accept."""

from __future__ import annotations

import ctypes
import re

import pytest

from support.c_interface import LIBRARY
from support.c_programs import ROOT, STRICT, run

INCLUDE = ROOT / "client" / "c" / "generated" / "include"
HEADER = INCLUDE / "contactd" / "paths.h"
CONSTANTS = dict(re.findall(r'#define (CONTACTD_\w+)(?: \\\n +)? *"([^"]+)"', HEADER.read_text()))
PATHS = {path for name, path in CONSTANTS.items() if name.startswith("CONTACTD_PATH_")}


@pytest.fixture(scope="module")
def handles():
    """Holds the library, a wheel and a contact."""
    library = ctypes.CDLL(str(LIBRARY))
    library.contactd_last_error.restype = ctypes.c_char_p
    connection, wheel, contact = ctypes.c_void_p(), ctypes.c_void_p(), ctypes.c_void_p()
    assert library.contactd_open(b"local", ctypes.byref(connection)) == 0
    assert library.contactd_wheel_new(connection, ctypes.byref(wheel)) == 0
    assert library.contactd_new(connection, ctypes.byref(contact)) == 0
    yield library, wheel, contact
    library.contactd_wheel_free(wheel)
    library.contactd_free(contact)
    library.contactd_close(connection)


def test_each_path_is_one_of_a_wheel_or_a_contact(handles):
    library, *objects = handles
    number = ctypes.c_int32()
    assert len(PATHS) > 300
    for path in PATHS:
        text = path.replace("%d", "0").encode()
        codes = [library.contactd_path(handle, text, ctypes.byref(number)) for handle in objects]
        assert 0 in codes, library.contactd_last_error(objects[0])


def test_the_paths_that_a_refusal_names_have_constants(handles):
    """Adjacent entries of the library must be those of the header."""
    library, wheel, contact = handles
    number = ctypes.c_int32()
    known = {path.replace("[%d]", "[0]") for path in PATHS}
    of_wheel = ("setup", "state", "setup.track", "setup.rail", "forces", "patches[0].place", "patches[0].solution")
    of_contact = ("grid", "bodies.lower", "ics", "ics.section.outline", "gap", "friction", "friction.rolling", "settings", "motion")
    for handle, above in [*((wheel, above) for above in of_wheel), *((contact, above) for above in of_contact)]:
        assert library.contactd_path(handle, f"{above}.nothing".encode(), ctypes.byref(number)) == 3
        refusal = library.contactd_last_error(handle).decode()
        names = re.search(r', only ([\w, ]+)', refusal)[1].split(", ")
        without = {"motion", "derivatives"}  # of a contact alone
        assert {f"{above}.{name}" for name in names if above != "patches[0].solution" or name not in without} <= known


def test_keywords_are_taken(handles):
    library, wheel, _ = handles
    for name, word in CONSTANTS.items():
        field = {"MODEL": "model", "CONFORMAL": "conformal", "SIDE": "side"}.get(name.split("_")[2])
        if name.startswith("CONTACTD_WORD_") and field:
            assert library.contactd_set_word(wheel, f"setup.{field}".encode(), word.encode()) == 0


def test_a_program_finds_a_patch_by_the_number_that_it_prints(tmp_path):
    source = tmp_path / "paths.c"
    source.write_text(
        "#include <contactd/paths.h>\n#include <stdio.h>\n"
        "int main(void) { return printf(CONTACTD_PATH_PATCHES_SOLUTION_PMAX, 3) < 0; }\n"
    )
    made = run("cc", *STRICT, f"-I{INCLUDE}", source, "-o", tmp_path / "paths")
    assert made.returncode == 0, made.stderr
    assert run(tmp_path / "paths").stdout == "patches[3].solution.pmax"
