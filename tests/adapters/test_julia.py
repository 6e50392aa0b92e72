"""Tests that the module for Julia calls existing functions of contactd.h. Julia is not among the packages, so the
calls are read from the module, compared with the header, and made with the same types."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import contactd
from support.creep_tables import invented_table
from support.daemons import BIN

ROOT = Path(__file__).parents[2]
MODULE = (ROOT / "adapters" / "julia" / "Contactd.jl").read_text()
HEADER = (ROOT / "client" / "c" / "include" / "contactd.h").read_text()
LIBRARY = BIN.parent / "lib" / "libcontactd-local.so"

#: Type of Julia -> corresponding types of C, and of ctypes.
TYPES: dict[str, tuple[set[str], Any]] = {
    "Int32": ({"int32_t"}, ctypes.c_int32),
    "Cdouble": ({"double"}, ctypes.c_double),
    "Cstring": ({"const char*"}, ctypes.c_char_p),
    "Ptr{Cvoid}": ({"contactd_any_handle", "contactd_handle", "contactd_connection*", "contactd_contact*", "contactd_wheel*", "contactd_creep_table*"}, ctypes.c_void_p),
    "Ptr{Ptr{Cvoid}}": ({"contactd_wheel* const*"}, ctypes.POINTER(ctypes.c_void_p)),
    "Ref{Ptr{Cvoid}}": ({"contactd_connection**", "contactd_contact**", "contactd_wheel**", "contactd_creep_table**"}, ctypes.POINTER(ctypes.c_void_p)),
    "Ptr{Cdouble}": ({"double*", "const double*"}, ctypes.POINTER(ctypes.c_double)),
    "Ref{Cdouble}": ({"double*"}, ctypes.POINTER(ctypes.c_double)),
    "Ref{Int32}": ({"int32_t*"}, ctypes.POINTER(ctypes.c_int32)),
}


def calls() -> dict[str, tuple[str, list[str], int]]:
    """Maps names to the types of the answer and of the arguments, and the number of further arguments."""
    found = {}
    # Arguments may be calls with one argument.
    for name, answer, arguments, rest in re.findall(
        r"ccall\(\(:(\w+), LIBRARY\), ([\w{}]+),\s+\(([^()]*)\)((?:[^()]|\([^()]*\))*)\)", MODULE
    ):
        types = [part.strip() for part in arguments.split(",") if part.strip()]
        given = len([part for part in rest.split(",") if part.strip()])
        found[name] = (answer, types, given)
    return found


def prototypes() -> dict[str, tuple[str, list[str]]]:
    """Does the same for the header."""
    found = {}
    for answer, name, arguments in re.findall(r"^CONTACTD_API ([\w ]+\*?) ?(contactd_\w+)\(([^)]*)\);", HEADER, re.MULTILINE):
        types = [re.sub(r"\s*\b\w+$", "", " ".join(part.split())) for part in arguments.split(",") if part.strip() != "void"]
        found[name] = (answer.strip(), types)
    return found


CALLS = calls()


def test_every_call_is_read():
    assert len(re.findall(r"ccall\(\(:", MODULE)) >= len(CALLS) > 20
    assert set(re.findall(r"ccall\(\(:(\w+)", MODULE)) == CALLS.keys()
    assert len(prototypes()) > 40


@pytest.mark.parametrize("name", CALLS)
def test_a_call_has_the_types_of_the_header(name):
    answer, types, given = CALLS[name]
    expected_answer, expected = prototypes()[name]
    assert expected_answer in TYPES[answer][0]
    assert len(types) == len(expected) == given
    for type_of_julia, type_of_c in zip(types, expected, strict=True):
        assert type_of_c in TYPES[type_of_julia][0], (type_of_julia, type_of_c)


def test_what_it_exports_is_defined():
    (exported,) = re.findall(r"^export (.+)$", MODULE, re.MULTILINE)
    for name in exported.split(", "):
        assert re.search(rf"^(?:function |(?:mutable )?struct )?{re.escape(name)}[( \n]", MODULE, re.MULTILINE), name


@pytest.fixture
def julia() -> Callable[..., Any]:
    """Calls a function of the library with the types that the module names."""
    if not LIBRARY.exists():
        pytest.skip("this build has no libcontactd-local")
    library = ctypes.CDLL(str(LIBRARY))

    def call(name: str, *arguments: Any) -> Any:
        answer, types, _ = CALLS[name]
        function = getattr(library, name)
        function.restype, function.argtypes = TYPES[answer][1], [TYPES[of][1] for of in types]
        return function(*arguments)

    return call


def test_the_calls_of_its_example_find_the_forces_of_a_wheel(julia):
    connection, wheel = ctypes.c_void_p(), ctypes.c_void_p()
    assert julia("contactd_open", b"local", connection) == 0
    assert julia("contactd_wheel_new", connection, wheel) == 0
    assert julia("contactd_set_word", wheel, b"setup.model", b"fastsim") == 0
    (example,) = re.findall(r'open_connection\("local"\) do connection\n(.*?)solve!', MODULE, re.DOTALL)
    values = {path: eval(value) for path, value in re.findall(r'wheel\["(state[\w.]+)"\] = (.+)$', example, re.MULTILINE)}
    assert values["state.Fz"] == 80e3
    for path, value in values.items():
        assert julia("contactd_set", wheel, path.encode(), value) == 0
    assert julia("contactd_wheel_solve", wheel) == 0
    count, forces = ctypes.c_int32(), (ctypes.c_double * 6)()
    assert julia("contactd_length", wheel, b"forces.track", count) == 0
    assert count.value == 6
    assert julia("contactd_get_array", wheel, b"forces.track", forces, 6) == 0
    assert forces[2] == pytest.approx(80e3, rel=1e-5)
    assert julia("contactd_set", wheel, b"state.Fz.none", 1.0) != 0
    assert b"state.Fz" in julia("contactd_last_error", wheel)
    assert julia("contactd_wheel_free", wheel) == 0
    assert julia("contactd_close", connection) == 0


def test_its_creep_table_has_the_forces_of_python(julia, tmp_path):
    path = invented_table(tmp_path)
    table, numbers = ctypes.c_void_p(), ctypes.c_double * 3
    forces, jacobian, bounds = numbers(), (ctypes.c_double * 9)(), numbers()
    assert julia("contactd_creep_table_open", str(path).encode(), 0.28, table) == 0
    assert julia("contactd_creep_table_forces", table, 6, 5, 82e3, 0.3, 80e3, numbers(1e-3, 2e-3, 3e-4), forces, jacobian, bounds) == 0
    found = contactd.CreepTable(path).forces(6, 5, 82e3, 0.3, 80e3, 1e-3, 2e-3, 3e-4)
    assert [*forces] == [found.Fx, found.Fy, found.Mz]
    assert [*jacobian] == found.by_creepage.ravel().tolist()
    assert julia("contactd_creep_table_close", table) == 0
