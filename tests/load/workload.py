"""Creates requests whose answers can be checked, because everything is linear in a random factor.

Gap, approach and rigid shift times s multiply all tractions and forces by s, and so do pressures for stresses;
coefficients are proportional to 1/G. The results for the factor 1 are requested once, before the load begins.
"""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

Frames = list[bytes]
#: Iterative solutions of scaled problems agree much better than their tolerance of 1e-6.
AGREEMENT = 1e-5


@dataclass(frozen=True)
class Kind:
    """Describes one kind of request: its parameters and frames for a factor, and the numbers of the answer that are
    linear in it."""

    name: str
    method: str
    weight: float
    make: Callable[[float], tuple[dict[str, Any], Frames]]
    numbers: Callable[[dict[str, Any], Frames], np.ndarray[Any, Any]]
    inverse: bool = False


def cattaneo(n: int, s: float) -> dict[str, Any]:
    """Returns the paper's problem on n x n elements."""
    return {
        "grid": {"nx": n, "ny": n, "dx": 2.4 / n, "dy": 2.4 / n},
        "bodies": {"upper": {"G": 200, "nu": 0.42}},
        "ics": {"source": "analytic"},
        "gap": {"paraboloid": {"Rx": 50 / s, "Ry": 50 / s}},
        "approach": 0.02 * s,
        "friction": {"mu": 0.4, "rigid_shift": [0.00817 * s, 0]},
    }


def with_gap_array(n: int, s: float) -> tuple[dict[str, Any], Frames]:
    x = (np.arange(n) - (n - 1) / 2) * 2.4 / n
    gap = s * (x[None, :] ** 2 + x[:, None] ** 2) / 100
    params = cattaneo(n, s)
    params["gap"] = {"array": {"$array": {"frame": 1, "dtype": "<f8", "shape": [n, n]}}}
    del params["friction"]
    return params, [gap.tobytes()]


def array(result: dict[str, Any], frames: Frames, name: str) -> np.ndarray[Any, Any]:
    reference = result[name]["$array"]
    return np.frombuffer(frames[reference["frame"] - 1], reference["dtype"])


def of_solution(result: dict[str, Any], frames: Frames) -> np.ndarray[Any, Any]:
    forces = result["forces"]
    return np.array([forces["Fn"], forces["Fx"], result["pmax"], array(result, frames, "pressure").sum()])


def of_solutions(result: dict[str, Any], frames: Frames) -> np.ndarray[Any, Any]:
    return np.array([value for entry in result["solutions"] for value in of_solution(entry["result"], frames)])


def stresses(s: float) -> tuple[dict[str, Any], Frames]:
    params = {
        "grid": {"nx": 8, "ny": 8, "dx": 0.1, "dy": 0.1},
        "nu": 0.3,
        "pressure": {"$array": {"frame": 1, "dtype": "<f8", "shape": [8, 8]}},
        "block": {"x": [0, 0.1], "y": [0], "z": [-0.1, -0.2, -0.4]},
    }
    return params, [np.full(64, s).tobytes()]


def coefficients(s: float) -> tuple[dict[str, Any], Frames]:
    grid = {"nx": 20, "ny": 20, "dx": 0.1, "dy": 0.1}
    return {"material": {"G": 82000 * s, "nu": 0.28}, "grid": grid, "ics": {"source": "analytic"}}, []


def many(s: float) -> tuple[dict[str, Any], Frames]:
    return {"problems": [cattaneo(12, s), cattaneo(25, s), cattaneo(12, s)]}, []


KINDS = [
    Kind("solve 25", "contact.solve", 60, lambda s: (cattaneo(25, s), []), of_solution),
    Kind("solve 10, gap in a frame", "contact.solve", 15, lambda s: with_gap_array(10, s), of_solution),
    Kind("solve 60", "contact.solve", 4, lambda s: (cattaneo(60, s), []), of_solution),
    Kind("solve_many", "contact.solve_many", 4, many, of_solutions),
    Kind("subsurface", "contact.subsurface", 5, stresses, lambda r, f: array(r, f, "von_mises")),
    Kind("ic.get", "ic.get", 5, coefficients, lambda r, f: array(r, f, "table"), inverse=True),
    Kind("health", "server.health", 7, lambda s: ({}, []), lambda r, f: np.array([])),
]
SMALL = KINDS[0].name


def request(kind: Kind, name: str, s: float) -> list[bytes]:
    params, frames = kind.make(s)
    return [json.dumps({"contactd": 1, "id": name, "method": kind.method, "params": params}).encode(), *frames]


def draw(choose: random.Random) -> tuple[int, float]:
    """Returns the number of a kind and a factor."""
    (kind,) = choose.choices(range(len(KINDS)), [kind.weight for kind in KINDS])
    return kind, choose.uniform(0.5, 2)


def is_right(kind: Kind, s: float, result: dict[str, Any], frames: Frames, reference: np.ndarray[Any, Any]) -> bool:
    """Returns whether the answer belongs to the request with the factor `s`."""
    if kind.method == "server.health":
        return bool(result["state"] == "serving")
    expected = reference / s if kind.inverse else reference * s
    found = kind.numbers(result, frames)
    return found.shape == expected.shape and bool(np.allclose(found, expected, rtol=AGREEMENT, atol=AGREEMENT * np.abs(expected).max()))
