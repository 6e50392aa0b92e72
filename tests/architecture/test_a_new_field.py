"""Tests that a new field of a wheel on its rail, or of a contact, is declared by hand in its struct and its schema
only. Slip laws and methods are named in few files.

The tree is copied. A number, a word and a signed number of an answer are added there, and to contacts a number, an
option of finite elements and a slip law. From two files each, the generator derives lists, bounds, messages, mirrored
wheels, paths of the C interface, variables of FMUs and values of Python.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from support.edited_tree import EditedTree

ROOT = Path(__file__).parents[2]
COPIED = ["core/include", "core/types", "proto/schema", "proto/generate", "proto/include", "proto/src/codec", "proto/src/wire", "client/fmu/variables"]
COPIED += ["client/python/contactd"]
PROGRAM = """
#include <iostream>

#include "contactd/error.hpp"
#include "contactd/field_path.hpp"
#include "contactd/fields/wheel_rail_setup.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/proto/field_codec.hpp"

using namespace contactd;

namespace contactd::proto {
const FieldHook* hook_of(const FieldType&) { return nullptr; }
double finite_field(double value, const char*) { return value; }
}  // namespace contactd::proto

int main() {
    WheelRailSetup setup;
    set_number(FieldPath(type_of<WheelRailSetup>(), "track.probe"), &setup, 3);
    set_text(FieldPath(type_of<WheelRailSetup>(), "track.probe_kind"), &setup, "second");
    const nlohmann::json written = proto::write_fields(setup.track, proto::MemberPath("track"));
    Track read;
    proto::read_fields(written, read, proto::MemberPath("track"));
    std::cout << read.probe << " " << (read.probe_kind == ProbeKind::second) << " " << written["probe_kind"] << "\\n";
    setup.track.probe = 6;
    try {
        check_bounds(setup);
    } catch (const InvalidArgument& error) {
        std::cout << error.what() << "\\n";
    }
    RailDeflection deflection{1, 2, 3};
    mirror_fields(deflection);
    std::cout << deflection.y << " " << deflection.z << " " << deflection.probe << "\\n";
}
"""


PYTHON = """
from contactd import ContactProblem, FemIcs, Friction, Grid, KineticFriction, Material, Paraboloid
from contactd.values.answers import read
from contactd.values.contact_params import problem_params
from contactd.values.wheel_rail.params import setup_params
from contactd.wheel_rail import RailDeflection, Track, WheelRailSetup

assert "probe: A number (mm), 0 to 5. Default 1." in Track.__doc__, Track.__doc__
track = Track(probe=3, probe_kind="second")
assert setup_params(WheelRailSetup(track=track))["track"] == {"probe": 3, "probe_kind": "second"}
assert read(RailDeflection, {"y": 1, "z": 2, "probe": 3}).probe == 3

