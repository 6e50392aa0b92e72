"""Tests that the Modelica package calls existing functions, with the results of the client. No compiler of Modelica is
among the packages, so its external functions are compiled, and a program simulates its model with them."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

import contactd
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from support.creep_tables import invented_table
from support.daemons import BIN

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
FOLDER = ROOT / "adapters" / "modelica" / "Contactd"
PACKAGE = (FOLDER / "package.mo").read_text()
HEADER = (FOLDER / "Resources" / "Include" / "contactd_modelica.h").read_text()
#: Type of Modelica -> type of C (language specification, 12.9.1).
TYPES = {"Real": "double", "String": "const char*", "WheelObject": "void*", "CreepTable": "void*", "Integer": "int"}
#: Keywords of the language (specification, 2.3.3), which are not allowed as names.
RESERVED = set(
    """algorithm and annotation block break class connect connector constant constrainedby der discrete each else elseif elsewhen
    encapsulated end enumeration equation expandable extends external false final flow for function if import impure in initial
    inner input loop model not operator or outer output package parameter partial protected public pure record redeclare
    replaceable return stream then true type when while within""".split()
)


def test_no_component_has_the_name_of_a_word_of_the_language():
    names = re.findall(r"^ *(?:input |output |parameter )?(?:Real|Integer|Boolean|String|WheelObject) (\w+)", PACKAGE, re.MULTILINE)
    assert len(names) > 20
    assert not set(names) & RESERVED


def test_names_that_begin_end():
    code = re.sub(r'"(?:\\.|[^"\\])*"', '""', PACKAGE)
    opened: list[str] = []
    for kind, name in re.findall(r"\b(package|class|function|model|end) (\w+)", code):
        if kind == "end":
            assert opened.pop() == name
        else:
            opened.append(name)
    assert not opened
    assert all(code.count(left) == code.count(right) for left, right in ("()", "[]", "{}"))


def test_external_functions_have_the_arguments_that_are_handed_over():
    found = re.findall(r'function (\w+)(.*?)external "C" (?:(\w+) = )?(\w+)\(([^;]*?)\)\s*annotation', PACKAGE, re.DOTALL)
    assert len(found) == 6
    for _, body, answer, name, handed in found:
        declared = {name: kind for kind, name in re.findall(r"(?:input|output) (\w+) (\w+)", body)}
        (prototype,) = re.findall(rf"static (\S+) {name}\(([^)]*)\)", HEADER)
        expected = [" ".join(part.split()) for part in prototype[1].split(",")]
        arguments = [part.strip() for part in re.split(r",(?![^(]*\))", handed)]
        assert len(arguments) == len(expected), name
        for argument, parameter in zip(arguments, expected, strict=True):
            kind = "int" if argument.startswith("size(") else TYPES[declared[argument]] + ("*" if argument == "w" else "")
            assert parameter.rpartition(" ")[0] == kind, (name, argument, parameter)
        assert (prototype[0] == "void") == (not answer)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    libraries = BIN.parent / "lib"
    if not (libraries / "libcontactd-local.so").exists():
        pytest.skip("this build has no libcontactd-local")
    built = tmp_path_factory.mktemp("modelica") / "wheelset"
    places = [f"-I{folder}" for folder in (HERE, FOLDER / "Resources" / "Include", ROOT / "client" / "c" / "include")]
    command = ["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", *places, HERE / "modelica_wheelset.c", f"-L{libraries}"]
    subprocess.run([*command, f"-Wl,-rpath,{libraries}", "-lcontactd-local", "-o", built], check=True)
    return built


def test_its_wheelset_swings_back_by_the_forces_of_the_client(program):
    first, *places = subprocess.run([program], capture_output=True, text=True, check=True, timeout=60).stdout.splitlines()
    state = WheelRailState(position=WheelsetPosition(y=3), velocity=WheelsetVelocity(x=10e3, pitch=-10e3 / 460), Fz=50e3)
    with contactd.local() as client:
        solution = client.wheel_rail(WheelRailSetup(model="fastsim", dx=1, dy=1), state, fields=[])
    on_rail = solution.forces.wheelset
    assert [float(number) for number in first.split()] == pytest.approx([on_rail.Fy, on_rail.Fz, 1e-3 * on_rail.Mz], rel=1e-9)
    y = [1e3 * float(place) for place in places]
    # test_ssp.py has the same wheelset as four FMUs: a quarter of its wave takes 0.23 s.
    assert y[0] == 3
    assert y[2] > 0.4 and y[3] < -0.9


def test_a_failure_is_one_of_modelica(program):
    ended = subprocess.run([program, "springs"], capture_output=True, text=True, timeout=60)
    assert ended.returncode == 3
    assert ended.stdout.startswith("contactd: setup.model is")


def test_its_creep_forces_are_those_of_python(program, tmp_path):
    path = invented_table(tmp_path)
    forces = subprocess.run([program, "table", path], capture_output=True, text=True, check=True, timeout=60).stdout.split()
    found = contactd.CreepTable(path).forces(6, 5, 82e3, 0.3, 80e3, 1e-3, 2e-3, 3e-4)
    assert [float(number) for number in forces] == pytest.approx([found.Fx, found.Fy, 1e-3 * found.Mz], rel=1e-12)
