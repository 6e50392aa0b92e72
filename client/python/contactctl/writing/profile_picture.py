"""Draws a profile with its curvature to a file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from contactd.pictures.canvas import plain
from contactd.wheel_rail import ProfileEvidence
from contactd.wheel_rail_pictures import draw_curvature, draw_profile

from .drawing import save_picture

__all__ = ["save_profile_picture"]


def save_profile_picture(path: Path, title: str, points: Any, evidence: ProfileEvidence, measured: Any = None) -> None:
    """Draws the profile above its curvature; `measured` are its points before smoothing."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 6.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True)
    draw_profile(above, points, evidence, measured)
    draw_curvature(below, points, measured)
    above.set_title(plain(title, 80), fontsize="medium")
    save_picture(path, figure, dpi=150)
