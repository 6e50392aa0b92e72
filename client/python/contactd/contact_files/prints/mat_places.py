"""Positions of rail, wheel and patch for the header of a .mat file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...values.generated.wheel_rail.result import WheelRailPatch
from ..answers.rail_places import along_axle
from ..answers.rail_results import RailResult

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["PatchPlaces", "patch_places"]


@dataclass(frozen=True)
class PatchPlaces:
    """Lines of the header.

    Attributes:
        rail: Time, position along the track, pitch, the rail profile's y, z and roll in the track's axes, nominal
            radius.
        wheel: The wheel profile's x, y, z, roll and yaw in the track's axes, nominal radius.
        reference: Reference of the patch on the rail (x, y, z, angle) and on the wheel (x, y, z), the number of
            patches, its own number, and the centre of spin.
        nominal: Position y of the wheel's profile on its axle.
        counted_from: The reference of the patch relative to the origin of the element numbering, in the axes of the
            patch.
    """

    rail: list[float]
    wheel: list[float]
    reference: list[float | int]
    nominal: float
    counted_from: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def none(cls, case: Case) -> PatchPlaces:
        """Returns the positions for basic contact, which only has a centre of spin."""
        centre = (case.values["SPINXO"], case.values["SPINYO"])
        return cls([], [], [*[0.0] * 7, 1, 1, *centre], 0.0)


def patch_places(result: RailResult, patch: WheelRailPatch, number: int) -> PatchPlaces:
    """Returns the positions of a patch; patches are counted from the field side."""
    values, contact, reference = result.contact.case.values, result.contact, patch.place.reference
    along = values.get("S_WS", values.get("X_WS", 0.0))
    rail, wheel = result.solution.rail_frame, result.solution.wheel_frame
    place = [reference.x, reference.y, reference.z, reference.angle, *result.on_wheel(patch)]
    return PatchPlaces(
        [0.0, along, values["PITCH"], rail.y, rail.z, rail.roll, values.get("NOMRADR", 0.0)],
        [wheel.x, wheel.y, wheel.z, wheel.roll, wheel.yaw, values["NOMRADW"]],
        [*place, len(result.patches), number, *result.spin_centre(patch)],
        along_axle(contact),
        result.spin_centre(patch),
    )
