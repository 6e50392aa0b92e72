"""Origins of influence coefficients.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from ...refusals import public
from ..params import Checked
from .fem_ics import FemIcs, LoadShape

__all__ = ["AnalyticIcs", "Ics", "LineContact"]


@dataclass(frozen=True)
class LineContact:
    """A contact that is infinite and constant along y: plane strain, and anti-plane strain for tractions along y.

    The grid has ny = 1, and forces are those on the length dy: Fn/dy is the force per length. Displacements of the
    plane are determined except for a constant, which `datum` fixes. Approach and rigid shift depend on it. Other
    results do not, for prescribed forces and in steady rolling.

    Attributes:
        datum: Distance from a load along the surface at which its displacements xx, yy and zz vanish, at least the
            length of the grid (mm), > 0. It affects approach and rigid shift, but not forces and steady rolling.
    """

    datum: float


@public
@dataclass(frozen=True)
class AnalyticIcs(Checked):
    """Influence coefficients of the elastic half-space in closed form.

    Attributes:
        body: The half-space, or longitudinally_uniform: half-spaces rotated from column to column of `section`
            (docs/sections.md). Answers have "layered" for a LayeredBody. Default "half_space".
        load_shape: Traction of the loaded element: 1 over it, or the bilinear hat function (1 - |x|/dx)(1 - |y|/dy).
            Default "constant".
        line_contact: A contact that does not vary along y; None: elements of finite length.
        section: Cross-section of a longitudinally uniform body as on the wire (docs/protocol.md, docs/sections.md), for
            example {"rail_60e1": {"from": 2}} or {"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}, or
            {"profile_section": {"kind": "rail", "profile": ProfilePoints(...), "depth": 60}} of contactd.wheel_rail.
            Its columns are the rows of the grid, dy wide along the outline.
    """

    _fixed = ("source", "analytic")

    body: Literal["half_space", "layered", "longitudinally_uniform"] | None = None
    load_shape: LoadShape | None = None
    line_contact: LineContact | None = None
    section: Mapping[str, Any] | None = None


Ics = AnalyticIcs | FemIcs
