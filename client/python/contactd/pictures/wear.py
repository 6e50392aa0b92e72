"""Draws worn profiles, the causes of wear, and the loads of profiles, on the caller's matplotlib axes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import invalid
from ..values.wheel_rail.passage_wear import PassageWear
from ..wear.section import Section
from .canvas import COLOURS, INK, axes_or_new, bare, plain

if TYPE_CHECKING:
    from ..wear.steps import WornStep

__all__ = ["draw_competition", "draw_depths", "draw_groups", "draw_measures", "draw_passage", "draw_shakedown", "draw_worn", "shakedown_limit"]

_WORN = "#c8553d"


def draw_worn(axes: Any, steps: Sequence[WornStep], magnified: float = 1.0, unit: str = "km") -> None:
    """Draws the new profile and that of the last step, and fills the removed area. `magnified` scales the depths."""
    first, last = _ends(steps)
    worn = np.stack([np.interp(_shares(first), _shares(last), column) for column in last.points.T], axis=1)
    shown = first.points + magnified * (worn - first.points)
    axes.fill(*np.concatenate([first.points, shown[::-1]]).T, color=_WORN, alpha=0.35, linewidth=0)
    axes.plot(*first.points.T, color=INK, linewidth=1.2, label="new")
    many = "" if magnified == 1 else f", wear {magnified:g} times as large"
    axes.plot(*shown.T, color=_WORN, linewidth=1.2, label=f"after {last.distance:g} {unit}{many}")
    axes.set_aspect("equal")
    axes.invert_yaxis()
    axes.set(xlabel="y (mm)", ylabel="z (mm)")
    axes.legend(frameon=False)


def draw_passage(wear: PassageWear, axes: Any = None) -> Any:
    """Implements PassageWear.plot."""
    axes = axes_or_new(axes)
    of_wheel = wear.body == "wheel"
    depths = wear.depths_per_km if of_wheel else wear.depths * 1e6
    axes.plot(wear.points[:, 0], 1000 * depths, color=_WORN)
    touched = wear.points[depths > 0, 0]
    if touched.size:
        margin = 0.5 * np.ptp(touched) + 1
        axes.set_xlim(touched.min() - margin, touched.max() + margin)
    after = "a km" if of_wheel else "a million passages"
    axes.set(xlabel=f"y of the {wear.body}'s profile (mm)", ylabel="depth (um)", title=f"Wear of the {wear.body} after {after}")
    axes.set_ylim(bottom=0)
    bare(axes)
    return axes


def draw_depths(axes: Any, steps: Sequence[WornStep], unit: str = "km", most: int = 6) -> None:
    """Plots the wear depth normal to the new profile against its y, for up to `most` steps."""
    first, _ = _ends(steps)
    chosen = [steps[i] for i in np.unique(np.linspace(1, len(steps) - 1, min(most, len(steps) - 1)).round().astype(int))]
    for i, step in enumerate(chosen):
        axes.plot(first.points[:, 0], _depths(first, step), color=_shade(i, len(chosen)), label=f"{step.distance:.4g} {unit}")
    axes.set(xlabel="y (mm)", ylabel="depth (mm)")
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False)


def draw_groups(axes: Any, steps: Sequence[WornStep], unit: str = "km") -> None:
    """Plots the area removed by each group of states against the distance. With many groups, small ones are summed."""
    sums = _sums_of_groups(steps)
    axes.stackplot([step.distance for step in steps], *sums.values(), labels=list(sums), colors=COLOURS[: len(sums)], alpha=0.75)
    axes.set(xlabel=unit, ylabel="worn area (mm$^2$)")
    axes.margins(x=0)
    axes.legend(loc="upper left", frameon=False)


def _sums_of_groups(steps: Sequence[WornStep]) -> dict[str, Any]:
    """Returns the removed area of groups up to each step, by their legend labels. If there are more groups than
    colours, it returns the largest ones and the sum of the others.
    """
    sums = {name: np.cumsum([step.groups.get(name, 0.0) for step in steps]) for name in {name for step in steps for name in step.groups}}
    by_size = sorted(sums, key=lambda name: (-sums[name][-1], name))
    few = by_size if len(by_size) <= len(COLOURS) else by_size[: len(COLOURS) - 1]
    shown = {plain(name) or "all": sums[name] for name in sorted(few)}
    if others := by_size[len(few) :]:
        shown[f"{len(others)} others"] = np.sum([sums[name] for name in others], axis=0)
    return shown


def draw_competition(axes: Any, steps: Sequence[WornStep], function: str) -> Any:
    """Plots cracks and wear against y: the damage of a function, summed over all steps, and the depth. Returns the
    second axes. Raises InvalidArgument if no step has such damage.
    """
    first, last = _ends(steps)
    y, sums = first.points[:, 0], np.zeros(len(first.points))
    found = False
    for step in steps[1:]:
        if step.fatigue is None or function not in step.fatigue.damages:
            continue
        found = True
        centres = 0.5 * (step.edges[1:] + step.edges[:-1]) / step.edges[-1]
        sums += np.interp(_shares(first), centres, step.fatigue.damages[function])
    if not found:
        raise invalid("steps", f"have no damage by {function}; request fatigue with this function")
    axes.fill_between(y, np.maximum(sums, 0), color=COLOURS[0], alpha=0.35, linewidth=0)
    axes.fill_between(y, np.minimum(sums, 0), color=COLOURS[2], alpha=0.35, linewidth=0)
    axes.plot(y, sums, color=COLOURS[0])
    axes.axhline(0, color=INK, linewidth=0.6)
    axes.set(xlabel="y (mm)")
    if sums.min() >= 0:
        axes.set_ylim(bottom=0)
    axes.set_ylabel(f"damage, {plain(function)}", color=COLOURS[0])
    beside = axes.twinx()
    beside.plot(y, _depths(first, last), color=_WORN)
    beside.set_ylim(bottom=0)
    beside.set_ylabel("depth (mm)", color=_WORN)
    return beside


def shakedown_limit(mu: Any) -> Any:
    """Returns p0/k at the shakedown limit of a line contact in full slip (Johnson): from the largest shear below or on
    the surface, under Hertz's pressure and a proportional traction.
    """
    coefficients = np.atleast_1d(np.asarray(mu, dtype=np.float64))
    depth = np.linspace(0.005, 1.5, 300)[:, None]
    angle = np.linspace(0.0, np.pi, 361)[None, :]
    s, t = depth, np.cos(angle) * 1.6
    # Evaluates McEwen's formulas, Johnson (4.49) and section 7.2: m and n of a point, the stresses due to pressure and
    # to traction.
    inner = np.sqrt((1 - t**2 + s**2) ** 2 + 4 * t**2 * s**2)
    m = np.sqrt(np.maximum((inner + 1 - t**2 + s**2) / 2, 1e-300))
    n = np.sign(t) * np.sqrt(np.maximum((inner - (1 - t**2 + s**2)) / 2, 0.0))
    below = n * (m**2 - s**2) / (m**2 + n**2)
    of_traction = m * (1 + (s**2 + n**2) / (m**2 + n**2)) - 2 * s
    shear = [max(float(np.abs(below + value * of_traction).max()), float(value)) for value in coefficients]
    return np.array([1 / value for value in shear]).reshape(np.shape(mu))


def draw_shakedown(axes: Any, steps: Sequence[WornStep], step: int = 1) -> None:
    """Plots the loads of all contacts before a step against their traction coefficients, each with its own limit, and
    the limit of a line contact in full slip, which is the only one that can be drawn in a map.
    """
    tired = steps[step].fatigue
    if tired is None or np.isnan(tired.contacts[:, 1]).all():
        raise invalid("steps", "have no loads; request fatigue with a strength")
    mu, load, limit, share = tired.contacts.T
    coefficients = np.linspace(0, max(0.5, float(mu.max()) * 1.1), 100)
    axes.plot(coefficients, shakedown_limit(coefficients), color=INK, linewidth=1, label="line contact in full slip")
    axes.vlines(mu, load, limit, color="0.75", linewidth=0.7, zorder=1)
    axes.scatter(mu, limit, marker="_", color=INK, s=40, label="limit of the contact", zorder=2)
    is_beyond = load > limit
    for beyond, colour, name in ((False, COLOURS[2], "load below it"), (True, _WORN, "load beyond it")):
        of_these = is_beyond == beyond
        if of_these.any():
            axes.scatter(mu[of_these], load[of_these], s=12 + 200 * share[of_these], color=colour, alpha=0.8, label=name, zorder=3)
    axes.set(xlabel="traction coefficient", ylabel="p0/k", xlim=(0, coefficients[-1]))
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False)


def draw_measures(axes: Any, distances: Sequence[float], measures: dict[str, Sequence[float]], unit: str = "km", label: str = "") -> None:
    """Plots numbers of a profile, such as conicities, against the distance."""
    for i, (name, values) in enumerate(measures.items()):
        style = ("-", "--", ":")[i % 3]  # keeps coincident lines visible
        axes.plot(distances, values, style, marker=".", color=COLOURS[i % len(COLOURS)], label=name)
    axes.set(xlabel=unit, ylabel=label)
    axes.legend(frameon=False)


def _ends(steps: Sequence[WornStep]) -> tuple[WornStep, WornStep]:
    if len(steps) < 2:
        raise invalid("steps", "are fewer than two, so there is no wear")
    return steps[0], steps[-1]


def _shares(step: WornStep) -> Any:
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(step.points, axis=0), axis=1))])
    return lengths / lengths[-1]


def _depths(first: WornStep, step: WornStep) -> Any:
    return Section(first.points, "wheel").depths_to(Section(step.points, "wheel"))


def _shade(index: int, count: int) -> Any:
    from matplotlib import colormaps

    return colormaps["viridis"](0.9 * index / max(count - 1, 1))
