"""Plans of creep-force tables: their nodes, and how each is solved."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import click
import numpy as np
import numpy.typing as npt

import contactd
from contactd.creep_tables import CreepTable, extension

from .recipes import RECIPES, Recipe

__all__ = ["Reals", "Row", "TablePlan", "digest", "opened"]

Reals = npt.NDArray[np.float64]

VERSION = 2  #: Of the nodes: rows of other versions are not used.


@dataclass(frozen=True)
class Row:
    """The nodes of one Poisson's ratio, one a/b and one first angle: the unit of work.

    Attributes:
        key: Identifies the row, also in later runs: a digest of all that determines its forces.
        nu: Poisson's ratio.
        number: Its number at this Poisson's ratio.
        nodes: Number of its nodes.
    """

    key: str
    nu: float
    number: int
    nodes: int

    @property
    def values(self) -> dict[str, Any]:
        """Numbers that identify the row in its plan."""
        return {"nu": self.nu, "row": self.number}


@dataclass(frozen=True)
class TablePlan:
    """A table.

    Attributes:
        nu: Poisson's ratios.
        ratios: Range of a/b.
        cells: Numbers of cells of log(a/b), of both angles, and of u.
        recipe: The recipe of its nodes.
    """

    nu: tuple[float, ...]
    ratios: tuple[float, float]
    cells: tuple[int, int, int, int]
    recipe: Recipe

    def __post_init__(self) -> None:
        if (
            not self.nu
            or list(self.nu) != sorted(set(self.nu))
            or len(self.nu) > 8
            or not 0 <= self.nu[0] <= self.nu[-1] <= 0.5
        ):
            raise click.UsageError(f"--nu is {list(self.nu)}; give one to eight ascending values between 0 and 0.5.")
        if not 1 / 32 <= self.ratios[0] < self.ratios[1] <= 32:
            raise click.UsageError(
                f"--ratios is {list(self.ratios)}; it must be the smallest and the largest a/b, within 1/32 and 32."
            )
        if not all(4 <= count <= 512 for count in self.cells):
            raise click.UsageError(
                f"--cells is {list(self.cells)}; each of the four numbers must lie between 4 and 512."
            )

    @cached_property
    def rows(self) -> list[Row]:
        """All rows in the order of the table's nodes: at each Poisson's ratio those of the table, then those of its box."""
        nodes = [int(count) for count in np.frombuffer(extension().creep_table_rows(self.ratios, self.cells))]
        shared = [VERSION, self.ratios, self.cells, self.recipe.described]
        return [
            Row(digest(*shared, nu, number), nu, number, count) for nu in self.nu for number, count in enumerate(nodes)
        ]

    def states(self, row: Row) -> Reals:
        """Returns rows of a/b and the scaled creepages of the nodes."""
        ratio, creepages = extension().creep_table_row(self.ratios, self.cells, row.nu, row.number)
        creepages = np.frombuffer(creepages).reshape(-1, 3)
        return np.column_stack([np.full(len(creepages), ratio), creepages])

    def states_at(self, points: Reals, nu: float) -> Reals:
        """Returns rows of a/b and the scaled creepages at points of log(a/b), both angles, and u."""
        creepages = extension().creep_table_creepages(
            self.ratios, self.cells, nu, np.ascontiguousarray(points).tobytes()
        )
        return np.column_stack([np.exp(points[:, 0]), np.frombuffer(creepages).reshape(-1, 3)])

    def described(self, rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
        """Returns the description in the file, which depends on the plan and the solves only. `fallback` and
        `unconverged` contain the numbers of nodes in the order of the rows.
        """
        first = np.cumsum([0, *(row.nodes for row in self.rows)]).tolist()
        numbers = {
            name: [start + node for start, row in zip(first, rows) for node in row["answers"][name]]
            for name in ("fallback", "unconverged")
        }
        return {
            "program": f"contactd {contactd.__version__}", "nu": list(self.nu), "ratios": list(self.ratios), "cells": list(self.cells),
            "recipe": self.recipe.described, "nodes": first[-1], **numbers, "statement": None,
        }  # fmt: skip

    def write(self, path: Path, rows: Sequence[dict[str, Any]]) -> None:
        """Fits the table to the forces of all rows, in the order of the plan, and writes its file."""
        forces = np.concatenate([np.array(row["answers"]["forces"]) for row in rows])
        described = json.dumps(self.described(rows), allow_nan=False).encode()
        library = extension()
        try:
            library.write_creep_table(
                self.ratios, self.cells, str(path.absolute()), np.array(self.nu).tobytes(), forces.tobytes(), described
            )
        except (library.Error, ValueError) as error:
            raise click.UsageError(str(error)) from None


def digest(*values: Any) -> str:
    """Returns a key of a row."""
    return hashlib.sha256(json.dumps(values).encode()).hexdigest()[:32]


def opened(path: Path, nu: float | None = None) -> tuple[CreepTable, TablePlan]:
    """Returns a table and its plan. Another program may have written the description, with a right digest: raises
    click.UsageError.
    """
    try:
        table = CreepTable(path, nu)
    except (contactd.TableFileError, contactd.InvalidArgument) as error:
        raise click.UsageError(getattr(error, "message", str(error))) from None
    given = table.description
    try:
        recipe, elements = RECIPES[given["recipe"]["name"]], given["recipe"]["elements"]
        recipe = Recipe(recipe.name, tuple(int(n) for n, _ in elements), recipe.across, recipe.degree)
        low, high = map(float, given["ratios"])
        nodes_a, nodes_b, nodes_c, nodes_d = map(int, given["cells"])
        plan = TablePlan(tuple(map(float, given["nu"])), (low, high), (nodes_a, nodes_b, nodes_c, nodes_d), recipe)
        is_known = (
            given["program"].isprintable()
            and (table.statement or " ").isprintable()
            and all(len(given[name]) <= given["nodes"] for name in ("fallback", "unconverged"))
        )
        is_known = (
            is_known
            and len(recipe.grids) == len(RECIPES[recipe.name].grids)
            and all(4 <= n <= 500 for n in recipe.grids)
        )
    except (ValueError, LookupError, TypeError, AttributeError, OverflowError, click.UsageError):
        is_known = False
    if not is_known:
        raise click.UsageError(f"{path.name} lacks the description that contactctl table build writes.")
    return table, plan
