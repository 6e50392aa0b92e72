"""Reads cross-sections and curved columns, for the driver of Python."""

from __future__ import annotations

from typing import Any

import numpy as np

from contactd import AnalyticIcs, ContactColumns, FemIcs, Grid, Material
from contactd.wheel_rail import ProfilePoints

__all__ = ["Sections"]

SHAPES = {
    "rail_60e1": ("inclination", "support", "from"),
    "rim_s1002": ("thickness", "from"),
    "edge_block": ("width", "height", "edge_distance"),
    "groove": ("radius", "depth", "width", "height"),
    "round_end": ("radius", "length"),
    "disc": ("radius", "core"),
    "plate_hole": ("radius", "plate_radius"),
    "slab": ("thickness", "width"),
}


class Sections:
    """A method for each word."""

    client: Any
    opening: dict[str, Any]

    def __init__(self) -> None:
        self.sections: dict[str, dict[str, Any]] = {}
        self.accuracies: dict[str, float] = {}

    def _have(self, body: str, **changes: Any) -> None:
        for name in ("upper", "lower") if body == "both" else (body,):
            section = {**self.sections[name], **changes}
            accuracy = self.accuracies[name]
            self.sections[name] = section
            ics = FemIcs(body="longitudinally_uniform", section=section, accuracy=accuracy) if accuracy else AnalyticIcs("longitudinally_uniform", section=section)
            self.opening[f"{name}_ics"] = ics

    def _begin(self, body: str, shape: str, value: dict[str, Any]) -> None:
        self.sections[body], self.accuracies[body] = {}, 1e-3
        self._have(body, **{shape: value})

    def section(self, body: str, shape: str, *numbers: str) -> None:
        value: dict[str, Any] = dict(zip(SHAPES[shape], map(float, numbers), strict=True))
        if "support" in value:
            value["support"] = ("cut", "foot")[int(value["support"])]
        self._begin(body, shape, value)

    def section_place(self, body: str, size: str, turn: str) -> None:
        self._have(body, size=float(size), turn=float(turn))

    def section_accuracy(self, body: str, accuracy: str) -> None:
        for name in ("upper", "lower") if body == "both" else (body,):
            self.accuracies[name] = float(accuracy)
        self._have(body)

    def outline(self, body: str, y: str, z: str) -> None:
        self._begin(body, "outline", {"outside": {"start": {"y": float(y), "z": float(z)}, "parts": []}})

    def _part(self, body: str, kind: str, clamped: str, curve: dict[str, Any]) -> None:
        outline = self.sections[body]["outline"]
        curves = [outline["outside"], *outline.get("holes", ())]
        curves[-1]["parts"].append({kind: curve, "clamped": bool(int(clamped))})

    def line(self, body: str, y: str, z: str, clamped: str) -> None:
        self._part(body, "line", clamped, {"to": {"y": float(y), "z": float(z)}})

    def arc(self, body: str, y: str, z: str, radius: str, clamped: str) -> None:
        self._part(body, "arc", clamped, {"to": {"y": float(y), "z": float(z)}, "radius": float(radius)})

    def spline(self, body: str, clamped: str, *numbers: str) -> None:
        points = [{"y": float(y), "z": float(z)} for y, z in zip(numbers[::2], numbers[1::2], strict=True)]
        self._part(body, "spline", clamped, {"through": points})

    def hole(self, body: str, y: str, z: str) -> None:
        holes = self.sections[body]["outline"].setdefault("holes", [])
        holes.append({"start": {"y": float(y), "z": float(z)}, "parts": []})

    def first_column(self, body: str, carrier: str, part: str, begin: str) -> None:
        self.sections[body]["outline"].update({"carrier": int(carrier), "part": int(part), "from": float(begin)})

    def profile(self, body: str, kind: str, curvature: str, smoothing: str, depth: str, begin: str) -> None:
        points = [(y, y * y * float(curvature)) for y in range(-34, 35)]
        profile = ProfilePoints(np.array(points, dtype=float), smoothing_length=float(smoothing))
        self._begin(body, "profile_section", {"kind": kind, "profile": profile, "depth": float(depth), "from": float(begin)})

    def columns(self, direction: str, y: str, z: str) -> None:
        grid = self.opening["grid"]
        place = AnalyticIcs("longitudinally_uniform", section=self.sections["lower"])
        table = self.client.get_ic(Material(G=1, nu=0.25), Grid(1, grid.ny, grid.dy, grid.dy, 0, 0), place)
        self.opening["columns"] = ContactColumns(table.frames, float(direction), (float(y), float(z)))

    def flat_columns(self, direction: str, y: str, z: str) -> None:
        rows = np.arange(self.opening["grid"].ny, dtype=float)
        self.opening["columns"] = ContactColumns(
            np.stack([rows, 0 * rows, 0 * rows], axis=1), float(direction), (float(y), float(z))
        )
