"""Numbers in text, by the rules that files of profiles have, too (docs/profiles.md): rows of them, and tables with columns."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator

__all__ = ["number_in", "rows_of", "table_of"]

_COMMENTS = re.compile("[#%!]")
_BLANKS_AND_SEMICOLONS = re.compile(r"\s*;\s*|\s+")
_ALL = re.compile(r"\s*[;,]\s*|\s+")
_TEXT_AND_QUOTES = re.compile('(?:"[^"]*"|[^"#%!])*')
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?", re.ASCII)


def number_in(word: str) -> float | None:
    """The number that a word is as a whole, with an exponent behind e or, as Fortran writes it, d; None where it is none."""
    if _NUMBER.fullmatch(word) is None:
        return None
    return float(word.lower().replace("d", "e"))


def rows_of(text: str) -> list[list[float]]:
    """The numbers of each line, as many in each.

    Between them are blanks, tabs, semicolons or commas; a comma is that of a decimal fraction where others part the numbers.
    What follows #, % or ! is a comment, and what follows a quotation mark without another one. Numbers may stand in these, and
    lines of words above all numbers are headings. Raises ValueError with the line.
    """
    rows: list[list[float]] = []
    style = _Style()
    for number, line in _lines(text):
        values = style.numbers(line)
        if values is None:
            words = _ALL.split(line)
            if not rows and all(number_in(word) is None and word for word in words):
                continue
            wrong = next(word for word in words if number_in(word) is None)
            raise ValueError(f"line {number} has {wrong[:40]!r} in the place of a number")
        if rows and len(values) != len(rows[0]):
            raise ValueError(f"line {number} has {len(values)} numbers, and the first {len(rows[0])}")
        rows.append(values)
    if not rows:
        raise ValueError("it has none")
    return rows


def table_of(text: str) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """The names in the first line, and the cells of the others with their lines; decimal fractions have points.

    Between cells are semicolons or tabs, where the first line has one, or else commas. In quotation marks no sign begins a
    comment. Raises ValueError with the line, also where columns have no names or the same.
    """
    names: list[str] = []
    rows: list[tuple[int, list[str]]] = []
    between = ","
    for number, line in _lines(text, keeps_quotes=True):
        if not names:
            between = next((sign for sign in ";\t" if sign in line), ",")
        try:
            (cells,) = csv.reader([line], delimiter=between, skipinitialspace=True, strict=True)
        except csv.Error as error:
            raise ValueError(f"line {number}: {error}") from None
        if not names:
            names = [cell.strip() for cell in cells]
            _check(names, number)
            continue
        if len(cells) != len(names):
            raise ValueError(f"line {number} has {len(cells)} columns, and the first {len(names)}")
        rows.append((number, [cell.strip() if between == "," else cell.strip().replace(",", ".") for cell in cells]))
    return names, rows


def _check(names: list[str], line: int) -> None:
    if "" in names:
        raise ValueError(f"line {line} has no name for column {names.index('') + 1}")
    if doubled := next((name for i, name in enumerate(names) if name in names[:i]), None):
        raise ValueError(f"line {line} names {doubled} twice")


class _Style:
    """How the numbers of a text are written, as its lines have shown it so far."""

    def __init__(self) -> None:
        self._has_decimal_commas = False

    def numbers(self, line: str) -> list[float] | None:
        """Those of a line; None where one of its words is none."""
        words = _BLANKS_AND_SEMICOLONS.split(line)
        with_points = [number_in(word.replace(",", ".", 1)) for word in words]
        any_comma = any("," in word[1:-1] for word in words)
        found = [value for value in with_points if value is not None]
        if len(found) == len(words) and (len(words) > 1 or self._has_decimal_commas or not any_comma):
            self._has_decimal_commas = self._has_decimal_commas or any_comma
            return found
        found = [value for value in map(number_in, _ALL.split(line)) if value is not None]
        return found if len(found) == len(_ALL.split(line)) else None


def _lines(text: str, *, keeps_quotes: bool = False) -> Iterator[tuple[int, str]]:
    """Lines that say something, with their numbers: without comments and quotation marks."""
    for number, line in enumerate(text.splitlines(), 1):
        found = _TEXT_AND_QUOTES.match(line) if keeps_quotes else None
        line = found.group().rstrip(" ") if found is not None else _COMMENTS.split(line, maxsplit=1)[0]
        if line.count('"') % 2:
            line = line.partition('"')[0]
        if not keeps_quotes:
            line = line.replace('"', "").strip()
        if line.strip():
            yield number, line
