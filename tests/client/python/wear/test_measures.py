"""Tests gauge dimensions of profiles."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import ContactWarning, InvalidArgument
from contactd.wear import rail_wear, wheel_gauge

#: A flange with straight faces: its tip 28 mm below the tread at y = -52, its face from (-50, 28) to (-30, 0).
WHEEL = np.array([(-70.0, 5.0), (-52.0, 28.0), (-50.0, 28.0), (-30.0, 0.0), (0.0, 0.0), (60.0, -3.0)])
#: A head 70 mm wide with corners of 13 mm.
CORNER = [(-35 + 13 - 13 * np.cos(a), 13 - 13 * np.sin(a)) for a in np.linspace(0, np.pi / 2, 91)]
RAIL = np.array([(-35.0, 30.0), *CORNER, (0.0, 0.0), (30.0, 0.0)])


def test_a_flange_has_its_height_thickness_and_slope():
    gauge = wheel_gauge(WHEEL)
    assert gauge.Sh == 28
    face = -30 - 20 * 10 / 28
    assert gauge.Sd == pytest.approx(face + 70)
    assert gauge.qR == pytest.approx(face - (-50 + 20 * 2 / 28))
    assert wheel_gauge(WHEEL, back=-68).Sd == pytest.approx(face + 68)


def test_a_tread_that_wears_makes_the_flange_higher():
    worn = WHEEL + np.where(WHEEL[:, :1] >= -30, [[0, -2]], [[0, 0]])
    assert wheel_gauge(worn).Sh == 30


def test_a_profile_without_a_flange_is_refused():
    with pytest.raises(InvalidArgument, match="flange"):
        wheel_gauge([(-30, 0), (0, 0), (60, -3)])
    with pytest.raises(InvalidArgument, match="tape circle"):
        wheel_gauge(WHEEL - [100, 0])


def test_a_rail_that_sinks_has_lost_that_on_top_and_nothing_beside():
    wear = rail_wear(RAIL, RAIL + np.array([0, 1.5]))
    assert wear.W1 == pytest.approx(1.5)
    assert wear.W2 == pytest.approx(0, abs=1e-9)


def test_a_rail_that_is_worn_from_its_side_has_lost_that_there():
    wear = rail_wear(RAIL, RAIL + np.array([2, 0]))
    assert wear.W1 == pytest.approx(0)
    assert wear.W2 == pytest.approx(2)
    assert wear.W3 == pytest.approx(np.sqrt(2), rel=0.1)


def test_equal_rails_have_lost_nothing():
    wear = rail_wear(RAIL, RAIL)
    assert (wear.W1, wear.W2, wear.W3) == (0, 0, 0)


def test_points_run_from_either_end():
    assert wheel_gauge(WHEEL[::-1]) == wheel_gauge(WHEEL)
    worn = RAIL + np.array([2, 1])
    assert rail_wear(RAIL[::-1], worn) == rail_wear(RAIL, worn[::-1]) == rail_wear(RAIL, worn)


def test_a_measured_wheel_has_its_gauges_by_either_order():
    """Uses a wheel similar to the S1002: flange height 28 mm, thickness 32.7, qR 12.2."""
    flange = [(-70, 9.5), (-64, 24.5), (-58, 27.7), (-55, 28), (-52, 27.6), (-49.5, 26), (-46, 20), (-38.5, 12), (-37.3, 10)]
    wheel = np.array([*flange, (-34, 7), (-26, 2.74), (0, 0), (60, -3.5)])
    for points in (wheel, wheel[::-1]):
        gauge = wheel_gauge(points)
        assert (gauge.Sh, gauge.Sd, gauge.qR) == pytest.approx((28, 32.7, 12.2), abs=0.05)


def test_points_in_no_order_are_refused():
    shuffled = np.random.default_rng(1).permutation(len(RAIL))
    with pytest.raises(InvalidArgument, match="new go back from y"):
        rail_wear(RAIL[shuffled], RAIL)
    with pytest.raises(InvalidArgument, match="worn go back from y"):
        rail_wear(RAIL, RAIL[shuffled])
    with pytest.raises(InvalidArgument, match="points go back from y"):
        wheel_gauge(WHEEL[[0, 1, 2, 4, 3, 5]])


def test_points_that_are_no_pairs_or_not_finite_are_refused():
    with pytest.raises(InvalidArgument, match="points have the shape"):
        wheel_gauge(WHEEL.T)
    with pytest.raises(InvalidArgument, match="worn are not all finite"):
        rail_wear(RAIL, np.where(RAIL == RAIL[5], np.nan, RAIL))


def test_a_flange_at_positive_y_is_refused():
    for points in (WHEEL * (-1, 1), (WHEEL * (-1, 1))[::-1]):
        with pytest.raises(InvalidArgument, match=r"flange at y = 5.* mm, but y points to the field side"):
            wheel_gauge(points)


def head(lean: float = 0.0) -> np.ndarray:
    """Creates a head with both sides, R 300 on top and corners of 13 mm, inclined towards y < 0 by an angle."""
    y = np.linspace(-36, 36, 145)
    z = np.where(abs(y) < 23, y**2 / 600, 0.88 + 13 - np.sqrt(np.maximum(169 - (abs(y) - 23) ** 2, 0)))
    points = np.vstack([(-36, 30), np.column_stack([y, z]), (36, 30)])
    return points @ np.array([[np.cos(lean), -np.sin(lean)], [np.sin(lean), np.cos(lean)]])


def test_a_rail_that_has_worn_at_positive_y_is_refused():
    new = head()
    for depth in (0.5, 2.0):
        worn = new - np.outer(depth * (new[:, 0] > 25), (1, 0))
        assert rail_wear((new * (-1, 1))[::-1], (worn * (-1, 1))[::-1]).W2 == pytest.approx(depth)
        with pytest.raises(InvalidArgument, match=f"lost {depth:g} mm at y > 0 and .* mm at y < 0, the gauge side"):
            rail_wear(new, worn)


def test_a_rail_that_leans_to_positive_y_is_refused():
    for lean in (1 / 40, 1 / 20):
        right = head(lean)
        assert rail_wear(right, right + np.array([0, 1])).W1 == pytest.approx(1)
        with pytest.raises(InvalidArgument, match="leans to y > 0"):
            rail_wear(right * (-1, 1), right * (-1, 1) + np.array([0, 1]))


def test_profiles_upside_down_are_refused():
    with pytest.raises(InvalidArgument, match=r"points rise to z = -28 mm at y = -5.*reverse the sign of z"):
        wheel_gauge(WHEEL * (1, -1))
    rail = head(1 / 40)
    for upside_down in (rail * (1, -1), rail * (-1, -1)):
        with pytest.raises(InvalidArgument, match=r"new have both ends near the top.*reverse the sign of z"):
            rail_wear(upside_down, upside_down)
        with pytest.raises(InvalidArgument, match=r"worn have both ends near the top.*reverse the sign of z"):
            rail_wear(rail, upside_down)


@pytest.mark.parametrize("unit", [1e-3, 0.1, 1 / 25.4, 1e3])
def test_profiles_in_other_units_are_refused(unit):
    for measured in (lambda: wheel_gauge(WHEEL * unit), lambda: rail_wear(RAIL * unit, RAIL * unit), lambda: rail_wear(RAIL, RAIL * unit)):
        with pytest.raises(InvalidArgument, match=r"span .* mm laterally, but wheels and rails are 15 to 1000 mm wide; give lengths in mm"):
            measured()


def test_a_profile_that_returns_to_its_first_point_is_refused():
    for measured in (lambda: wheel_gauge([*WHEEL, WHEEL[0]]), lambda: rail_wear(RAIL, [*RAIL, RAIL[0]])):
        with pytest.raises(InvalidArgument, match="end at their first point; give an open profile"):
            measured()


def test_rails_in_different_coordinates_are_refused():
    rail = head(1 / 40)
    with pytest.raises(InvalidArgument, match=r"worn has gained 20 mm at y > 0, 14 mm below its top; reverse the sign of y, or give both"):
        rail_wear(rail, rail + np.array([20, 0]))
    with pytest.raises(InvalidArgument, match="worn lies 460 mm below new; give both profiles with the same origin"):
        rail_wear(rail, rail + np.array([0, 460]))


def test_exchanged_rails_are_warned_of():
    worn = RAIL + np.array([2, 1])
    with pytest.warns(ContactWarning, match=r"worn has gained 2 mm .* exchanged or displaced"):
        assert rail_wear(worn, RAIL).W2 == pytest.approx(-2)
