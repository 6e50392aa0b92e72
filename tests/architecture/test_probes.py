"""What is new is written by hand in few files: a value of a line of CONTACT's files in 3, a method in 6, an array of the
history in 6. Each test writes one in a copy of the tree, counts the files and uses it.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from support.contact_cases import END, FIRST
from support.edited_tree import EditedTree

VALUE_PROGRAM = """
#include "given/file_values.cpp"
#include "given/given_bodies.cpp"

#include <iostream>

int main() {
    using namespace contactd;
    const ContactFile file = read_contact_file(R"(TEXT)", "probe.inp");
    for (const std::string& error : file.cases.front().errors) std::cout << error << "\\n";
    cases::Given given;
    cases::set_bodies(given, {file.cases.front()});
    std::cout << given.layer->residual << "\\n";
}
"""
METHOD_PROGRAM = """
#include "methods/server_methods.cpp"
#include "methods/method_table.cpp"

#include <iostream>

int main() {
    contactd::server::MethodTable methods;
    contactd::server::add_server_methods(methods);
    std::cout << methods.find("server.probe")->is_immediate << "\\n";
}
"""
METHOD_PYTHON = """
from contactd.calls.call import Waits
from contactd.calls.server import ServerCalls
from contactd.transport.messages import Reply

class Echo(Waits, ServerCalls):
    is_closed = False

    def _carry_out(self, request):
        assert request.method == "server.probe"
        return Reply({"value": 2 * request.envelope["params"]["value"]}, [])

assert Echo("ipc://nowhere").probe(3) == 6
"""
HISTORY_PROGRAM = """
#include "history/moved.hpp"

#include <iostream>

#include "contactd/fields/contact.hpp"
#include "contactd/fields/grid_arrays.hpp"
#include "variables/generated/history.hpp"

int main() {
    using namespace contactd;
    ContactSolution solution;
    solution.probe = {5, 6};
    const SurfaceState end = end_of(solution);
    FrictionLaw friction;
    friction.mu = {0.3};
    const Grid from{2, 1, 1, 1, 0, 0}, to{2, 1, 1, 1, 1, 0};
    const SurfaceState moved = cases::on_grid(end, from, to, friction);
    std::cout << end.probe[0] << " " << moved.probe[0] << " " << moved.probe[1] << "\\n";
    std::cout << name_of(SolutionField::probe) << " " << fmu::history_arrays.back().name << "\\n";
}
"""
HISTORY_PYTHON = """
from contactd.contact_files.python_text import python_text
from contactd.values.contact_params import traction_params
from contactd.values.generated.array_labels import ARRAY_LABELS
from contactd.values.generated.problem import Estimate
from contactd.values.solution import ALL_FIELDS, OPTIONAL_ARRAYS

