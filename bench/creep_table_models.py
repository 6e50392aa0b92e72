"""Compares models of rolling contact and tables of creep forces with the full theory: errors of forces on the same 200
random states, over mu Fn (moments: over mu Fn c, c^2 = ab).

    python3 bench/creep_table_models.py [--states 200] [--seed 6] [TABLE ...]      (about two minutes)
        (the packages contactd, contactctl and contactd_local on PYTHONPATH)

nu 0.28; a/b from 0.05 to 20, uniform in its logarithm; scaled creepages with uniform directions, and lengths from 0.02 to
25, uniform in their logarithm; a quarter without spin. The reference is the recipe `fine` of contactctl table build,
except in its rare states without convergence, which are left out. FASTSIM and FaStrip use 50 x 50 elements.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import numpy as np

import contactd
from contactctl.table.nodes import FN, MU, SIZE, UNIT, Bools, extrapolated, interpolated
from contactctl.table.plan import Reals, TablePlan
from contactctl.table.recipes import RECIPES
from contactd import ContactProblem, Friction, Grid, Material, Rolling, SemiAxes
from contactd.calls.answer_warnings import collected

NU = 0.28
#: Names, models, elements along and across, and spin offsets.
MODELS = (
    ("FASTSIM", "fastsim", 50, 0.0), ("FaStrip", "fastrip", 50, 0.0), ("Polach", "polach", 50, 0.0),
    ("full theory, 10 x 10", "full", 10, 1 / 6), ("full theory, 25 x 25", "full", 25, 1 / 6), ("full theory, 25 x 25, spin at the centres", "full", 25, 0.0),
)  # fmt: skip


def random_states(count: int, seed: int) -> Reals:
    """Returns rows of a/b and scaled creepages. Those with other signs are equivalent by symmetry."""
    draw = np.random.default_rng(seed)
    log_ratio = draw.uniform(math.log(0.05), math.log(20), count)
    X, Y, S = draw.normal(size=(3, count))
    S[draw.random(count) < 0.25] = 0
    p, q = 1.4 * np.exp(0.17 * log_ratio) * np.abs(X), 2 * Y  # the angles of tables
    u = 4 / math.pi * np.arctan(np.exp(draw.uniform(math.log(0.02), math.log(25), count)))
    points = np.column_stack([log_ratio, np.arctan2(np.hypot(p, S), q), np.arctan2(np.abs(S), p), u])
    return TablePlan((NU,), (0.05, 20.0), (4, 4, 4, 4), RECIPES["fine"]).states_at(points, NU)


def problem(state: Reals, model: str, n: int, offset: float) -> ContactProblem:
    ratio, xi, eta, phi = map(float, state)
    a, b = SIZE * math.sqrt(ratio), SIZE / math.sqrt(ratio)
    rolling = Rolling(xi=xi * UNIT, eta=eta * UNIT, phi=phi * UNIT / SIZE, spin_offset=offset if model == "full" else None)
    return ContactProblem(model=model, grid=Grid.centred(n, n, 2 * a, 2 * b), upper=Material(82_000.0, NU), gap=SemiAxes(a, b), Fn=FN,
                          friction=Friction(mu=MU, rolling=rolling))  # fmt: skip


def line(name: str, errors: Reals, no_spin: Bools) -> str:
    forces, moments = errors[:, :2].max(axis=1), errors[:, 2]
    numbers = [forces.max(), np.quantile(forces, 0.9), forces.mean(), forces[no_spin].max(), forces[no_spin].mean(), moments.max(), moments.mean()]
    return f"{name:42}" + "".join(f"{number:10.2g}" for number in numbers)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="*", type=Path, metavar="TABLE", help="files of tables to compare")
    parser.add_argument("--states", type=int, default=200, help="default %(default)s")
    parser.add_argument("--seed", type=int, default=6, help="default %(default)s")
    options = parser.parse_args()
    states = random_states(options.states, options.seed)
    with contactd.local(in_process=True) as client, collected():
        exact, converged = extrapolated(client, states, NU, RECIPES["fine"])
        no_spin = states[converged, 3] == 0
        print(f"{int(converged.sum())} states, {int(no_spin.sum())} without spin, seed {options.seed}")
        print(f"{'':42}" + "".join(f"{head:>10}" for head in ("F largest", "90 %", "mean", "no spin", "mean", "Mz", "mean")))
        for name, model, n, offset in MODELS:
            found = np.array([[-s.Fx, -s.Fy, -s.Mz / SIZE] for s in client.solve_many([problem(state, model, n, offset) for state in states])]) / (MU * FN)
            print(line(name, np.abs(found - exact)[converged], no_spin))
        for path in options.tables:
            print(line(path.name, np.abs(interpolated(contactd.CreepTable(path, NU), states) - exact)[converged], no_spin))


if __name__ == "__main__":
    main()
