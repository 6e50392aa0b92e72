"""Lists the computations: a Case is a contact, a table or a check of these, and its place in a figure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .propagation import MESHES

Spec = dict[str, Any]


@dataclass(frozen=True)
class Case:
    """One point of a curve."""

    part: str
    curve: str
    parameter: str  #: what changes along the curve
    value: float
    spec: Spec


#: Distances (mm) of the centre of a rigid ball of 50 mm under 5 kN from the edge of a block.
DISTANCES = (5, 3, 2, 1, 0.5, 0)
#: Lateral shifts of a wheelset S1002 on 60E1 at 1/40 (mm), and the ways of solving its contacts.
SHIFTS = (0, 5.5, 6, 6.5, 6.75)
WAYS = ("off", "half_space", "rotated", "fem")
#: Bodies whose tables are built, with 20 to 80 strips of 0.5 mm, and Poisson's ratio.
BODIES: dict[str, tuple[Spec, int, float]] = {
    "edge at 0.5 strips": ({"edge_block": {"width": 100, "height": 50, "edge_distance": 0.25}}, 20, 0.28),
    "edge at 2 strips": ({"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}, 20, 0.28),
    "edge at 10 strips": ({"edge_block": {"width": 100, "height": 50, "edge_distance": 5}}, 20, 0.28),
    "60E1 head": ({"rail_60e1": {"from": 2}}, 80, 0.28),
    "groove R10": ({"groove": {"radius": 10, "depth": 10, "width": 120, "height": 70}}, 41, 0.28),
    "round end R9.7": ({"round_end": {"radius": 9.7, "length": 60}}, 41, 0.28),
    "layer of one strip": ({"slab": {"thickness": 0.5, "width": 150}}, 20, 0.28),
    "edge at 0.5 strips, nu 0.49": ({"edge_block": {"width": 100, "height": 50, "edge_distance": 0.25}}, 20, 0.49),
    "groove R5, nu 0.45": ({"groove": {"radius": 5, "depth": 5, "width": 60, "height": 40}}, 25, 0.45),
}
ACCURACIES = (1e-2, 1e-3)
#: The reference accuracy. If it is refused, the finest accepted one is the reference. Half of the reciprocity defect is
#: part of the stated error, and no mesh reduces it.
FINEST = 1e-4
#: Half angles of contact of a cylinder in a hole (degrees), of 20 strips or more.
HALF_ANGLES = (20, 30, 45, 60, 75, 80)
#: Radii of grooves (mm) in which a roller of 10 mm lies, and the models of both bodies.
GROOVES = (10.25, 10.10, 10.05, 10.02)
BODIES_IN_GROOVES = ("half_space", "rotated", "sections")
#: Orders of elements in three dimensions, factorisation or BoomerAMG, and their meshes. Lengths are relative to the
#: width of a strip.
SOLID_ORDERS = {1: 0, 2: 0, 3: 1}
SOLID = {"columns": 1, "offsets": 9, "edges": 2, "growth": 1.8, "length": 250, "many": 80}


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
        Case("tables", name, "accuracy", accuracy, {"kind": "table", **body, "accuracy": accuracy})
        for name, (section, columns, nu) in BODIES.items()
        for body in [{"section": section, "columns": columns, "nu": nu}]
        for accuracy in ACCURACIES
    ]


def persson() -> list[Case]:
    return [Case("persson", "strips of 1°", "half_angle", a, {"kind": "persson", "half_angle": a}) for a in HALF_ANGLES]


def groove() -> list[Case]:
    return [
        Case("groove", body, "radius", radius, {"kind": "groove", "radius": radius, "body": body})
        for body in BODIES_IN_GROOVES
        for radius in GROOVES
    ]


def solid() -> list[Case]:
    return [
        Case("solid", "edge at 0.5 strips", "order", order, {"kind": "solid", "order": order, "factor": factor, **SOLID})
        for order, factor in SOLID_ORDERS.items()
    ]


def propagation() -> list[Case]:
    return [
        Case("propagation", f"{body}, order {order}", "edges", edges, {"kind": "propagation", "body": body, "order": order, "edges": edges})
        for body in ("flat", "curved")
        for order, edges in MESHES
    ]


PARTS = {
    "edges": edges, "throat": throat, "tables": tables, "persson": persson, "groove": groove, "propagation": propagation,
    "solid": solid,
}  # fmt: skip
EFFORTS = {"persson": 10.0, "propagation": 2.0, "groove": 5.0, "solid": 100.0}


def effort(spec: Spec) -> float:
    """Estimates the processor seconds."""
    if spec["kind"] == "table":
        return 2.0 + 5e-3 * spec["columns"] ** 2
    return EFFORTS.get(spec["kind"], 6.0 if spec.get("conformal") == "fem" else 1.0)
