"""Computes the wear of a passage, from the rows of a solution to the worn section."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from ..errors import invalid
from ..values.generated.wheel_rail.rigid_wheelset import PlacedProfiles
from ..values.wheel_rail.origins import Origin, origin_of
from ..values.wheel_rail.passage_wear import PassageWear
from ..values.wheel_rail.solution import WheelRailPatch, WheelRailSolution
from .places import rows_on_rail, rows_on_wheel
from .section import Section, deposit

__all__ = ["passage_wear"]

_KM = 1e6  #: mm
_PARTS: dict[str, Literal["wheel", "rail"]] = {"lower": "wheel", "upper": "rail"}
_SPACING = 0.25  #: Largest distance between points of a section (mm).


def passage_wear(solution: WheelRailSolution, body: str | None, law: str | None) -> PassageWear:
    """Implements WheelRailSolution.wear."""
    index, name, part = _law_of(solution, body, law)
    origin = origin_of(solution)
    profiles = None if origin is None else origin.profiles()
    if origin is None or profiles is None:
        raise invalid("solution", "is from a file, or its client is closed, so its profiles are not available; solve it again")
    worn = [patch for patch in solution.patches if patch.solution.wear is not None]
    spacing = min([_SPACING, *(patch.place.grid.dy for patch in worn)])
    section = Section.of(getattr(profiles, part), part, spacing)
    edges = section.edges(spacing)
    per_passage, per_km = np.zeros(len(edges) - 1), np.zeros(len(edges) - 1)
    deepest, passages, area = 0.0, np.nan, 0.0
    for patch in worn:
        depths, dy = _depths(patch, index), patch.place.grid.dy
        points = _points(patch, solution, origin, profiles, part)
        often = _KM / (2 * np.pi * (origin.nominal_radius + points[:, 1])) if part == "wheel" else np.full(len(points), np.nan)
        lengths = section.nearest(points)
        per_passage += deposit(edges, lengths, dy, depths)
        per_km += deposit(edges, lengths, dy, depths * np.nan_to_num(often))
        area += float(depths.sum()) * dy
        if depths.max() > deepest or np.isnan(passages):
            deepest, passages = float(depths.max()), float(often[depths.argmax()])
    centres = 0.5 * (edges[1:] + edges[:-1])
    at_points = [np.interp(section.lengths, centres, cells) for cells in (per_passage, per_km)]
    return PassageWear(
        body=part, law=name, T_gamma=sum(patch.solution.wear.T_gamma for patch in worn if patch.solution.wear is not None),
        depth_per_passage=deepest, area_per_passage=area, passages_per_km=passages, points=section.points, depths=at_points[0],
        depths_per_km=at_points[1] if part == "wheel" else np.full(len(section.points), np.nan), normals=section.normals,
    )  # fmt: skip


def _law_of(solution: WheelRailSolution, body: str | None, law: str | None) -> tuple[int, str, Literal["wheel", "rail"]]:
    """Returns the number of the law in the answer, its name, and the body it applies to. Raises InvalidArgument."""
    if body not in (None, "wheel", "rail"):
        raise invalid("body", f'is {body!r}; it must be "wheel" or "rail"')
    if solution.patches and all(patch.solution.wear is None for patch in solution.patches):
        raise invalid("wear", "was not requested; give the laws, as in contactd.wheel_rail(..., wear=EnergyWear(...))")
    answers = [patch.solution.wear.laws for patch in solution.patches if patch.solution.wear is not None]
    if not answers:
        raise invalid("solution", "has no contact, so there is no wear")
    named = [(number, one.name, _PARTS[one.body]) for number, one in enumerate(answers[0])]
    found = [one for one in named if body in (None, one[2]) and law in (None, one[1])]
    if len(found) != 1:
        there = ", ".join(f"{name} of the {part}" for _, name, part in named) or "none"
        raise invalid("law", f"must be one of those of the answer: {there}. Give body and law")
    return found[0]


def _depths(patch: WheelRailPatch, index: int) -> Any:
    wear = patch.solution.wear
    assert wear is not None
    return np.array([row.depths[index] for row in wear.rows] or [0.0])


def _points(patch: WheelRailPatch, solution: WheelRailSolution, origin: Origin, profiles: PlacedProfiles, part: str) -> Any:
    """Returns (y, z) of the rows in the profile of the worn body."""
    wear, left, at = patch.solution.wear, origin.side == "left", origin.position
    assert wear is not None
    if part == "rail":
        place = (float(profiles.rail_origin.y), float(profiles.rail_origin.z))
        return rows_on_rail(wear.y, wear.z, origin=place, deviation=(origin.rail.y, origin.rail.z), left=left)
    position = {"y": at.y, "roll": at.roll, "yaw": at.yaw, "z": solution.z}
    return rows_on_wheel(
        wear.y, wear.z, x=patch.place.reference.x, position=position, origin=float(profiles.wheel_origin),
        radius=origin.nominal_radius, left=left,
    )  # fmt: skip
