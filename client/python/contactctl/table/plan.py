"""Plans of creep-force tables: their nodes, and how each is solved."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import click

import contactd

__all__ = ["Row", "TablePlan", "recipe_of"]

VERSION = 1  #: Of the nodes: rows of other versions are not used.


def recipe_of(grids: tuple[int, int]) -> dict[str, Any]:
    """Returns the description of a recipe: two grids of n elements along and 2n across, extrapolated linearly in 1/n."""
    return {"elements": [[n, 2 * n] for n in grids], "spin_offset": 0.25, "extrapolation": "linear in 1/n"}


@dataclass(frozen=True)
class Row:
    """The nodes of one Poisson's ratio, one a/b and one first angle: the unit of work.

    Attributes:
        key: Identifies the row, also in later runs: a digest of all that determines its forces.
    """

    key: str
    nu: float
    ratio: int
    angle: int

    @property
    def values(self) -> dict[str, Any]:
        """Numbers that identify the row in its plan."""
        return {"nu": self.nu, "ratio": self.ratio, "angle": self.angle}


@dataclass(frozen=True)
class TablePlan:
    """A table.

    Attributes:
        nu: Poisson's ratios.
        ratios: Range of a/b.
        cells: Numbers of cells of log(a/b), of both angles, and of u.
        grids: Numbers of elements n along the contact.
    """

    nu: tuple[float, ...]
    ratios: tuple[float, float]
    cells: tuple[int, int, int, int]
    grids: tuple[int, int]

    def __post_init__(self) -> None:
        if not self.nu or list(self.nu) != sorted(set(self.nu)) or len(self.nu) > 8 or not 0 <= self.nu[0] <= self.nu[-1] <= 0.5:
            raise click.UsageError(f"--nu is {list(self.nu)}; give one to eight ascending values between 0 and 0.5.")
        if not 1 / 32 <= self.ratios[0] < self.ratios[1] <= 32:
            raise click.UsageError(f"--ratios is {list(self.ratios)}; it must be the smallest and the largest a/b, within 1/32 and 32.")
        if not all(4 <= count <= 1024 for count in self.cells):
            raise click.UsageError(f"--cells is {list(self.cells)}; each of the four numbers must lie between 4 and 1024.")
        if not 4 <= self.grids[0] < self.grids[1] <= 500:
            raise click.UsageError(f"--grids is {list(self.grids)}; it must be two ascending numbers between 4 and 500.")

    @cached_property
    def rows(self) -> list[Row]:
        """All rows in the order of the table's nodes."""
        return list(self._rows())

    def _rows(self) -> Iterator[Row]:
        shared = json.dumps([VERSION, self.ratios, self.cells, recipe_of(self.grids)])
        for nu in self.nu:
            for ratio in range(self.cells[0] + 1):
                for angle in range(self.cells[1] + 1):
                    key = hashlib.sha256(f"{shared}{json.dumps([nu, ratio, angle])}".encode()).hexdigest()[:32]
                    yield Row(key, nu, ratio, angle)

    @property
    def nodes(self) -> int:
        """Number of nodes in all rows."""
        return len(self.rows) * (self.cells[2] + 1) * (self.cells[3] - 1)

    def fits(self, row: dict[str, Any]) -> bool:
        """Returns whether a row of a file is a failure, or has an answer with numbers for each of its nodes."""
        answers = row.get("answers")
        if answers is None:
            return "error" in row
        lists = [answers.get(name) for name in ("forces", "fallback", "unconverged")]
        if not all(isinstance(found, list) and all(isinstance(number, (int, float)) for number in found) for found in lists):
            return False
        return len(answers["forces"]) == 3 * (self.cells[2] + 1) * (self.cells[3] - 1)

    def described(self, rows: list[dict[str, Any]]) -> dict[str, Any]:
        """Returns the description in the file, which depends on the plan and the solves only."""
        count = {name: sum(len(row["answers"][name]) for row in rows) for name in ("fallback", "unconverged")}
        return {
            "program": f"contactd {contactd.__version__}", "nu": list(self.nu), "ratios": list(self.ratios), "cells": list(self.cells),
            "recipe": recipe_of(self.grids), "nodes": self.nodes, **count, "statement": None,
        }  # fmt: skip
