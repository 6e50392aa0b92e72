"""Draws the picture of docs/viscoelastic.md from its example.

Run: viscoelastic_picture.py FILE [ENDPOINT]. Without an endpoint it starts its own daemon (`contactd` on PATH). Needs
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

PAGE = Path(__file__).parents[3] / "docs" / "viscoelastic.md"


def results_of_page(client: Client) -> dict[str, Any]:
    """Returns the variables of the example."""
    names: dict[str, Any] = {"client": client}
    for example in re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(example, str(PAGE), "exec"), names)
    return names


def draw(names: dict[str, Any], path: Path) -> None:
    grid, a = names["grid"], names["a"]
    figure, (along, over) = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    for name, style in (("stiff", "--"), ("rolling", "-"), ("soft", ":")):
        solution, label = names[name], {"stiff": "elastic, G", "rolling": "viscoelastic, l = a", "soft": "elastic, G/(1 + f)"}[name]
        along.plot(grid.x, solution.pressure[0], style, label=label)
    along.set(title="Pressure, rolling to the right", xlabel="x (mm)", ylabel="pressure (N/mm$^2$)", ylim=(0, None))
    along.legend(frameon=False, fontsize="small")
    over.semilogx(names["lengths"] / a, [s.rolling_resistance.force / s.Fn for s in names["curve"]], "o-", ms=4)
    over.set(title="Rolling resistance", xlabel="l/a, way of creep over half-width", ylabel="resistance over normal force", ylim=(0, None))
    largest = over.twinx()
    largest.semilogx(names["lengths"] / a, [s.pmax for s in names["curve"]], "s--", ms=3, color="C1")
    largest.set_ylabel("largest pressure (N/mm$^2$)", color="C1")
    for axes in (along, over, largest):
        axes.spines["top"].set_visible(False)
    along.spines["right"].set_visible(False)
    figure.savefig(path, dpi=130)


def main() -> None:
    if not sys.argv[1:]:
        raise SystemExit("usage: viscoelastic_picture.py FILE [ENDPOINT]")
    with ExitStack() as stack:
        names = results_of_page(stack.enter_context(Client(sys.argv[2], timeout=120) if sys.argv[2:] else contactd.local()))
    draw(names, Path(sys.argv[1]))


if __name__ == "__main__":
    main()
