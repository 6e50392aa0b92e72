"""Generates the values of Python: for each part of the schemas, a module of dataclasses, keywords and typed keyword
arguments.

A module declares the classes that it lists and the classes that these use, unless they are written by hand or belong to
another module. A class inherits its methods from a base that is written by hand.
"""

from __future__ import annotations

import os
import re
import textwrap
from pathlib import Path

from .declarations import ROOT, Declarations, Schema
from .python_classes import Class, Collected, Member, in_code, in_python, literal
from .python_modules import MODULES, Module

VALUES = ROOT / "client" / "python" / "contactd" / "values"
GENERATED = VALUES / "generated"
NOTE = "Written by ./dev generate from proto/schema: edit it there."
PACKAGE = f'"""Values whose fields are those of the schemas.\n\n{NOTE}\n"""\n'
WIDTH = 120
#: Names from other modules that generated code uses, and their imports.
NAMES = {
    "Sequence": "collections.abc", "Mapping": "collections.abc", "dataclass": "dataclasses", "field": "dataclasses",
    "replace": "dataclasses", "KW_ONLY": "dataclasses", "TYPE_CHECKING": "typing", "Any": "typing", "Literal": "typing", "TypedDict": "typing",
    "PathLike": "os", "npt": "import numpy.typing as npt", "np": "import numpy as np", "public": "../refusals",
}  # fmt: skip
UNPACK = "\nif TYPE_CHECKING:\n    from typing_extensions import Unpack\n"
REPLACE = '''
    @public
    def replace(self, **changes: Unpack[{keywords}]) -> {name}:
        """A copy with some fields changed{says}."""
        return replace(self, **{changes})
'''


def python_files(declarations: Declarations) -> dict[Path, str]:
    """Returns the text of each file."""
    homes = {**_written_by_hand(), **NAMES, "instead": "params"}
    mine = {module.name: Collected(declarations, module) for module in MODULES}
    roots = {name: module for module, collected in mine.items() for name in collected.roots}
    files = {}
    for module in MODULES:
        found = mine[module.name]
        found.collect(lambda name, here=module.name, taken=frozenset(homes): name not in taken and roots.get(name, here) == here)
        files[GENERATED / f"{module.name}.py"] = _text(module, found, homes)
        homes.update(dict.fromkeys([*found.classes, *found.words, *module.aliases], f"generated/{module.name}"))
    files.update((path.with_name("__init__.py"), PACKAGE) for path in [*files])
    return files


def _written_by_hand() -> dict[str, str]:
    """Returns the module of each class and alias that is written by hand."""
    homes: dict[str, str] = {}
    for path in sorted(set(VALUES.rglob("*.py")) - set(GENERATED.rglob("*.py"))):
        text = path.read_text()
        module = path.relative_to(VALUES).with_suffix("").as_posix()
        homes.update(dict.fromkeys(re.findall(r"^(?:class )?([A-Z]\w+)(?:\(| =|:)", text, re.MULTILINE), module))
    return homes


def _text(module: Module, found: Collected, homes: dict[str, str]) -> str:
    listed = [*found.classes.values()]
    code = [f"{name} = Literal[{', '.join(map(literal, words))}]" for name, words in found.words.items()]
    keywords = {one.name: one.schema.get("x-python-class", {}).get("keywords") for one in listed}
    parts = ["\n".join(code)] if code else []
    parts += [_class(one) for one in listed]
    parts += [_keywords(one, keywords[one.name], f"Keywords of {one.name}.") for one in listed if keywords[one.name]]
    parts += [f"{name} = {means}" for name, means in module.aliases.items()]
    body = "\n\n\n".join(parts)
    exported = _all([*found.classes, *found.words, *filter(None, keywords.values()), *module.aliases])
    body = f"{UNPACK if any(keywords.values()) else ''}\n{exported}{'' if code else chr(10)}\n{body}"
    head = f'"""{_filled(module.says, 3, 0)}\n\n{NOTE}\n"""\n\nfrom __future__ import annotations\n\n'
    imports = _imports(f"generated/{module.name}", body, homes, {*found.classes, *found.words})
    return f"{head}{imports}{body}\n"


def _class(one: Class) -> str:
    options = one.schema.get("x-python-class", {})
    if options.get("typed_dict"):
        return _keywords(one, one.name, options["description"])
    bases = f"({', '.join(options['bases'])})" if "bases" in options else ""
    arguments = ", ".join(["frozen=True", *(f"{name}={value}" for name, value in options.get("dataclass", {}).items())])
    lines = ["@public"] if options.get("public") else []
    lines += [f"@dataclass({arguments})", f"class {one.name}{bases}:", _docstring(one, options)]
    marks = [f"    _{name} = {in_code(options[name])}" for name in ("key", "fixed") if name in options]
    members = [_member(member) for member in one.members]
    if "positional" in options:
        members.insert(len(options["positional"]), "    _: KW_ONLY")
    blocks = ["\n".join(block) for block in (marks, members) if block]
    if "keywords" in options:
        blocks.append(_replace(one, options["keywords"]))
    return "\n\n".join(["\n".join(lines), *blocks])


