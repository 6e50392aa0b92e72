"""Names and units of the arrays of a solution.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

__all__ = ["ARRAY_LABELS"]

ARRAY_LABELS = {
    "element_division": ("0 exterior, 1 adhesion, 2 slip, 3 flow", "1"),
    "pressure": ("pressure", "N/mm^2"),
    "traction_x": ("traction along x on the upper body", "N/mm^2"),
    "traction_y": ("traction along y on the upper body", "N/mm^2"),
    "slip_x": ("slip of the upper body over the lower, along x", ""),
    "slip_y": ("slip of the upper body over the lower, along y", ""),
    "displacement_x": ("displacement of the upper body's surface minus that of the lower body's, along x", "mm"),
    "displacement_y": ("displacement of the upper body's surface minus that of the lower body's, along y", "mm"),
    "displacement_z": ("elastic displacement of both bodies along z", "mm"),
    "flow_x": ("plastic flow of a layer, along x", ""),
    "flow_y": ("plastic flow of a layer, along y", ""),
    "yield_stress": ("yield stress of a layer", "N/mm^2"),
    "friction_coefficient": ("coefficient of friction", "1"),
    "upper_temperature": ("temperature of the upper surface", "degC"),
    "lower_temperature": ("temperature of the lower surface", "degC"),
    "pressure_by_approach": ("derivative of the pressure by the approach", "N/mm^3"),
}
