"""Tests the forces P1 and P2 of lumped systems."""

from __future__ import annotations

import math

import pytest

from contactd import InvalidArgument
from contactd.track import p1_force, p1_hertz, p2_force, p2_forces

P1 = {"load": 100e3, "speed": 0.6, "unsprung": 600, "effective": 50}
P2 = {"load": 0, "speed": 0.8889, "unsprung": 600, "track_mass": 245, "stiffness": 62e6, "damping": 55.4e3}


def test_p1_by_formula_and_by_energy():
    linear = 1.5 * 9.29e10 ** (2 / 3) * 100e3 ** (1 / 3)
    assert p1_force(stiffness=linear, **P1) == pytest.approx(254.04e3, rel=1e-4)
    assert p1_hertz(constant=9.29e10, **P1) == pytest.approx(274.36e3, rel=1e-4)


def test_hertzs_spring_is_the_linear_one_for_small_speeds():
    small = {**P1, "speed": 1e-4}
    linear = 1.5 * 9.29e10 ** (2 / 3) * 100e3 ** (1 / 3)
    assert p1_hertz(constant=9.29e10, **small) - 100e3 == pytest.approx(p1_force(stiffness=linear, **small) - 100e3, rel=1e-3)


def test_p2_is_the_force_of_the_tracks_spring():
    assert p2_force(**P2) == pytest.approx(117.0e3, rel=1e-4)
    forces = p2_forces(**P2)
    assert forces.spring == pytest.approx(121.07e3, rel=1e-4)
    assert forces.support == pytest.approx(124.7e3, rel=5e-4)
    assert forces.contact == pytest.approx(88.54e3, rel=1e-4)


@pytest.mark.parametrize("damping", [0, 1e3, 3e5, 457778.0, 2e6])
def test_exact_forces_are_those_of_the_motion(damping):
    forces = p2_forces(**{**P2, "damping": damping})
    both, t, step = 845.0, 0.0, 2e-6
    u, v, spring, support = 0.0, 0.8889 * 600 / 845, 0.0, 0.0
    while t < 0.02:  # the midpoint rule
        support = max(support, 62e6 * u + damping * v)
        middle = (v - 0.5 * step / both * (62e6 * u)) / (1 + 0.5 * step / both * (damping + 0.5 * step * 62e6))
        u, v, t = u + step * middle, 2 * middle - v, t + step
        spring = max(spring, 62e6 * u)
    assert forces.spring == pytest.approx(spring, rel=1e-4)
    assert forces.support == pytest.approx(support, rel=1e-3)
    if damping == 0:
        assert forces.spring == pytest.approx(p2_force(**{**P2, "damping": 0}), rel=1e-9)
        assert forces.contact == pytest.approx(forces.spring * 600 / 845, rel=1e-9)
    assert math.isfinite(forces.contact)


def test_masses_of_zero_are_refused():
    with pytest.raises(InvalidArgument, match="unsprung = 0"):
        p2_force(**{**P2, "unsprung": 0})
