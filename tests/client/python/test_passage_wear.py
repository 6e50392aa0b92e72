"""Tests the wear of a passage: laws as objects, and the worn sections of wheels and rails."""

from __future__ import annotations

import matplotlib
import numpy as np
import pytest

import contactd
from contactd import ArchardWear, EnergyWear, InvalidArgument, WearLaw, WearRequest, wheel_rail
from contactd.wheel_rail import WheelRailSetup

matplotlib.use("Agg")
pytestmark = pytest.mark.usefixtures("solving_here")

C = 6.75e-4
SETUP = WheelRailSetup(dx=0.5, dy=0.5)
STATE = {"y": 3, "yaw": 0.003, "speed": 20e3, "Fz": 80e3}


def solved(*laws, setup=SETUP, **state):
    return wheel_rail(setup, **{**STATE, **state}, wear=laws, fields=[])


def test_an_energy_law_takes_off_in_proportion_to_t_gamma():
    solution = solved(EnergyWear(C, source="our test"))
    wear = solution.wear()
    answer = solution.patches[0].solution.wear
    assert (wear.body, wear.law) == ("wheel", "energy")
    assert wear.area_per_passage == pytest.approx(C * 1e-3 * answer.T_gamma_with_spin, rel=1e-6)  # mm^3/J, and N mm
    assert wear.T_gamma == answer.T_gamma
    assert wear.depth_per_passage == answer.laws[0].depth


def test_a_wheel_comes_round_by_its_radius():
    wear = solved(EnergyWear(C, source="our test")).wear("wheel")
    deepest = wear.depths_per_km.argmax()
    radius = 460 + wear.points[deepest, 1]
    assert wear.passages_per_km == pytest.approx(1e6 / (2 * np.pi * radius), rel=5e-4)  # planes of patches leave the profile
    assert wear.depth_per_km == pytest.approx(wear.depth_per_passage * wear.passages_per_km)
    assert wear.depths_per_km.max() == pytest.approx(wear.depth_per_km, rel=0.03)


@pytest.mark.parametrize("body", ["wheel", "rail"])
@pytest.mark.parametrize("side", ["right", "left"])
def test_the_section_loses_the_area_of_the_passages(body, side):
    sign = 1 if side == "right" else -1
    law = EnergyWear(C, source="our test", body=body)
    wear = solved(law, setup=SETUP.replace(side=side), y=sign * 3, yaw=sign * 0.003).wear()
    passages = 1000
    worn, new = wear.section(passages=passages), wear.points
    assert worn.shape == new.shape
    below = np.trapezoid(worn[:, 1], worn[:, 0]) - np.trapezoid(new[:, 1], new[:, 0])  # z is down
    assert (below if body == "rail" else -below) == pytest.approx(passages * wear.area_per_passage, rel=0.02)
    assert np.abs(worn - new).max() == pytest.approx(passages * wear.depths.max(), rel=0.1)


def test_a_wheel_after_kilometres_and_after_passages_is_the_same():
    wear = solved(EnergyWear(C, source="our test")).wear()
    many = wear.passages_per_km
    deepest = 100 * wear.depth_per_km  # radii differ by a thousandth across the contact
    assert wear.section(km=100) == pytest.approx(wear.section(passages=100 * many), abs=1e-3 * deepest)
    assert np.array_equal(wear.section(km=0), wear.points)


def test_left_and_right_wear_alike():
    law = EnergyWear(C, source="our test")
    right = solved(law).wear()
    left = solved(law, setup=SETUP.replace(side="left"), y=-3, yaw=-0.003).wear()
    assert left.depth_per_km == pytest.approx(right.depth_per_km, rel=1e-6)
    assert left.depths_per_km == pytest.approx(right.depths_per_km, abs=1e-3 * right.depth_per_km)


def test_laws_are_told_apart_by_body_and_name():
    hard = ArchardWear(hardness=3000, mild=5e-4, source="our test", name="hard")
    solution = solved(EnergyWear(C, source="our test"), hard, EnergyWear(2 * C, source="our test", body="rail", name="rail's"))
    assert solution.wear("rail").law == "rail's"
    assert solution.wear("wheel", "hard").law == "hard"
    assert solution.wear(law="energy").area_per_passage == pytest.approx(solution.wear("rail").area_per_passage / 2)
    with pytest.raises(InvalidArgument, match=r"law must be one of those of the answer: energy of the wheel, hard of the wheel"):
        solution.wear("wheel")
    with pytest.raises(InvalidArgument, match='body is "upper"|body is \'upper\''):
        solution.wear("upper")


def test_requests_and_laws_of_before_serve_as_well():
    law = WearLaw("energy", "our test", "lower", (0, 10), energy=EnergyWear(C))
    expected = solved(EnergyWear(C, source="our test")).wear().depth_per_km
    for wear in (law, [law], WearRequest((law,))):
        assert wheel_rail(SETUP, **STATE, wear=wear, fields=[]).wear().depth_per_km == expected


def test_what_a_kind_says_of_its_law_does_not_go_into_the_kind_on_the_wire():
    law = WearLaw("mild", "our test", "lower", (0, 10), energy=EnergyWear(C, source="another", body="rail", range=(0, 1), name="x"))
    assert law.params()["energy"] == {"coefficient": C}


def test_the_range_of_a_law_warns():
    with pytest.warns(contactd.ContactWarning, match="range"):
        solved(EnergyWear(C, source="our test", range=(0, 0.1)))


def test_a_law_without_a_source_is_refused():
    with pytest.raises(TypeError, match="EnergyWear has no source: give the source of its coefficients"):
        solved(EnergyWear(C))
    with pytest.raises(TypeError, match='EnergyWear.body is \'lower\'; it must be "wheel" or "rail"'):
        solved(EnergyWear(C, source="our test", body="lower"))
    with pytest.raises(InvalidArgument, match=r"wear\.laws\[0\]\.energy\.coefficient"):
        solved(EnergyWear(-1, source="our test"))


def test_a_rail_wears_by_passages():
    wear = solved(EnergyWear(C, source="our test", body="rail")).wear()
    with pytest.raises(InvalidArgument, match="a rail wears by passages"):
        wear.depth_per_km  # noqa: B018
    with pytest.raises(InvalidArgument, match="a rail wears by passages"):
        wear.section(km=1)
    with pytest.raises(TypeError, match="either km or passages"):
        wear.section()
    with pytest.raises(InvalidArgument, match="passages is -1"):
        wear.section(passages=-1)
    assert "depth per km" not in repr(wear)


def test_without_laws_or_profiles_there_is_no_such_wear(tmp_path):
    with pytest.raises(InvalidArgument, match="wear was not requested"):
        wheel_rail(SETUP, **STATE, fields=[]).wear()
    solution = solved(EnergyWear(C, source="our test"))
    solution.save(tmp_path / "wheel.h5")
    with pytest.raises(InvalidArgument, match="is from a file"):
        contactd.load(tmp_path / "wheel.h5").wear()


def test_it_draws_itself():
    wear = solved(EnergyWear(C, source="our test")).wear()
    axes = wear.plot()
    assert axes.get_lines()[0].get_ydata().max() == pytest.approx(1000 * wear.depths_per_km.max())
    assert "wheel" in axes.get_title()
    matplotlib.pyplot.close("all")
