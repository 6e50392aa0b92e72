"""The modules of the Python client stand on floors: imports go down, never back. Imports inside functions, for type checkers
only, and of extras by their names count as well, because who reads a module must know what they name."""

from __future__ import annotations

import ast
import sys
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2] / "client" / "python" / "contactd"
#: Folder: the folders that its modules may import from, beside its own, and beside the modules of GROUND.
ARROWS = {
    "values": [],
    "values/wheel_rail": ["values"],
    "pictures": ["values", "values/wheel_rail", "wear"],
    "files": ["values"],
    "transport": ["values", "files"],
    "calls": ["values", "values/wheel_rail", "files", "transport"],
    "fits": ["", "values", "calls", "transport"],
    "wear": ["", "values", "values/wheel_rail", "files", "calls"],
    "demo": ["", "values", "pictures"],
    "contact_files": [
        "", "values", "values/wheel_rail", "files", "transport", "calls", "contact_files/problems", "contact_files/answers", "contact_files/prints",
    ],
    "contact_files/problems": ["values", "values/wheel_rail"],
    "contact_files/answers": ["values", "values/wheel_rail", "contact_files/problems"],
    "contact_files/prints": ["values", "values/wheel_rail", "contact_files/problems", "contact_files/answers"],
}
GROUND = {"contactd._version", "contactd.errors", "contactd.refusals"}
MOST_FLOORS = 10
#: What values may import beside the standard library; of the libraries of extras nothing but the names of types.
LIBRARIES_OF_VALUES = {"numpy", "typing_extensions"}
TYPES_OF_EXTRAS = {"matplotlib", "scipy", "xarray"}


def name_of(path: Path) -> str:
    parts = path.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(path): path for path in ROOT.rglob("*.py")}


@cache
def tree(module: str) -> ast.Module:
    return ast.parse(MODULES[module].read_text())


def imported(module: str, node: ast.AST) -> list[str]:
    """The modules that a node names: those of an import, and that of a string like "contactd.pictures.contact:draw_contact"."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        package = module.split(".") if MODULES[module].name == "__init__.py" else module.split(".")[:-1]
        above = package[: len(package) - node.level + 1] if node.level else []
        parent = ".".join([*above, *filter(None, [node.module])])
        return [whole if (whole := f"{parent}.{alias.name}") in MODULES else parent for alias in node.names]
    if isinstance(node, ast.Constant) and isinstance(node.value, str) and ":" in node.value:
        return [node.value.partition(":")[0]]
    return []


def all_imported(module: str) -> set[str]:
    return {name for node in ast.walk(tree(module)) for name in imported(module, node)} - {module}


IMPORTS = {module: all_imported(module) & MODULES.keys() for module in MODULES}


def folder_of(module: str) -> str:
    folder = MODULES[module].parent.relative_to(ROOT).as_posix()
    return "" if folder == "." else folder


def test_no_module_leads_back_to_itself() -> None:
    try:
        TopologicalSorter(IMPORTS).prepare()
    except CycleError as error:
        pytest.fail("a circle: " + " <- ".join(error.args[1]))


def test_the_longest_chain_is_short() -> None:
    below: dict[str, list[str]] = {}
    for module in TopologicalSorter(IMPORTS).static_order():
        below[module] = [*max((below[other] for other in IMPORTS[module]), key=len, default=[]), module]
    longest = max(below.values(), key=len)
    assert len(longest) <= MOST_FLOORS, " <- ".join(longest)


@pytest.mark.parametrize("folder", ARROWS)
def test_folders_import_along_the_arrows(folder: str) -> None:
    mine = {module for module in MODULES if folder_of(module) == folder}
    assert mine, f"{folder} has no modules; it must have them, or no line above"
    allowed = mine | GROUND | {module for module in MODULES if folder_of(module) in ARROWS[folder]}
    wrong = {module: sorted(IMPORTS[module] - allowed) for module in mine if IMPORTS[module] - allowed}
    assert not wrong


def test_every_folder_has_a_line() -> None:
    assert {folder_of(module) for module in MODULES} == {"", *ARROWS}


def test_the_ground_stands_on_nothing_of_the_package() -> None:
    assert not set().union(*(IMPORTS[module] for module in GROUND))


def test_values_know_no_library_of_an_extra() -> None:
    for module in MODULES:
        if not folder_of(module).startswith("values"):
            continue
        for_checkers = {
            node
            for block in ast.walk(tree(module))
            if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
            for node in ast.walk(block)
        }
        for node in ast.walk(tree(module)):
            if not isinstance(node, ast.Import | ast.ImportFrom):
                continue
            libraries = {name.partition(".")[0] for name in imported(module, node)}
            foreign = libraries - LIBRARIES_OF_VALUES - sys.stdlib_module_names - {"contactd"}
            assert foreign <= (TYPES_OF_EXTRAS if node in for_checkers else set()), f"{module} imports {foreign}"



def test_modules_are_named_by_what_they_have() -> None:
    """A word that ends in -ing names what somebody does, not what is there."""
    assert not [module for module in MODULES if module.endswith("ing")]
