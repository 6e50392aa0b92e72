"""Provides parameters that several scenarios use."""

from __future__ import annotations

from typing import Any

#: A solve of some milliseconds.
SOLVE: dict[str, Any] = {
    "grid": {"nx": 6, "ny": 5, "dx": 0.4, "dy": 0.4},
    "bodies": {"upper": {"G": 200, "nu": 0.42}},
    "ics": {"source": "analytic"},
    "gap": {"paraboloid": {"Rx": 50, "Ry": 50}},
    "approach": 0.02,
}
#: A solve that only ends when it is cancelled.
ENDLESS: dict[str, Any] = {
    **SOLVE,
    "grid": {"nx": 80, "ny": 80, "dx": 0.03, "dy": 0.03},
    "friction": {"mu": 0.4, "rolling": {"kind": "transient", "xi": 1e-3, "steps": 100_000}},
}
#: Stresses at one point, in one turn of a worker.
STRESS: dict[str, Any] = {
    "grid": {"nx": 1, "ny": 1, "dx": 1, "dy": 1}, "nu": 0.3, "pressure": [[1]], "points": [[0, 0, -1]],
}  # fmt: skip
HEAT: dict[str, Any] = {
    "grid": {"nx": 3, "ny": 1, "dx": 1, "dy": 1}, "velocity": 20000, "temperature": {"upper": {"bulk_temperature": 80}, "lower": {}},
    "pressure": [[0, 900, 800]], "traction_x": [[0, -270, -240]], "traction_y": [[0, 0, 0]], "slip_x": [[0, 0.01, 0.01]],
    "slip_y": [[0, 0, 0]],
}  # fmt: skip
TABLE: dict[str, Any] = {
    "material": {"G": 82000, "nu": 0.28},
    "grid": {"nx": 4, "ny": 6, "dx": 0.8, "dy": 0.8},
    "ics": {"source": "analytic"},
}
#: A table in about a tenth of a second.
QUICK_BUILD: dict[str, Any] = {**TABLE, "ics": {"source": "fem", "preset": "paper-test2", "order": 1, "L_over_h": 40}}
#: A table that takes a minute.
LONG_BUILD: dict[str, Any] = {**TABLE, "ics": {"source": "fem", "preset": "paper-test1", "L_over_h": 1000}}
