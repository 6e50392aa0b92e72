"""Solves a roller in a groove of nearly its own radius, by half-spaces and by sections."""

from __future__ import annotations

from typing import Any

import numpy as np

from contactd import AnalyticIcs, Client, ContactColumns, FemIcs, Grid, Material

STEEL = Material(G=82000, nu=0.28)
ROLLER, ALONG_X, FORCE = 10.0, 460.0, 10e3  # radii across and along (mm), N
STRIPS, SIZE = 41, 0.5  # mm
BODY = {"width": 120, "height": 70}  # around the groove; the roller is the end of a slab of 60 mm


def bodies(radius: float, body: str) -> tuple[Any, Any]:
    """Returns the coefficients of roller and groove."""
    if body == "half_space":
        return AnalyticIcs(), AnalyticIcs()
    roller = {"round_end": {"radius": ROLLER, "length": 60}}
    groove = {"groove": {"radius": radius, "depth": radius, **BODY}}
    if body == "rotated":
        return AnalyticIcs(body="longitudinally_uniform", section=roller), AnalyticIcs(body="longitudinally_uniform", section=groove)
    return FemIcs(body="longitudinally_uniform", section=roller, accuracy=1e-2), FemIcs(body="longitudinally_uniform", section=groove, accuracy=1e-2)


def measure(client: Client, radius: float, body: str) -> dict[str, Any]:
    grid = Grid.centred(35, STRIPS, 35 * SIZE, STRIPS * SIZE)
    _, of_groove = bodies(radius, "rotated")
    frames = client.get_ic(STEEL, Grid.centred(1, STRIPS, SIZE, STRIPS * SIZE), of_groove).frames
    assert frames is not None
    # Returns the distance from the groove along its normals to the roller, which touches it at the bottom.
    angles, lower = np.asarray(frames)[:, 2], radius - ROLLER
    across = radius - lower * np.cos(angles) - np.sqrt(ROLLER**2 - (lower * np.sin(angles)) ** 2)
    gap = across[:, None] + grid.x[None, :] ** 2 / (2 * ALONG_X)
    upper_ics, lower_ics = bodies(radius, body)
    solution = client.solve(
        grid=grid,
        upper=STEEL,
        lower=STEEL,
        upper_ics=upper_ics,
        lower_ics=lower_ics,
        columns=ContactColumns(frames, 0.0, (0.0, -radius)),
        gap=gap,
        Fn=FORCE,
    )
    if not solution.converged:
        return {"failure": "The contact did not converge."}
    return {"pmax": solution.pmax, "approach": solution.approach}
