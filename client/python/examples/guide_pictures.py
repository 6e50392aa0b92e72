"""Draws the pictures of docs/contact.md from its examples.

Run: guide_pictures.py FOLDER [ENDPOINT]. Without an endpoint it starts its own daemon (`contactd` on PATH). Needs
matplotlib.
"""

import re
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

import contactd
from contactd import Client

GUIDE = Path(__file__).parents[3] / "docs" / "contact.md"


def results_of_guide(client: Client) -> dict[str, Any]:
    """Returns the variables of the examples, run one after the other."""
    names: dict[str, Any] = {"client": client}
    for example in re.findall(r"^```python\n(.*?)^```", GUIDE.read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(example, str(GUIDE), "exec"), names)
    return names


def bare_axes(axes: Any, title: str, x: str, y: str) -> None:
    axes.set(title=title, xlabel=x, ylabel=y)
    axes.spines[["top", "right"]].set_visible(False)


def draw_cattaneo(names: dict[str, Any], path: Path) -> None:
    problem, there, back = names["sphere"], names["shifted"], names["back"]
    x, row, mu = problem.grid.x, problem.grid.ny // 2, 0.4
    y = problem.grid.y[row]
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    fine = np.linspace(-1.2, 1.2, 481)
    pmax = there.pmax

    def ellipsoid(radius: float) -> Any:
        return pmax * radius * np.sqrt(np.maximum(1 - (fine**2 + y**2) / radius**2, 0))

    held = np.cbrt(1 + there.Fx / (mu * there.Fn))
    axes.plot(fine, mu * ellipsoid(1), color="0.6", label="bound, mu p")
    axes.plot(fine, mu * (ellipsoid(1) - ellipsoid(held)), color="C0", label="closed form")
    axes.plot(x, -there.traction_x[row], "o", ms=3, color="C0", label="shifted")
    axes.plot(x, -back.traction_x[row], "s", ms=3, color="C1", label="and back")
    axes.plot(fine, -mu * ellipsoid(1), color="0.6")
    bare_axes(axes, "", "x (mm)", "traction opposite to the shift (N/mm$^2$)")
    axes.legend(frameon=False, loc="upper left", bbox_to_anchor=(1, 1))
    figure.savefig(path, dpi=130)


def draw_carter(names: dict[str, Any], path: Path) -> None:
    problem, solutions, middle = names["cylinder"], names["carter"], 0
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.2, 4), layout="constrained")
    scale = 0.3 * names["P"]
    creepages = names["creepages"] / names["full_slip"]
    fine = np.linspace(0, creepages[-1], 200)
    left.plot(fine, 1 - np.maximum(1 - fine, 0) ** 2, color="C0", label="Carter")
    left.plot(creepages, -names["force"] / scale, "o", color="C1", label="contactd")
    bare_axes(left, "Force", "creepage / creepage of full slip", "force / (mu P)")
    left.legend(frameon=False)
    for shown, color in zip((1, 4, 7), ("C0", "C1", "C2")):
        traction, label = -solutions[shown].traction_x[middle], f"xi = {creepages[shown]:.2f} xi_full"
        right.plot(problem.grid.x, traction, ".-", color=color, lw=1, ms=4, label=label)
    right.plot(problem.grid.x, 0.3 * solutions[0].pressure[middle], color="0.6", label="bound, mu p")
    bare_axes(right, "Tractions of three creepages", "x (mm); rolling to the right", "-p_x (N/mm$^2$)")
    right.legend(frameon=False, loc="upper left", bbox_to_anchor=(1, 1))
    figure.savefig(path, dpi=130)


def draw_wheel(names: dict[str, Any], path: Path) -> None:
    problem, solution = names["wheel"], names["rolling"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    grid = problem.grid
    division = np.where(solution.element_division == 1, 0.8, np.where(solution.element_division == 2, 0.95, 1.0))
    left.pcolormesh(grid.x, grid.y, division, cmap="gray", vmin=0, vmax=1)
    every = (slice(None, None, 3), slice(None, None, 3))
    inside = (solution.element_division != 0)[every]
    x, y = np.meshgrid(grid.x, grid.y)
    left.quiver(
        x[every][inside], y[every][inside], solution.traction_x[every][inside], solution.traction_y[every][inside],
        color="C0", width=0.003,
    )  # fmt: skip
    left.set_aspect("equal")
    bare_axes(left, "Tractions on the wheel; dark grey adheres", "x (mm); rolling to the right", "y (mm)")
    for solutions, style, label in ((names["full"], "o-", "full"), (names["fastsim"], "--", "fastsim")):
        right.plot(1e3 * names["curve"], [-s.Fx / 1e3 for s in solutions], style, color="C0", ms=4, label=f"-Fx, {label}")
        right.plot(1e3 * names["curve"], [-s.Fy / 1e3 for s in solutions], style, color="C1", ms=4, label=f"-Fy, {label}")
    bare_axes(right, "Spin 2e-4 rad/mm, eta = 0", "longitudinal creepage (1e-3)", "force on the rail (kN)")
    right.legend(frameon=False)
    figure.savefig(path, dpi=130)


def main() -> None:
    if not sys.argv[1:]:
        raise SystemExit("usage: guide_pictures.py FOLDER [ENDPOINT]")
    folder = Path(sys.argv[1])
    with ExitStack() as stack:
        names = results_of_guide(stack.enter_context(Client(sys.argv[2], timeout=120) if sys.argv[2:] else contactd.local()))
    draw_cattaneo(names, folder / "contact-cattaneo.png")
    draw_carter(names, folder / "contact-carter.png")
    draw_wheel(names, folder / "contact-wheel.png")


if __name__ == "__main__":
    main()
