"""Writes files of worn profiles, and draws pictures of their wear."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from contactd import Client, InvalidArgument
from contactd.files.marks import written_by
from contactd.files.profile_text import format_profile
from contactd.pictures.wear import draw_competition, draw_depths, draw_groups, draw_measures, draw_shakedown, draw_worn
from contactd.wear import Section, WearStudy, WornStep, conicities, rail_wear, wheel_gauge
from contactd.wear.evolution import place_of

from ..files import check_own, write_text
from ..writing.drawing import save_animation, save_picture

__all__ = ["Measures", "check_folders", "measured", "totals_of", "write_pictures", "write_profiles"]

Measures = dict[str, list[float]]  #: Measures: a list with a number per step.

_GROUPS = {"conicity": ("conicity at 3 mm", "conicity at 5 mm"), "flange": ("Sh", "Sd", "qR"), "head": ("W1", "W2", "W3")}
_MOST = 25  #: Largest number of steps with conicities.
_FRAMES = 40  #: Number of frames of an animation.


def check_folders(profiles: Path | None, pictures: Path | None) -> None:
    """Checks before a solve. Raises click.UsageError for existing files that another program has written."""
    for option, folder, stems, endings in (
        ("--profiles", profiles, ("wheel", "rail"), (".prw", ".prr", ".whl", ".ban")),
        ("--pictures", pictures, ("wheel-", "rail-", *_GROUPS, "measures"), (".png", ".gif", ".json")),
    ):
        for path in sorted(folder.iterdir()) if folder is not None and folder.is_dir() else ():
            if path.suffix in endings and path.name.startswith(stems):
                check_own(option, path)


def write_profiles(folder: Path, study: WearStudy, steps: Sequence[WornStep]) -> list[Path]:
    """Writes the last profiles as Simpack and MiniProf files."""
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    last = steps[-1]
    for part in study.parts:
        points = last.of(part).points
        laws = ", ".join(f"{law['name']} ({law['source']})" for law in study.law_params())
        remarks = [f"{written_by()}: {part} after {last.distance:.9g} {study.unit}, by {laws}"]
        for ending in (".prw", ".whl") if part == "wheel" else (".prr", ".ban"):
            written.append(folder / f"{part}{ending}")
            write_text(written[-1], format_profile(points, part, ending, remarks))
    return written


def measured(client: Client, study: WearStudy, steps: Sequence[WornStep]) -> Measures:
    """Returns conicities and gauge dimensions of up to 25 steps; `distance` contains their distances."""
    place = place_of(client, study)
    chosen = [steps[i] for i in np.unique(np.linspace(0, len(steps) - 1, min(len(steps), _MOST)).round().astype(int))]
    found: Measures = {"distance": [step.distance for step in chosen]}
    back = float(study.setup_params().get("wheelset", {}).get("flange_back_position", -70.0))
    for step in chosen:
        at_3, at_5 = _or_nan(lambda step=step: conicities(client, study, place, step), 2)
        numbers = {"conicity at 3 mm": at_3, "conicity at 5 mm": at_5}
        if "wheel" in study.parts:
            gauge = _or_nan(lambda step=step: vars(wheel_gauge(step.of("wheel").points, back)).values(), 3)
            numbers.update(zip(("Sh", "Sd", "qR"), gauge))
        if "rail" in study.parts:
            new = steps[0].of("rail").points
            worn = _or_nan(lambda step=step, new=new: vars(rail_wear(new, step.of("rail").points)).values(), 3)
            numbers.update(zip(("W1", "W2", "W3"), worn))
        for name, number in numbers.items():
            found.setdefault(name, []).append(float(number))
    return found


def totals_of(study: WearStudy, steps: Sequence[WornStep]) -> dict[str, dict[str, float]]:
    """Returns the total wear of all steps by bodies: the largest depth (mm), its position on the new profile (y, mm),
    and the area (mm^2). The depth is the distance of the worn profile from the new one.
    """
    found: dict[str, dict[str, float]] = {}
    for part in study.parts:
        new, last = steps[0].of(part), steps[-1].of(part)
        depths = Section(new.points, part).depths_to(Section(last.points, part))
        deepest = int(depths.argmax())
        found[part] = {"depth": float(depths[deepest]), "y": float(new.points[deepest, 0]), "area": last.area}
    return found


def _or_nan(tell: Any, count: int) -> list[float]:
    """Returns NaN if a profile is too short."""
    try:
        return list(tell())
    except InvalidArgument:
        return [float("nan")] * count


def write_pictures(folder: Path, study: WearStudy, steps: Sequence[WornStep], measures: Measures) -> list[Path]:
    """Draws worn and new profiles, depths, groups, conicity and gauges against the distance, an animation, and with
    fatigue the shakedown diagram and cracks against wear. Needs matplotlib.
    """
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib.figure import Figure

    folder.mkdir(parents=True, exist_ok=True)
    written: list[Path] = []

    def picture(name: str, draw: Any, width: float = 7.0, height: float = 4.2) -> None:
        figure = Figure(figsize=(width, height), layout="constrained")
        draw(figure.subplots())
        save_picture(folder / name, figure, dpi=120)
        written.append(folder / name)

    for part in study.parts:
        own = [step.of(part) for step in steps]
        picture(f"{part}-worn.png", lambda axes, own=own: draw_worn(axes, own, _magnified(own), study.unit))
        picture(f"{part}-depths.png", lambda axes, own=own: draw_depths(axes, own, study.unit))
        picture(f"{part}-groups.png", lambda axes, own=own: draw_groups(axes, own, study.unit))
        _animate(folder / f"{part}-wear.gif", own, study.unit)
        written.append(folder / f"{part}-wear.gif")
        if study.tired_part != part or len(own) < 2 or own[1].fatigue is None:
            continue
        for function in own[1].fatigue.damages:
            name = "".join(c if c.isalnum() else "-" for c in function)
            picture(f"{part}-damage-{name}.png", lambda axes, own=own, function=function: draw_competition(axes, own, function))
        if not np.isnan(own[1].fatigue.contacts[:, 1:3]).all():
            picture(f"{part}-shakedown.png", lambda axes, own=own: draw_shakedown(axes, own))
    labels = {"conicity": "equivalent conicity", "flange": "change (mm)", "head": "mm"}
    for name, members in _GROUPS.items():
        values = {member: measures[member] for member in members if member in measures}
        if name == "flange":  # the profile changes too little for its own scale
            values = {f"{member}, {numbers[0]:.2f} new": [number - numbers[0] for number in numbers] for member, numbers in values.items()}
        if values:
            picture(f"{name}.png", lambda axes, values=values, name=name: draw_measures(axes, measures["distance"], values, study.unit, labels[name]))
    write_text(folder / "measures.json", json.dumps(measures, indent=1))
    return written


def _magnified(steps: Sequence[WornStep]) -> float:
    """Returns the scale that makes small depths some millimetres in the picture."""
    largest = float(sum(step.depths.max() for step in steps[1:]))
    return next((factor for factor in (1, 2, 5, 10, 20, 50) if largest * factor >= 2), 100)


def _animate(path: Path, steps: Sequence[WornStep], unit: str) -> None:
    from matplotlib.animation import FuncAnimation, PillowWriter
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, 4.2), dpi=90, layout="constrained")
    FigureCanvasAgg(figure)
    axes, magnified = figure.subplots(), _magnified(steps)
    frames = np.unique(np.linspace(1, len(steps) - 1, min(len(steps) - 1, _FRAMES)).round().astype(int))

    def frame(last: int) -> list[Any]:
        axes.clear()
        draw_worn(axes, steps[: last + 1], magnified, unit)
        return []

    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "wear.gif"
        FuncAnimation(figure, frame, frames=[int(i) for i in frames], init_func=list).save(made, writer=PillowWriter(fps=8))
        save_animation(path, made.read_bytes())