friction = Friction(0.3, (0.1, 0), kinetic=KineticFriction(0.2, 5, "probe"), probe=4)
problem = ContactProblem(
    grid=Grid(2, 2, 1, 1), upper=Material(1, 0), gap=Paraboloid(50), Fn=1, ics=FemIcs(probe=3), friction=friction, probe=2
)
assert "probe: A number (mm), 0 to 5. Default 1." in ContactProblem.__doc__, ContactProblem.__doc__
sent = problem_params(problem.replace(probe=5))
assert sent["ics"] == {"source": "fem", "probe": 3}
assert sent["friction"]["kinetic"]["law"] == "probe"
assert (sent["probe"], sent["friction"]["probe"]) == (5, 4)
"""
#: Lists a method of each family, and expensive methods, whose cost is next to their handler.
METHODS = ["ic.delete", "job.cancel", "session.forget", "solves.pressures"]
METHODS += ["contact.subsurface", "contact.temperature", "wheelrail.geometry", "wheelrail.wheelset", "session.step_many"]
#: Lists folders with sources. CONTACT's interface has its own numbers for CONTACT's laws.
SUFFIXES = {".cpp", ".hpp", ".h", ".c", ".py", ".f90"}
SOURCES = ["core", "engine", "proto/src", "server", "client/c", "client/cpp", "client/fmu", "client/python/contactd"]


def add_fields(tree: EditedTree) -> None:
    """What somebody would write by hand, two files for each field."""
    headers = "core/include/contactd"
    tree.replace(
        f"{headers}/wheel_rail_setup.hpp",
        (
            "struct Track {\n",
            "enum class ProbeKind { first, second };\n\nstruct Track {\n    double probe = 1;\n    ProbeKind probe_kind = ProbeKind::first;\n",
        ),
    )
    deflection = "struct RailDeflection {\n    double y = 0, z = 0"
    tree.replace(f"{headers}/wheel_rail_solution.hpp", (f"{deflection};\n", f"{deflection}, probe = 0;\n"))
    laws = "enum class SlipLaw { linear, exponential, rational"
    tree.replace(f"{headers}/friction.hpp", (f"{laws} }};", f"{laws}, probe }};"))
    number = {"description": "A number.", "x-unit": "mm", "x-fmu": "parameter", "type": "number", "minimum": 0, "maximum": 5, "default": 1}
    # Fields of contacts are for Python only, whose structs are their schemas.
    of_contacts = {**{key: value for key, value in number.items() if key != "x-fmu"}, "x-derived": True}
    with tree.schema("definitions") as definitions:
        track = definitions["definitions"]["wheel_rail_setup"]["properties"]["track"]
        track["properties"] = {
            "probe": number,
            "probe_kind": {"description": "A word.", "x-cpp": "ProbeKind", "enum": ["first", "second"], "default": "first"},
            **track["properties"],
        }
        definitions["definitions"]["ics"]["properties"]["probe"] = of_contacts
    with tree.schema("wheelrail.solve.result") as result:
        signed = {"description": "A signed number.", "x-unit": "mm", "x-parity": "odd", "x-fmu": "output", "type": "number"}
        result["properties"]["rail_deflection"]["properties"]["probe"] = signed
    with tree.schema("contact.solve.params") as solve:
        friction = solve["properties"]["friction"]["properties"]
        for properties in (solve["properties"], friction):
            properties["probe"] = of_contacts
        friction["kinetic"]["properties"]["law"]["enum"].append("probe")


@pytest.fixture
def tree(tmp_path: Path) -> EditedTree:
    """One with the fields, and what is generated from them."""
    edited = EditedTree(tmp_path, COPIED)
    add_fields(edited)
    edited.generate()
    return edited


def test_python_has_a_new_field(tree: EditedTree) -> None:
    tree.python(PYTHON)


def files_with(pattern: str) -> set[Path]:
    """Returns the handwritten sources that contain the pattern."""
    files = (path for folder in SOURCES for path in (ROOT / folder).rglob("*.*") if path.suffix in SUFFIXES)
    return {path for path in files if "generated" not in path.parts and re.search(pattern, path.read_text())}


def test_a_slip_law_is_named_in_few_files() -> None:
    """In the enum, where it is computed, and in its schema."""
    named = files_with(r'SlipLaw::exponential\b|"exponential"|enum class SlipLaw {')
    assert len(named) + 1 <= 4, sorted(named)


@pytest.mark.parametrize("method", METHODS)
def test_a_method_is_named_in_few_files(method: str) -> None:
    """A method is named in its two schemas, its handler, the client of Python, and the client of C++, whose header
    declares a function."""
    schemas = {ROOT / "proto" / "schema" / f"{method}.{part}.json" for part in ("params", "result")}
    assert all(path.exists() for path in schemas)
    named = files_with(rf'"{re.escape(method)}"')
    assert len(schemas | named) + 1 <= 6, sorted(named)


@pytest.mark.slow  # compiles a dozen files
@pytest.mark.timeout(300)
def test_a_new_field_follows_from_its_struct_and_its_schema(tree: EditedTree) -> None:
    variables = (tree.root / "client" / "fmu" / "variables" / "generated" / "wheel_fields.hpp").read_text()
    assert '.path = "setup.track.probe"' in variables
    assert '.path = "rail_deflection.probe"' in variables
    (tree.root / "probe.cpp").write_text(PROGRAM)
    sources = ["probe.cpp", "proto/src/codec/field_codec.cpp", "proto/src/wire/answer_text.cpp", "core/types/field_path.cpp", "core/types/fields.cpp"]
    sources += [str(path.relative_to(tree.root)) for path in (tree.root / "core" / "types" / "generated").glob("*.cpp")]
    told = tree.run(*sources)
    assert told == ['3 1 "second"', "track.probe is 6; it must be zero or positive and at most 5 mm", "-1 2 -3"]


def test_a_member_that_no_schema_declares_is_found(tmp_path: Path) -> None:
    begin = "struct RailDeviation {\n"
    EditedTree(tmp_path, ["core/include"]).replace("core/include/contactd/wheel_rail_state.hpp", (begin, f"{begin}    double forgotten = 0;\n"))
    generated = ROOT / "core" / "types" / "generated"
    include = [f"-I{tmp_path}/core/include", f"-I{generated}/include"]
    made = subprocess.run(
        ["c++", "-std=c++20", "-fsyntax-only", *include, generated / "wheel_rail_state.cpp"], capture_output=True, text=True
    )
    assert made.returncode != 0
    assert "RailDeviation" in made.stderr
