"""Tests the wire format of regions of the potential contact area."""

import numpy as np
import pytest

from contactd import ContactRegions, RegionLimits
from contactd.values.params import params_of

LIMITS = [RegionLimits((-3, -1), (-2, 2)), RegionLimits((1, 3), (-2, 2))]


@pytest.mark.parametrize("shares", [[1, 0.4, 0.4, 1], [[1, 0.4], [0.4, 1]], np.array([[1, 0.4], [0.4, 1]])])
def test_shares_are_a_matrix_or_its_rows(shares):
    written = params_of(ContactRegions(LIMITS, shares))
    assert written == {"limits": [{"x": [-3, -1], "y": [-2, 2]}, {"x": [1, 3], "y": [-2, 2]}], "shares": [1, 0.4, 0.4, 1]}


def test_a_matrix_that_is_not_square_is_refused():
    with pytest.raises(TypeError, match=r"regions.shares has the shape \(1, 4\); it must be square"):
        params_of(ContactRegions(LIMITS, [[1, 0.4, 0.4, 1]]), "regions")
