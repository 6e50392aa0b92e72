"""Fits a layer and falling friction to a creep curve with noise, and draws the picture of docs/friction.md. The curve
is synthetic, not measured: this program computes it from known parameters.

Run: friction_fit.py PICTURE; needs contactd-local, matplotlib and scipy.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

import contactd
from contactd import (
    ContactProblem,
    Fit,
    Friction,
    FrictionMemory,
    Grid,
    InterfacialLayer,
    KineticFriction,
    Material,
    Paraboloid,
    Rolling,
)

SPEED, NOISE = 8000.0, 0.006
MEMORY = FrictionMemory(distance=0.04, least_velocity=1)
CREEPAGES = np.concatenate([np.linspace(4e-4, 4e-3, 10), np.geomspace(5e-3, 0.05, 12)])
#: Field, true value, and bounds.
PARAMETERS = {
    "friction.mu": (0.35, (0.2, 0.6)),
    "friction.kinetic.mu": (0.15, (0.02, 0.2)),
    "friction.kinetic.slip_velocity": (90, (20, 1000)),
    "friction.layer.flexibility": (3e-5, (1e-6, 1e-3)),
}


def problem(xi: float = 0.0, mu: float = 0.3, kinetic: float = 0.1, slip_velocity: float = 200.0, flexibility: float = 1e-5) -> ContactProblem:
    """Returns a wheel on a rail; without arguments, the start of a search."""
    grid = Grid.centred(25, 25, 12.5, 10.5)
    friction = Friction(
        mu, rolling=Rolling(xi=xi, dq=grid.dx, velocity=SPEED), layer=InterfacialLayer(flexibility),
        kinetic=KineticFriction(kinetic, slip_velocity, memory=MEMORY),
    )  # fmt: skip
    return ContactProblem(grid, Material(82000, 0.28), Paraboloid(460, 300), Fn=30000, friction=friction)


def measured(client: contactd.Client) -> np.ndarray:
    """Returns traction coefficients with noise."""
    values = [value for value, _ in PARAMETERS.values()]
    answers = client.solve_many([problem(float(xi), *values) for xi in CREEPAGES], fields=[])
    coefficients = [-answer.Fx / answer.Fn for answer in answers if not isinstance(answer, contactd.StatusError)]
    return np.array(coefficients) + np.random.default_rng(4).normal(0, NOISE, len(CREEPAGES))


def fitted(client: contactd.Client) -> Fit:
    bounds = {path: bounds for path, (_, bounds) in PARAMETERS.items()}
    between = np.concatenate([np.linspace(0, 6e-3, 31), np.linspace(7e-3, 0.05, 44)])
    return contactd.fit(client, problem(), CREEPAGES, measured(client), bounds, curve=between)


def main() -> None:
    if len(sys.argv) != 2:
        raise SystemExit("usage: friction_fit.py PICTURE")
    with contactd.local() as client:
        found = fitted(client)
    for path, (right, _) in PARAMETERS.items():
        one = found[path]
        print(f"{path:32} {one.value:.4g} +- {one.standard_error:.2g}, made with {right:g}")
    print(f"rms {found.rms:.4f}, {found.solves} solves; {' '.join(found.warnings)}")
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained", sharey=True)
    for part in axes:
        found.plot(part)
    axes[0].set(xlim=(0, 6e-3), title="small creepage")
    axes[1].set(title="large creepage", ylabel="")
    axes[0].get_legend().remove()
    axes[1].get_legend().get_texts()[-1].set_text("made, with noise")
    figure.savefig(sys.argv[1], dpi=110)


if __name__ == "__main__":
    main()
