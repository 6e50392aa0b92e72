"""Compares a table of creep forces with solves of random states."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from contactd import Client

from .extension import read_table
from .nodes import Reals, extrapolated
from .plan import recipe_of

__all__ = ["check_table", "random_states"]

_BATCH = 200  #: Number of states between reports.


def random_states(points: int, seed: int, ratios: tuple[float, float], scales: Callable[[Reals], Reals]) -> Reals:
    """Returns rows of a/b and scaled creepages, by a/b: uniform in log(a/b), in the direction of (X, Y, S), and in the
    logarithm of their length from 0.02 to 25; a quarter has no spin. `scales` returns the creepages of full slip.
    """
    draw = np.random.default_rng(seed)
    ratio = np.sort(np.exp(draw.uniform(math.log(ratios[0]), math.log(ratios[1]), points)))
    direction = draw.normal(size=(points, 3))
    direction[draw.random(points) < 0.25, 2] = 0
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    length = np.exp(draw.uniform(math.log(0.02), math.log(25), points))
    return np.column_stack([ratio, length[:, None] * direction * scales(ratio)])


def check_table(
    client: Client, path: Path, given: float | None, points: int, seed: int, grids: tuple[int, int], show: Callable[[float, str], None]
) -> dict[str, Any]:
    """Returns the errors of (Fx, Fy)/(mu Fn) and of Mz/(mu Fn c), and where the first is largest."""
    nu, described, _ = read_table(path, given, np.empty((0, 4)))
    states = random_states(points, seed, tuple(described["ratios"]), lambda ratio: _full_slip(ratio, nu))
    table = read_table(path, nu, states)[2]
    errors, unconverged = np.empty_like(table), 0
    for first in range(0, points, _BATCH):
        part = slice(first, first + _BATCH)
        forces, converged = extrapolated(client, states[part], nu, grids, square=True)
        errors[part], unconverged = np.abs(table[part] - forces), unconverged + int((~converged).sum())
        show(min(first + _BATCH, points) / points, f"{min(first + _BATCH, points)} of {points} states")
    of_forces, of_moment = errors[:, :2].max(axis=1), errors[:, 2]
    return {
        "nu": nu, "points": points, "seed": seed, "elements": [[n, n] for n in grids], "table": recipe_of(tuple(n for n, _ in described["recipe"]["elements"])),
        "errors": {"Fx, Fy": _spread(of_forces), "Mz": _spread(of_moment)}, "unconverged": unconverged, "worst": states[of_forces.argmax()].tolist(),
    }  # fmt: skip


def _spread(errors: Reals) -> dict[str, float]:
    ninety, ninety_nine = np.quantile(errors, [0.9, 0.99])
    return {"mean": float(errors.mean()), "90 %": float(ninety), "99 %": float(ninety_nine), "largest": float(errors.max())}


def _full_slip(ratio: Reals, nu: float) -> Reals:
    """Returns the creepages of full slip, which only scale the random states here."""
    a = np.sqrt(ratio)[:, None]
    t = np.pi * (np.arange(512) + 0.5) / 512
    square = a**2 * np.cos(t) ** 2 + np.sin(t) ** 2 / a**2
    weight, share = np.sin(t) ** 2 / np.sqrt(square), nu * a**2 * np.cos(t) ** 2 / square
    xi, eta = (1.5 / a[:, 0] * (part * weight).mean(axis=1) for part in (1 - nu + share, 1 - share))
    return np.column_stack([xi, eta, 1 / np.hypot(1 / (a[:, 0] * xi), a[:, 0] / eta)])
