"""Influence coefficients: where they come from, and how tables of them are asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from ..refusals import check_type, public
from .fem_ics import FemIcs, LoadShape

__all__ = ["AnalyticIcs", "FemIcs", "Ics", "LineContact"]


@dataclass(frozen=True)
class LineContact:
    """A contact that does not change along y nor end there: plane strain (anti-plane strain for what points along y).

    The grid has ny = 1, and its dy is the length that forces are counted over: Fn/dy is the force per length.
    Displacements of the plane are known up to a constant only, which `datum` fixes. The approach and the rigid shift
    depend on it; under prescribed forces, and in steady rolling, nothing else does.

    Attributes:
        datum: Distance from a load, along the surface, at which its displacements xx, yy and zz vanish (mm), at least the
            length of the grid.
    """

    datum: float


@public
@dataclass(frozen=True)
class AnalyticIcs:
    """Influence coefficients of the elastic half-space in closed form.

    Attributes:
        body: "half_space" (default), or "longitudinally_uniform": half-spaces that are turned from column to column of
            `section` (docs/sections.md); "layered" is what answers say of a LayeredBody.
        load_shape: Traction of the loaded element: "constant" (default), or "bilinear", the tent
            (1 - |x|/dx) (1 - |y|/dy).
        line_contact: A contact that does not change along y; None: elements end along y.
        section: Of a longitudinally uniform body, as FemIcs.section.
    """

    body: Literal["half_space", "layered", "longitudinally_uniform"] | None = None
    load_shape: LoadShape | None = None
    line_contact: LineContact | None = None
    section: Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        if self.line_contact is not None:
            check_type("line_contact", self.line_contact, LineContact)


Ics = AnalyticIcs | FemIcs
