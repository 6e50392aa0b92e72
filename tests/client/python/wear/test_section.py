"""Tests wearing sections: deposited wear is conserved, and equals the area between two sections."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import InvalidArgument
from contactd.wear import Section, deposit


def tread(n=401):
    y = np.linspace(-50, 50, n)
    return np.stack([y, 0.05 * y - y**2 / 800 + np.where(y < -30, (y + 30) ** 2 / 30, 0)], axis=1)


@pytest.mark.parametrize("seed", range(5))
def test_rows_keep_their_area_to_rounding_on_any_cells(seed):
    random = np.random.default_rng(seed)
    edges = np.concatenate([[0.0], np.cumsum(random.uniform(0.05, 0.8, 300))])
    centres, depths = random.uniform(5, edges[-1] - 5, 80), random.uniform(0, 1e-6, 80)
    cells = deposit(edges, centres, 0.37, depths)
    assert (cells * np.diff(edges)).sum() == pytest.approx(0.37 * depths.sum(), rel=1e-13)
    assert (cells >= 0).all()


def test_a_row_covers_its_own_width():
    cells = deposit([0.0, 1.0, 2.0, 3.0, 4.0], [2.25], 1.5, [0.2])
    np.testing.assert_allclose(cells, [0, 0.1, 0.2, 0], atol=1e-15)


def test_rows_beyond_the_end_are_refused_where_they_wear():
    assert deposit([0.0, 1.0, 2.0], [2.5], 1.0, [0.0]).tolist() == [0, 0]
    with pytest.raises(InvalidArgument, match=r"ends at 0 and 2 mm of its length, but the contact reaches from 1\.8 to 2\.8"):
        deposit([0.0, 1.0, 2.0], [2.3], 1.0, [1e-6])


@pytest.mark.parametrize(("body", "away"), [("wheel", -1), ("rail", 1)])
def test_matter_is_above_a_wheel_and_below_a_rail(body, away):
    flat = Section.of([(y, 0.0) for y in range(-5, 6)], body)
    np.testing.assert_allclose(flat.normals, [(0, away)] * 11, atol=1e-15)
    worn = flat.worn(np.full(11, 0.1))
    np.testing.assert_allclose(worn.points[:, 1], 0.1 * away)
    assert flat.area_above(worn) == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("body", ["wheel", "rail"])
def test_ten_steps_take_off_what_they_were_told(body):
    new = section = Section.of(tread(), body)
    told = 0.0
    for step in range(10):
        depths = 0.05 * np.exp(-(((section.points[:, 0] + 4 * step - 30) / 12) ** 2))
        area = float((depths * np.gradient(section.lengths)).sum())
        told += area
        section = section.worn(depths, area)
    assert new.area_above(section) == pytest.approx(told, rel=1e-9)


@pytest.mark.parametrize("body", ["wheel", "rail"])
@pytest.mark.parametrize("size", [1e-3, 1e-13, 1e-310])
def test_hardly_anything_taken_off_moves_no_point_farther_than_told(body, size):
    section = Section.of(tread(), body)
    depths = size * np.exp(-((section.points[:, 0] / 12) ** 2))
    moved = section.worn(depths, float((depths * np.gradient(section.lengths)).sum()))
    assert np.abs(moved.points - section.points).max() <= 1.1 * size + 2e-14


def test_without_a_balance_the_curvature_takes_its_part():
    angle = np.linspace(-0.5, 0.5, 201)
    arc = Section.of(np.stack([100 * np.sin(angle), 100 * np.cos(angle)], axis=1), "wheel")  # of a convex wheel
    worn = arc.worn(np.full(201, 0.5))
    assert arc.area_above(worn) == pytest.approx(0.5 * (100**2 - 99.5**2), rel=2e-5)


def test_points_from_the_field_side_are_mirrored():
    ascending = Section.of(tread(), "rail")
    np.testing.assert_array_equal(Section.of(tread()[::-1], "rail").points, ascending.points)


def test_points_are_added_on_a_smooth_curve_and_none_is_moved():
    angle = np.linspace(-0.5, 0.5, 21)
    coarse = np.stack([100 * np.sin(angle), 100 * np.cos(angle)], axis=1)
    fine = Section.of(coarse, "wheel", 0.5).points
    assert np.linalg.norm(np.diff(fine, axis=0), axis=1).max() < 0.51
    assert abs(np.linalg.norm(fine, axis=1)[20:-20] - 100).max() < 1e-4
    for point in coarse:
        assert np.linalg.norm(fine - point, axis=1).min() < 1e-12


def test_rows_lie_where_the_section_is_nearest():
    section = Section.of(tread(), "wheel")
    at = section.lengths[[37, 200, 355]]
    rows = section.points[[37, 200, 355]] + 0.2 * section.normals[[37, 200, 355]]
    np.testing.assert_allclose(section.nearest(rows), at, atol=0.02)
    with pytest.raises(InvalidArgument, match="mm from the section"):
        section.nearest([(0.0, 20.0)])


@pytest.mark.parametrize("points", [[(0, 0), (1, 1)], [(0, 0), (0, 0), (1, 1)], [(0, 0), (1, np.nan), (2, 0)]])
def test_what_is_no_curve_is_refused(points):
    with pytest.raises(InvalidArgument, match="points"):
        Section.of(points, "wheel")
