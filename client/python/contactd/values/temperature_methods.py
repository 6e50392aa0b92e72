"""Implements methods of temperatures of both surfaces; `temperature` declares the fields."""

from __future__ import annotations

from typing import Any

from .representation import Rows

__all__ = ["SurfaceTemperaturesMethods"]


class SurfaceTemperaturesMethods:
    """Methods of SurfaceTemperatures."""

    def _title(self: Any) -> str:
        return f"SurfaceTemperatures at {self.upper_temperature.size} elements"

    def _rows(self: Any) -> Rows:
        at = self.temperature
        return [
            ("largest temperature", at.largest), ("at x", at.x), ("y", at.y), ("largest rise", at.rise),
            ("heat into the upper body", at.heat_upper), ("into the lower", at.heat_lower),
        ]  # fmt: skip
