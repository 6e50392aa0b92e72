"""Writes the parts of pages that come from docstrings, headers and schemas, so that they are complete."""

from __future__ import annotations

import ast
import itertools
import json
import re
from pathlib import Path
from typing import Any

from headers import path_of, public_headers

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "client" / "python" / "contactd"
SCHEMAS = ROOT / "proto" / "schema"
MEMBERS = "briefdescription detaileddescription innerclass enum typedef func var public-type public-func public-static-func public-attrib"


def cpp(headers: list[str]) -> str:
    return "\n".join(
        f"## {header}\n\n{_head(header)}\n\n{_directive(f'doxygenfile:: {header}', project='cpp', sections=MEMBERS)}"
        for header in headers
    )


def _head(header: str) -> str:
    """Returns the comment at the beginning of a header."""
    lines = path_of(header).read_text().splitlines()
    comment = itertools.takewhile(lambda line: line.startswith("//"), lines)
    return "\n".join(re.sub("^// ?", "", line) for line in comment)


def c() -> str:
    return _directive("doxygenfile:: contactd.h", project="c", sections="user-defined")


#: Modules with names of their own, beside those that the package itself exports.
MODULES = ("wheel_rail", "contact_files", "materials", "roughness")


def python(modules: list[str]) -> str:
    """Lists the names among these that the package exports."""
    import contactd

    parts, exported = [], _exports(contactd)
    for module in modules:
        if module in MODULES:
            of_others = set(contactd.__all__) - set(exported.get(module, ()))
            once = {"exclude-members": ", ".join(sorted(of_others))}
            parts.append(f"## contactd.{module}\n\n" + _directive(f"automodule:: contactd.{module}", **once))
            values = [name for name in exported.get(module, ()) if _kind(getattr(contactd, name)) == "data"]
            parts += [
                f"```{{eval-rst}}\n.. py:currentmodule:: contactd\n.. py:data:: {name}\n\n   This is contactd.{module}.{name}.\n```\n"
                for name in values
            ]
            continue
        text = ast.get_docstring(ast.parse((PACKAGE / f"{module.replace('.', '/')}.py").read_text())) or ""
        objects = "\n".join(f".. auto{_kind(getattr(contactd, name))}:: {name}" for name in exported[module])
        title = module.partition(".")[2] or module  # without the folder
        title = title.removeprefix("generated.").replace(".", " ").replace("_", " ")
        parts.append(f"## {title}\n\n```{{eval-rst}}\n.. currentmodule:: contactd\n\n{_lead(text)}\n\n{objects}\n```\n")
    return "\n".join(parts)


def _exports(package: Any) -> dict[str, list[str]]:
    """Groups names by modules: first those of the package itself, then those of its folders, each in the order of the
    imports in __init__.py. Lazily imported names come last."""
    imports = [item for item in ast.parse((PACKAGE / "__init__.py").read_text()).body if isinstance(item, ast.ImportFrom)]
    modules = {alias.name: item.module or "" for item in imports if item.level == 1 for alias in item.names}
    found: dict[str, list[str]] = {module: [] for module in modules.values()}
    for name in [*modules, *sorted(set(package.__all__) - set(modules))]:
        if name in package.__all__ and not name.startswith("_"):
            module = modules.get(name) or getattr(package, name).__module__.removeprefix("contactd.")
            found.setdefault(module, []).append(name)
    return {module: found[module] for module in sorted(found, key=lambda module: module.count(".")) if found[module]}


def _lead(docstring: str) -> str:
    """The first paragraph."""
    return docstring.partition("\n\n")[0]


def _kind(thing: object) -> str:
    return "class" if isinstance(thing, type) else "function" if callable(thing) else "data"


def wire() -> str:
    """Links to files next to the pages of the site, which Markdown cannot do."""
    names = sorted(path.name.removesuffix(".json") for path in SCHEMAS.glob("*.json"))
    links = {"openrpc": ("openrpc", "All methods and messages in one document")}
    links |= {f"schema/{name}": (name, _sentence(name)) for name in names}
    rows = [f'<tr><td><a href="../../{file}.json">{name}</a></td><td>{text}</td></tr>' for file, (name, text) in links.items()]
    head = "<thead><tr><th>file</th><th>content</th></tr></thead>"
    return f'<div class="table-wrapper"><table class="docutils">{head}<tbody>{"".join(rows)}</tbody></table></div>\n'


