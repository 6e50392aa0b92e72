"""Draws the picture of docs/temperature.md from its example.

Run: temperature_picture.py FILE [ENDPOINT]. Without an endpoint it starts its own daemon (`contactd` on PATH). Needs
matplotlib.
"""

import re
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt

import contactd
from contactd import Client

PAGE = Path(__file__).parents[3] / "docs" / "temperature.md"


def results_of_page(client: Client) -> dict[str, Any]:
    """Returns the variables of the example."""
    names: dict[str, Any] = {"client": client}
    for example in re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(example, str(PAGE), "exec"), names)
    return names


def draw(names: dict[str, Any], path: Path) -> None:
    grid, row = names["wheel"].grid, names["wheel"].grid.ny // 2
    figure, (along, curves) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    along.plot(grid.x, names["warm"].upper_temperature[row], color="C3", label="both surfaces, from 0 degrees")
    along.plot(grid.x, names["met"].upper_temperature[row], color="C1", label="wheel, from 150 degrees")
    along.plot(grid.x, names["met"].lower_temperature[row], color="C0", label="rail, from 0 degrees")
    there = grid.x[names["sliding"].pressure[row] > 0]
    along.axvspan(there[0] - grid.dx / 2, there[-1] + grid.dx / 2, color="0.93", label="contact")
    along.set(title="Middle row, rolling to the right", xlabel="x (mm)", ylabel="temperature (degrees Celsius)")
    along.legend(frameon=False, fontsize="small")
    curves.plot(100 * names["creepages"], names["constant"], "o-", ms=4, label="Coulomb")
    curves.plot(100 * names["creepages"], names["fallen"], "s-", ms=4, label="falling with the temperature")
    curves.set(title="Traction curve", xlabel="longitudinal creepage (%)", ylabel="force over normal force")
    curves.set_ylim(0, 0.33)
    curves.legend(frameon=False, loc="lower right")
    for axes in (along, curves):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=130)


def main() -> None:
    if not sys.argv[1:]:
        raise SystemExit("usage: temperature_picture.py FILE [ENDPOINT]")
    with ExitStack() as stack:
        names = results_of_page(stack.enter_context(Client(sys.argv[2], timeout=120) if sys.argv[2:] else contactd.local()))
    draw(names, Path(sys.argv[1]))


if __name__ == "__main__":
    main()
