"""Wheels on rails and rollers by the conventions of the CONTACT program."""

from __future__ import annotations

from typing import Any

import pytest

from contactd import FrictionMemory, TemperatureFriction
from contactd.contact_files.problems.rails import RailContact
from contactd.wheel_rail import S1002, Rail60E1
from support.contact_cases import rail_case


def made(case: Any) -> RailContact:
    return RailContact.of(case, lambda _, which: Rail60E1(0.025) if which == "RAIL" else S1002(), "exact")


_STEEL = {"BKTEMP": 20.0, "HEATCP": 450.0, "LAMBDA": 0.05, "DENS": 7.85e-6}
_ROLLER: dict[str, Any] = {"C1": 5, "NOMRADR": 500.0, "RPITCH": 4.0, "X_WS": 0.0}


@pytest.mark.parametrize("cant", [0.0, 0.025])
def test_a_roller_has_its_cant_and_leans_with_it(cant: float) -> None:
    track = made(rail_case(CANT=cant, **_ROLLER)).setup.track
    assert track is not None
    assert (track.cant, track.roller_radius, bool(track.roller_leans)) == (cant, 500, cant != 0)


def _along(law: int, *sets: tuple[float, dict[str, float]], **changes: Any) -> Any:
    friction = [{"SVF": place, **numbers} for place, numbers in sets]
    memory = {"MEMDST": 0.0, "MEM_S0": 1.0} if law else {}
    return made(rail_case(friction=friction, V=2, VARFRC=2, L=law, FRCLAW=law, **memory, **changes)).setup.friction


def test_friction_along_the_track_has_the_mean_numbers_half_way_and_equal_laws_are_one() -> None:
    def law(fkin: float, f1: float, s1: float, f2: float, s2: float) -> dict[str, float]:
        return {"FKIN": fkin, "F1": f1, "SABSH1": s1, "F2": f2, "SABSH2": s2}

    one, other, mean = law(0.3, 0, 1e-4, 0, 1e-4), law(0.1, 0.2, 400, 0.1, 2000), law(0.2, 0.1, 200.00005, 0.05, 1000.00005)
    same = made(rail_case(friction=[mean], L=4, FRCLAW=4, MEMDST=0.0, MEM_S0=1.0)).setup.friction
    assert _along(4, (-10, one), (10, other)) == same
    assert _along(4, (-10, mean), (20, mean)) == same
    assert _along(4, (0, mean), (20, other)) == same
    assert _along(4, (-20, other), (-10, mean)) == same
    hot = {"FREF": 0.4, "TREF": 20.0, "DFHEAT": -0.2, "DTHEAT": 100.0}
    cold = {"FREF": 0.2, "TREF": 40.0, "DFHEAT": -0.1, "DTHEAT": 300.0}
    steel = {f"{name}{body}": value for body in "12" for name, value in _STEEL.items()}
    friction = _along(6, (-10, hot), (10, cold), H=3, **steel)
    assert friction.temperature.change == pytest.approx(-0.15)
    assert (friction.temperature.reference, friction.temperature.range) == (30, 200)


def test_friction_along_the_track_of_a_wheel_on_a_roller_is_that_at_its_own_place() -> None:
    friction = _along(0, (0, {"FSTAT": 0.2, "FKIN": 0.2}), (10, {"FSTAT": 0.4, "FKIN": 0.4}), **{**_ROLLER, "X_WS": 5.0, "S_WS": 0.0})
    (mu,) = friction.mu if isinstance(friction.mu, list) else [friction.mu]
    assert mu == pytest.approx(0.3)


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


_HEAT: dict[str, Any] = {"H": 3, "T": 3} | {
    f"{name}{body}": value
    for name, value in (("BKTEMP", 20.0), ("HEATCP", 450.0), ("LAMBDA", 0.05), ("DENS", 7.85e-6))
    for body in (1, 2)
}


def _at(angle: float, change: float) -> dict[str, float]:
    return {"ALPHVF": angle, "FREF": 0.4, "TREF": 20.0, "DFHEAT": change, "DTHEAT": 400.0}


@pytest.mark.parametrize("distance", [0.0, 0.01])
@pytest.mark.parametrize("alike", [False, True])
def test_friction_by_temperature_and_angle_has_memory(distance: float, alike: bool) -> None:
    sets = [_at(-1.0, -0.1), _at(0.5, -0.1 if alike else -0.2)]
    case = rail_case(V=1, VARFRC=1, L=6, FRCLAW=6, friction=sets, MEMDST=distance, MEM_S0=5.0, **_HEAT)
    friction = made(case).setup.friction
    assert friction is not None
    memory = FrictionMemory(distance, 5) if distance > 0 else None
    if alike:
        assert friction.temperature == TemperatureFriction(-0.1, 20, 400, memory)
        assert (friction.temperature_by_angle, friction.memory) == (None, None)
    else:
        assert friction.temperature_by_angle == [(-1.0, -0.1, 20, 400), (0.5, -0.2, 20, 400)]
        assert (friction.temperature, friction.memory) == (None, memory)
