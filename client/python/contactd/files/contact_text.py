"""Reads and writes the text format of the CONTACT program for numerical influence coefficients (docs/ic-tables.md,
Exchange)."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, NoReturn

import numpy as np

from ..errors import TableFileError
from .whole import read_whole

if TYPE_CHECKING:
    from ..values.arrays import Array

__all__ = ["format_text", "parse_text", "read_text"]

_ORDER = 312  # order of the columns: z (normal), x, y
_COLUMNS = [(i, j) for i in (2, 0, 1) for j in (2, 0, 1)]
_ROW = 2 + len(_COLUMNS)
_MARK = "times G = "
#: Our own comment in front of each block.
_OFFSET = re.compile(r"offset iy = (\S+), y = (\S+);")
#: Parities of A[i,j] along x and y: -1 where exactly one of i and j is that axis.
_PARITY = [tuple(-1 if (i == axis) != (j == axis) else 1 for axis in (0, 1)) for i, j in _COLUMNS]
_MOST_OFFSETS = 4_000_000
_MOST_BYTES = 1 << 31  #: Largest size: lines of 250 characters, for offsets to both sides.
#: Largest relative difference of coordinates and the header's element sizes that counts as rounding.
_SIZE_TOLERANCE = 1e-6


def format_text(array: Array, dx: float, dy: float, G: float) -> str:
    """Returns the text for a pair's table [3, 3, ny, nx] (mm^3/N); `G` is the pair's combined modulus (N/mm^2)."""
    ny, nx = array.shape[2:]
    lines = ["1 1", f"0 {_ORDER}", "1 0", f"{nx} {ny} {dx:.17g} {dy:.17g}"]
    heads = "%  ix                       x" + "".join(f"{'C':>22}{'xyz'[i]}{'xyz'[j]}" for i, j in _COLUMNS)
    scaled = G * np.stack([array[i, j] for i, j in _COLUMNS], axis=-1)  # [ny, nx, 9]
    along_y = np.array([parity[1] for parity in _PARITY])
    for offset in range(1 - ny, ny):
        lines.append(f"% offset iy = {offset}, y = {offset * dy:.9g}; sums over both bodies, {_MARK}{G:.17g}")
        lines.append(heads)
        rows = scaled[abs(offset)] * (along_y if offset < 0 else 1)
        for ix, row in enumerate(rows.tolist()):
            lines.append(f"{ix:5d} {ix * dx:23.16e}" + "".join(f" {value:23.16e}" for value in row))
    return "\n".join([*lines, ""])


def read_text(path: str | os.PathLike[str], G: float | None, tolerance: float) -> tuple[Array, float, float, float]:
    """Reads a file with parse_text. Raises TableFileError naming the file and the line."""
    try:
        return parse_text(read_whole(path, _MOST_BYTES).decode("ascii", "replace"), G, tolerance)
    except TableFileError as error:
        raise TableFileError(f"{os.fspath(path)}, {error}") from None


def parse_text(text: str, G: float | None, tolerance: float) -> tuple[Array, float, float, float]:
    """Returns table (mm^3/N), dx, dy and modulus of such a text. Raises TableFileError naming the line."""
    if G is not None and not (math.isfinite(G) and G > 0):
        raise ValueError(f"G is {G}; it must be positive")
    return _Reader(text, G).read(tolerance)


def _fail(line: int, problem: str) -> NoReturn:
    raise TableFileError(f"line {line} {problem}")


def _words(line: str) -> list[str]:
    """Splits the part before a comment at blanks and commas."""
    return line.split("%", 1)[0].replace(",", " ").split()


def _plain(word: str) -> str:
    """Writes a number in Python's format."""
    text = word.lower().replace("d", "e")
    if "e" not in text:  # Fortran omits the E before an exponent of three digits.
        text = re.sub(r"(?<=[0-9.])(?=[+-])", "e", text, count=1)
    return text


def _number(word: str) -> float | None:
    """Returns the finite number written as `word` in the format of Python or Fortran."""
    text = _plain(word)
    if not re.fullmatch(r"[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?", text, re.ASCII):
        return None
    value = float(text)
    return value if math.isfinite(value) else None


def _off_by(word: str, exact: float) -> float:
    """Returns the largest rounding difference between `word` and `exact`: half its last digit, and the digits of the
    element size.
    """
    digits, _, exponent = _plain(word).partition("e")
    return 0.5000001 * 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2])) + _SIZE_TOLERANCE * abs(exact)


def _shown(words: Sequence[str], n: int) -> str:
    return f'"{words[n]:.30}"' if n < len(words) else "too few numbers"


