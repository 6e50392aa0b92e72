"""Tests the descriptions in the archives."""

from __future__ import annotations

import re
import subprocess
import sys
import xml.etree.ElementTree as ET
import zipfile
from pathlib import Path

import pytest

from support.daemons import BIN
from support.fmus import KINDS, PACKAGES, VERSIONS, archive

ROOT = Path(__file__).parents[3]
ALL = [pytest.param(kind, fmi, id=f"{kind} FMI {fmi}") for kind in KINDS for fmi in VERSIONS]


@pytest.mark.parametrize(("kind", "fmi"), ALL)
def test_fmpy_finds_no_problem(kind, fmi):
    from fmpy.validation import validate_fmu

    assert validate_fmu(str(archive(kind, fmi))) == []


@pytest.mark.parametrize(("kind", "fmi"), ALL)
def test_everything_has_a_sentence_and_every_length_a_unit(kind, fmi):
    from fmpy import read_model_description

    description = read_model_description(str(archive(kind, fmi)))
    units = {unit.name: unit.baseUnit for unit in description.unitDefinitions}
    assert units["mm"].m == 1
    assert units["mm"].factor == 1e-3
    assert (units["N/mm2"].kg, units["N/mm2"].m, units["N/mm2"].s, units["N/mm2"].factor) == (1, -1, -2, 1e6)
    for variable in description.modelVariables:
        assert variable.description.endswith("."), variable.name
    reals = {v.name: v.unit for v in description.modelVariables if v.type in ("Real", "Float64")}
    assert (reals["Fx"], reals["pmax"], reals["power"], reals["friction.mu"]) == ("N", "N/mm2", "N.mm/s", None)


@pytest.mark.parametrize("kind", KINDS)
def test_both_versions_have_the_same_variables(kind):
    from fmpy import read_model_description

    def listed(fmi):
        variables = read_model_description(str(archive(kind, fmi))).modelVariables
        return [(v.name, v.valueReference, v.causality, v.unit, v.start, v.description) for v in variables]

    two, three = listed(2), listed(3)
    assert len(two) > 60
    assert two == three[1:]
    assert three[0][0] == "time"


@pytest.mark.parametrize(("kind", "fmi"), ALL)
def test_they_can_do_what_the_page_says(kind, fmi):
    with zipfile.ZipFile(archive(kind, fmi)) as fmu:
        of = ET.fromstring(fmu.read("modelDescription.xml")).find("CoSimulation")
    can = {name for name, value in of.items() if value == "true"}
    written = {
        2: {"canGetAndSetFMUstate", "canSerializeFMUstate", "providesDirectionalDerivative"},
        3: {"canGetAndSetFMUState", "canSerializeFMUState", "providesDirectionalDerivatives"},
    }
    assert can == written[fmi] | {"canHandleVariableCommunicationStepSize"}


@pytest.mark.parametrize("fmi", VERSIONS)
def test_the_shared_object_has_all_functions_of_the_headers_and_nothing_else(fmi):
    """Importers also look up functions that co-simulation does not need."""
    header = (PACKAGES / "fmpy" / "c-code" / f"fmi{fmi}Functions.h").read_text()
    declared = set(re.findall(rf"^ *FMI{fmi}_Export .* (fmi{fmi}\w+);", header, re.MULTILINE))
    library = BIN.parent / "lib" / "fmu" / "contactd_fmu.so"
    symbols = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout
    exported = {line.split()[-1] for line in symbols.splitlines()}
    assert {name for name in exported if name.startswith(f"fmi{fmi}")} == declared
    assert all(name.startswith(("fmi2", "fmi3")) for name in exported)


@pytest.mark.parametrize(("kind", "fmi"), ALL)
def test_an_archive_is_the_same_whenever_it_is_made(kind, fmi):
    with zipfile.ZipFile(archive(kind, fmi)) as fmu:
        assert {entry.date_time for entry in fmu.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        platform = {2: "linux64", 3: "x86_64-linux"}[fmi]
        assert f"binaries/{platform}/{kind}.so" in fmu.namelist()
        assert "documentation/licenses/contactd.txt" in fmu.namelist()


def test_archives_hold_the_binaries_of_other_platforms_where_importers_look(tmp_path):
    for platform, library in (("windows", "contactd_fmu.dll"), ("arm64", "contactd_fmu.so")):
        for name, text in ((f"lib/fmu/{library}", platform), ("notices/licenses/hdf5", "as HDF5 likes"), ("notices/SOURCES.txt", "hdf5 1.14")):
            (tmp_path / platform / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / platform / name).write_text(text)
    programs = [BIN / "contactd-fmu-description", BIN.parent / "lib" / "fmu" / "contactd_fmu.so"]
    others = ["--windows", tmp_path / "windows", "--arm64", tmp_path / "arm64"]
    subprocess.run([sys.executable, ROOT / "packaging" / "fmu", *programs, tmp_path, *others], check=True, capture_output=True)
    for kind in KINDS:
        found = {}
        for archive_ in tmp_path.glob(f"{kind}_*.fmu"):
            with zipfile.ZipFile(archive_) as fmu:
                found[archive_.name] = {name.split("/")[1]: fmu.read(name) for name in fmu.namelist() if name.startswith("binaries/")}
                assert fmu.read("documentation/licenses/arm64/sources.txt") == b"hdf5 1.14"
        assert found[f"{kind}_fmi2.fmu"].keys() == {"linux64", "win64"}
        assert found[f"{kind}_fmi2_arm64.fmu"] == {"linux64": b"arm64"}, "the only folder in which importers of arm64 look"
        assert found[f"{kind}_fmi3.fmu"].keys() == {"x86_64-linux", "x86_64-windows", "aarch64-linux"}
        assert found[f"{kind}_fmi3.fmu"]["aarch64-linux"] == b"arm64"
