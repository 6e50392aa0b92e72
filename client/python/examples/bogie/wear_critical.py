"""Computes the critical speed of the bogie against the distance run by its worn wheels. See docs/damage.md.

Run: python3 client/python/examples/bogie/wear_critical.py [--contact fastsim] [--between 40 120] FOLDER

FOLDER contains stage-000 and so on, each with wheel.prw and distance.txt, from a loop of dynamics and wear
(contactd.wear.dynamics). Every wheel of the bogie has the profile of the stage. The program writes critical.csv there:
distance (km), and the speed above which small motions grow (m/s). The speed is empty if they do not grow between both
speeds, or already at the lower one, which `growth_low` and `growth_high` (1/s) show. --picture FILE plots it.
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # for railway, which the examples share

from hunting import small_motions
from railway.stability import critical_speed
from runs import SETUPS

import contactd
from contactd import Client
from contactd.wheel_rail import ProfileFile


@dataclass(frozen=True)
class Stage:
    """Holds a worn profile, and the motion of the bogie on it."""

    distance: float
    critical: float | None
    growth_low: float
    growth_high: float


def stages_of(client: Client, folder: Path, contact: str, low: float, high: float, tolerance: float) -> list[Stage]:
    """Returns the stages. Raises SystemExit if the folder has none."""
    places = sorted(place for place in folder.glob("stage-*") if (place / "wheel.prw").is_file())
    if not places:
        raise SystemExit(f"{folder} has no stage-000 with a wheel.prw, as contactctl wear leaves it with dynamics.")
    found = []
    for place in places:
        distance = float((place / "distance.txt").read_text())
        found.append(_stage(small_motions(client, contact, ProfileFile(place / "wheel.prw")), distance, low, high, tolerance))
        critical = found[-1].critical
        written = f"{critical:.1f} m/s" if critical is not None else f"not between {low:g} and {high:g} m/s"
        print(f"{distance:g} km: critical speed {written}", flush=True)
    return found


def _stage(motions: Callable[[float], complex], distance: float, low: float, high: float, tolerance: float) -> Stage:
    growths = {low: motions(low).real, high: motions(high).real}

    def growth(speed: float) -> float:
        if speed not in growths:
            growths[speed] = motions(speed).real
        return growths[speed]

    hunts = growths[low] <= 0 < growths[high]
    return Stage(distance, critical_speed(growth, low, high, tolerance) if hunts else None, growths[low], growths[high])


def write(stages: list[Stage], path: Path) -> None:
    with path.open("w", newline="") as into:
        table = csv.writer(into, lineterminator="\n")
        table.writerow(["distance", "critical_speed", "growth_low", "growth_high"])
        for stage in stages:
            critical = "" if stage.critical is None else f"{stage.critical:.2f}"
            table.writerow([repr(stage.distance), critical, f"{stage.growth_low:.4f}", f"{stage.growth_high:.4f}"])


def draw(stages: list[Stage], contact: str, path: Path) -> None:
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    known = [stage for stage in stages if stage.critical is not None]
    figure, panel = plt.subplots(figsize=(6.5, 3.4), layout="constrained")
    panel.plot([stage.distance for stage in known], [stage.critical for stage in known], marker="o", color="tab:blue")
    panel.set(xlabel="distance (km)", ylabel="critical speed (m/s)", title=f"small motions, {contact}")
    panel.grid(alpha=0.3)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def main() -> None:
    parser = argparse.ArgumentParser(prog="wear_critical.py", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folder", type=Path, help="folder with stage-000 and so on, in which critical.csv is written")
    parser.add_argument("--contact", choices=SETUPS, default="fastsim", help="default: %(default)s")
    parser.add_argument("--between", type=float, nargs=2, metavar=("LOW", "HIGH"), default=(40.0, 120.0), help="speeds (m/s)")
    parser.add_argument("--tolerance", type=float, default=0.25, help="tolerance of the critical speed (m/s); default: %(default)g")
    parser.add_argument("--picture", type=Path, help="file of the picture, such as critical.png")
    options = parser.parse_args()
    low, high = options.between
    if not 0 < low < high:
        parser.error(f"--between: {low:g} and {high:g} m/s must be above 0, and the second above the first")
    if not options.tolerance > 0:
        parser.error(f"--tolerance is {options.tolerance:g}; it must be above 0")
    with contactd.local() as client:
        stages = stages_of(client, options.folder, options.contact, low, high, options.tolerance)
    write(stages, options.folder / "critical.csv")
    if options.picture is not None:
        draw(stages, options.contact, options.picture)


if __name__ == "__main__":
    main()
