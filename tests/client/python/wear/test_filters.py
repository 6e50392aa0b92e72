"""Tests which depths of a step filters keep, and how a groove changes in a step."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contactd.wear import critical_depth, exponential_step, smoothed
from contactd.wear.filters import smoothing_length

PRESSURE, MODULUS = 450.0, 115_000.0


def wave(length: float, size: float = 0.05, n: int = 4000) -> np.ndarray:
    return np.cos(math.pi * np.arange(0.5, n) * round(2 * n * size / length) / n)


def gain(filtered: np.ndarray, given: np.ndarray) -> float:
    return float((filtered * given).sum() / (given**2).sum())


@pytest.mark.parametrize("take", [lambda d: smoothed(d, 0.3, 8.0), lambda d: exponential_step(d, 0.3, 0.05, PRESSURE, MODULUS)])
def test_filters_lose_nothing_also_at_the_ends(take):
    depths = np.random.default_rng(1).uniform(0, 1, 137)
    assert take(depths).sum() == pytest.approx(depths.sum(), rel=1e-13)
    np.testing.assert_allclose(take(np.ones(50)), 1, rtol=1e-13)
    np.testing.assert_allclose(take(depths[::-1]), take(depths)[::-1], atol=1e-14)


def test_smoothing_leaves_half_of_its_wavelength():
    for length in (2.0, 5.0):
        given = wave(length)
        assert gain(smoothed(given, 0.05, length), given) == pytest.approx(0.5, rel=1e-3)


def test_the_critical_depth_is_that_of_the_page():
    assert critical_depth(1, 1000, 115_000) == pytest.approx(5.5e-3, rel=0.01)
    assert critical_depth(10, 1000, 115_000) == pytest.approx(55e-3, rel=0.01)
    assert smoothing_length(critical_depth(3, PRESSURE, MODULUS), PRESSURE, MODULUS) == pytest.approx(3)


@pytest.mark.parametrize("length", [1, 2, 3, 5, 10])
@pytest.mark.parametrize("depth", [0.005, 0.02, 0.1])
def test_no_groove_grows_in_a_step_also_in_partial_slip(length, depth):
    """In a step of depth h a groove decreases by the fraction pi E* h/(L pm), and 1.65 times that in partial slip."""
    given = wave(length)
    length = 400 / round(400 / length)  # contains a whole number of half waves
    for partial in (1.0, 1.65):
        q = partial * math.pi * MODULUS * depth / (length * PRESSURE)
        auto = 1 - q * gain(smoothed(given, 0.05, smoothing_length(depth, PRESSURE, MODULUS)), given)
        slow = 1 - q * gain(exponential_step(given, 0.05, depth, PRESSURE, MODULUS), given)
        assert abs(auto) <= (0.05 if partial == 1 and auto < 0 else 1)
        assert abs(auto) < 1 or auto == pytest.approx(1)
        if partial == 1:
            assert slow == pytest.approx(math.exp(-q), rel=2e-2, abs=1e-6)
        assert -0.66 < slow <= 1
