"""What a user wrote down: JSON or YAML in the words of the wire, with arrays in files of their own where they are large."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Hashable, Iterable
from pathlib import Path
from typing import Any

import click
import numpy as np

__all__ = ["read_document", "read_object", "write_text"]


def read_object(path: str) -> dict[str, Any]:
    """The object that a file holds, "-" being standard input; the ending .json, .yaml or .yml says how it is written.

    ``{"$file": "gap.npy"}`` stands for the array of that file, beside this one: .npy, or text with a row a line. Raises
    click.UsageError with the file and the line.
    """
    document = read_document(path)
    if not isinstance(document, dict):
        raise click.UsageError(f"{path} holds {_kind(document)}; it must hold an object, fields with their values.")
    folder = Path() if path == "-" else Path(path).parent
    found: dict[str, Any] = _with_arrays(document, folder, path)
    return found


def read_document(path: str) -> Any:
    """As read_object, whatever the file holds, and arrays left as they are."""
    text = _text(path)
    # JSON is YAML, but for what both say about doubtful numbers and signs.
    is_json = path.endswith(".json") or (path == "-" and text.lstrip()[:1] in ("{", "["))
    try:
        return _json(text) if is_json else _yaml(text)
    except RecursionError:
        raise click.UsageError(f"{path} is nested too deeply.") from None
    except ValueError as error:
        raise click.UsageError(f"{path} is no {'JSON' if is_json else 'YAML'}: {error}") from None


def write_text(path: str | Path, text: str) -> None:
    """Whole or not at all."""
    part = Path(f"{path}.part")
    try:
        part.write_text(text)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def _text(path: str) -> str:
    try:
        return sys.stdin.read() if path == "-" else Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise click.UsageError(f"{path} cannot be read: {error.strerror}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{path} is no text in UTF-8; it must be JSON or YAML.") from None


def _kind(value: Any) -> str:
    return "nothing" if value is None else f"a {type(value).__name__}"


def _json(text: str) -> Any:
    def constant(name: str) -> Any:
        raise ValueError(f"{name} is no number that contact problems have; every number must be finite")

    return json.loads(text, object_pairs_hook=_object, parse_constant=constant)


def _object(pairs: Iterable[tuple[Hashable, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name, value in pairs:
        if not isinstance(name, str):
            raise ValueError(f"a field is called {name!r}; names of fields are texts")
        if name in found:
            raise ValueError(f"the field {name} is there twice")
        found[name] = value
    return found


def _yaml(text: str) -> Any:
    try:
        import yaml
    except ImportError:
        raise click.UsageError(
            "Reading YAML needs the package PyYAML: pip install PyYAML, or on Debian python3-yaml. JSON needs none."
        ) from None

    # Numbers and words as YAML 1.2 has them: 1e-3 is a number, yes and 12:30 are texts.
    Loader: Any = type("Loader", (yaml.SafeLoader,), {})

    def pairs(loader: Any, node: Any) -> dict[str, Any]:
        def construct(part: Any) -> Any:
            return loader.construct_object(part, deep=True)

        own = [key for key, _ in node.value if not key.tag.endswith(":merge")]
        _object((construct(key), None) for key in own)  # before what is merged, which they may replace
        loader.flatten_mapping(node)
        return {construct(key): construct(value) for key, value in node.value}

    Loader.yaml_implicit_resolvers = {}
    for tag, pattern, first in (
        ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""]),
        ("bool", r"true|True|TRUE|false|False|FALSE", list("tTfF")),
        ("int", r"[-+]?[0-9]+", list("-+0123456789")),
        ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)", list("-+.0123456789")),
        ("merge", r"<<", ["<"]),
    ):  # fmt: skip
        Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"), first)
    Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(loader.construct_scalar(node)))
    Loader.add_constructor("tag:yaml.org,2002:map", pairs)
    try:
        return yaml.load(text, Loader)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = "" if mark is None else f", line {mark.line + 1}, column {mark.column + 1}"
        raise ValueError(f"{getattr(error, 'problem', None) or str(error)}{where}") from None


def _with_arrays(value: Any, folder: Path, path: str) -> Any:
    if isinstance(value, dict):
        if value.keys() == {"$file"}:
            return _array(folder / str(value["$file"]), path)
        return {name: _with_arrays(member, folder, path) for name, member in value.items()}
    if isinstance(value, list):
        return [_with_arrays(member, folder, path) for member in value]
    return value


def _array(file: Path, path: str) -> np.ndarray[Any, Any]:
    try:
        if file.suffix == ".npy":
            loaded: np.ndarray[Any, Any] = np.load(file, allow_pickle=False)
            return loaded
        text = file.read_text()
        return np.loadtxt(text.splitlines(), delimiter="," if "," in text else None, ndmin=2)
    except OSError as error:
        raise click.UsageError(f"{path} names {file}, which cannot be read: {error.strerror or error}.") from None
    except ValueError as error:
        raise click.UsageError(f"{path} names {file}, which holds no array of numbers: {error}.") from None
