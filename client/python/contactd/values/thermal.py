"""What bodies have to do with heat.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from .params import HasParams

__all__ = ["ThermalBodies", "ThermalBody"]


@dataclass(frozen=True)
class ThermalBody(HasParams):
    """What a body has to do with heat; properties do not follow its temperature. Those of steel unless given.

    Attributes:
        bulk_temperature: Temperature where the surface has not been in contact (degC), >= -273.15. Default 0.
        conductivity: Thermal conductivity (W/(m K)), >= 0; a body of none takes no heat. Default 50.
        heat_capacity: Specific heat capacity (J/(kg K)), >= 1e-12. Default 450.
        density: Density (kg/m^3), >= 1e-12. Default 7850.
    """

    bulk_temperature: float | None = None
    conductivity: float | None = None
    heat_capacity: float | None = None
    density: float | None = None


@dataclass(frozen=True)
class ThermalBodies(HasParams):
    """What both bodies have to do with heat: with it, solutions of steady rolling along x have temperatures of the
    surfaces.

    ::

        ThermalBodies()  # of steel
        ThermalBodies(upper=ThermalBody(bulk_temperature=120), lower=ThermalBody(bulk_temperature=20))

    Attributes:
        upper: The upper body; None: of steel, at 0 degrees.
        lower: The lower body; None: as the upper one.
        plastic_share: Share of the plastic work of an interfacial layer that becomes heat (0 to 1); the rest stays in
            the layer. Default 1.
    """

    upper: ThermalBody | None = None
    lower: ThermalBody | None = None
    plastic_share: float | None = None
