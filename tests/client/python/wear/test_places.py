"""Tests the positions of rows of the track on profiles."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contactd.wear import rows_on_rail, rows_on_wheel

ORIGIN, RADIUS = 750.0, 460.0


def placed(across, down, x=0.0, left=False, **position):
    return rows_on_wheel(across, down, x=x, position=position, origin=ORIGIN, radius=RADIUS, left=left)


def in_track(point, x, position):
    """Returns a wheel's profile point at its lowest position, in the track."""
    roll, yaw = position["roll"], position["yaw"]
    across, below = ORIGIN + point[0], RADIUS + point[1]
    along = math.sqrt(below**2 - (below * math.cos(0)) ** 2)
    y, z = across * math.cos(roll) - below * math.sin(roll), across * math.sin(roll) + below * math.cos(roll)
    return (
        along * math.cos(yaw) - y * math.sin(yaw),
        position["y"] + along * math.sin(yaw) + y * math.cos(yaw),
        position["z"] - RADIUS + z,
    )


def test_a_wheelset_in_the_middle_has_its_profile_where_it_sits():
    np.testing.assert_allclose(placed([751.5, 740.0], [0.0, 0.4]), [(1.5, 0), (-10, 0.4)], atol=1e-12)


def test_points_of_a_wheel_come_back_from_the_track():
    position = {"y": 5.5, "z": 0.3, "roll": -6e-3, "yaw": 0.012}
    for point in ((-32.0, 6.0), (0.0, 0.0), (25.0, -0.8)):
        x, y, z = in_track(point, 0.0, position)
        np.testing.assert_allclose(placed(y, z, x=x, **position), point, atol=1e-9)


def test_left_wheels_are_right_ones_in_a_mirror():
    right = placed([740.0, 745.0], [0.1, 0.2], x=-3.0, y=4.0, z=0.1, roll=2e-3, yaw=5e-3)
    left = placed([-740.0, -745.0], [0.1, 0.2], x=-3.0, y=-4.0, z=0.1, roll=-2e-3, yaw=-5e-3, left=True)
    np.testing.assert_allclose(left, right, atol=1e-12)


def test_a_step_along_the_track_moves_a_row_by_the_yaw():
    moved = placed(750.0, 0.0, x=10.0, yaw=0.01) - placed(750.0, 0.0, yaw=0.01)
    assert moved[0] == pytest.approx(-0.1, rel=1e-4)


def test_rails_have_their_origin_and_their_deviation():
    right = rows_on_rail([751.0], [0.4], origin=(753.0, 0.1), deviation=(0.5, 0.2))
    np.testing.assert_allclose(right, [(-2.5, 0.1)], atol=1e-12)
    left = rows_on_rail([-751.0], [0.4], origin=(753.0, 0.1), deviation=(-0.5, 0.2), left=True)
    np.testing.assert_allclose(left, right, atol=1e-12)
