"""Draws creep curves with non-Coulomb friction for docs/friction.md: an elastic layer, a plastic layer, falling
friction, and friction with memory.

Run: friction_curves.py PICTURE; needs contactd-local and matplotlib.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

import contactd
from contactd import (
    ContactProblem,
    Friction,
    FrictionMemory,
    Grid,
    InterfacialLayer,
    KineticFriction,
    Material,
    Paraboloid,
    Rolling,
)

MU, SPEED = 0.35, 8000.0
CREEPAGES = np.concatenate([np.linspace(0, 5e-3, 21), np.geomspace(6e-3, 0.05, 14)])
FALLING = KineticFriction(mu=0.15, slip_velocity=90)
KINDS: dict[str, Friction] = {
    "Coulomb": Friction(MU, rolling=Rolling()),
    "elastic layer": Friction(MU, rolling=Rolling(), layer=InterfacialLayer(4e-5)),
    "layer that flows and hardens": Friction(MU, rolling=Rolling(), layer=InterfacialLayer(4e-5, 120, 3000)),
    "layer that flows": Friction(MU, rolling=Rolling(), layer=InterfacialLayer(4e-5, 120)),
    "falling": Friction(MU, rolling=Rolling(), kinetic=FALLING),
    "falling, with memory": Friction(
        MU, rolling=Rolling(), kinetic=KineticFriction(0.15, 90, memory=FrictionMemory(0.05, 1))
    ),
}


def curve(client: contactd.Client, friction: Friction) -> list[float]:
    """Returns -Fx over mu Fn at each creepage."""
    grid = Grid.centred(25, 25, 12.5, 10.5)
    found = []
    for xi in CREEPAGES:
        rolling = Rolling(xi=float(xi), dq=grid.dx, velocity=SPEED)
        problem = ContactProblem(
            grid, Material(82000, 0.28), Paraboloid(460, 300), Fn=30000,
            friction=Friction(MU, rolling=rolling, kinetic=friction.kinetic, layer=friction.layer),
        )  # fmt: skip
        solution = client.solve(problem)
        found.append(-solution.Fx / (MU * solution.Fn))
    return found


def main() -> None:
    if len(sys.argv) != 2:
        raise SystemExit("usage: friction_curves.py PICTURE")
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained", sharey=True)
    with contactd.local() as client:
        for name, friction in KINDS.items():
            forces = curve(client, friction)
            for part in axes:
                part.plot(1e3 * CREEPAGES, forces, label=name)
    axes[0].set(xlim=(0, 5), xlabel="longitudinal creepage (1e-3)", ylabel="force / (mu Fn)", title="small creepage")
    axes[1].set(xlim=(0, 50), xlabel="longitudinal creepage (1e-3)", title="large creepage")
    axes[1].legend(frameon=False)
    for part in axes:
        part.spines[["top", "right"]].set_visible(False)
    figure.savefig(sys.argv[1], dpi=110)


if __name__ == "__main__":
    main()
