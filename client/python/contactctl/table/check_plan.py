"""Fresh states for the check of a table: random ones, others that cover its cells, and searches from the worst."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from contactd import Client, CreepTable, StatusError

from ..codes import Code, code_of
from .bound_cells import BOUND_CELLS, Integers, touches_apex
from .nodes import extrapolated, interpolated
from .plan import Reals, TablePlan, digest, opened
from .recipes import Recipe

__all__ = ["CANDIDATES", "RANDOM", "ROUNDS", "CheckPlan", "Sample", "Search", "measure"]

VERSION = 1  #: Of the states and of the search: rows of other versions are not used.
RANDOM, BY_CELL, TWICE = (
    25,
    25,
    3,
)  #: States of a sample at random and by cell, and those solved by a second recipe, too.
ROUNDS, CANDIDATES = 5, 6  #: Of a search.
HARD = 4  #: How much denser hard cells are sampled.
LENGTHS = (0.02, 25.0)  #: Of the scaled creepages of random states.


@dataclass(frozen=True)
class Sample:
    """Some states with one Poisson's ratio and one a/b, whose influence coefficients they share: the unit of work."""

    key: str
    number: int

    @property
    def values(self) -> dict[str, Any]:
        return {"sample": self.number}


@dataclass(frozen=True)
class Search:
    """A random search for larger differences, from one point of the table."""

    key: str
    nu: float
    point: tuple[float, ...]
    start: float

    @property
    def values(self) -> dict[str, Any]:
        return {"nu": self.nu, "point": list(self.point), "start": self.start}


