"""Reads numbers from text, with the same rules as profiles (docs/profiles.md): rows of numbers, and tables with
columns.
"""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator

__all__ = ["number_in", "rows_of", "table_of"]

_LINES_OF_REPORT = 20000
_COMMENTS = re.compile("[#%!]")
_BLANKS_AND_SEMICOLONS = re.compile(r"\s*;\s*|\s+")
_ALL = re.compile(r"\s*[;,]\s*|\s+")
_TEXT_AND_QUOTES = re.compile('(?:"[^"]*"|[^"#%!])*')
_NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eEdD][+-]?\d+)?", re.ASCII)


def number_in(word: str) -> float | None:
    """Returns the number that a whole word represents, with an exponent after e or (Fortran) d; otherwise None."""
    if _NUMBER.fullmatch(word) is None:
        return None
    return float(word.lower().replace("d", "e"))


def rows_of(text: str) -> list[list[float]]:
    """Returns the numbers of each line; all lines have the same count.

    Separators are blanks, tabs, semicolons or commas. If there is another separator, a comma is a decimal comma. Text
    after #, % or !, or after an unpaired quotation mark, is a comment. Numbers may be quoted, and lines of words above
    all numbers are headings. Raises ValueError with the line.
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
            raise ValueError(f"line {number} has {wrong[:40]!r} instead of a number")
        if rows and len(values) != len(rows[0]):
            raise ValueError(f"line {number} has {len(values)} numbers, but the first has {len(rows[0])}")
        rows.append(values)
    if not rows:
        raise ValueError("it has none")
    return rows


def table_of(text: str, on_progress: Callable[[float], None] | None = None) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """Returns the names in the first line, and the cells of the other lines with their line numbers. Decimal fractions
    have points.

    Separators are semicolons or tabs if the first line has one, otherwise commas. Comment signs inside quotation marks
    are text. `on_progress` receives the fraction read. Raises ValueError with the line, also if a column has no name or
    a repeated one.
    """
    names: list[str] = []
    rows: list[tuple[int, list[str]]] = []
    between, done = ",", 0
    for number, line in _lines(text, keeps_quotes=True):
        done += len(line) + 1
        if on_progress is not None and number % _LINES_OF_REPORT == 0:
            on_progress(min(1.0, done / len(text)))
        if not names:
            between = next((sign for sign in ";\t" if sign in line), ",")
        try:
            (cells,) = csv.reader([line], delimiter=between, skipinitialspace=True, strict=True)
        except csv.Error:
            raise ValueError(f"line {number} {_problem_of(line, between)}") from None
        if not names:
            names = [cell.strip() for cell in cells]
            _check(names, number)
            continue
        if len(cells) != len(names):
            raise ValueError(f"line {number} has {len(cells)} columns, but the first has {len(names)}")
        rows.append((number, [cell.strip() if between == "," else cell.strip().replace(",", ".") for cell in cells]))
    return names, rows


def _check(names: list[str], line: int) -> None:
    if number := next((name for name in names if number_in(name.replace(",", ".")) is not None), None):
        raise ValueError(f"line {line} has the number {number:.40} instead of the name of a column; add a line with the names of all columns at the top")
    if "" in names:
        raise ValueError(f"line {line} has no name for column {names.index('') + 1}")
    if doubled := next((name for name, count in Counter(names).items() if count > 1), None):
        raise ValueError(f"line {line} names {doubled:.60} twice")


def _problem_of(line: str, between: str) -> str:
    longest = max(map(len, line.split(between)))
    if longest > csv.field_size_limit():
        return f"has a cell of {longest} characters; a cell must contain a number or a short text"
    return "has quotation marks that do not enclose a cell as a whole"


class _Style:
    """Describes the number format of a text, as far as its lines determine it."""

    def __init__(self) -> None:
        self._has_decimal_commas = False

    def numbers(self, line: str) -> list[float] | None:
        """Returns the numbers of a line; None if a word is not a number."""
        words = _BLANKS_AND_SEMICOLONS.split(line)
        any_comma = any("," in word[1:-1] for word in words)
        if len(words) > 1 or self._has_decimal_commas or not any_comma:
            found = _numbers_in(word.replace(",", ".", 1) for word in words)
            if found is not None:
                self._has_decimal_commas = self._has_decimal_commas or any_comma
                return found
        return _numbers_in(_ALL.split(line))


def _numbers_in(words: Iterable[str]) -> list[float] | None:
    """Returns the numbers of words; None if a word is not a number."""
    found: list[float] = []
    for word in words:
        value = number_in(word)
        if value is None:
            return None
        found.append(value)
    return found


def _lines(text: str, *, keeps_quotes: bool = False) -> Iterator[tuple[int, str]]:
    """Yields lines with content and their numbers, without comments and quotation marks."""
    for number, line in enumerate(text.splitlines(), 1):
        found = _TEXT_AND_QUOTES.match(line) if keeps_quotes else None
        line = found.group().rstrip(" ") if found is not None else _COMMENTS.split(line, maxsplit=1)[0]
        if line.count('"') % 2:
            line = line.partition('"')[0]
        if not keeps_quotes:
            line = line.replace('"', "").strip()
        if line.strip():
            yield number, line
