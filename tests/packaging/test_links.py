"""Tests that the in-process solver and the daemon contain and need nothing under the GPL."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from support.daemons import BIN

sys.path.insert(0, str(Path(__file__).parents[2] / "packaging" / "wheels"))

from elf import links

LIB = BIN.parent / "lib"
BUILT = [
    BIN / "contactd", LIB / "libcontactd-local.so", LIB / "libcontactd-cntc.so", LIB / "libcontactd.so", LIB / "fmu" / "contactd_fmu.so",
    *(LIB / "python").glob("contactd_local*.so"),
]  # fmt: skip
GPL = re.compile(r"lib(fftw3|cholmod|gmsh|umfpack|spqr|klu)")


def built(file: Path) -> Path:
    if not file.exists():
        pytest.skip(f"{file} is not built")
    return file


@pytest.mark.parametrize("file", BUILT, ids=lambda file: file.name)
def test_no_library_under_the_gpl_is_needed(file):
    assert not [name for name in links(built(file)) if GPL.match(name)]


@pytest.mark.parametrize("file", BUILT, ids=lambda file: file.name)
def test_no_function_of_fftw_is_inside_or_asked_for(file):
    symbols = "".join(
        subprocess.run(["nm", *option, "-C", built(file)], capture_output=True, text=True, check=True).stdout
        for option in ([], ["-D"])
    )
    assert "main" in symbols or "contactd" in symbols or "cntc" in symbols or "fmi2" in symbols
    assert not re.findall(r"\S*\bfftwf?_\S*", symbols)