def _replace(one: Class, keywords: str) -> str:
    """Returns the method `replace`. If the schema requires exactly one of several fields, each replaces the others."""
    either = [part["required"][0] for part in one.schema.get("oneOf", ())]
    says = f"; {' and '.join(either)} take the place of each other" if either else ""
    changes = f"instead(changes, {', '.join(map(literal, either))})" if either else "changes"
    return REPLACE.format(keywords=keywords, name=one.name, says=says, changes=changes).strip("\n")


def _docstring(one: Class, options: Schema) -> str:
    """Returns the docstring of a class, without the schema's remarks on omitting its object."""
    says = options.get("description", one.schema["description"])
    first, *others = says if isinstance(says, list) else [re.sub(r"[.;] [Ll]eft out:? [^.;]*", "", says)]
    paragraphs = [f'    """{_filled(in_python(first), 7, 4)}', *("    " + _filled(other, 4, 4) for other in others)]
    if "examples" in options:
        paragraphs.append("\n".join(["    ::", "", *(f"        {example}" for example in options["examples"])]))
    if one.members:
        attributes = [" " * 8 + _filled(f"{member.name}: {member.says}", 8, 12) for member in one.members]
        paragraphs.append("\n".join(["    Attributes:", *attributes]))
    text = "\n\n".join(paragraphs)
    return text + ('\n    """' if "\n" in text else '"""')


def _member(member: Member) -> str:
    line = f"    {member.name}: {member.type}"
    if member.notes:
        arguments = "" if member.default is None else f"default={member.default}, "
        arguments += f"metadata={in_code(member.notes)}"
        whole = f"{line} = field({arguments})"
        return whole if len(whole) <= WIDTH else f"{line} = field(\n        {arguments}\n    )"
    return line if member.default is None else f"{line} = {member.default}"


def _keywords(one: Class, name: str, says: str) -> str:
    lines = [f"class {name}(TypedDict, total=False):", f'    """{_filled(says, 7, 4)}"""', ""]
    return "\n".join(lines + [f"    {member.name}: {member.type}" for member in one.members])


def _filled(text: str, first: int, others: int) -> str:
    """Wraps a text into lines. The first line starts at column `first`, and the others are indented by `others` spaces."""
    filled = textwrap.fill(
        text, WIDTH, initial_indent=" " * first, subsequent_indent=" " * others, break_long_words=False, break_on_hyphens=False
    )
    return filled[first:]


def _listing(head: str, items: list[str], tail: str) -> str:
    line = f"{head}{', '.join(items)}{tail}"
    return line if len(line) <= WIDTH else head + "\n" + "".join(f"    {item},\n" for item in items) + tail


def _all(names: list[str]) -> str:
    return _listing("__all__ = [", [f'"{name}"' for name in sorted(names, key=_order)], "]") + "\n"


def _imports(module: str, body: str, homes: dict[str, str], own: set[str]) -> str:
    """Returns the imports for every name from another module that the code uses outside docstrings."""
    code = re.sub(r'""".*?"""|"[^"\n]*"', "", body, flags=re.DOTALL)
    used = {name: homes[name] for name in re.findall(r"\b[A-Za-z]\w*\b", code) if name in homes and name not in own}
    plain = sorted(home for home in used.values() if home.startswith("import "))
    modules = {home: sorted((n for n in used if used[n] == home), key=_order) for home in used.values() if home not in plain}
    relative = {
        _relative(home, module): modules.pop(home) for home in [*modules] if home not in NAMES.values() or home.startswith("../")
    }
    blocks = [
        [_listing(f"from {home} import ", names, "") for home, names in sorted(modules.items())],
        plain,
        [_import(home, relative[home]) for home in sorted(relative, key=lambda home: (-_dots(home), home))],
    ]
    return "\n".join("\n".join(block) + "\n" for block in blocks if block)


def _relative(home: str, module: str) -> str:
    """Returns how a module names another one. Both are paths below `values`."""
    path = os.path.relpath(home, os.path.dirname(module))
    up = path.count("../")
    return "." * (1 + up) + path[3 * up :].replace("/", ".")


def _import(home: str, names: list[str]) -> str:
    line = f"from {home} import {', '.join(names)}"
    return line if len(line) <= WIDTH else _listing(f"from {home} import (", names, ")")


def _dots(home: str) -> int:
    return len(home) - len(home.lstrip("."))


def _order(name: str) -> tuple[int, str]:
    return (0 if name.isupper() and len(name) > 1 else 1 if name[0].isupper() else 2, name)
