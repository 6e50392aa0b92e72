"""Generates the lists of arrays over the grid: those of a solution, and those that a step passes on to the next (`x-history`)."""

from __future__ import annotations

from pathlib import Path

from . import fmu, python
from .cpp import GENERATED, HEADERS, NOTE, formatted
from .declarations import DeclarationError, Declarations, Schema

SOLUTION = "ContactSolution"
STATE = "SurfaceState"
BOUNDS = {"minimum": "{.least = 0}", "exclusiveMinimum": "{.least = 0, .least_excluded = true}"}


def grid_array_files(declarations: Declarations) -> dict[Path, str]:
    """Returns the text of each file."""
    arrays = list(declarations.enums["SolutionField"].keywords)
    properties = declarations.schemas[SOLUTION]["properties"]
    history = {name: part["x-history"] for name, part in declarations.schemas[STATE]["properties"].items()}
    for name in [*arrays, *history]:
        if name not in arrays or name not in properties:
            raise DeclarationError(f"the array {name} is not in the answer and its list of fields")
    labels = {name: properties[name]["x-label"] for name in arrays}
    return {
        HEADERS / "grid_arrays.hpp": formatted(_header(len(arrays), len(history))),
        GENERATED / "grid_arrays.cpp": formatted(_source(arrays, history)),
        fmu.GENERATED / "history.hpp": formatted(_variables(history)),
        python.GENERATED / "array_labels.py": _labels(labels),
    }


def _header(arrays: int, history: int) -> str:
    return f"""{NOTE}
#pragma once

#include <array>

#include "contactd/history.hpp"

namespace contactd {{

/// Arrays of numbers in the order of SolutionField; null for the element division.
extern const std::array<std::vector<double> {SOLUTION}::*, {arrays}> solution_arrays;

/// Arrays that a step passes on to the next, in the order of {STATE}.
extern const std::array<HistoryArray, {history}> history_arrays;

}}  // namespace contactd
"""


def _source(arrays: list[str], history: dict[str, Schema]) -> str:
    members = ", ".join("nullptr" if name == "element_division" else f"&{SOLUTION}::{name}" for name in arrays)
    lines = [NOTE, '#include "contactd/fields/grid_arrays.hpp"\n', "namespace contactd {\n"]
    lines += [f"constexpr std::array<std::vector<double> {SOLUTION}::*, {len(arrays)}> solution_arrays{{{members}}};\n"]
    lines += [f"constexpr std::array<HistoryArray, {len(history)}> history_arrays{{", *(f"{_array(*item)}," for item in history.items()), "};\n"]
    return "\n".join([*lines, "}  // namespace contactd\n"])


def _array(name: str, history: Schema) -> str:
    parts = [f'"{name}"', f"&{STATE}::{name}", f"&{SOLUTION}::{name}"]
    if history:
        parts += [bounds for key, bounds in BOUNDS.items() if key in history] or ["Bounds{}"]
        parts += [f"[](const FrictionLaw& law) -> bool {{ return {history['if']}; }}"]
        parts += [f"[](const FrictionLaw& law, [[maybe_unused]] std::size_t element) -> std::optional<double> {{ return {history['enters']}; }}"]
    return f"HistoryArray{{{', '.join(parts)}}}"


def _variables(history: dict[str, Schema]) -> str:
    arrays = [f'HistoryArray{{"{name}", {{{", ".join(map(_quoted, part.get("fmu", ())))}}}}},' for name, part in history.items()]
    return "\n".join(
        [
            NOTE,
            "#pragma once\n\n#include <array>\n#include <string_view>\n",
            "namespace contactd::fmu {\n",
            "/// An array that a step passes on to the next, unless one of the variables is 0. Unused places are empty.",
            "struct HistoryArray {\nconst char* name;\nstd::array<std::string_view, 2> needs;\n};\n",
            f"inline constexpr std::array<HistoryArray, {len(history)}> history_arrays{{",
            *arrays,
            "};\n",
            "}  // namespace contactd::fmu\n",
        ]
    )


def _quoted(text: str) -> str:
    return f'"{text}"'


def _labels(labels: dict[str, list[str]]) -> str:
    rows = [f"    {_quoted(name)}: ({_quoted(words)}, {_quoted(unit)})," for name, (words, unit) in labels.items()]
    head = f'"""Names and units of the arrays of a solution.\n\n{python.NOTE}\n"""\n\nfrom __future__ import annotations\n\n'
    return "\n".join([head + '__all__ = ["ARRAY_LABELS"]\n', "ARRAY_LABELS = {", *rows, "}", ""])
