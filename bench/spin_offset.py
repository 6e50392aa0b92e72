"""Compares places for the evaluation of the rigid slip of spin: errors of Fx, Fy and Mz in steady rolling on coarse
grids, with spin evaluated at the element centres (spin_offset 0) and ahead of them, relative to the limit of fine
grids.

    CONTACTD_BIN=build/production/bin PYTHONPATH=client/python python3 bench/spin_offset.py      (about a minute)
        [--offsets 0 1/6 ...] [--cases 96] [--csv FILE]

Steel, semi-axes with sqrt(ab) = 5 mm, Fn = 50 kN, mu = 0.3, n x n elements over 1.1 times the ellipse's box, the
default dq. 96 cases, drawn with a fixed seed: a/b from 1/4 to 4, creepages and spin of both signs from a tenth of
those of full slip up to nearly full slip, chi along the axes and oblique, nu from 0 to 0.45, n from 15 to 50. The
error of a case is

    e = sqrt(dFx^2 + dFy^2 + dMz^2/(ab)) / (mu Fn),

so that forces near zero do not dominate. Limits are extrapolated from n = 96 and 192 (the error falls with the element
size), for each offset separately. Their difference shows the accuracy of the limit, and is printed too.
"""

from __future__ import annotations

import argparse
import csv
import math
import random
import warnings
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import numpy.typing as npt

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

FN, MU, G, SIZE = 50_000.0, 0.3, 82_000.0, 5.0
UNIT = MU * FN / (G * SIZE**2)  # creepage at which linear forces are of the size of mu Fn
FINE = (96, 192)
Forces = npt.NDArray[np.float64]  # Fx, Fy, Mz/sqrt(ab), over mu Fn


@dataclass(frozen=True)
class Case:
    ratio: float  # a/b
    nu: float
    chi: float
    xi: float
    eta: float
    phi: float
    n: int

    def problem(self, n: int, offset: float) -> ContactProblem:
        a, b = SIZE * math.sqrt(self.ratio), SIZE / math.sqrt(self.ratio)
        rolling = Rolling(xi=self.xi, eta=self.eta, phi=self.phi, chi=self.chi, spin_offset=offset)
        return ContactProblem(
            grid=Grid.centred(n, n, 2.2 * a, 2.2 * b),
            upper=Material(G, self.nu),
            gap=SemiAxes(a, b),
            Fn=FN,
            friction=Friction(mu=MU, rolling=rolling),
        )


def cases(number: int) -> list[Case]:
    """Returns cases that alternate four kinds of creepage and five grids, in every combination."""
    dice = random.Random(1990)
    kinds = [(0, 0), (1, 0), (0, 1), (1, 1)]  # whether there is a longitudinal and a lateral creepage
    result = []
    for k in range(number):
        longitudinal, lateral = kinds[k % 4]
        creepage = [which * dice.choice((-1, 1)) * dice.uniform(0.05, 0.35) * UNIT for which in (longitudinal, lateral)]
        spin = dice.choice((-1, 1)) * 10 ** dice.uniform(-1, 0.3) * UNIT / SIZE
        chi = dice.choice((0, 0, math.pi / 2, math.pi, math.pi / 4, dice.uniform(0, 2 * math.pi)))
        ratio = 2 ** dice.choice((-2, -1, 0, 0, 1, 2))
        result.append(Case(ratio, dice.choice((0.0, 0.28, 0.45)), chi, *creepage, spin, (15, 20, 25, 35, 50)[k % 5]))
    return result


def forces(client: Client, problems: list[ContactProblem]) -> list[Forces]:
    solutions: list[ContactSolution] = []
    for first in range(0, len(problems), 8):
        for solution in client.solve_many(problems[first : first + 8], timeout=3600):
            if isinstance(solution, Exception):
                raise solution
            assert solution.converged, solution.evidence
            solutions.append(solution)
    return [np.array([s.Fx, s.Fy, s.Mz / SIZE]) / (MU * FN) for s in solutions]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--offsets", nargs="+", type=lambda text: float(Fraction(text)), default=[0.0, 1 / 6])
    parser.add_argument("--cases", type=int, default=96)
    parser.add_argument("--csv", help="write every case to this file, one per line")
    arguments = parser.parse_args()
    offsets, all_cases = arguments.offsets, cases(arguments.cases)
    warnings.simplefilter("ignore", ContactWarning)  # coarse elements are measured on purpose
    with LocalDaemon(daemon_program()) as daemon, Client(daemon.endpoint) as client:
        coarse = {o: forces(client, [case.problem(case.n, o) for case in all_cases]) for o in offsets}
        limits = []
        for offset in (offsets[0], offsets[-1]):
            once, twice = (forces(client, [case.problem(n, offset) for case in all_cases]) for n in FINE)
            limits.append([2 * fine - rough for rough, fine in zip(once, twice)])
    known = [float(np.linalg.norm(a - b)) for a, b in zip(*limits)]
    limit = [(a + b) / 2 for a, b in zip(*limits)]
    errors = {o: [np.abs(f - l) for f, l in zip(coarse[o], limit)] for o in offsets}
    total = {o: np.array([np.linalg.norm(e) for e in errors[o]]) for o in offsets}
    print(f"{len(all_cases)} cases; limits known to {np.median(known):.1e} (median), {max(known):.1e} (largest)")
    print("offset   mean of e   largest e   mean error of Fx, Fy, Mz/sqrt(ab), over mu Fn")
    for o in offsets:
        means = (f"{e:9.2e}" for e in np.mean(errors[o], 0))
        print(f"{o:6.3f}   {total[o].mean():9.2e}   {total[o].max():9.2e}  ", *means)
    first = total[offsets[0]]
    for o in offsets[1:]:
        ratio = total[o] / first
        worst, weighty = ratio.argmax(), total[o] > 1.3 * np.maximum(first, 0.01)
        mean = np.exp(np.log(ratio).mean())
        print(f"{o:.3f} against {offsets[0]:.3f}: better in {(ratio < 1).sum()}, mean ratio {mean:.2f}")
        print(f"    more than 1.3 times worse in {(ratio > 1.3).sum()}; the worst: {ratio[worst]:.2f} times,", end=" ")
        print(f"e = {total[o][worst]:.1e}")
        print(f"    more than 1.3 times worse than the larger of e and 1 % of mu Fn in {weighty.sum()}")
    for n in sorted({case.n for case in all_cases}):
        these = [i for i, case in enumerate(all_cases) if case.n == n]
        print(f"n = {n}:", *(f"{total[o][these].mean():.2e}" for o in offsets))
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            rows = csv.writer(file)
            names = [f"e {o:.4f}" for o in offsets]
            rows.writerow(["a/b", "nu", "chi", "xi", "eta", "phi", "n", *names, "limit known to"])
            for i, case in enumerate(all_cases):
                rows.writerow([*vars(case).values(), *(total[o][i] for o in offsets), known[i]])


if __name__ == "__main__":
    main()
