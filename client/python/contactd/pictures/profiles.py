"""Draws wheels and rails in their positions on the caller's matplotlib axes; used by contactd.wheel_rail_pictures."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from ..errors import invalid
from ..values.arrays import Array
from ..values.generated.wheel_rail.rigid_wheelset import (
    EquivalentConicity,
    PlacedProfiles,
    ProfilesOfSides,
    WheelsetContacts,
)
from ..values.generated.wheel_rail.setup import Side
from ..values.generated.wheel_rail.state import RailDeviation, WheelRailState, WheelsetPosition
from ..values.wheel_rail.solution import WheelRailPatch, WheelRailSolution

__all__ = ["draw_body", "draw_conicity", "draw_contact_locus", "draw_patches", "placed_rail", "placed_wheel"]

INK, STEEL, PRESSURE = "#1d1d2b", "0.88", "#c8401d"


def placed_wheel(
    profiles: PlacedProfiles, position: WheelsetPosition, side: Side = "right", nominal_radius: float = 460
) -> Array:
    """Returns (y, z) of the wheel's profile in the track (mm), shape [n, 2], for a wheelset without yaw."""
    out = 1 if side == "right" else -1
    along, below = profiles.wheel_origin + profiles.wheel[:, 0], nominal_radius + profiles.wheel[:, 1]
    cosine, sine = np.cos(position.roll), out * np.sin(position.roll)
    y = out * position.y + cosine * along - sine * below
    return np.column_stack([out * y, (position.z or 0.0) - nominal_radius + sine * along + cosine * below])


def placed_rail(profiles: PlacedProfiles, deviation: RailDeviation | None = None, side: Side = "right") -> Array:
    """Returns (y, z) of the rail's profile in the track (mm), shape [n, 2]."""
    moved = deviation or RailDeviation()
    out = 1 if side == "right" else -1
    cosine, sine = np.cos(moved.roll), out * np.sin(moved.roll)
    y, z = profiles.rail.T
    rotated = profiles.rail_origin.y + out * moved.y + cosine * y - sine * z
    return np.column_stack([out * rotated, profiles.rail_origin.z + moved.z + sine * y + cosine * z])


def draw_contact_locus(
    axes: Any,
    both: ProfilesOfSides,
    at_shifts: Iterable[WheelsetContacts],
    side: Side = "right",
    *,
    lift: float = 12,
) -> Any:
    """Draws the contact-locus diagram: lines between the contact points on wheel and rail for each lateral shift.

    The wheel is drawn for the centred wheelset, raised by `lift` (mm). Returns the mappable for a colour bar of the
    shifts.
    """
    listed = list(at_shifts)
    if not listed:
        raise invalid("at_shifts", "is empty; there is nothing to draw")
    profiles: PlacedProfiles = getattr(both, side)
    out = 1 if side == "right" else -1
    contacts = [getattr(contacts, side) for contacts in listed]
    shifts = np.array([contacts.shift for contacts in listed])
    at_rail = np.array([[out * (profiles.rail_origin.y + contact.rail_y), contact.z] for contact in contacts])
    wheel = np.column_stack([profiles.wheel_origin + profiles.wheel[:, 0], profiles.wheel[:, 1] - lift])
    rises = np.interp([contact.wheel_y for contact in contacts], *profiles.wheel.T)
    at_wheel = np.array(
        [[out * (profiles.wheel_origin + contact.wheel_y), rise - lift] for contact, rise in zip(contacts, rises, strict=True)]
    )
    draw_body(axes, wheel * (out, 1), upwards=True)
    draw_body(axes, placed_rail(profiles, side=side), upwards=False)
    colours = axes.scatter(*at_rail.T, c=shifts, cmap="coolwarm", s=12, zorder=3, edgecolors=INK, linewidths=0.3)
    axes.scatter(*at_wheel.T, c=shifts, cmap="coolwarm", s=12, zorder=3, edgecolors=INK, linewidths=0.3)
    for shift, above, below in zip(shifts, at_wheel, at_rail, strict=True):
        axes.plot(*np.transpose([above, below]), color=colours.to_rgba(shift), lw=1)
    _frame(axes)
    axes.set_title(f"{side} wheel")
    return colours


