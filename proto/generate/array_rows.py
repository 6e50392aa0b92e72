"""Completes the rows of references in proto/schema: an object with `x-arrays-of` refers to each array of that document."""

from __future__ import annotations

import json
import re
from pathlib import Path

from .declarations import SCHEMAS

_ARRAY = {"$ref": "definitions.json#/definitions/array"}
_LIST = re.compile(
    r'"x-arrays-of": "(?P<file>[\w.]+)",\n.*?(?P<rows>(?:^ *"\w+": \{"\$ref": "(?P=file)#/properties/\w+"\},\n)+)', re.DOTALL | re.MULTILINE
)


def schema_files(folder: Path = SCHEMAS) -> dict[Path, str]:
    """Returns the text of each schema with such an object."""
    texts = {path: path.read_text() for path in sorted(folder.glob("*.json"))}
    return {path: _LIST.sub(lambda found: _completed(found, folder), text) for path, text in texts.items() if '"x-arrays-of"' in text}


def _completed(found: re.Match[str], folder: Path) -> str:
    """Returns the match with a row for each array, behind the row of the array before it."""
    file, rows = found["file"], found["rows"]
    row_of = {re.findall(r'"(\w+)"', row)[0]: row for row in rows.splitlines(keepends=True)}
    fields = json.loads((folder / file).read_text())["properties"]
    arrays = [name for name, field in fields.items() if _ARRAY.items() <= field.items()]
    names = [name for name in row_of if name in fields]
    for before, name in zip(["", *arrays], arrays):
        if name not in names:
            names.insert(names.index(before) + 1 if before else 0, name)
    indent = rows[: len(rows) - len(rows.lstrip(" "))]
    lines = [f'{indent}"{name}": {{"$ref": "{file}#/properties/{name}"}},\n' for name in names]
    return found[0].removesuffix(rows) + "".join(lines)
