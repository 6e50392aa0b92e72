"""Finds units in the headings of files with numbers, as written by surface measurement programs."""

from __future__ import annotations

import re
from collections.abc import Iterator

from .number_text import number_in

__all__ = ["heading_of", "unit_factor"]

#: Factors from units to mm or N/mm^2; None for words without a unit.
_UNITS = {
    "m": 1e3, "dm": 1e2, "cm": 10.0, "mm": 1.0, "um": 1e-3, "nm": 1e-6, "pm": 1e-9, "å": 1e-7, "in": 25.4, "mil": 0.0254, "ft": 304.8,
    "pa": 1e-6, "kpa": 1e-3, "mpa": 1.0, "gpa": 1e3, "n/mm^2": 1.0, "n/mm2": 1.0, "n/mm²": 1.0, "n/m^2": 1e-6, "n/m2": 1e-6, "n/m²": 1e-6,
}  # fmt: skip
_NAMES = {
    "meter": "m", "metre": "m", "centimeter": "cm", "centimetre": "cm", "millimeter": "mm", "millimetre": "mm", "micrometer": "um",
    "micrometre": "um", "micron": "um", "nanometer": "nm", "nanometre": "nm", "angstrom": "å", "inch": "in", "inches": "in", "feet": "ft",
    "pascal": "pa",
}  # fmt: skip
_NO_UNIT = {"-", "1", "none", "unitless", "dimensionless"}
_OF_PLACES = re.compile(r"\b(x|y|xy|lateral|width|length|horizontal|sampling|spacing|pixel)\b[\s_-]*$", re.IGNORECASE)
_VALUES = r"(?:z|heights?|values?|data|gaps?|distances?|topography|pressures?|tractions?)"
_UNIT = r"([^\s,;:=()\[\]]+)"
_STATED = (
    re.compile(rf"(?<![^\W_])units?\b\s*(?:[:=]|\bis\b|\bare\b|[\[(])\s*{_UNIT}", re.IGNORECASE),
    re.compile(rf"\b{_VALUES}\s*[\[(]\s*{_UNIT}\s*[\])]", re.IGNORECASE),
)
_IN_WORDS = re.compile(rf"\b{_VALUES}\s+(?:are\s+)?in\s+{_UNIT}", re.IGNORECASE)
_LONGEST = 400  #: Number of characters examined in a line.
_SCALE = re.compile(r"(?<![^\W_])z[\s_-]*(?:scale|factor|multiplier)\b\s*[:=]?\s*(\S+)", re.IGNORECASE)


def heading_of(text: str) -> list[str]:
    """Returns the lines above the first one that begins with a number, including comment signs."""
    heading = []
    for line in text.splitlines():
        words = line.replace(";", " ").replace(",", " ").split()
        if words and number_in(words[0].strip('"')) is not None:
            break
        heading.append(line[:_LONGEST])
    return heading


def unit_factor(text: str) -> float:
    """Returns the factor from the unit in the heading to mm, or to N/mm^2; 1 without a unit.

    Raises ValueError for a unit of neither length nor pressure, for two different units, and for a scale.
    """
    found: dict[float, str] = {}
    for line in heading_of(text):
        if (scale := _SCALE.search(line)) is not None and number_in(scale.group(1)) != 1:
            raise ValueError(f"its heading states a scale of the heights, {line.strip()[:60]!r}; give them in mm, without a scale")
        for unit in _units_in(line):
            found.setdefault(_factor(unit, line), unit)
    if len(found) > 1:
        raise ValueError(f"its heading states two units of the values, {' and '.join(found.values())}")
    return next(iter(found), 1.0)


def _units_in(line: str) -> Iterator[str]:
    for stated in _STATED:
        for match in stated.finditer(line):
            if _OF_PLACES.search(line[: match.start()]) is None:
                yield match.group(1)
    for match in _IN_WORDS.finditer(line):  # most such lines contain no unit, such as "values in rows"
        if _known(match.group(1)) in _UNITS:
            yield match.group(1)


def _known(unit: str) -> str:
    word = unit.strip("\"'.").lower().replace("µ", "u").replace("μ", "u")
    return _NAMES.get(word.removesuffix("s"), _NAMES.get(word, word))


def _factor(unit: str, line: str) -> float:
    word = _known(unit)
    if word in _NO_UNIT:
        return 1.0
    if word not in _UNITS:
        raise ValueError(f"its heading states the unit {unit[:20]!r} in {line.strip()[:60]!r}; give lengths in mm and pressures in N/mm^2")
    return _UNITS[word]
