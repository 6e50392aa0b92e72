"""The Python client has the names of the schemas' fields from what is generated: literals of them stand in hooks only.

A hook writes or reads what has another form on the wire than in Python, or is the message of a method. Each is named with
its reason and the most literals that it may have; who needs fewer lowers the number.
"""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from support.schema_fields import FIELDS

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "client" / "python" / "contactd"
FOLDERS = ["values", "calls", "transport"]
#: File: the most literals, and why there are any.
HOOKS: dict[str, tuple[int, str]] = {
    "values/answers.py": (1, '"result", where errors of answers stand'),
    "values/contact_params.py": (77, "bodies, coefficients and tractions, which depend on each other on the wire; tables and stresses"),
    "values/creep_curves.py": (7, "rows of representations"),
    "values/dictionaries.py": (7, '"type", the kind of a value in files'),
    "values/fit.py": (1, "rows of representations"),
    "values/friction_methods.py": (7, "a pair of arrays, x and y on the wire; motions, of which the wire wants one"),
    "values/grid_methods.py": (1, "the name of a type"),
    "values/hertz_grid.py": (15, "what of a problem decides the ellipse of contact"),
    "values/material_methods.py": (16, "Young's modulus; values that are set when they are made"),
    "values/params.py": (2, "the metadata of fields"),
    "values/partial_solution.py": (13, "arrays that answers lack where nothing asks for them"),
    "values/problem_methods.py": (3, "fields in whose place a solution may stand"),
    "values/profile_points.py": (4, "the text of a file, which is read when the file is named"),
    "values/solution_methods.py": (9, "rows of representations"),
    "values/stated_wear.py": (14, "kinds of wear, and wheel and rail, as a WearLaw has them"),
    "values/subsurface_methods.py": (8, "components that are drawn, rows of representations"),
    "values/tables.py": (35, "tables, whose array has another name on the wire; rows of representations"),
    "values/temperature_methods.py": (1, "rows of representations"),
    "values/temperature_params.py": (14, "what contact.temperature takes of a solution"),
    "values/wear_law_methods.py": (4, "what a kind may say of its law, which stands beside it on the wire"),
    "values/wheel_rail/comparison.py": (7, "forces that are compared"),
    "values/wheel_rail/params.py": (6, "the material of the rail, which the daemon does not know by itself"),
    "values/wheel_rail/passage_wear.py": (2, "which of the two wears"),
    "values/wheel_rail/solution.py": (4, "answers without patches"),
    "values/wheel_rail/solution_methods.py": (12, "rows of representations"),
    "calls/answer_warnings.py": (30, "where warnings stand in answers"),
    "calls/any_session.py": (13, "messages of session.close, save, restore and forget"),
    "calls/caller.py": (12, "envelopes"),
    "calls/comparison.py": (49, "what models take of a case: their options, and what all are asked for alike"),
    "calls/contact.py": (19, "messages of contact.solve_many, contact.subsurface and contact.temperature"),
    "calls/contact_files.py": (8, "messages of contact_file"),
    "calls/contact_session.py": (22, "fields of a step that are of a shift, of rolling or of neither"),
    "calls/creep_curves.py": (12, "creepages, the fields of a shift that a curve refuses, messages of contact.solve_many"),
    "calls/progress_bar.py": (1, "the extra of that name"),
    "calls/server.py": (11, "messages of server, job and solves"),
    "calls/sessions.py": (24, "messages of session.open, join, info and list"),
    "calls/stated_problems.py": (11, "gap and bodies, which calls take by their places"),
    "calls/step_many.py": (2, "messages of session.step_many"),
    "calls/steps.py": (8, "messages of session.step"),
    "calls/tables.py": (24, "messages of ic"),
    "calls/timeouts.py": (10, "requests that may have to wait for tables"),
    "calls/wheel_rail.py": (28, "messages of wheelrail; the side of a set-up"),
    "calls/wheel_rail_session.py": (22, "messages of the steps of wheels"),
    "transport/connections.py": (5, "envelopes"),
    "transport/event_loop.py": (3, "envelopes"),
    "transport/frames.py": (13, "references to frames"),
    "transport/in_process.py": (2, "envelopes"),
    "transport/messages.py": (22, "envelopes"),
}


def is_export(node: ast.AST) -> bool:
    return isinstance(node, ast.Assign) and any(isinstance(name, ast.Name) and name.id == "__all__" for name in node.targets)


def is_type(node: ast.AST) -> bool:
    """Returns whether a node is a type that lists keywords."""
    return isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.value.id == "Literal"


def literals(text: str) -> list[str]:
    """Those of fields, but for types, and for lists of what a module exports."""
    found, nodes = [], [ast.parse(text)]
    while nodes:
        node = nodes.pop()
        if isinstance(node, ast.Constant) and node.value in FIELDS:
            found.append(node.value)
        nodes += [] if is_export(node) or is_type(node) else ast.iter_child_nodes(node)
    return found


def files() -> dict[str, list[str]]:
    paths = [path for folder in FOLDERS for path in sorted((PACKAGE / folder).rglob("*.py"))]
    texts = {path.relative_to(PACKAGE).as_posix(): path.read_text() for path in paths}
    return {file: literals(text) for file, text in texts.items() if "Written by ./dev generate" not in text[:2000]}


FILES = files()


@pytest.mark.parametrize("file", sorted(FILES))
def test_names_of_fields_stand_in_hooks_only(file: str) -> None:
    most, _ = HOOKS.get(file, (0, ""))
    assert len(FILES[file]) <= most, f"{file} has {len(FILES[file])}: {sorted(set(FILES[file]))}"


@pytest.mark.parametrize("file", sorted(HOOKS))
def test_a_hook_has_as_many_as_it_says(file: str) -> None:
    assert len(FILES[file]) == HOOKS[file][0], "lower the number"


def test_literals_are_found() -> None:
    assert literals('__all__ = ["Fn"]\nx = {"Fn": f"{y} Fn", "mine": z["mu"]}\n') == ["mu", "Fn"]
