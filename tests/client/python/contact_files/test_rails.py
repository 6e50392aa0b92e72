"""Wheels on rails and rollers by the conventions of the CONTACT program."""

from __future__ import annotations

from typing import Any

import pytest

from contactd.contact_files.problems.rails import RailContact
from contactd.wheel_rail import S1002, Rail60E1
from support.contact_cases import rail_case


def made(case: Any) -> RailContact:
    return RailContact.of(case, lambda _, which: Rail60E1(0.025) if which == "RAIL" else S1002(), "exact")


_ROLLER: dict[str, Any] = {"C1": 5, "NOMRADR": 500.0, "RPITCH": 4.0, "X_WS": 0.0}


@pytest.mark.parametrize("cant", [0.0, 0.025])
def test_a_roller_has_its_cant_and_leans_with_it(cant: float) -> None:
    track = made(rail_case(CANT=cant, **_ROLLER)).setup.track
    assert track is not None
    assert (track.cant, track.roller_radius, bool(track.roller_leans)) == (cant, 500, cant != 0)


def test_forces_do_not_follow_slopes_along_the_track() -> None:
    assert made(rail_case(**_ROLLER)).setup.slope_forces == "none"
    assert made(rail_case()).setup.slope_forces is None
    slices = [(-10.0, Rail60E1(0.025)), (10.0, Rail60E1(0.025))]
    sliced = RailContact.of(
        rail_case(), lambda _, which: (slices, "cubic") if which == "RAIL" else S1002(), "exact"
    )  # fmt: skip
    assert sliced.setup.slope_forces == "none"


@pytest.mark.parametrize("plane", [2, 3, 4, 5])
def test_wheels_displaced_along_the_track_turn_about_the_rigid_axle_in_planes_only(plane: int) -> None:
    case = rail_case(D=plane, DISCNS=plane, E=5, DXWHL=3.0, VYAW=0.01, VPITCH=-4.0, VZWHL=0.5)
    wheel = made(case).state.wheel
    stays = plane in (3, 4)
    assert wheel.x == 3
    assert wheel.y_velocity == pytest.approx(0 if stays else 0.03)
    assert wheel.z_velocity == pytest.approx(0.5 if stays else 12.5)
