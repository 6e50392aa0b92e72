"""Standard profiles by name: against second sources, and the conicities of the page."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from contactd import InvalidArgument
from contactd.standard_profiles import STANDARDS
from contactd.wheel_rail import S1002, Rail60E1, StandardProfile, Track, WheelRailSetup

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "profiles.md").read_text()
RAILS = [name for name, of in STANDARDS.items() if of.of == "rail"]
BY_ORIGIN = Track(rail_origin=(750.0, 0.0))
#: z (mm) of S1002 in tables C.1 and C.2 of EN 13715:2020, as in the public package EN13715 of A. Rohrbeck: every half
#: millimetre from y = -35 on, and from y = 0 on.
TABLE_1 = [
    6.867, 6.432, 6.038, 5.681, 5.357, 5.062, 4.793, 4.547, 4.321, 4.114, 3.922, 3.743, 3.576, 3.419, 3.27, 3.129,
    2.994, 2.865, 2.741, 2.623, 2.509, 2.401, 2.297, 2.197, 2.101, 2.008, 1.92, 1.834, 1.752, 1.673, 1.597, 1.523,
    1.452, 1.384, 1.318, 1.254, 1.193, 1.134, 1.076, 1.021, 0.967, 0.916, 0.866, 0.818, 0.771, 0.726, 0.682, 0.64,
    0.6, 0.561, 0.523, 0.486, 0.451, 0.417, 0.384, 0.352, 0.322, 0.292, 0.264, 0.237, 0.211, 0.185, 0.161, 0.138,
    0.116, 0.094, 0.074, 0.054, 0.035, 0.017,
]
TABLE_2 = [
    0, -0.016, -0.032, -0.047, -0.061, -0.075, -0.087, -0.1, -0.111, -0.122, -0.132, -0.142, -0.151, -0.16, -0.168,
    -0.176, -0.183, -0.19, -0.196, -0.203, -0.208, -0.214, -0.219, -0.224, -0.229, -0.234, -0.238, -0.242, -0.247,
    -0.251, -0.256, -0.26, -0.265, -0.269, -0.274, -0.28, -0.285, -0.291, -0.298, -0.304, -0.312, -0.32, -0.328,
    -0.338, -0.348, -0.358, -0.37, -0.382, -0.396, -0.41, -0.426, -0.443, -0.46, -0.479, -0.499, -0.521, -0.543,
    -0.567, -0.592, -0.619, -0.646, -0.675, -0.705, -0.737, -0.769,
]


def rail_of(shared, profile):
    return shared.placed_profiles(WheelRailSetup(rail=profile, track=BY_ORIGIN)).right.rail


def second_sources():
    """Largest differences and points of rails, by their names, of the tests in C++."""
    text = (ROOT / "tests" / "core" / "geometry" / "profile" / "second_sources.hpp").read_text()
    found = {}
    for part in text.split("StandardName::n")[1:]:
        name, within = re.match(r"(\w+),\s*([\d.]+),", part).groups()
        points = re.findall(r"\{(-?[\d.]+), (-?[\d.]+)\}", part)
        found[name] = float(within), np.array(points, dtype=float)
    return found


def distance(points, place):
    """From a place to the chords between points."""
    best = np.inf
    for start, end in pairwise(points):
        along = np.clip(np.dot(place - start, end - start) / np.dot(end - start, end - start), 0, 1)
        best = min(best, float(np.hypot(*(start + along * (end - start) - place))))
    return best


def between(points, y):
    """z at y by the cubic through the four nearest points."""
    nearest = points[np.argsort(np.abs(points[:, 0] - y))[:4]]
    return np.polyval(np.polyfit(nearest[:, 0] - y, nearest[:, 1], 3), 0.0)


@pytest.mark.parametrize("name", second_sources())
def test_a_rail_agrees_with_its_second_source(shared, name):
    within, points = second_sources()[name]
    rail = rail_of(shared, StandardProfile(name))
    above = points[points[:, 1] < rail[:, 1].max() - 0.1]  # The profile ends at the fillet to the underside.
    chords = 4e-3  # sagitta of a chord of 0.5 mm on R8
    assert len(above) > 30
    assert max(distance(rail, point) for point in above) < within + chords


def test_s1002_agrees_with_the_tables_of_the_standard(shared):
    wheel = shared.placed_profiles(WheelRailSetup(wheel=StandardProfile("S1002"))).right.wheel
    for first, table in ((-35, TABLE_1), (0, TABLE_2)):
        y = first + 0.5 * np.arange(len(table))
        assert np.abs([between(wheel, one) for one in y] - np.array(table)).max() < 6e-4  # The table is rounded to 1e-3 mm.


def test_names_of_shapes_have_their_points_to_the_last_bit(shared):
    assert np.array_equal(rail_of(shared, StandardProfile("UIC60", 1 / 40)), rail_of(shared, Rail60E1(1 / 40)))
    named, shape = (shared.placed_profiles(WheelRailSetup(wheel=wheel)).right.wheel for wheel in (StandardProfile("S1002"), S1002()))
    assert np.array_equal(named, shape)


@pytest.mark.parametrize("name", RAILS)
def test_heads_have_no_kinks_and_their_top_at_zero(shared, name):
    placed = shared.placed_profiles(WheelRailSetup(rail=StandardProfile(name, 1 / 40))).right
    assert placed.rail_evidence.kinks == () and placed.rail_evidence.warnings == ()
    assert placed.rail[:, 1].min() == pytest.approx(0, abs=1e-4)
    turned = np.diff(np.unwrap(np.arctan2(*np.diff(placed.rail, axis=0).T[::-1])))
    assert turned.min() > -1e-6 and turned.max() < 0.06  # arcs that continue each other, the smallest with R7.64


@pytest.mark.parametrize("name", RAILS)
def test_conicities_are_those_of_the_page(shared, name):
    (shown,) = re.findall(rf"^\| `{name}` \|.*\| ([\d.]+) \| ([\d.]+) \|$", PAGE, re.MULTILINE)
    for inclination, value in zip((1 / 40, 1 / 20), shown, strict=True):
        (found,) = shared.equivalent_conicity(WheelRailSetup(rail=StandardProfile(name, inclination)), [3])
        assert found.integrated == pytest.approx(float(value), abs=0.6e-4)


@pytest.mark.parametrize("name", STANDARDS)
def test_the_page_has_the_differences_of_the_table(name):
    (shown,) = re.findall(rf"^\| `{name}` \|(?:[^|]*\|){{3}} ([\d.]+) \|", PAGE, re.MULTILINE)
    assert float(shown) == STANDARDS[name].difference


def test_a_name_of_the_other_side_is_refused(shared):
    with pytest.raises(InvalidArgument, match="S1002"):
        rail_of(shared, StandardProfile("S1002"))
    with pytest.raises(InvalidArgument, match="54E1"):
        shared.placed_profiles(WheelRailSetup(wheel=StandardProfile("54E1")))
