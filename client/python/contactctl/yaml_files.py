"""Reads YAML: numbers and words of YAML 1.2, with a limited number of values."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Iterable
from typing import Any, ClassVar

import click

from contactd import MissingExtra

__all__ = ["parse_yaml"]

#: Largest number of values. Each needs a kilobyte while reading; use separate files for larger arrays.
_MOST_VALUES = 200_000
#: Limit including aliases and merges: a few lines can represent billions of values.
_MOST_REPEATED = 500_000
_MOST_DIGITS = 1000  #: Largest number of digits of an integer.
_WORDS = (
    ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""]),
    ("bool", r"true|True|TRUE|false|False|FALSE", list("tTfF")),
    ("int", r"[-+]?[0-9]+", list("-+0123456789")),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)", list("-+.0123456789")),
    ("merge", r"<<", ["<"]),
)  # 1e-3 is a number, yes and 12:30 are texts


def parse_yaml(text: str, check_names: Callable[[Iterable[tuple[Hashable, Any]]], Any]) -> Any:
    """Parses a text. Calls `check_names` with the names of each object. Raises ValueError with the line."""
    try:
        import yaml
    except ImportError:
        raise click.UsageError(
            f"{MissingExtra('Reading YAML', 'PyYAML', 'cli', 'python3-yaml')} JSON needs none."
        ) from None
    kind, loader = _loader_kind(yaml, check_names), None
    try:
        loader = kind(text)
        root = loader.get_single_node()
        if root is None:
            return None
        _Repeated().count(root)
        return loader.construct_document(root)
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        raise ValueError(f"line {line} has the character {chr(error.character)!a}, which YAML does not allow") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        where = "" if mark is None else f", line {mark.line + 1}, column {mark.column + 1}"
        raise ValueError(f"{getattr(error, 'problem', None) or str(error)}{where}") from None
    finally:
        if loader is not None:
            loader.dispose()


def _loader_kind(yaml: Any, check_names: Callable[[Iterable[tuple[Hashable, Any]]], Any]) -> Any:
    class Loader(yaml.SafeLoader):  # type: ignore[misc]
        yaml_implicit_resolvers: ClassVar[dict[str, Any]] = {}
        values = 0

        def compose_node(self, parent: Any, index: Any) -> Any:
            self.values += 1
            if self.values > _MOST_VALUES:
                raise ValueError(f"it has more than {_MOST_VALUES} values; put arrays into separate files ($file), or write JSON")
            return super().compose_node(parent, index)

    def pairs(loader: Any, node: Any) -> dict[str, Any]:
        def construct(part: Any) -> Any:
            return loader.construct_object(part, deep=True)

        own = [key for key, _ in node.value if not key.tag.endswith(":merge")]
        check_names((construct(key), None) for key in own)  # before merged values, which they may replace
        loader.flatten_mapping(node)
        return {construct(key): construct(value) for key, value in node.value}

    for tag, pattern, first in _WORDS:
        Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"), first)
    Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: _whole(loader.construct_scalar(node)))
    Loader.add_constructor("tag:yaml.org,2002:map", pairs)
    return Loader


def _whole(digits: str) -> int:
    if len(digits) > _MOST_DIGITS:
        raise ValueError(f"it has a whole number of {len(digits)} digits; at most {_MOST_DIGITS} are supported")
    return int(digits)


class _Repeated:
    """Counts the values of a document after replacing every alias, each node once."""

    def __init__(self) -> None:
        self._known: dict[int, int] = {}
        self._open: set[int] = set()

    def count(self, node: Any) -> int:
        """Raises ValueError if there are too many, or a value contains itself."""
        name = id(node)
        if name in self._known:
            return self._known[name]
        if name in self._open:
            raise ValueError(f"the value that begins in line {node.start_mark.line + 1} contains itself by an alias")
        self._open.add(name)
        parts = node.value if isinstance(node.value, list) else ()
        members = [part for item in parts for part in (item if isinstance(item, tuple) else (item,))]
        total = 1 + sum(self.count(member) for member in members)
        self._open.remove(name)
        if total > _MOST_REPEATED:
            raise ValueError(f"its aliases repeat more than {_MOST_REPEATED} values")
        self._known[name] = total
        return total
