"""Writes the table of contents from the lists of docs/index.md, with a caption for each heading. The pages in LISTS
are followed by the pages that they list. A page in no list is an error."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import Any

#: Has the index in short. Links lead to it.
README = "README"
#: Pages with a list of pages of their own.
LISTS = ("docs/reference/python", "docs/reference/cpp")


def roads(index: str) -> Iterator[tuple[str, list[str]]]:
    """Maps each heading with a list to its name and the targets of the links at the beginning of the list's items."""
    for section in re.split(r"^## ", index, flags=re.MULTILINE)[1:]:
        heading, _, text = section.partition("\n")
        if pages := re.findall(r"^\* \[[^\]]+\]\(([^)#]+)[^)]*\)", text, re.MULTILINE):
            yield heading.strip(), pages


def document(index: str, page: str) -> str:
    """Returns Sphinx's name of a page that `index` links to."""
    return posixpath.splitext(posixpath.normpath(posixpath.join(posixpath.dirname(index), page)))[0]


def change_source(app: Any, name: str, source: list[str]) -> None:
    if name == README:
        source[0] = f"---\norphan: true\n---\n{source[0]}"
    if name in (app.config.root_doc, *LISTS):
        for heading, pages in roads(source[0]):
            entries = "\n".join("/" + document(name, page) for page in pages)
            caption = f":caption: '{heading}'\n" if name == app.config.root_doc else ""
            source[0] += f"\n```{{toctree}}\n:hidden:\n{caption}\n{entries}\n```\n"


def check_that_every_page_is_listed(app: Any, environment: Any, _changed: list[str]) -> None:
    from sphinx.errors import ExtensionError  # Tests read the lists without Sphinx.

    index = app.config.root_doc
    lists = {name: environment.doc2path(name).read_text() for name in (index, *LISTS) if name in environment.found_docs}
    listed = {document(name, page) for name, text in lists.items() for _, pages in roads(text) for page in pages}
    if missing := sorted(environment.found_docs - listed - {README, index}):
        raise ExtensionError(not_listed([str(environment.doc2path(name, base=False)) for name in missing], index))


def not_listed(pages: list[str], index: str = "docs/index") -> str:
    names = " and ".join(pages)
    return f"{names}: in no list of {index}.md. Add a point there that begins with a link to it, under the heading where readers will look."


def setup(app: Any) -> dict[str, Any]:
    app.connect("source-read", change_source)
    app.connect("env-before-read-docs", check_that_every_page_is_listed)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