estimate = Estimate(pressure=[[1.0]], probe=[[2.0]])
assert traction_params(estimate, "previous").keys() == {"pressure", "probe"}
assert traction_params(estimate, "initial").keys() == {"pressure"}
assert "probe" in ALL_FIELDS and "probe" in OPTIONAL_ARRAYS
assert ARRAY_LABELS["probe"] == ("probe", "mm")
assert '"probe")' in python_text("", [])
"""
ARRAY = {"$ref": "definitions.json#/definitions/array", "description": "A state of particles, shape [ny, nx] (mm)."}


@pytest.mark.slow  # compiles the reader of files
@pytest.mark.timeout(300)
def test_a_value_of_a_line_takes_three_files(tmp_path: Path) -> None:
    tree = EditedTree(tmp_path, ["core/include", "core/types", "core/profile_files", "core/src/influence", "cases"])
    tree.replace("cases/read/steps.cpp", ("TAU_C0 K_TAU", "TAU_C0 K_TAU {PROBE=0.1}"))
    tree.replace("cases/given/file_values.cpp", ('"TAU_C0", "K_TAU"', '"TAU_C0", "K_TAU", "PROBE"'))
    tree.replace("cases/given/given_bodies.cpp", ("    validate(layer);\n", "    layer.residual = given[8];\n    validate(layer);\n"))
    assert len(tree.edited) <= 3
    constants = "   0.28  0.28  82000.  82000.\n"
    text = FIRST.replace("022020", "022420").replace(constants, f"{constants} 8200. 1. 120. 9000. 0.25\n") + END
    (tmp_path / "value.cpp").write_text(VALUE_PROGRAM.replace("TEXT", text))
    readers = sorted(path.name for path in (tmp_path / "cases" / "read").glob("*.cpp"))
    (tmp_path / "read.cpp").write_text("".join(f'#include "read/{name}"\n' for name in readers))
    types = ["core/types/fields.cpp", "core/types/friction.cpp", "core/types/material.cpp", "core/types/generated/friction.cpp"]
    assert tree.run("value.cpp", "read.cpp", "core/profile_files/profile_lines.cpp", *types) == ["0.25"]


@pytest.mark.slow  # compiles the methods of a family
@pytest.mark.timeout(300)
def test_a_method_takes_six_files(tmp_path: Path) -> None:
    folders = ["core", "cases", "proto", "engine", "server/src", "client/cpp", "client/c/generated", "client/fmu/variables"]
    tree = EditedTree(tmp_path, [*folders, "client/python/contactd"])
    value = {"type": "object", "additionalProperties": False, "required": ["value"], "examples": [{"value": 3}]}
    value["properties"] = {"value": {"description": "A number.", "type": "number"}}
    notes = {"x-order": 999, "x-summary": "Doubles a number.", "x-errors": []}
    params, result = ({"$schema": "http://json-schema.org/draft-07/schema#", "title": part, "description": part, **value} for part in "ab")
    tree.write("proto/schema/server.probe.params.json", json.dumps({**params, **notes}))
    tree.write("proto/schema/server.probe.result.json", json.dumps(result))
    handler = "void probe(const CallPtr& call, const DaemonParts&) {\n"
    handler += '    call->succeed({{"value", 2 * call->request.params["value"].get<double>()}});\n}\n'
    added = '    methods.add({.name = "server.probe", .is_immediate = true, .handle = probe});\n'
    last = '    methods.add({.name = "server.config", .is_immediate = true, .handle = config});\n'
    tree.replace("server/src/methods/server_methods.cpp", ("}  // namespace\n\n", f"{handler}\n}}  // namespace\n\n"), (last, last + added))
    call = "    @asks\n    def probe(self, value: float, *, timeout: float | None = None) -> Answering[float]:\n"
    call += '        """Doubles a number."""\n'
    call += '        return float((yield from self.asked("server.probe", {"value": value}, timeout=timeout))["value"])\n\n'
    begin = "    @asks\n    def config("
    tree.replace("client/python/contactd/calls/server.py", (begin, call + begin))
    begin = "    std::vector<Job> jobs("
    tree.replace("client/cpp/include/contactd/client/client.hpp", (begin, f"    double probe(double value, const CallOptions& options = {{}});\n{begin}"))
    body = "double Client::probe(double value, const CallOptions& options) {\n"
    body += '    return impl_->result_of("server.probe", options, {{"value", value}})["value"].get<double>();\n}\n\n'
    begin = "std::vector<Job> Client::jobs("
    tree.replace("client/cpp/src/client.cpp", (begin, body + begin))
    assert len(tree.edited) <= 6
    tree.generate()
    tree.python(METHOD_PYTHON)
    tree.compile("client/cpp/src/client.cpp", "-fsyntax-only")
    (tmp_path / "method.cpp").write_text(METHOD_PROGRAM)
    assert tree.run("method.cpp") == ["1"]


@pytest.fixture
def with_history(tmp_path: Path) -> EditedTree:
    """A tree whose steps pass on one more array, which the solver increases by 1 in each step."""
    folders = ["core/include", "core/types", "core/src", "cases", "proto/schema", "proto/generate", "client/fmu/variables"]
    tree = EditedTree(tmp_path, [*folders, "client/python/contactd"])
    history = {"if": "true", "enters": "law.mu_of(element)", "minimum": 0}
    with tree.schema("contact.solve.params") as solve:
        for state in ("previous", "initial"):
            solve["properties"][state]["properties"]["probe"] = {**ARRAY, **({"x-history": history} if state == "previous" else {})}
    with tree.schema("contact.solve.result") as answer:
        answer["properties"]["probe"] = {**ARRAY, "x-label": ["probe", "mm"]}
    with tree.schema("definitions") as definitions:
        fields = definitions["definitions"]["fields"]
        fields["maxItems"] += 1
        fields["items"]["enum"].insert(-3, "probe")
    tree.replace("core/include/contactd/contact_load.hpp", ("    bool empty() const {", "    std::vector<double> probe{};\n\n    bool empty() const {"))
    enumerators = ("    friction_coefficient,\n    upper", "    friction_coefficient,\n    probe,\n    upper")
    tree.replace("core/include/contactd/contact.hpp", ("    std::vector<double> friction_coefficient;\n", "    std::vector<double> friction_coefficient, probe;\n"), enumerators)
    tree.replace(
        "core/src/contact/outer/boundary_elements.cpp",
        ("            remember_failures();\n", "            remember_failures();\n            particles_.probe.assign(n_, particles->probe.empty() ? 1 : particles->probe[0] + 1);\n"),
        ("        report_failures();\n        return", "        solution_.probe = std::move(particles_.probe);\n        report_failures();\n        return"),
    )  # fmt: skip
    assert len(tree.edited) <= 6
    tree.generate()
    return tree


def test_an_array_of_the_history_is_in_messages_python_and_c(with_history: EditedTree) -> None:
    with_history.python(HISTORY_PYTHON)
    schemas = with_history.root / "proto" / "schema"
    reference = '"probe": {"$ref": "contact.solve.result.json#/properties/probe"},\n'
    assert all(reference in (schemas / name).read_text() for name in ("session.step.result.json", "wheelrail.solve.result.json"))
    assert "CONTACTD_PATH_PREVIOUS_PROBE" in (with_history.root / "client/c/generated/include/contactd/paths.h").read_text()


@pytest.mark.slow  # compiles lists of fields and the solver
@pytest.mark.timeout(300)
def test_an_array_of_the_history_takes_six_files(with_history: EditedTree) -> None:
    for source in ("core/src/contact/outer/boundary_elements.cpp", "core/src/wheel_rail/position/traction_history.cpp", "core/types/generated/contact.cpp"):
        with_history.compile(source, "-fsyntax-only")
    (with_history.root / "history.cpp").write_text(HISTORY_PROGRAM)
    sources = ["core/types/history.cpp", "core/types/generated/grid_arrays.cpp", "cases/history/moved.cpp"]
    assert with_history.run("history.cpp", *sources) == ["5 6 0.3", "probe probe"]