class _Reader:
    def __init__(self, text: str, G: float | None) -> None:
        self._lines = text.split("\n")
        if self._lines[-1] == "":
            self._lines.pop()
        self._at = 0
        self._modulus = G
        self._reported: float | None = None

    def read(self, tolerance: float) -> tuple[Array, float, float, float]:
        self._read_kind()
        self._read_constants("column definition (0 312)", (0, _ORDER))
        self._read_constants("symmetry (1 0)", (1, 0))
        nx, ny, dx, dy = self._read_extent()
        rows = np.empty((2 * ny - 1, nx, len(_COLUMNS)))
        for block, iy in enumerate(range(1 - ny, ny)):
            self._skip_comment(iy, dy)
            self._skip_comment(iy, dy)
            rows[block] = self._read_block(nx, iy, dx)
        self._expect_end()
        if self._modulus is None:
            raise TableFileError("G is missing; the text does not contain the modulus by which its values are multiplied")
        array = self._symmetric_part(rows, nx, ny, tolerance)
        array /= self._modulus
        return array, dx, dy, self._modulus

    def _next(self, requested: str) -> str:
        if self._at == len(self._lines):
            _fail(self._at + 1, f"is missing; it must contain {requested}")
        self._at += 1
        return self._lines[self._at - 1]

    def _header(self, requested: str) -> list[str]:
        """Returns the words of the next line that is neither empty nor a comment."""
        words: list[str] = []
        while not words:
            words = _words(self._next(requested))
        return words

    def _whole(self, words: Sequence[str], n: int, requested: str) -> int:
        value = _number(words[n]) if n < len(words) else None
        if value is None or not value.is_integer():
            _fail(self._at, f"contains {_shown(words, n)}; it must contain the {requested}")
        return int(value)

    def _read_kind(self) -> None:
        requested = "number of tables, 1, and that of the convex body, 1 or 2"
        words = self._header(f"the {requested}")
        if all(_number(word) is None for word in words):
            return  # a line of words
        tables, convex = self._whole(words, 0, requested), self._whole(words, 1, requested)
        if tables != 1:
            _fail(
                self._at,
                f"announces {tables} tables, one for each row of elements; only a single table for all rows is supported",
            )
        if not 0 <= convex <= 2:
            _fail(self._at, f"names the convex body {convex}; it must be 1 or 2")

    def _read_constants(self, name: str, expected: tuple[int, int]) -> None:
        words = self._header(f"the {name}")
        for n, constant in enumerate(expected):
            value = self._whole(words, n, name)
            if value != constant:
                _fail(
                    self._at,
                    f"contains {value} where the {name} must have {constant}; other kinds of files are not supported",
                )

    def _read_extent(self) -> tuple[int, int, float, float]:
        requested = "extent and element sizes, mx my dx dy"
        words = self._header(f"the {requested}")
        nx, ny = self._whole(words, 0, requested), self._whole(words, 1, requested)
        if nx < 1 or ny < 1 or nx * ny > _MOST_OFFSETS:
            _fail(
                self._at,
                f"announces {nx} x {ny} offsets; there must be at least one and at most {_MOST_OFFSETS}",
            )
        sizes: list[float] = []
        for n in (2, 3):
            size = _number(words[n]) if n < len(words) else None
            if size is None or size <= 0:
                _fail(self._at, f"contains {_shown(words, n)}; it must contain the {requested}, and the sizes must be positive")
            sizes.append(size)
        needed, there = (2 * ny - 1) * (nx + 2), len(self._lines) - self._at
        if there < needed:
            _fail(self._at, f"announces {nx} x {ny} offsets, for which {needed} lines must follow, but there are {there}")
        return nx, ny, sizes[0], sizes[1]

    def _skip_comment(self, iy: int, dy: float) -> None:
        line = self._next("a comment")
        if len(_words(line)) >= _ROW:
            _fail(self._at, "contains numbers; it must be one of the two comment lines before each y offset")
        _, mark, rest = line.partition(_MARK)
        if mark:
            self._take_modulus(_words(rest))
        if own := _OFFSET.search(line):
            self._check_offset(own.groups(), iy, dy)

    def _take_modulus(self, words: Sequence[str]) -> None:
        """Reads the modulus from our own comments, which must agree. The caller's modulus takes precedence."""
        reported = _number(words[0]) if words else None
        if reported is None or reported <= 0:
            _fail(self._at, 'does not give the modulus after "times G ="')
        if self._reported not in (None, reported):
            _fail(self._at, f"gives the modulus {reported:.17g}, but earlier comments give {self._reported:.17g}")
        self._reported = reported
        if self._modulus is None:
            self._modulus = reported

    def _check_offset(self, given: Sequence[str], iy: int, dy: float) -> None:
        """Detects a header that was changed without its comments."""
        offset, y = _number(given[0]), _number(given[1])
        if offset != iy:
            _fail(self._at, f"announces the y offset {given[0]:.30}; by the extent in the header it must be {iy}")
        if y is None or abs(y - iy * dy) > _SIZE_TOLERANCE * abs(iy) * dy:
            _fail(self._at, f"has y {given[1]:.30}; by the element size in the header it must be {iy * dy:.9g}")

    def _read_block(self, nx: int, iy: int, dx: float) -> Array:
        lines = self._lines[self._at : self._at + nx]
        try:
            block = np.array([line.split() for line in lines], dtype=np.float64)
            quick = block.shape == (nx, _ROW) and bool(np.isfinite(block).all()) and "_" not in "".join(lines)
        except ValueError:
            quick = False
        if not quick:  # another number format, or a broken line
            block = np.array([self._read_row(line, n, (n, iy)) for n, line in enumerate(lines)])
        k = np.arange(nx)
        for wrong in np.flatnonzero(block[:, 0] != k)[:1]:
            _fail(
                self._at + int(wrong) + 1,
                f"has ix {block[wrong, 0]:g}; it must be that of the offset {(int(wrong), iy)}",
            )
        for at in map(int, np.flatnonzero(np.abs(block[:, 1] - k * dx) > _SIZE_TOLERANCE * k * dx)):
            if abs(block[at, 1] - at * dx) > _off_by(_words(lines[at])[1], at * dx):
                _fail(self._at + at + 1, f"has x {block[at, 1]:g}; it must be ix dx, {at * dx:g}")
        self._at += nx
        rows: Array = block[:, 2:]
        return rows

    def _read_row(self, line: str, n: int, offset: tuple[int, int]) -> list[float]:
        number, words = self._at + n + 1, _words(line)
        if len(words) != _ROW:
            _fail(
                number,
                f"contains {len(words)} numbers; it must contain eleven, ix x Czz Czx Czy Cxz Cxx Cxy Cyz Cyx Cyy of the "
                f"offset {offset}",
            )
        values: list[float] = []
        for at, word in enumerate(words):
            value = _number(word)
            if value is None:
                _fail(number, f"contains {_shown(words, at)}; it must be a finite number")
            values.append(value)
        return values

    def _expect_end(self) -> None:
        for number, line in enumerate(self._lines[self._at :], self._at + 1):
            if _words(line):
                _fail(number, "follows the last y offset, which the fourth line of the header gives")

    def _line_of(self, nx: int, ny: int, k: int, iy: int) -> int:
        """Returns the line number of an offset, counted from the last one of the blocks."""
        blocks_behind = ny - 1 - iy
        return self._at - blocks_behind * (nx + 2) - (nx - 1 - k)

    def _symmetric_part(self, rows: Array, nx: int, ny: int, tolerance: float) -> Array:
        """Returns the part of each component that has its parities in both offsets."""
        plus, minus = rows[ny - 1 :], rows[ny - 1 :: -1]
        allowed = tolerance * max(abs(rows[ny - 1, 0, n]) for n, (i, j) in enumerate(_COLUMNS) if i == j)
        array = np.empty((3, 3, ny, nx))
        for n, (i, j) in enumerate(_COLUMNS):
            along_x, along_y = _PARITY[n]
            part = 0.5 * (plus[..., n] + along_y * minus[..., n])
            if along_x < 0:
                part[:, 0] = 0
            wrong = np.argwhere(~(np.abs(plus[..., n] - part) <= allowed))
            if len(wrong):
                l, k = (int(index) for index in wrong[0])
                name = f"C{'xyz'[i]}{'xyz'[j]}"
                why = ", because contactd's tables are those of bodies symmetric in x and y"
                if k == 0 and along_x < 0:
                    must = "it must vanish at ix = 0"
                elif l == 0:
                    must = "it must vanish at the y offset 0"
                else:
                    other = self._line_of(nx, ny, k, -l)
                    sign = "minus " if along_y < 0 else ""
                    must = f"it must be {sign}the value of line {other} for the opposite y offset, {minus[l, k, n]:.17g}"
                _fail(self._line_of(nx, ny, k, l), f"has {plus[l, k, n]:.17g} for {name}; {must}{why}")
            array[i, j] = part
        return array
