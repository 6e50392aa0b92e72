"""Draws the pictures of docs/track.md from its examples.

Run: track_pictures.py FOLDER. It solves in process and needs matplotlib.
"""

import re
import sys
from pathlib import Path
from typing import Any

import numpy as np

from contactd.pictures.canvas import new_figure
from contactd.pictures.track import plot_peaks, plot_receptances, plot_spectra

PAGE = Path(__file__).parents[3] / "docs" / "track.md"


def results_of_page() -> dict[str, Any]:
    """Returns the variables of the examples."""
    names: dict[str, Any] = {}
    for example in re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(example, str(PAGE), "exec"), names)
    return names


def draw(names: dict[str, Any], folder: Path) -> None:
    figures = {}
    for name in ("receptance", "spectrum", "flat"):
        figures[name] = new_figure(6.4, 4)
    receptances = plot_receptances(names["ring"], {"over a sleeper": 0.0, "mid-span": 0.3}, np.geomspace(20, 3000, 400), figures["receptance"].subplots())
    receptances.set_title("Receptance of the example track R1")
    runs = {"contact solves": names["rough"], "Hertz, unfiltered": names["unfiltered"]}
    spectra = plot_spectra(runs, figures["spectrum"].subplots(), 100, 4000, 0.04)
    spectra.set_title("Force of a wheel at 30 m/s")
    peaks = {f"{shape} flat of 50 mm": values for shape, values in names["peaks"].items()}
    flats = plot_peaks(names["speeds"], peaks, figures["flat"].subplots())
    flats.axhline(names["wheel"].load / 1e3, color="0.6", linewidth=0.8)
    flats.set_title("Largest force; the line is the static load")
    for name, figure in figures.items():
        figure.savefig(folder / f"track-{name}.png", dpi=110)


def main() -> None:
    if len(sys.argv) != 2:
        raise SystemExit("usage: track_pictures.py FOLDER")
    draw(results_of_page(), Path(sys.argv[1]))


if __name__ == "__main__":
    main()
