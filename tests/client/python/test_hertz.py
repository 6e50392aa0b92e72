"""Tests Hertz's contact from the data of a case."""

from __future__ import annotations

import math

import pytest

from contactd.values.hertz import (
    Load,
    compliance_of,
    ellipse_of_axes,
    ellipse_of_curvatures,
    ellipse_of_ratio,
)

STEEL = compliance_of((0.28, 0.28), (82000.0, 82000.0))


def test_a_circle_has_the_closed_form() -> None:
    radius, force = 50.0, 1000.0
    found = ellipse_of_curvatures(1 / (2 * radius), 1 / (2 * radius), Load(force, True, STEEL))
    a = (3 * force * radius * STEEL / 4) ** (1 / 3)
    assert found.aa == pytest.approx(a, rel=1e-12)
    assert found.bb == pytest.approx(a, rel=1e-12)
    assert found.approach == pytest.approx(a * a / radius, rel=1e-12)
    assert found.rho == pytest.approx(2 * radius, rel=1e-12)
    assert found.cp == pytest.approx(a, rel=1e-12)


@pytest.mark.parametrize("ratio", [1 / 300, 0.2, 1.0, 3.0, 300.0])
@pytest.mark.parametrize("load", [Load(8e4, True, STEEL), Load(0.05, False, STEEL)])
def test_curvatures_and_semi_axes_lead_to_each_other(ratio: float, load: Load) -> None:
    given = ellipse_of_axes(4 * ratio, 4.0, load)
    by_curvatures = ellipse_of_curvatures(given.a1, given.b1, load)
    by_ratio = ellipse_of_ratio(given.a1, ratio, load)
    for found in (by_curvatures, by_ratio):
        assert (found.aa, found.bb, found.b1) == pytest.approx((given.aa, given.bb, given.b1), rel=1e-9)


def test_force_and_approach_belong_together() -> None:
    by_force = ellipse_of_axes(6, 3, Load(5e4, True, STEEL))
    by_approach = ellipse_of_axes(6, 3, Load(by_force.approach, False, STEEL))
    assert by_approach.a1 == pytest.approx(by_force.a1, rel=1e-12)


def test_rotated_by_a_right_angle_it_is_the_same() -> None:
    load = Load(5e4, True, STEEL)
    one, other = ellipse_of_axes(6, 3, load), ellipse_of_axes(3, 6, load)
    assert (one.a1, one.b1, one.approach) == pytest.approx((other.b1, other.a1, other.approach), rel=1e-12)


def test_the_sum_of_curvatures_meets_the_potential() -> None:
    """Under p0 sqrt(1 - ..) displacements at the end of a semi-axis are those of the middle minus a1 a^2 (Johnson,
    3.5)."""
    load = Load(1e4, True, STEEL)
    found = ellipse_of_axes(5, 2, load)
    p0 = 3 * load.value / (2 * math.pi * found.aa * found.bb)
    eccentricity = 1 - (found.bb / found.aa) ** 2
    # Evaluates the complete elliptic integral K by the arithmetic-geometric mean.
    x, y = 1.0, math.sqrt(1 - eccentricity)
    while abs(x - y) > 1e-15:
        x, y = (x + y) / 2, math.sqrt(x * y)
    assert found.approach == pytest.approx(p0 * found.bb * STEEL * math.pi / (2 * x), rel=1e-12)
