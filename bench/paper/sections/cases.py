"""What is computed: one Case is a contact or a table, and its place in a figure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

Spec = dict[str, Any]


@dataclass(frozen=True)
class Case:
    """One point of one curve."""

    part: str
    curve: str
    parameter: str  #: what changes along the curve
    value: float
    spec: Spec


#: Of the centre of a rigid ball of 50 mm under 5 kN from the edge of a block (mm).
DISTANCES = (5, 3, 2, 1, 0.5, 0)
#: Lateral shifts of a wheelset S1002 on 60E1 at 1/40 (mm), and how its contacts are solved.
SHIFTS = (0, 5.5, 6, 6.5, 6.75)
WAYS = ("off", "half_space", "rotated", "fem")
#: Bodies whose tables are built, with columns of 0.5 mm, 20 to 80 of them.
BODIES: dict[str, tuple[Spec, int]] = {
    "edge at 0.5 columns": ({"edge_block": {"width": 100, "height": 50, "edge_distance": 0.25}}, 20),
    "edge at 2 columns": ({"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}, 20),
    "60E1 head": ({"rail_60e1": {"from": 2}}, 80),
    "groove R10": ({"groove": {"radius": 10, "depth": 10, "width": 120, "height": 70}}, 41),
    "round end R9.7": ({"round_end": {"radius": 9.7, "length": 60}}, 41),
    "layer of one column": ({"slab": {"thickness": 0.5, "width": 150}}, 20),
}
ACCURACIES = (1e-2, 1e-3)
FINEST = 1e-4  # what the others are measured against


def edges() -> list[Case]:
    return [
        Case("edges", curve, "distance", d, {"kind": "edge", "distance": d, "body": curve})
        for curve in ("half-space", "block")
        for d in DISTANCES
    ]


def throat() -> list[Case]:
    return [
        Case("throat", way, "y", y, {"kind": "throat", "y": y, "conformal": way}) for way in WAYS for y in SHIFTS
    ]


def tables() -> list[Case]:
    return [
        Case("tables", name, "accuracy", accuracy, {"kind": "table", "section": section, "columns": columns, "accuracy": accuracy})
        for name, (section, columns) in BODIES.items()
        for accuracy in ACCURACIES
    ]  # fmt: skip


PARTS = {"edges": edges, "throat": throat, "tables": tables}


def effort(spec: Spec) -> float:
    """Guessed processor seconds."""
    if spec["kind"] == "table":
        return 2.0 + 5e-3 * spec["columns"] ** 2
    return 6.0 if spec.get("conformal") == "fem" else 1.0
