"""C and C++ have the names of the schemas' fields from what is generated: literals of them stand in few folders.

Each of these is named with the most literals that it may have and the reason that it has any.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from support.schema_fields import FIELDS

ROOT = Path(__file__).parents[2]

LAYERS = ["core", "engine", "proto/include", "proto/src", "server", "client"]
SUFFIXES = {".c", ".cpp", ".f90", ".h", ".hpp"}
REFUSAL = "fields that are named by a refusal, or by a warning, of what no schema can check"
WORD = "words of messages that are a field's by chance"
#: What a folder of core or engine may have without a word: refusals name fields there, and no message is made there.
FEW = 20
#: Folder: the most literals, and why there are any.
FOLDERS: dict[str, tuple[int, str]] = {
    "client/c/example": (20, "an example, written as a user would"),
    "client/c/fortran": (10, "an example, written as a user would"),
    "client/c/include": (50, "contactd.h: names of arguments in examples and macros"),
    "client/c/matlab": (10, "arrays, which MATLAB has by name"),
    "client/c/src": (141, "paths of arrays and alternatives, which are hooks as those of the codec"),
    "client/cntc/src/edge": (10, WORD),
    "client/cntc/src/interface": (50, "fields that its refusals name beside CONTACT's"),
    "client/cntc/src/problem": (10, "fields that its refusals name beside CONTACT's"),
    "client/cpp/src": (150, "messages of methods, envelopes, and where warnings stand in answers"),
    "client/fmu/describe": (20, "attributes of modelDescription.xml"),
    "client/fmu/instance": (10, WORD),
    "client/fmu/interface": (20, WORD),
    "client/fmu/models": (90, "what a model sets and gives: its paths in the C interface"),
    "client/fmu/variables": (51, "variables that an FMU has beside the schema's"),
    "client/python/local": (10, "names of arguments"),
    "core/include/contactd": (
        110,
        "lists of the fields of sections and of finite elements, which files and keys visit, too",
    ),
    "core/src/store": (30, "what a key is made of, whose names may never change, and refusals"),
    "core/src/store/hdf5": (100, "names in files of tables, which may never change"),
    "core/types": (70, REFUSAL),
    "core/types/heat": (20, REFUSAL),
    "core/types/profile_files": (10, "a keyword of Simpack's files"),
    "engine": (30, "where tables are known from"),
    "engine/ics/build": (20, "lines of progress between builder and daemon"),
    "proto/src/codec": (529, "hooks: shorthand of coefficients, arrays, alternatives, and messages of methods"),
    "proto/src/schema": (40, "keywords of JSON Schema and of OpenRPC"),
    "proto/src/wire": (50, "envelopes and frames"),
    "server/contactd_ic": (20, "lines of progress between builder and daemon"),
    "server/src/access": (10, REFUSAL),
    "server/src/config": (40, "keys of the configuration"),
    "server/src/jobs": (30, "envelopes and reports of progress"),
    "server/src/methods": (240, "messages of server, job, solves and session; the requests that costs are measured by"),
    "server/src/methods/costs": (60, "arguments that the cost of a request follows from"),
    "server/src/methods/ics": (40, "messages of ic"),
    "server/src/operation": (20, "lines of logs"),
    "server/src/operation/metrics": (30, "metrics"),
    "server/src/service": (10, WORD),
    "server/src/sessions": (10, REFUSAL),
}


def literals(text: str) -> list[str]:
    """Those that are a field, each once a place, without includes and comments."""
    code = re.sub(r"#include.*|//.*", "", text)
    return [literal for literal in re.findall(r'"([^"\\\n]*)"', code) if literal in FIELDS]


def folders() -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for layer in LAYERS:
        for path in sorted((ROOT / layer).rglob("*")):
            if path.suffix in SUFFIXES and "Written by ./dev generate" not in (text := path.read_text())[:2000]:
                found.setdefault(path.parent.relative_to(ROOT).as_posix(), []).extend(literals(text))
    return {folder: names for folder, names in found.items() if names}


FOUND = folders()


@pytest.mark.parametrize("folder", sorted(set(FOUND) | set(FOLDERS)))
def test_a_folder_has_no_more_names_of_fields_than_it_says(folder: str) -> None:
    names = FOUND.get(folder, [])
    most, _ = FOLDERS.get(folder, (FEW if folder.startswith(("core", "engine")) else 0, ""))
    assert len(names) <= most, f"take them from what is generated: {sorted(set(names))}"


def test_literals_are_found() -> None:
    assert literals('#include "mu"\nset("Fn", 1); // "mu"\nconst char* x = "mine";\n') == ["Fn"]
