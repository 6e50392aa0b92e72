"""Defines the Cattaneo problem of section 4, and the known values of its solution."""

from __future__ import annotations

import math
from typing import Any

from contactd import (
    AnalyticIcs,
    ContactProblem,
    FemIcs,
    Friction,
    Grid,
    Material,
    Paraboloid,
    SolverSettings,
    TangentialSettings,
)

Spec = dict[str, Any]
Ics = dict[str, Any]

BODY = Material(G=200, nu=0.42)
RADIUS, APPROACH, WINDOW = 50.0, 0.02, 2.4  # mm
MU, SHIFT = 0.4, 0.00817  # rigid shift along x (mm)
TOLERANCE = 1e-6  # of both stopping criteria

# In Hertz's contact of two equal bodies, 1/E* = (1 - nu)/G, and the contact radius is sqrt(R delta).
_E_STAR = BODY.G / (1 - BODY.nu)
FZ = 4 / 3 * _E_STAR * math.sqrt(RADIUS) * APPROACH**1.5
PMAX = 2 * _E_STAR / math.pi * math.sqrt(APPROACH / RADIUS)
AREA = math.pi * RADIUS * APPROACH
#: The paper's reference values; the part "limit" shows how accurate they are.
FX = 3.2216
#: Cattaneo's solution for this shift, which neglects lateral displacements (Johnson, Contact Mechanics, 7.2).
_FULL_SLIP = 3 * MU * FZ * (2 - BODY.nu) / (8 * BODY.G * math.sqrt(RADIUS * APPROACH))  # shift where adhesion ends (mm)
CATTANEO_FX = MU * FZ * (1 - (1 - SHIFT / _FULL_SLIP) ** 1.5)


def spec_of(n: int, ics: Ics, **more: Any) -> Spec:
    """Returns a request on n x n elements. `ics` are the fields of FemIcs, or of AnalyticIcs if they have no mesh.

    `more`: tangential (the ics of xx, xy, yx, yy where they differ from those of zz), no_xy, tolerance.
    """
    return {"problem": "cattaneo", "n": n, "ics": ics, **more}


def ics_of(fields: Ics) -> AnalyticIcs | FemIcs:
    return FemIcs(**fields) if fields.keys() - {"load_shape"} else AnalyticIcs(**fields)


def contact_problem(spec: Spec) -> ContactProblem:
    tolerance = spec.get("tolerance", TOLERANCE)
    return ContactProblem(
        grid=Grid.centred(spec["n"], spec["n"], WINDOW, WINDOW),
        upper=BODY,
        gap=Paraboloid(RADIUS, RADIUS),
        approach=APPROACH,
        ics=ics_of(spec["ics"]),
        friction=Friction(MU, (SHIFT, 0)),
        normal=SolverSettings(tolerance=tolerance),
        tangential=TangentialSettings(tolerance=tolerance, solver="tangcg"),  # as in the paper
    )
