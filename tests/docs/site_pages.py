"""Reads the pages of a built documentation site, without a browser."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit


@dataclass
class Page(HTMLParser):
    """Holds links, anchors, pictures and headings of a page."""

    path: Path
    titles: list[str] = field(default_factory=list)
    headings: list[str] = field(default_factory=list)
    anchors: set[str] = field(default_factory=set)
    ids: list[str] = field(default_factory=list)
    links: list[str] = field(default_factory=list)
    loaded: list[str] = field(default_factory=list)  # scripts, styles, pictures
    images: list[tuple[str, str]] = field(default_factory=list)  # source and replacement text
    language: str = ""
    _inside: str = ""

    def __post_init__(self) -> None:
        super().__init__()
        self.feed(self.path.read_text())

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given: dict[str, Any] = dict(attrs)
        self.anchors |= {given[key] for key in ("id", "name") if given.get(key)}
        if given.get("id"):
            self.ids.append(given["id"])
        if tag == "html":
            self.language = given.get("lang", "")
        elif tag == "a" and given.get("href"):
            self.links.append(given["href"])
        elif tag in ("link", "script", "img", "iframe", "object") and (source := given.get("href") or given.get("src") or given.get("data")):
            self.loaded.append(source)
        if tag == "img":
            self.images.append((given.get("src", ""), given.get("alt") or ""))
        if tag in ("title", "h1"):
            self._inside = tag
            (self.titles if tag == "title" else self.headings).append("")

    def handle_endtag(self, tag: str) -> None:
        if tag == self._inside:
            self._inside = ""

    def handle_data(self, data: str) -> None:
        if self._inside == "title":
            self.titles[-1] += data
        elif self._inside == "h1":
            self.headings[-1] += data


class Site:
    """All pages of a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.pages = {path: Page(path) for path in sorted(folder.rglob("*.html")) if "_static" not in path.parts}

    def documents(self) -> Iterator[Page]:
        """Returns the written pages, without search and indices, with their paths from the root."""
        made = {self.folder / f"{name}.html" for name in ("index", "search", "genindex", "py-modindex")}
        return (page for path, page in self.pages.items() if path not in made)

    def broken(self) -> list[str]:
        """Returns links and sources without a target in the folder."""
        return [f"{path.relative_to(self.folder)}: {target}" for path, page in self.pages.items() for target in page.links + page.loaded if not self.leads_somewhere(page, target)]

    def leads_somewhere(self, page: Page, target: str) -> bool:
        parts = urlsplit(target)
        if parts.scheme:
            return True
        path = (page.path.parent / unquote(parts.path)).resolve() if parts.path else page.path
        if not parts.fragment or path.suffix != ".html":
            return path.exists()
        return path in self.pages and unquote(parts.fragment) in self.pages[path].anchors | {"top"}


def luminance(colour: str) -> float:
    """Returns the relative luminance of #rgb or #rrggbb, as defined in WCAG 2."""
    digits = {"white": "ffffff", "black": "000000"}.get(colour, colour.lstrip("#"))
    digits = "".join(2 * digit for digit in digits) if len(digits) == 3 else digits
    parts = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    """Returns the contrast ratio of WCAG 2, from 1 to 21."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def code_colours(style: str, selector: str) -> tuple[str, list[str]]:
    """Returns the background and text colours of code in Pygments' style sheet."""
    rules = re.findall(rf"^{re.escape(selector)} ?([^{{]*) {{ ([^}}]*)}}", style, re.MULTILINE)
    ground = next(found[1] for name, rule in rules if not name and (found := re.search(r"background: (#\w+)", rule)))
    errors = {".err", ".hll", ".gd", ".gi", ".gr", ".gt", ".w"}  # occurs on no page, or formats no letters
    letters = [found[1] for name, rule in rules if name not in errors and "background" not in rule and (found := re.search(r"(?<!-)color: (#\w+)", rule))]
    return ground, letters
