"""Measures discretisation errors: prints the tables of docs/contact.md, "How fine a grid, how long a step".

    CONTACTD_BIN=build/production/bin PYTHONPATH=client/python python3 bench/discretisation.py       (about a minute)

Normal contact: steel half-spaces, ellipses with a/b from 1/4 to 4 at a prescribed approach, on grids in nine positions
relative to the centre of the ellipse. Errors are relative to Hertz's closed form (model="hertz").

Rolling: a/b = 0.3, 1 and 3, with a small longitudinal or lateral creepage and no slip, so that the force is Kalker's
linear one. Errors are relative to its limit, extrapolated from 80 and 160 elements across. A second table has
creepages whose force is about half of mu Fn, with errors over mu Fn. The last has oblique directions, with two
definitions of the element size along them.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from contactd import (
    Client,
    ContactProblem,
    ContactSolution,
    ContactWarning,
    Friction,
    Grid,
    LocalDaemon,
    Material,
    Rolling,
    SemiAxes,
)
from daemon_program import daemon_program

STEEL = Material(G=82_000, nu=0.28)
FN, SIZE = 50_000.0, 5.0  # N; sqrt(ab), mm
UNIT = 0.3 * FN / (STEEL.G * SIZE**2)  # creepage at which linear forces are of the size of mu Fn
ACROSS = (3, 4, 6, 8, 10, 12, 16, 25, 40, 60)
ROLLING_ACROSS = (6, 8, 10, 16, 25, 50, 100)
STEPS = (0.5, 1, 2, 3, 5, 10, 30)  # elements


def solved(client: Client, problems: Sequence[ContactProblem]) -> list[ContactSolution]:
    solutions: list[ContactSolution] = []
    for first in range(0, len(problems), 16):
        for solution in client.solve_many(problems[first : first + 16], timeout=3600):
            if isinstance(solution, Exception):
                raise solution
            assert solution.converged, solution.evidence
            solutions.append(solution)
    return solutions


def semi_axes(ratio: float) -> SemiAxes:
    return SemiAxes(SIZE * math.sqrt(ratio), SIZE / math.sqrt(ratio))


def pressed(ratio: float, across: int, place: tuple[float, float]) -> ContactProblem:
    """Returns an ellipse with `across` elements per axis and its centre `place` elements from that of an element."""
    axes, n = semi_axes(ratio), 2 * math.ceil(0.6 * across + 1) + 1
    dx, dy = 2 * axes.a / across, 2 * axes.b / across
    grid = Grid(n, n, dx, dy, -(0.5 * n + place[0]) * dx, -(0.5 * n + place[1]) * dy)
    return ContactProblem(grid=grid, upper=STEEL, gap=axes, approach=0.065)


def normal_contact(client: Client) -> None:
    print("| elements across | error of Fn: median, largest | error of pmax: median, largest |\n|---|---|---|")
    cases = list(product((0.25, 0.5, 1, 2, 4), product((0, 0.25, 0.5), repeat=2)))
    for across in ACROSS:
        problems = [pressed(ratio, across, place) for ratio, place in cases]
        exact = solved(client, [problem.replace(model="hertz") for problem in problems])
        found = solved(client, problems)
        cells = []
        for name in ("Fn", "pmax"):
            errors = [abs(getattr(f, name) / getattr(e, name) - 1) for f, e in zip(found, exact)]
            cells.append(f"{np.median(errors):.2%}, {max(errors):.2%}")
        print(f"| {across} |", " | ".join(cells), "|", flush=True)


def rolls(ratio: float, across: int, steps: float, lateral: bool, creepage: float, mu: float) -> ContactProblem:
    axes, n = semi_axes(ratio), 2 * math.ceil(0.55 * across) + 1
    dx, dy = 2 * axes.a / across, 2 * axes.b / across
    rolling = Rolling(dq=steps * dx, eta=creepage) if lateral else Rolling(dq=steps * dx, xi=creepage)
    friction = Friction(mu=mu, rolling=rolling)
    return ContactProblem(grid=Grid(n, n, dx, dy), upper=STEEL, gap=semi_axes(ratio), Fn=FN, friction=friction)


def rolling(client: Client, creepage: float, mu: float) -> None:
    cases = list(product((0.3, 1, 3), (False, True)))  # a/b, lateral

    def forces(across: int, steps: float) -> list[float]:
        answers = solved(client, [rolls(ratio, across, steps, lateral, creepage, mu) for ratio, lateral in cases])
        return [s.Fy if lateral else s.Fx for s, (_, lateral) in zip(answers, cases)]

    limits = [2 * fine - coarse for coarse, fine in zip(forces(80, 1), forces(160, 1))]
    scales = [min(abs(limit), mu * FN) if mu > 1 else mu * FN for limit in limits]
    print("| elements across |", " | ".join(f"{steps:g}" for steps in STEPS), "|\n|---|" + "---|" * len(STEPS))
    for across in ROLLING_ACROSS:
        cells = []
        for steps in STEPS:
            errors = [abs(force - limit) / scale for force, limit, scale in zip(forces(across, steps), limits, scales)]
            cells.append(f"{max(errors):.1%}")
        print(f"| {across} |", " | ".join(cells), "|", flush=True)
    print("forces of the limit over mu Fn:", *(f"{abs(limit) / (mu * FN):.2g}" for limit in limits))


def oblique(client: Client) -> None:
    """Compares two element sizes along an oblique chi: the chord of the element's ellipse, and that of the element."""
    print("| elements across | ellipse | longest way through the element |\n|---|---|---|")
    cases = list(product((0.3, 1, 3), (0.2, math.pi / 6, math.pi / 4, 1.2), (False, True)))  # a/b, chi, lateral

    def forces(across: int, longest_way: bool) -> list[float]:
        problems = []
        for ratio, chi, lateral in cases:
            problem = rolls(ratio, across, 1, lateral, 1e-6, 1000)
            along_x, along_y = problem.grid.dx / math.cos(chi), problem.grid.dy / math.sin(chi)
            dq = min(along_x, along_y) if longest_way else None
            assert problem.friction is not None and problem.friction.rolling is not None
            motion = replace(problem.friction.rolling, chi=chi, dq=dq)
            problems.append(problem.replace(friction=Friction(mu=1000, rolling=motion)))
        return [s.Fy if lateral else s.Fx for s, (_, _, lateral) in zip(solved(client, problems), cases)]

    limits = [2 * fine - coarse for coarse, fine in zip(forces(80, False), forces(160, False))]
    for across in (10, 16, 25, 50):
        means = [np.mean([abs(f / limit - 1) for f, limit in zip(forces(across, way), limits)]) for way in (False, True)]
        print(f"| {across} |", " | ".join(f"{mean:.1%}" for mean in means), "|", flush=True)


def main() -> None:
    warnings.simplefilter("ignore", ContactWarning)  # coarse elements are measured on purpose
    with LocalDaemon(daemon_program()) as daemon, Client(daemon.endpoint) as client:
        normal_contact(client)
        print("\nLargest error of the force of a small creepage, for dq in elements:\n")
        rolling(client, 1e-6, 1000)
        print("\nLargest error over mu Fn where some of the contact slips, for dq in elements:\n")
        rolling(client, 0.15 * UNIT, 0.3)
        print("\nMean error of the force of a small creepage along and across oblique directions, by the dq of an element:\n")
        oblique(client)


if __name__ == "__main__":
    main()
