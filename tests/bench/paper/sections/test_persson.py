"""Tests the closed form of cylinders in holes, and the contact compared with it."""

import numpy as np
import pytest

from paper.sections.persson import clearance, half_angle_of, pressure, solve


@pytest.mark.parametrize("degrees", [10, 30, 60, 80])
def test_the_pressures_of_the_closed_form_carry_the_load(degrees):
    half_angle = np.radians(degrees)
    nodes, weights = np.polynomial.legendre.leggauss(400)
    angle = half_angle * nodes
    assert np.sum(weights * half_angle * pressure(half_angle, angle) * np.cos(angle)) == pytest.approx(1, rel=1e-6)


def test_the_closed_form_has_the_values_of_others():
    assert clearance(np.radians(20)) == pytest.approx(19.535251, rel=1e-6)
    assert clearance(np.radians(75)) == pytest.approx(0.287077, rel=1e-5)
    assert pressure(np.radians(45), np.zeros(1))[0] == pytest.approx(0.882111, rel=1e-5)
    assert pressure(np.radians(60), np.radians([30]))[0] == pytest.approx(0.603848, rel=1e-5)


def test_a_contact_has_no_tension_and_no_overlap():
    random = np.random.default_rng(1)
    half = random.normal(size=(20, 20))
    compliance = half @ half.T + np.eye(20)
    angles = np.linspace(-1.2, 1.2, 20)
    gap = 5 * (1 - np.cos(angles))
    p = solve(compliance, np.cos(angles), gap)
    assert p.min() >= 0
    assert p @ np.cos(angles) == pytest.approx(1)
    touching = p > 0
    approach = (gap + compliance @ p)[touching] / np.cos(angles)[touching]
    assert np.ptp(approach) < 1e-10


def test_the_end_of_a_contact_is_found_between_strips():
    angles = np.radians(np.arange(-40, 41))
    p = np.sqrt(np.maximum(np.radians(30.3) ** 2 - angles**2, 0))
    assert half_angle_of(angles, p) == pytest.approx(np.radians(30.3), rel=5e-3)
    assert half_angle_of(-angles, p) == pytest.approx(np.radians(30.3), rel=5e-3)