def draw_conicity(axes: Any, conicities: Iterable[EquivalentConicity], label: str, color: str = "C0") -> None:
    """Plots equivalent conicity against amplitude: solid by integration, dashed by the first harmonic."""
    listed = list(conicities)
    amplitudes = [conicity.amplitude for conicity in listed]
    for way, style in (("integrated", "o-"), ("harmonic", "s--")):
        values = [np.nan if (value := getattr(conicity, way)) is None else value for conicity in listed]
        axes.plot(
            amplitudes,
            values,
            style,
            color=color,
            ms=4,
            mfc=color if way == "integrated" else "white",
            label=f"{label}, {way}",
        )
    axes.set(xlabel="amplitude of the wheelset (mm)", ylabel="equivalent conicity")
    axes.spines[["top", "right"]].set_visible(False)


def draw_patches(
    axes: Any,
    profiles: PlacedProfiles,
    state: WheelRailState,
    solution: WheelRailSolution,
    side: Side = "right",
    *,
    nominal_radius: float = 460,
    scale: float | None = None,
) -> None:
    """Draws wheel and rail in their positions, and the pressure of each patch (the largest along x) as a hill into the
    rail.

    The wheel is drawn without its yaw, so there may be a gap at its flange. `scale` is the height of 1 N/mm^2 (mm); if
    None, the largest pressure has a height of 6 mm. Patches must have their pressures.
    """
    at = state.position
    position = WheelsetPosition(y=at.y, z=solution.z, roll=at.roll)
    draw_body(axes, placed_wheel(profiles, position, side, nominal_radius), upwards=True)
    rail = placed_rail(profiles, state.rail, side)
    draw_body(axes, rail, upwards=False)
    largest = max((patch.solution.pmax for patch in solution.patches), default=1)
    for patch in solution.patches:
        surface, hill = _hill(patch, rail, 6 / largest if scale is None else scale)
        axes.fill(*np.concatenate([surface, hill[::-1]]).T, color=PRESSURE, alpha=0.85, lw=0, zorder=3)
        reported = f"{patch.solution.forces.Fn / 1e3:.1f} kN\n{patch.solution.pmax:.0f} N/mm$^2$"
        middle = hill[np.argmax(np.hypot(*(hill - surface).T))]
        out = 1 if side == "right" else -1
        axes.annotate(
            reported,
            middle,
            (8 * out, -14),
            textcoords="offset points",
            ha="left" if out > 0 else "right",
            va="top",
            fontsize=10,
            color=INK,
        )
    _frame(axes)


def _hill(patch: WheelRailPatch, rail: Array, scale: float) -> tuple[Array, Array]:
    """Returns (y, z) of the rows of a patch on the rail, and of the tops of their pressures."""
    if not hasattr(patch.solution, "pressure"):
        raise invalid("solution", 'has patches without pressure; request fields=["pressure"], or all')
    pressure = np.asarray(patch.solution.pressure).max(axis=1)
    at, rows = patch.place.reference, patch.place.grid.y
    along, into = np.array([np.cos(at.angle), np.sin(at.angle)]), np.array([-np.sin(at.angle), np.cos(at.angle)])
    middle = np.array([at.y, at.z])
    inside = rail[np.argsort((rail - middle) @ along)] - middle  # Contact coordinates.
    depth = np.interp(rows, inside @ along, inside @ into)
    surface = middle + rows[:, None] * along + depth[:, None] * into
    return surface, surface + scale * pressure[:, None] * into


def draw_body(axes: Any, outline: Array, upwards: bool) -> None:
    """Fills a body with a given outline, shape [n, 2]: above the outline for a wheel (`upwards`), below for a rail."""
    beyond = outline[:, 1].min() - 12 if upwards else outline[:, 1].max() + 6
    axes.fill_between(*outline.T, beyond, color=STEEL, lw=0)
    axes.plot(*outline.T, color=INK, lw=1.2)


def _frame(axes: Any) -> None:
    axes.set_aspect("equal")
    axes.set(xlabel="y, to the right (mm)", ylabel="z, down (mm)")
    if not axes.yaxis_inverted():
        axes.invert_yaxis()
    axes.spines[["top", "right"]].set_visible(False)
