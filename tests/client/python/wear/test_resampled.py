"""Tests sections whose points have become too distant."""

from __future__ import annotations

import numpy as np

from contactd.wear import Section


def test_points_of_an_arc_lie_equally_apart_again():
    angles = np.concatenate([np.linspace(-0.5, 0, 20), np.linspace(0.2, 0.5, 10)])
    arc = Section(np.stack([100 * np.sin(angles), 100 - 100 * np.cos(angles)], axis=1), "wheel")
    found = arc.resampled(5.0)
    gaps = np.linalg.norm(np.diff(found.points, axis=0), axis=1)
    assert gaps.max() < 1.01 * gaps.min()
    np.testing.assert_allclose(np.hypot(found.points[:, 0], found.points[:, 1] - 100), 100, atol=0.01)
    np.testing.assert_allclose(found.points[[0, -1]], arc.points[[0, -1]], atol=1e-9)
    assert len(found.points) == len(arc.points)


def test_points_that_lie_well_stay():
    even = Section(np.stack([np.linspace(0, 10, 41), np.zeros(41)], axis=1), "rail")
    assert even.resampled(0.25) is even
