"""Computes wear and fatigue of a section in each state, cell by cell."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import InvalidArgument, invalid
from .placed import StudyPlace
from .places import rows_on_rail, rows_on_wheel
from .section import Section, WornPart, deposit
from .stability import LoadedRows
from .steps import StepFatigue
from .study import WearStudy

__all__ = ["Contributions", "fatigue_of", "rows_along"]

Array = npt.NDArray[np.float64]

_KM = 1e6  #: mm


@dataclass
class Contributions:
    """Holds wear per unit of distance, state by state: per km, or per passage if only a rail wears.

    Attributes:
        part: The wheel or the rail.
        edges: Ends of the cells along the section (mm).
        rates: Depths of the cells in each state, weighted with its share, shape [states, cells].
        contacts: The rows of all contacts, for stability.
        places: The patches of each state with their arc lengths and passages per unit of distance.
    """

    part: WornPart
    edges: Array
    rates: Array
    contacts: list[LoadedRows] = field(default_factory=list)
    places: list[list[tuple[dict[str, Any], Array, Array]]] = field(default_factory=list)

    @classmethod
    def of(
        cls, answers: Sequence[dict[str, Any]], section: Section, study: WearStudy, place: StudyPlace, part: WornPart
    ) -> Contributions:
        """Computes them from the answers of all states. Raises InvalidArgument naming the state whose contact is beyond
        the section.
        """
        edges = section.edges(study.spacing)
        found = cls(part, edges, np.zeros((len(answers), len(edges) - 1)))
        law = study.law_index(part)
        for i, (share, answer) in enumerate(zip(study.shares, answers)):
            found.places.append([])
            for patch in answer.get("patches", ()):
                try:
                    found._add(i, share, patch, answer, law, section, study, place)
                except InvalidArgument as error:
                    raise invalid(f"states[{study.given_index(i)}]", f"cannot be placed: {error.message.removesuffix('.')}") from error
        return found

    @property
    def size(self) -> float:
        """The length of a cell (mm)."""
        return float(self.edges[1] - self.edges[0])

    @property
    def centres(self) -> Array:
        """The middles of the cells (mm)."""
        return np.asarray(0.5 * (self.edges[1:] + self.edges[:-1]))

    @property
    def areas(self) -> Array:
        """The area removed by each state per unit of distance (mm^2)."""
        return np.asarray(self.rates.sum(axis=1) * self.size)

    def by_groups(self, study: WearStudy, distance: float) -> dict[str, float]:
        """Returns the areas for a distance by groups of states (mm^2)."""
        groups: dict[str, float] = {}
        for one, area in zip(study.collective, self.areas):
            groups[one.group] = groups.get(one.group, 0.0) + float(area) * distance
        return groups

    def _add(
        self, i: int, share: float, patch: dict[str, Any], answer: dict[str, Any], law: int, section: Section, study: WearStudy, place: StudyPlace
    ) -> None:
        rows = [row for row in patch["solution"].get("wear", {}).get("rows", ()) if row["depths"][law] > 0]
        dy = patch["place"]["grid"]["dy"]
        if rows:
            lengths, passages = rows_along(rows, patch, answer, i, section, study, place, self.part)
            depths = np.array([row["depths"][law] for row in rows]) * passages
            self.rates[i] += share * deposit(self.edges, lengths, dy, depths)
            area, width = patch["solution"]["area"]["contact"], dy * len(rows)
            worn = share * float(depths.sum()) * dy
            self.contacts.append(LoadedRows(worn, patch["solution"]["forces"]["Fn"] / area, area / width, width))
        if self.part == study.tired_part and (tired := patch["solution"].get("fatigue", {})).get("rows"):
            self.places[-1].append((patch, *rows_along(tired["rows"], patch, answer, i, section, study, place, self.part)))


def rows_along(
    rows: Sequence[dict[str, Any]],
    patch: dict[str, Any],
    answer: dict[str, Any],
    index: int,
    section: Section,
    study: WearStudy,
    place: StudyPlace,
    part: WornPart,
) -> tuple[Array, Array]:
    """Returns the arc lengths of rows on the section, and the number of passages of each per unit of distance."""
    state = study.collective[index].state
    y, z = np.array([row["y"] for row in rows]), np.array([row["z"] for row in rows])
    if part == "wheel":
        position = {"y": state.position.y, "roll": state.position.roll, "yaw": state.position.yaw, "z": answer["z"]}
        x = patch["place"]["reference"]["x"]
        points = rows_on_wheel(y, z, x=x, position=position, origin=place.wheel_origin, radius=place.radius, left=place.left)
        passages: Array = np.asarray(_KM / (2 * np.pi * (place.radius + points[:, 1])))
    else:
        points = rows_on_rail(y, z, origin=place.rail_origin, deviation=(state.rail.y, state.rail.z), left=place.left)
        passages = np.full_like(y, study.passages_per_unit)
    return section.nearest(points), passages


def fatigue_of(answers: Sequence[dict[str, Any]], wear: Contributions, study: WearStudy, distance: float) -> StepFatigue | None:
    """Returns the fatigue of the section over a distance, if the study requests it."""
    if wear.part != study.tired_part:
        return None
    cells = len(wear.edges) - 1
    damages: dict[str, Array] = {}
    dang_van: Array = np.full(cells, -np.inf)
    limits: Array = np.full(cells, np.inf)
    points = []
    for share, patches in zip(study.shares, wear.places):
        for patch, lengths, passages in patches:
            tired, dy = patch["solution"]["fatigue"], patch["place"]["grid"]["dy"]
            for damage in tired["damages"]:
                spread = deposit(wear.edges, lengths, dy, share * distance * passages * damage["value"])
                damages[damage["name"]] = damages.get(damage["name"], np.zeros(cells)) + spread
            touched = deposit(wear.edges, lengths, dy, np.ones(len(lengths))) > 0
            order = np.argsort(lengths)  # Rows of a left wheel have the opposite order.
            at = order[np.clip(np.searchsorted(lengths[order], wear.centres), 0, len(lengths) - 1)]
            if "dang_van" in tired:
                value = np.array([row["dang_van"] for row in tired["rows"]])[at]
                dang_van = np.where(touched, np.maximum(dang_van, value), dang_van)
            if "limit" in tired:
                shear = np.array([row["shear"] for row in tired["rows"]])[at]
                margin = study.shear_yield / shear if study.shear_yield else 1 / shear
                limits = np.where(touched & (shear > 0), np.minimum(limits, margin), limits)
            points.append([tired["traction_coefficient"], tired.get("load", np.nan), tired.get("limit", np.nan), share])
    return StepFatigue(
        damages, np.where(np.isfinite(dang_van), dang_van, np.nan), np.where(np.isfinite(limits), limits, np.nan),
        np.array(points).reshape(-1, 4),
    )  # fmt: skip
