"""Plots stresses inside a body: a section through a block of points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from ..values.generated.subsurface import SubsurfaceStress
from ..values.subsurface_methods import Component
from .canvas import INK, aspect_of, axes_or_new, bare, colour_bar, warm

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_stress"]

_AXES = "zyx"  #: Axes of the arrays.
_UNSIGNED = ("von_mises", "tresca")  #: Equivalent stresses.
_NAMES = {"von_mises": "Von Mises stress", "tresca": "Tresca's stress", "hydrostatic": "Hydrostatic stress"}
_NAMES |= {f"principal_{i}": f"Principal stress {i}" for i in (1, 2, 3)}


def draw_stress(
    stress: SubsurfaceStress,
    component: Component = "von_mises",
    *,
    x: float | None = None,
    y: float | None = None,
    z: float | None = None,
    axes: Axes | None = None,
) -> Axes:
    """Implements SubsurfaceStress.plot."""
    if component not in get_args(Component):
        raise ValueError(f"component is {component!r}; it must be one of {', '.join(get_args(Component))}")
    if getattr(stress, component) is None:
        raise ValueError(f"component is {component!r}, which the stresses lack: request it with invariants=True")
    if stress.block is None:
        raise ValueError("the stresses are those of single points; a picture requires those of a StressBlock")
    places = {name: np.atleast_1d(np.asarray(getattr(stress.block, name), dtype=float)) for name in _AXES}
    cut = _cut(places, {"x": x, "y": y, "z": z}, stress)
    index = tuple(cut.get(name, slice(None)) for name in _AXES)
    values = getattr(stress, component)[index]
    free = [name for name in _AXES if name not in cut]
    axes = axes_or_new(axes, 7.0, 4.6)
    name = _NAMES.get(component, f"Stress {component}")
    label = f"{name} (N/mm$^2$){'' if component in _UNSIGNED else ', tension positive'}"
    where = ", ".join(f"{axis} = {places[axis][at]:.3g} mm" for axis, at in sorted(cut.items()))
    axes.set_title(f"{name} at {where}")
    if len(free) == 1:
        _draw_line(axes, places[free[0]], values, free[0], label)
        return axes
    _draw_map(axes, stress, component, [places[name] for name in free], values, free, label)
    return axes


def _cut(places: dict[str, Any], requested: dict[str, float | None], stress: SubsurfaceStress) -> dict[str, int]:
    """Returns the index on each axis that is constant in the plot: the only point, the requested one, or that of the
    largest stress.
    """
    cut = {name: 0 for name, values in places.items() if len(values) == 1}
    for name, value in requested.items():
        if value is not None:
            cut[name] = int(np.argmin(np.abs(places[name] - value)))
    if not cut:
        cut["y"] = int(np.argmin(np.abs(places["y"] - stress.largest.y)))
    if len(cut) == len(places):
        raise ValueError("x, y and z leave a single point, which cannot be drawn; give fewer of them")
    return cut


def _draw_line(axes: Axes, along: Any, values: Any, name: str, label: str) -> None:
    order = np.argsort(along)
    axes.plot(along[order], values[order], color=INK)
    axes.set(xlabel=f"{name} (mm)", ylabel=label)
    bare(axes)


def _draw_map(
    axes: Axes, stress: SubsurfaceStress, component: str, along: list[Any], values: Any, free: list[str], label: str
) -> None:
    orders = [np.argsort(one) for one in along]
    up, across = (one[order] for one, order in zip(along, orders))
    values = values[np.ix_(*orders)]
    signed = component not in _UNSIGNED
    bound = float(np.abs(values).max())
    drawn = axes.pcolormesh(
        across, up, values, cmap="RdBu_r" if signed else warm(), vmin=-bound if signed else 0, vmax=bound, shading="nearest"
    )
    colour_bar(axes, drawn, label)
    if (levels := np.linspace(-bound if signed else 0, bound, 9)[1:-1]).any() and min(values.shape) > 1:
        axes.contour(across, up, values, levels=levels, colors=INK, linewidths=0.5, linestyles="solid")
    at = stress.largest
    if component == "von_mises" and np.isclose(values.max(), at.von_mises):
        axes.plot(getattr(at, free[1]), getattr(at, free[0]), "x", color=INK, ms=8, label=f"largest, {at.von_mises:.4g} N/mm$^2$")
        axes.legend(loc="lower right", fontsize="small")
    depth = "; negative inside the body" if free[0] == "z" else ""
    aspect = aspect_of(float(np.ptp(across)) or 1.0, float(np.ptp(up)) or 1.0)
    axes.set(xlabel=f"{free[1]} (mm)", ylabel=f"{free[0]} (mm){depth}", aspect=aspect)
