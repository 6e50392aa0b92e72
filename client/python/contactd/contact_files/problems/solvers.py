"""Tolerances and limits of the solvers for a case."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ...values.generated.evidence import SolverSettings

__all__ = ["solver_settings"]

_OWN = {"normal": 1e-8, "tangential": 1e-6, "outer": 1e-6}  #: Default tolerances of contactd; a case can only decrease them.
_NO_LIMIT = 999  #: Default of MAXGS.


def solver_settings(values: Mapping[str, Any]) -> dict[str, SolverSettings]:
    """Returns the settings that differ from the defaults. MAXGS limits the iterations for pressures and tractions, and
    MAXOUT from 2 on the outer iterations.
    """
    eps, inner, outer = values["EPS"], values["MAXGS"], values["MAXOUT"]
    limits = {"normal": inner if inner != _NO_LIMIT else None, "outer": outer if outer > 1 else None}
    limits["tangential"] = limits["normal"]
    found = {name: SolverSettings(eps if eps < own else None, limits[name]) for name, own in _OWN.items()}
    return {name: one for name, one in found.items() if one != SolverSettings()}