def _sentence(name: str) -> str:
    schema = json.loads((SCHEMAS / f"{name}.json").read_text())
    text = schema.get("x-summary") or schema.get("description", "")
    return str(text).partition(". ")[0].rstrip(".").replace("&", "&amp;").replace("<", "&lt;")


def _directive(name: str, **options: str) -> str:
    lines = "".join(f"   :{key}: {value}\n" for key, value in options.items())
    return f"```{{eval-rst}}\n.. {name}\n{lines}```\n"


#: Maps the words in markers to the parts and the names that must occur on pages.
PARTS = {"modules": (python, lambda: [*(_exports(_package()).keys() - set(MODULES)), *MODULES]), "headers": (cpp, public_headers)}
WHOLE = {"docs/reference/c": c, "docs/reference/wire": wire}
LISTED = re.compile(r"<!-- (modules|headers): ([^>]*) -->\s*\Z")


def _package() -> Any:
    import contactd

    return contactd


def missing(pages: list[str]) -> list[str]:
    """Lists modules and headers that are on no page, or on two."""
    named = [(found[1], name) for page in pages if (found := LISTED.search(page)) for name in found[2].split()]
    there = [(kind, name) for kind, (_, names) in PARTS.items() for name in names()]
    return sorted(
        name for kind, name in {*named, *there} if (named.count((kind, name)), there.count((kind, name))) != (1, 1)
    )


def write(_app: Any, name: str, source: list[str]) -> None:
    if part := WHOLE.get(name):
        source[0] += "\n" + part()
    if found := LISTED.search(source[0]):
        source[0] = source[0][: found.start()] + PARTS[found[1]][0](found[2].split())


def check_that_nothing_is_missing(app: Any, environment: Any, _changed: list[str]) -> None:
    from sphinx.errors import ExtensionError  # Tests read the parts without Sphinx.

    pages = [
        Path(environment.doc2path(name)).read_text()
        for name in environment.found_docs
        if name.startswith("docs/reference/")
    ]
    if names := missing(pages):
        raise ExtensionError(
            f"{', '.join(names)}: to be named once, at the end of one page of docs/reference, and exist"
        )


#: Lists the types of numpy's ArrayLike.
ARRAY_LIKE = re.compile(r"(?:~?collections\.abc\.)?Buffer \| [^,]*?_NestedSequence\[bool \|[^\]]*\]")


def named(types: str | None) -> str | None:
    """Keeps ArrayLike as a name."""
    return types and ARRAY_LIKE.sub("ArrayLike", types)


def adapt_signature(
    _app: Any, _what: str, _name: str, _object: object, _options: object, signature: str | None, answer: str | None
) -> tuple[str | None, str | None]:
    return named(signature), named(answer)


def adapt(_app: Any, _what: str, _name: str, _object: object, _options: object, lines: list[str]) -> None:
    """In a docstring, |x| is the absolute value of x, not a substitution, and docs/contact.md is a page."""
    lines[:] = [named(line) or "" for line in lines]
    lines[:] = [re.sub(r"\|([^|`]+)\|", r"\\|\1\\|", line) for line in lines]
    lines[:] = [re.sub(r"(?<![\w/`])docs/(\w[\w-]*)\.md", r":doc:`docs/\1.md </docs/\1>`", line) for line in lines]


def without_names_that_are_there_twice(_app: Any, doctree: Any) -> None:
    """Breathe uses the same anchors for the kinds of members of all classes; nothing links to them."""
    from docutils import nodes  # Tests read the parts without Sphinx.

    for title in doctree.findall(nodes.rubric):
        if "breathe-sectiondef-title" in title["classes"]:
            title["ids"] = []


def setup(app: Any) -> dict[str, Any]:
    app.connect("autodoc-process-docstring", adapt, priority=600)  # comes after napoleon, which writes attribute types
    app.connect("autodoc-process-signature", adapt_signature)
    app.connect("source-read", write)
    app.connect("env-before-read-docs", check_that_nothing_is_missing)
    app.connect("doctree-read", without_names_that_are_there_twice)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
