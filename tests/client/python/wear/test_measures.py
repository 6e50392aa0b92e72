"""What gauges tell of profiles."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import InvalidArgument
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
