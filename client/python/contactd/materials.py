"""Provides materials with the source of their constants, in N and mm.

::

    from contactd import Paraboloid, solve
    from contactd.materials import SOURCES, aluminium, steel

    solution = solve(Paraboloid(50, 50), steel, aluminium, Fn=100)
    print(SOURCES["aluminium"])

Real materials vary by some per cent. Use measured values where you have them: ``Material(E=206000, nu=0.29)``.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from .values.generated.materials import Material

__all__ = ["SOURCES", "aluminium", "glass", "steel", "structural_steel"]

#: Steel of wheels and rails, the default of contactd.wheel_rail.
steel = Material(G=82000.0, nu=0.28)
#: Structural steel.
structural_steel = Material(E=210000.0, nu=0.3)
#: Aluminium alloys.
aluminium = Material(E=70000.0, nu=0.3)
#: Soda-lime silicate glass.
glass = Material(E=70000.0, nu=0.2)

#: Sources of the constants by the name of the material.
SOURCES: Mapping[str, str] = MappingProxyType(
    {
        "steel": "usual in wheel-rail contact, as in the examples of CONTACT: G = 82000 N/mm^2, nu = 0.28",
        "structural_steel": "EN 1993-1-1, 3.2.6: E = 210000 N/mm^2, nu = 0.3",
        "aluminium": "EN 1999-1-1, 3.2.5: E = 70000 N/mm^2, nu = 0.3",
        "glass": "EN 572-1: E = 70000 N/mm^2, nu = 0.2",
    }
)
