"""Reads input files of users: JSON or YAML as on the wire, with large arrays in separate files."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Hashable, Iterable, Sequence
from pathlib import Path
from typing import Any

import click

from contactd.files.marks import can_be_written_over
from contactd.files.reach import check_within
from contactd.files.whole import read_whole, write_whole
from contactd.wheel_rail import ProfileFile

from .array_files import read_array
from .yaml_files import parse_yaml

__all__ = [
    "COMMENT", "allowed_folders", "check_own", "may_overwrite", "named_file", "read_document", "read_named", "read_object", "with_arrays",
    "writable", "writable_folder", "write_text",
]  # fmt: skip

_UNMARKED = " The CONTACT program and versions of contactd before 0.1.0 write .mat and .subs files without a mark."
COMMENT = "$comment"  #: Name of a comment in an object.
_DEEPEST = 50  #: Largest depth of fields, four times that of any request.
_MOST_BYTES = 1 << 25  #: Largest size of a document; arrays should be in separate files.
_MOST_VALUES = 2_000_000  #: Largest number of values in a JSON document.


def read_object(path: str) -> dict[str, Any]:
    """Returns the object in a file; "-" is standard input. The extension .json, .yaml or .yml determines the format.

    ``{"$file": "gap.npy"}`` is replaced by the array of that file in the same folder: .npy, or text with one row per
    line. In a profile, ``file: wheel.whl`` or ``file: {name: wheel.whl, unit: 25.4}`` is replaced by the text of that
    file. Text named ``$comment`` is a comment. Raises click.UsageError with the file and the line.
    """
    found: dict[str, Any] = with_arrays(read_named(path), path)
    return found


def read_named(path: str) -> dict[str, Any]:
    """Reads like read_object, but keeps the names of files instead of their arrays."""
    document = read_document(path)
    if not isinstance(document, dict):
        raise click.UsageError(f"{path} contains {_kind(document)}; it must contain an object, fields with their values.")
    if isinstance(document.get(COMMENT), str):
        del document[COMMENT]
    return document


def with_arrays(document: Any, path: str) -> Any:
    """Returns the contents of `path` with the arrays and profiles of the named files."""
    return _with_arrays(document, path)


def read_document(path: str) -> Any:
    """Reads any document like read_object, but does not read arrays."""
    text = _text(path)
    # JSON is a subset of YAML, apart from unusual numbers and characters.
    is_json = path.endswith(".json") or (path == "-" and text.lstrip()[:1] in ("{", "["))
    try:
        return _json(text) if is_json else parse_yaml(text, _object)
    except RecursionError:
        raise click.UsageError(f"{path} is nested too deeply.") from None
    except ValueError as error:
        raise click.UsageError(f"{path} is not valid {'JSON' if is_json else 'YAML'}: {error}") from None


def writable(option: str, path: str | Path, heading: Sequence[str] | None = None) -> Path:
    """Checks before a solve that the file can be written: it does not exist, or contactd has written it. `heading`
    contains the column names of a table without comments. Raises click.UsageError.
    """
    place = Path(path)
    folder = place.absolute().parent
    if not folder.is_dir():
        raise click.UsageError(f"{option} {path}: there is no folder {place.parent}.")
    if place.is_dir():
        raise click.UsageError(f"{option} {path} is a folder; it must be the name of a file.")
    is_written_to = place.exists() and not place.is_file()  # other files are renamed into place
    needed = [place] if is_written_to else [folder, place] if place.exists() else [folder]
    if not all(os.access(path, os.W_OK) for path in needed):
        raise click.UsageError(f"{option} {path} cannot be written: permission is denied.")
    check_own(option, place, heading)
    return place


def check_own(option: str, place: Path, heading: Sequence[str] | None = None) -> None:
    """Raises click.UsageError for a file that another program has written, unless --overwrite is set."""
    if may_overwrite():
        return
    try:
        if can_be_written_over(place, heading):
            return
    except OSError as error:
        raise click.UsageError(f"{option} {place} cannot be read to check whether contactd wrote it: {error.strerror}.") from None
    what = "is a broken link" if place.is_symlink() and not place.exists() else "exists, and contactd did not write it"
    more = _UNMARKED if place.suffix in (".mat", ".subs") and place.exists() else ""
    raise click.UsageError(f"{option} {place} {what}. Name another file, or give --overwrite.{more}")


def may_overwrite() -> bool:
    """Returns whether the command has --overwrite."""
    return bool(_option("overwrite", False))


def allowed_folders(folder: Path) -> list[Path]:
    """Returns the folders of files that a file in `folder` may name: this folder, and those of --allow-folder."""
    return [folder, *map(Path, _option("allow_folder", ()))]


def _option(name: str, otherwise: Any) -> Any:
    context = click.get_current_context(silent=True)
    return otherwise if context is None else getattr(context.find_root().obj, name, otherwise)


def named_file(name: str | Path, named_by: str) -> Path:
    """Returns the path of a file named in another one, relative to that. Raises click.UsageError for other folders that
    --allow-folder does not allow.
    """
    folder = Path() if named_by == "-" else Path(named_by).parent
    place = folder / name
    try:
        check_within(place, allowed_folders(folder))
    except OSError as error:
        raise click.UsageError(f"{named_by} names {place}, which cannot be read: {error.strerror}.") from None
    return place


def writable_folder(option: str, path: str | Path) -> Path:
    """Checks a folder in the same way, and creates it if missing. Raises click.UsageError."""
    place = Path(path)
    there = next(folder for folder in (place.absolute(), *place.absolute().parents) if folder.exists())
    if not there.is_dir():
        raise click.UsageError(f"{option} {path} must be the name of a folder, but {there.name} is a file.")
    if not os.access(there, os.W_OK | os.X_OK):
        raise click.UsageError(f"{option} {path} cannot be written: permission is denied.")
    return place


def write_text(path: str | Path, text: str) -> None:
    """Writes a text file, which is never incomplete."""
    write_whole(path, lambda file: file.write(text.encode()))


def _text(path: str) -> str:
    try:
        if path != "-":
            return read_whole(path, _MOST_BYTES).decode("utf-8-sig")
        text = sys.stdin.read(_MOST_BYTES + 1)
        if len(text) > _MOST_BYTES:
            raise click.UsageError(f"Standard input has more than {_MOST_BYTES} characters; put arrays into files ($file).")
        return text
    except OSError as error:
        raise click.UsageError(f"{path} cannot be read: {error.strerror}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{path} is not text in UTF-8; it must be JSON or YAML.") from None


def _kind(value: Any) -> str:
    return "nothing" if value is None else f"a {type(value).__name__}"


def _json(text: str) -> Any:
    if sum(map(text.count, ",[{")) > _MOST_VALUES:
        raise ValueError(f"it has more than {_MOST_VALUES} values; put arrays into separate files ($file)")

    def constant(name: str) -> Any:
        raise ValueError(f"{name} is not a valid number; every number must be finite")

    return json.loads(text, object_pairs_hook=_object, parse_constant=constant)


def _object(pairs: Iterable[tuple[Hashable, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, value in pairs:
        if not isinstance(name, str):
            raise ValueError(f"a field is called {name!r}; names of fields must be strings")
        if name in found:
            raise ValueError(f"the field {name} is given twice")
        found[name] = value
    return found


def _with_arrays(value: Any, path: str, depth: int = 0) -> Any:
    if depth > _DEEPEST:
        raise click.UsageError(f"{path} is nested too deeply.")
    if isinstance(value, dict):
        if value.keys() == {"$file"}:
            if not isinstance(name := value["$file"], str):
                raise click.UsageError(f"{path}: $file is {name!r:.60}; it must be the name of a file.")
            return read_array(named_file(name, path), path)
        return {
            name: _profile(member, path) if name == "file" else _with_arrays(member, path, depth + 1)
            for name, member in value.items()
        }
    if isinstance(value, list):
        return [_with_arrays(member, path, depth + 1) for member in value]
    return value


def _profile(named: Any, path: str) -> Any:
    """Returns the file of a profile with its text; values that are not file names, or that have a text, are
    unchanged.
    """
    given = {"name": named} if isinstance(named, str) else named
    if not isinstance(given, dict) or not isinstance(name := given.get("name"), str) or "text" in given:
        return named
    place = named_file(name, path)
    try:
        read = ProfileFile(place)
    except OSError as error:
        raise click.UsageError(f"{path} names {place}, which cannot be read: {error.strerror or error}.") from None
    return {**given, "name": Path(name).name, "text": read.text}
