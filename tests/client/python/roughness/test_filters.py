"""Tests contact filters against Hertz's closed form, given values and limits."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import ContactWarning, InvalidArgument
from contactd.materials import steel
from contactd.roughness import (
    DIRECTIVE_2002_49,
    ContactFilter,
    ContactWeights,
    EllipseWeights,
    Record,
    effective,
    hertz_weights,
    lines_of,
)

WAVES = np.array([100, 80, 63, 50, 40, 31.5, 25, 20, 16, 12.5, 10, 8, 6.3, 5, 4, 3.15])
WHEEL = hertz_weights(50e3, 460, 300, steel)
#: Third octaves of ellipses of 50 kN over a rail of radius 300 mm, computed by independent quadrature (dB).
GIVEN = {
    (360, "isotropic"): "-.33 -.46 -.68 -.97 -1.38 -2.00 -2.86 -4.05 -5.81 -8.80 -13.07 -17.96 -16.91 -16.85 -21.43 -21.87",
    (920, "isotropic"): "-.39 -.57 -.87 -1.32 -1.96 -3.03 -4.66 -7.21 -11.53 -18.63 -16.32 -15.35 -21.01 -20.64 -24.17 -24.99",
    (920, "alike"): "-.19 -.29 -.47 -.76 -1.19 -1.96 -3.20 -5.23 -8.93 -18.35 -18.21 -13.65 -18.90 -20.06 -22.66 -23.12",
}
X = np.arange(-1000.0, 1000.0)


def record(length: float, y=(0.0,)) -> Record:
    return Record(1.0, 1e-3 * np.tile(np.cos(2 * np.pi * X / length), (len(y), 1)), np.array(y), X[0])


@pytest.mark.parametrize("case", GIVEN)
def test_third_octaves_of_ellipses_are_those_given(case):
    diameter, across = case
    found = ContactFilter(hertz_weights(50e3, diameter / 2, 300, steel), across).band_levels(WAVES)
    np.testing.assert_allclose(found, [float(word) for word in GIVEN[case].split()], atol=0.02)


@pytest.mark.parametrize("across", ["isotropic", "alike"])
def test_long_waves_pass(across):
    found = ContactFilter(WHEEL, across).levels([1e3, 1e4, 1e6])
    np.testing.assert_allclose(found, 0, atol=0.02)
    assert found[2] == pytest.approx(0, abs=1e-6)


def test_points_of_an_ellipse_have_its_filter():
    for across in ("isotropic", "alike"):
        np.testing.assert_allclose(
            ContactFilter(WHEEL.points(), across).power(WAVES[:-3]), ContactFilter(WHEEL, across).power(WAVES[:-3]), atol=2e-4
        )


def test_an_isotropic_surface_is_alike_in_both_directions_of_a_circle():
    points = EllipseWeights(3.0, 3.0).points()
    turned = ContactWeights(points.y, -points.x, points.values)
    np.testing.assert_allclose(ContactFilter(turned).power(WAVES), ContactFilter(points).power(WAVES), rtol=1e-9)


def test_two_equal_patches_are_one():
    points = WHEEL.points()
    twice = ContactWeights(*(np.tile(part, 2) for part in (points.x, points.y, points.values)))
    np.testing.assert_allclose(ContactFilter(twice).power(WAVES), ContactFilter(points).power(WAVES), rtol=1e-12)


def test_patches_side_by_side_average_what_is_not_alike_across():
    points = EllipseWeights(4.0, 4.0).points()
    apart = ContactWeights(np.tile(points.x, 2), np.concatenate([points.y - 12, points.y + 12]), np.tile(points.values, 2))
    np.testing.assert_allclose(ContactFilter(apart, "alike").power(WAVES), ContactFilter(points, "alike").power(WAVES), atol=1e-14)
    assert (ContactFilter(apart).power(WAVES[:8]) < ContactFilter(points).power(WAVES[:8])).all()


@pytest.mark.parametrize("across", ["isotropic", "alike"])
def test_filtered_records_are_waves_times_the_filter(across):
    for length in (100.0, 25.0, 10.0):
        found = ContactFilter(WHEEL, across).applied(record(length))
        expected = np.sinc(2 * WHEEL.a / length) if across == "alike" else np.sqrt(ContactFilter(WHEEL).power(length))
        np.testing.assert_allclose(found.heights[0], 1e-3 * expected * np.cos(2 * np.pi * found.x / length), atol=1e-5)


def test_lines_that_are_alike_have_the_filter_of_roughness_alike_across():
    for length in (50.0, 12.5):
        found, plain = effective(WHEEL, record(length, (-10, 0, 10))), ContactFilter(WHEEL, "alike").applied(record(length))
        np.testing.assert_allclose(found.heights, plain.heights, atol=1e-5)
        assert found.y.tolist() == [0.0]


def test_effective_roughness_is_linear_and_keeps_constants():
    noise = np.random.default_rng(5)
    one, other = (Record(1.0, noise.standard_normal((3, 400)), np.array([-4.0, 0, 4.0])) for _ in range(2))
    both = one.with_heights(2 * one.heights - other.heights)
    np.testing.assert_allclose(
        effective(WHEEL, both).heights, 2 * effective(WHEEL, one).heights - effective(WHEEL, other).heights, atol=1e-12
    )
    flat = one.with_heights(np.full((3, 400), 0.7))
    for found in (effective(WHEEL, flat), ContactFilter(WHEEL).applied(flat), ContactFilter(WHEEL, "alike").applied(flat)):
        np.testing.assert_allclose(found.heights, 0.7, rtol=1e-12)


def test_effective_roughness_is_mirrored_with_the_lines():
    noise = np.random.default_rng(6).standard_normal((3, 401))
    lines = Record(1.0, noise, np.array([-4.0, 0, 4.0]))
    found = effective(WHEEL, lines).heights
    np.testing.assert_allclose(effective(WHEEL, lines.with_heights(noise[:, ::-1])).heights, found[:, ::-1], atol=1e-12)
    np.testing.assert_allclose(effective(WHEEL, lines.with_heights(noise[::-1])).heights, found, atol=1e-12)


def test_third_octaves_of_a_record_follow_its_spectrum():
    lines = lines_of(Record(1.0, np.cumsum(np.random.default_rng(7).standard_normal(200_000)) * 1e-4))
    contact = ContactFilter(WHEEL)
    found = contact.third_octaves(lines)
    difference = contact.filtered(lines).third_octaves().levels - lines.third_octaves().levels
    np.testing.assert_allclose(found.levels, difference, atol=1e-9)
    assert abs(found.at(12.5) - contact.levels(12.5)) > 0.1


def test_the_columns_of_the_directive_lie_beside_hertz():
    for (load, diameter), column in DIRECTIVE_2002_49.items():
        waves = column.wavelengths
        found = ContactFilter(hertz_weights(1e3 * load, diameter / 2, 300, steel)).band_levels(waves) - column.levels
        assert np.abs(found[waves >= 10]).max() < 2.5
        assert np.abs(found[waves >= 3.15]).max() < 2.85
    assert DIRECTIVE_2002_49[50, 920].at(40) == -1.3
    assert [len(column.levels) for column in DIRECTIVE_2002_49.values()] == [35] * 5


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: ContactFilter(WHEEL, "around"), "across = 'around': it must be isotropic or alike"),
        (lambda: ContactFilter(WHEEL, exponent=1.5), "exponent = 1.5"),
        (lambda: ContactFilter(WHEEL).power([10, 0]), "wavelengths = 0.0 mm"),
        (lambda: ContactFilter(WHEEL).applied(Record(1.0, X[:50])), "the kernel of the contact is"),
        (lambda: effective(WHEEL, record(10)), "the heights beside it are unknown"),
        (lambda: EllipseWeights(0, 1), "a = 0 mm"),
        (lambda: hertz_weights(-1, 460, 300, steel), "Fn = -1"),
        (lambda: hertz_weights(5e4, 460, -300, steel), "Ry = -300"),
        (lambda: ContactWeights(np.zeros(2), np.zeros(2), np.zeros(2)), "the sum 0"),
        (lambda: ContactWeights(np.zeros(2), np.zeros(3), np.ones(2)), "2 weights for 2 x 3 places"),
    ],
)
def test_wrong_arguments_are_refused(make, words):
    with pytest.raises(InvalidArgument, match=words):
        make()


def test_few_elements_and_narrow_lines_are_warned_of():
    x, y = np.meshgrid([0.0, 1, 2], [0.0, 1, 2])
    coarse = ContactWeights(x, y, np.ones((3, 3)), (1.0, 1.0))
    with pytest.warns(ContactWarning, match="3 x 3 elements. Use 32 across or more"):
        ContactFilter(coarse)
    with pytest.warns(ContactWarning, match="of the contact's weight lies beyond the lines"):
        effective(WHEEL, record(10, (-1, 0, 1)))
