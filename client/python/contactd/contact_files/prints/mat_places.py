"""Where rail, wheel and a patch are, as the header of a .mat file has them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...values.wheel_rail.result import WheelRailPatch
from ..answers.rail_places import rail_frame, wheel_frame
from ..answers.rail_results import RailResult

if TYPE_CHECKING:
    from ...values.contact_files import ContactCase as Case

__all__ = ["PatchPlaces", "patch_places"]


@dataclass(frozen=True)
class PatchPlaces:
    """Lines of the header.

    Attributes:
        rail: Time, place along the track, pitch, the rail profile's y, z and roll in the track's axes, its nominal radius.
        wheel: The wheel profile's x, y, z, roll and yaw in the track's axes, its nominal radius.
        reference: Of the patch on the rail (x, y, z, angle) and on the wheel (x, y, z), the number of patches and its own,
            and the centre of spin.
        nominal: y of the wheel's profile on its axle.
        counted_from: The reference of the patch from where elements are counted, in the axes of the patch.
    """

    rail: list[float]
    wheel: list[float]
    reference: list[float | int]
    nominal: float
    counted_from: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def none(cls, case: Case) -> PatchPlaces:
        """The places of basic contact, which has the centre of spin only."""
        centre = (case.values["SPINXO"], case.values["SPINYO"])
        return cls([], [], [*[0.0] * 7, 1, 1, *centre], 0.0)


def patch_places(result: RailResult, patch: WheelRailPatch, number: int) -> PatchPlaces:
    """The places of a patch, which is counted from the field side."""
    values, contact, reference = result.contact.case.values, result.contact, patch.place.reference
    along = values.get("S_WS", values.get("X_WS", 0.0))
    y_rail, z_rail, roll_rail = rail_frame(contact, result.solution)
    place = [reference.x, reference.y, reference.z, reference.angle, *result.on_wheel(patch)]
    wheel, nominal = wheel_frame(contact, result.solution.z)
    return PatchPlaces(
        [0.0, along, values["PITCH"], y_rail, z_rail, roll_rail, values.get("NOMRADR", 0.0)],
        [*wheel, values["NOMRADW"]],
        [*place, len(result.patches), number, *result.spin_centre(patch)],
        nominal,
        result.spin_centre(patch),
    )
