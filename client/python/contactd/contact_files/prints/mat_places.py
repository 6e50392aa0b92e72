"""Computes positions of rail, wheel and patch for the header of a .mat file."""

from __future__ import annotations

from dataclasses import dataclass

from ..case import Case
from ..case_results import is_right
from ..solved_case import SolvedCase

__all__ = ["PatchPlaces", "patch_places"]

_REFERENCE = ("XCP(TR)", "YCP(TR)", "ZCP(TR)", "DELTCP(TR)", "XCP(W)", "YCP(W)", "ZCP(W)")


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


def patch_places(solved: SolvedCase, index: int) -> PatchPlaces:
    """Returns the positions of a patch; patches are counted from the field side."""
    values, wheel = solved.case.values, solved.answer.wheelrail
    assert wheel is not None
    patches, rail, of_wheel = solved.answer.patches, wheel.rail_frame, wheel.wheel_frame
    reference = [patches[index].numbers[name] for name in _REFERENCE]
    centre = (patches[index].numbers["SPINXO"], patches[index].numbers["SPINYO"])
    along_axle = values["FBDIST"] / 2 - values["FBPOS"]
    return PatchPlaces(
        [0.0, values.get("S_WS", values.get("X_WS", 0.0)), values["PITCH"], rail.y, rail.z, rail.roll, values.get("NOMRADR", 0.0)],
        [of_wheel.x, of_wheel.y, of_wheel.z, of_wheel.roll, of_wheel.yaw, values["NOMRADW"]],
        [*reference, len(patches), index + 1, *centre],
        along_axle if is_right(solved.case) else -along_axle,
        centre,
    )  # fmt: skip
