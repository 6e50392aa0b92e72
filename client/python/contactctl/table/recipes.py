"""Recipes of nodes: grids of solves, and their extrapolation to infinitely fine elements."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import click
import numpy as np

__all__ = ["RECIPES", "Recipe", "recipe_named"]


@dataclass(frozen=True)
class Recipe:
    """A regression of forces on powers of 1/n.

    Attributes:
        name: The name for --recipe.
        grids: Numbers n of elements along the contact, ascending.
        across: Elements across the contact for each element along it: 1 or 2.
        degree: Highest power of 1/n, below the number of grids.
    """

    name: str
    grids: tuple[int, ...]
    across: int
    degree: int

    @property
    def spin_offset(self) -> float:
        return 1 / 6 if self.across == 1 else 0.25

    @cached_property
    def weights(self) -> list[float]:
        """The weights of the grids' forces in the extrapolated force."""
        powers = np.vander(1 / np.array(self.grids), self.degree + 1, increasing=True)
        return [float(weight) for weight in np.linalg.pinv(powers)[0]]

    @property
    def described(self) -> dict[str, Any]:
        kind = "linear" if self.degree == 1 else "linear and quadratic"
        elements = [[n, self.across * n] for n in self.grids]
        return {
            "name": self.name,
            "elements": elements,
            "spin_offset": self.spin_offset,
            "extrapolation": f"{kind} in 1/n",
        }

    @property
    def text(self) -> str:
        """The recipe in words."""
        return f"{self.name}: {', '.join(f'{n} x {self.across * n}' for n in self.grids)} elements, {self.described['extrapolation']}"


#: By their errors, with the measured costs of a node: 5e-4 (double), 2e-4 (square and fine), in docs/creep-tables.md.
RECIPES = {
    recipe.name: recipe
    for recipe in (
        Recipe("double", (36, 72), 2, 1),
        Recipe("square", (101, 201), 1, 1),
        Recipe("fine", (30, 45, 72, 108), 2, 2),
    )
}
FALLBACK = Recipe("fallback", (25, 50), 1, 1)  #: For nodes whose solves have not converged.


def recipe_named(name: str, grids: tuple[int, int] | None) -> Recipe:
    """Returns a recipe, with other grids if they are given. Raises click.UsageError."""
    if name not in RECIPES:
        raise click.UsageError(f"--recipe is {name!r}; it must be {', '.join(RECIPES)}.")
    recipe = RECIPES[name]
    if grids is None or grids == recipe.grids:
        return recipe
    if not 4 <= grids[0] < grids[1] <= 500 or len(recipe.grids) != 2:
        raise click.UsageError(
            f"--grids is {list(grids)}; it must be two ascending numbers between 4 and 500, for double or square."
        )
    return replace(recipe, grids=grids)