@dataclass(frozen=True)
class CheckPlan:
    """The check of a table: its states depend on these values only.

    Attributes:
        path: The table.
        table: Its plan.
        nu: The only Poisson's ratio, or None for random ones of the table.
        points: Number of random states, of which samples have a whole number.
        seed: Seed of all random numbers.
        recipe: The recipe of the fresh solves.
        second: Another recipe, which shows the uncertainty of the solver.
    """

    path: Path
    table: TablePlan
    nu: float | None
    points: int
    seed: int
    recipe: Recipe
    second: Recipe

    @cached_property
    def samples(self) -> list[Sample]:
        shared = [
            VERSION,
            self.table.ratios,
            self.table.cells,
            self.table.nu,
            self.nu,
            self.seed,
            self.recipe.described,
            self.second.described,
        ]
        return [Sample(digest(*shared, number), number) for number in range(math.ceil(self.points / RANDOM))]

    @property
    def counts(self) -> dict[str, int]:
        """Lengths of the answers of a sample; negative for any."""
        return {"forces": 3 * (RANDOM + BY_CELL), "second": 3 * TWICE, "unconverged": -1}

    @property
    def ends(self) -> Reals:
        """The ends of log(a/b), both angles, and u."""
        low, high = self.table.ratios
        return np.array([[math.log(low), 0, 0, 0], [math.log(high), math.pi, math.pi / 2, 2]])

    def sampled(self, sample: Sample) -> tuple[float, Reals]:
        """Returns Poisson's ratio, and points of log(a/b), both angles, and u. The first are random: uniform in log(a/b),
        on the sphere of the angles, and in the logarithm of the length from 0.02 to 25; a quarter has no spin. The others
        lie in one cell after the other.
        """
        draw = np.random.default_rng([self.seed, sample.number])
        offset = np.random.default_rng([self.seed]).random()
        nu = self.nu if self.nu is not None else draw.uniform(self.table.nu[0], self.table.nu[-1])
        low, high = self.ends
        place = (offset + sample.number * (math.sqrt(5) - 1) / 2) % 1  # successive values fill the range evenly
        log_ratio = low[0] + place * (high[0] - low[0])
        no_spin = draw.random(RANDOM) < 0.25
        angle_a = np.where(no_spin, draw.uniform(0, math.pi, RANDOM), np.arccos(draw.uniform(-1, 1, RANDOM)))
        angle_b = np.where(no_spin, 0, draw.uniform(0, math.pi / 2, RANDOM))
        length = np.exp(draw.uniform(math.log(LENGTHS[0]), math.log(LENGTHS[1]), RANDOM))
        cells = self._cells(log_ratio)
        chosen = cells[(np.arange(BY_CELL) + BY_CELL * sample.number) % len(cells)]
        within = low[1:] + (chosen + draw.random((BY_CELL, 3))) * (high - low)[1:] / BOUND_CELLS[1:]
        random = np.column_stack([angle_a, angle_b, 4 / math.pi * np.arctan(length)])
        points = np.vstack([random, within])
        return float(nu), self.inside(np.column_stack([np.full(len(points), log_ratio), points]))

    def inside(self, points: Reals) -> Reals:
        """Moves points into the table, with creepages that are neither zero nor infinite."""
        low, high = self.ends
        return np.clip(points, [*low[:3], 0.001], [*high[:3], 1.999])

    def _cells(self, log_ratio: float) -> Integers:
        """Returns the cells of the angles and u in a random order, the hard ones several times: around the apex, and large
        spin on contacts wider than long.
        """
        cells = np.indices(BOUND_CELLS[1:]).reshape(3, -1).T
        spin, large = cells[:, 1] == BOUND_CELLS[2] - 1, cells[:, 2] >= BOUND_CELLS[3] // 2
        near = touches_apex(*cells.T)
        hard = (
            near
            if log_ratio > math.log(3)
            else spin & large
            if log_ratio < -math.log(3)
            else np.zeros(len(cells), dtype=bool)
        )
        every = np.vstack([cells, *[cells[hard]] * (HARD - 1)])
        return np.random.default_rng([self.seed]).permutation(every)

    def solved(self, client: Client, unit: Sample | Search) -> dict[str, Any]:
        """Returns a row of the journal. Raises errors of the connection."""
        began = time.monotonic()
        try:
            answers = self._search(client, unit) if isinstance(unit, Search) else self._sample(client, unit)
        except StatusError as error:
            return {"code": int(code_of(error)), "error": str(error), "seconds": time.monotonic() - began}
        return {"code": int(Code.DONE), "answers": answers, "seconds": time.monotonic() - began}

    def _sample(self, client: Client, sample: Sample) -> dict[str, Any]:
        nu, points = self.sampled(sample)
        states = self.table.states_at(points, nu)
        forces, converged = extrapolated(client, states, nu, self.recipe)
        second, again = extrapolated(client, states[RANDOM : RANDOM + TWICE], nu, self.second)
        again &= converged[RANDOM : RANDOM + TWICE]
        second[~again] = forces[RANDOM : RANDOM + TWICE][~again]
        return {
            "forces": forces.ravel().tolist(),
            "unconverged": np.flatnonzero(~converged).tolist(),
            "second": second.ravel().tolist(),
        }

    def _search(self, client: Client, search: Search) -> dict[str, Any]:
        table: CreepTable = opened(self.path, search.nu)[0]
        draw = np.random.default_rng([self.seed, int(search.key[:8], 16)])
        low, high = self.ends
        best, worst, errors = np.array(search.point), search.start, [0.0, 0.0]
        for stage in range(ROUNDS):
            step = 0.6**stage * (high - low) / self.table.cells
            points = self.inside(best + step * draw.normal(size=(CANDIDATES, 4)))
            states = self.table.states_at(points, search.nu)
            forces, converged = extrapolated(client, states, search.nu, self.recipe)
            found = np.abs(interpolated(table, states) - forces) * converged[:, None]
            measured = measure(found)
            if measured.max() > worst:
                at = int(measured.argmax())
                best, worst, errors = points[at], float(measured[at]), [float(found[at, :2].max()), float(found[at, 2])]
        return {"point": best.tolist(), "errors": errors}


def measure(errors: Reals) -> Reals:
    """Returns what a search maximises: the error of a force, or half of that of the moment if it is larger."""
    larger: Reals = np.maximum(errors[:, :2].max(axis=1), errors[:, 2] / 2)
    return larger
