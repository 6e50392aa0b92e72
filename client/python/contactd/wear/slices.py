"""Computes wear of rails that vary along the track, such as the nose of a crossing, by a set of wheel states.

States have positions along the track, `position.x`, and represent the passages there. A particle of the rail at x is
passed by a contact in the steady rolling state at x. Profiles are not changed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ..calls.answer_warnings import collected, give
from ..errors import invalid
from ..values.generated.wear_laws import WearEnergy, WearLaw
from ..values.generated.wheel_rail.setup import WheelRailSetup
from ..values.params import params_of, with_objects
from ..values.wheel_rail.params import setup_params, state_params
from .placed import WheelRailClient
from .states import WeightedState

__all__ = ["DepthMap", "depths_along"]

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class DepthMap:
    """Depths along the normals, on a map of the track.

    Attributes:
        x_edges: Ends of the pieces along the track (mm).
        y_edges: Ends of the cells across it (mm), y to the right.
        depths: Depth removed in a passage, shape [pieces, cells] (mm): the mean over the passages of each piece.
        pmax: The largest pressure in each piece (N/mm^2); 0 without a state.
    """

    x_edges: Array
    y_edges: Array
    depths: Array
    pmax: Array

    def after(self, passages: float) -> Array:
        """Returns the depths after so many passages (mm) on unchanged profiles."""
        return self.depths * passages


def depths_along(
    client: WheelRailClient,
    setup: WheelRailSetup | Mapping[str, Any],
    states: Sequence[WeightedState],
    law: WearLaw | Mapping[str, Any],
    x_edges: npt.ArrayLike,
    y_edges: npt.ArrayLike,
    *,
    energy: WearEnergy = "scaled",
) -> DepthMap:
    """Returns the wear depths of a rail in the given states; the law must be that of the rail. A state belongs to the
    piece of its `position.x`; weights are shares of the passages there. The area of each row inside `y_edges` is
    conserved.

    Raises InvalidArgument for a law of the wheel, for edges that do not ascend, if all wear is outside them, and for a
    state that cannot be solved, which it names.
    """
    along, across = (_edges(values, name) for values, name in ((x_edges, "x_edges"), (y_edges, "y_edges")))
    given = params_of(law, "law") if isinstance(law, WearLaw) else with_objects(WearLaw, law, "law")
    if given.get("body") != "upper":
        raise invalid("law.body", f"is {given.get('body')}; the rail's law must have body upper")
    plain = setup_params(setup) if isinstance(setup, WheelRailSetup) else dict(setup)
    params: Mapping[str, Any] = {**plain, "wear": {"energy": energy, "laws": [given]}}
    depths, weights = np.zeros((len(along) - 1, len(across) - 1)), np.zeros(len(along) - 1)
    pmax, worn, warnings = np.zeros(len(along) - 1), list[float](), list[str]()
    for i, one in enumerate(states):
        piece = int(np.searchsorted(along, one.state.position.x, side="right")) - 1
        if not 0 <= piece < len(pmax):
            raise invalid(f"states[{i}].position.x", f"is {one.state.position.x:g}, outside the pieces, {along[0]:g} to {along[-1]:g} mm")
        own = params if one.mu is None else {**params, "friction": {**(params.get("friction") or {}), "mu": one.mu}}
        with collected() as sentences:
            answer = client.call("wheelrail.solve", {"setup": own, "state": state_params(one.state, f"states[{i}]"), "fields": []})
        warnings += [f"states[{i}]: {sentence}" for sentence in sentences]
        weights[piece] += one.weight
        for patch in answer.get("patches", ()):
            pmax[piece] = max(pmax[piece], patch["solution"]["pmax"])
            dy = patch["place"]["grid"]["dy"]
            for row in patch["solution"].get("wear", {}).get("rows", ()):
                # A row is dy wide along its surface, and narrower when seen from above.
                half = 0.5 * dy * abs(np.cos(row["angle"]))
                covered = np.diff(np.clip(across, row["y"] - half, row["y"] + half))
                if row["depths"][0] > 0:
                    worn.append(row["y"])
                share = covered / (2 * half) if half > 0 else np.zeros(len(covered))
                depths[piece] += one.weight * row["depths"][0] * dy * share / np.diff(across)
    if worn and not depths.any():
        raise invalid("y_edges", f"reach from {across[0]:g} to {across[-1]:g} mm, but contacts wear from {min(worn):g} to {max(worn):g} mm: extend them")
    give(warnings)
    return DepthMap(along, across, depths / np.where(weights > 0, weights, 1.0)[:, None], pmax)


def _edges(values: npt.ArrayLike, name: str) -> Array:
    found = np.asarray(values, dtype=np.float64)
    if found.ndim != 1 or len(found) < 2 or not np.isfinite(found).all() or not (np.diff(found) > 0).all():
        raise invalid(name, "must be at least two finite numbers in ascending order")
    return found
