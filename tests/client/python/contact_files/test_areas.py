"""The potential contact area of a case: elements, and how far apart the surfaces are on them."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import Grid, Paraboloid, RegionLimits
from contactd.contact_files.problems.areas import potential_contact
from contactd.contact_files.problems.distances import EXCLUDED, regions_of
from support.contact_cases import basic_case

QUADRATIC = {"IBASE": 1, "IPLAN": 1, "B1": 1e-3, "B2": 0.0, "B3": 2e-3, "B4": 0.0, "B5": 0.0, "B6": 0.0}
CORNER = {"IPOTCN": 1, "MX": 6, "MY": 4, "XL": -3.0, "YL": -1.0, "DX": 1.0, "DY": 0.5}


def area(**values: object) -> Grid:
    return potential_contact(basic_case(**{**QUADRATIC, **values}).values).grid


def test_all_ways_to_place_elements_mean_the_same() -> None:
    corner = area(**CORNER)
    corners = area(IPOTCN=2, MX=6, MY=4, XL=-3.0, YL=-1.0, XH=3.0, YH=1.0)
    centre = area(IPOTCN=3, MX=6, MY=4, XC1=-2.5, YC1=-0.75, DX=1.0, DY=0.5)
    centres = area(IPOTCN=4, MX=6, MY=4, XC1=-2.5, YC1=-0.75, XCM=2.5, YCM=0.75)
    assert corner == corners == centre == centres == Grid(6, 4, 1.0, 0.5, -3.0, -1.0)


def test_a_hertzian_box_is_as_large_as_its_scale_says() -> None:
    found = potential_contact(basic_case().values)
    assert (found.grid.nx * found.grid.dx, found.grid.ny * found.grid.dy) == pytest.approx((2 * 6 * 1.1, 2 * 4 * 1.1))
    assert isinstance(found.gap, Paraboloid)
    assert found.gap.Rx is not None and found.ellipse is not None
    assert found.h[0, 0] == pytest.approx(found.ellipse.a1 * found.grid.x[0] ** 2 + found.ellipse.b1 * found.grid.y[0] ** 2)


def test_a_line_of_a_given_length_ends_there() -> None:
    found = potential_contact(basic_case(IPOTCN=-5, MX=10, MY=7, AA=0.5, BB=10.0, SCALE=1.5).values)
    assert found.grid.dy == pytest.approx(20 / 5)  # 7/1.5 is nearest to 5, which is odd as 7 is
    assert (found.h[0] == EXCLUDED).all() and (found.h[-1] == EXCLUDED).all()
    assert (found.h[1:-1] < 1).all()
    shorter = potential_contact(basic_case(IPOTCN=-5, MX=10, MY=7, AA=0.5, BB=10.0, SCALE=1.0).values)
    assert shorter.grid.dy == pytest.approx(20 / 7)


def test_a_quadratic_distance_with_all_its_terms() -> None:
    terms = {"B2": 0.3, "B4": 0.1, "B5": -0.2, "B6": 0.05}
    found = potential_contact(basic_case(**{**QUADRATIC, **CORNER, **terms}).values)
    x, y = found.grid.x[4], found.grid.y[1]
    assert found.h[1, 4] == pytest.approx(1e-3 * x * x + 0.3 * x * y + 2e-3 * y * y + 0.1 * x - 0.2 * y + 0.05)
    assert not isinstance(found.gap, Paraboloid)


def test_a_profile_goes_on_straight_beyond_its_ends() -> None:
    rows = {"IBASE": 2, "IPLAN": 1, "NN": 3, "XM": 0.5, "RM": 100.0, "Y1": -0.5, "DY1": 0.5, "HEIGHTS": [0.3, 0.1, 0.0]}
    found = potential_contact(basic_case(**{**CORNER, **rows}).values)
    in_middle = [0.3 + 0.4 * 0.25, 0.3 - 0.4 * 0.25, 0.1 - 0.2 * 0.25, -0.2 * 0.25]
    y = np.array([0.4, 0.2, 0.05, -0.05])
    assert in_middle == pytest.approx(y)
    x = found.grid.x
    assert found.h == pytest.approx(y[:, None] + (x[None, :] - 0.5) ** 2 / 200)


def test_waves_and_radii() -> None:
    waves = {f"B{i}": value for i, value in enumerate((0.1, 2.0, 0.3, 0.2, 1.5, -0.4, 50.0, 80.0), 1)}
    found = potential_contact(basic_case(**{**CORNER, "IBASE": 3, "IPLAN": 1, **waves}).values)
    x, y = found.grid.x[2], found.grid.y[3]
    expected = 0.1 * np.sin(2 * (x - 0.3)) - 0.2 * np.sin(1.5 * (x + 0.4)) + x * x / 50 + y * y / 80
    assert found.h[3, 2] == pytest.approx(expected)


def test_distances_of_the_elements_come_by_rows() -> None:
    given = {"IBASE": 9, "IPLAN": 1, "GAP": list(range(24))}
    assert potential_contact(basic_case(**{**CORNER, **given}).values).h[2, 1] == 13


def test_elements_outside_of_the_planform_do_not_touch() -> None:
    circle = {"IPLAN": 2, "P1": 1.0, "P2": 0.0, "P3": 1.0, "P4": 0.0, "P5": 0.0, "P6": -1.0}
    found = potential_contact(basic_case(**{**QUADRATIC, **CORNER, **circle}).values)
    x, y = found.grid.x[None, :], found.grid.y[:, None]
    assert ((found.h == EXCLUDED) == (x * x + y * y >= 1)).all()
    names = ("XL1", "XH1", "YL1", "YH1", "XL2", "XH2", "YL2", "YH2")
    rectangles = {"IPLAN": 3, **dict(zip(names, (-3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 0.0, 1.0)))}
    found = potential_contact(basic_case(**{**QUADRATIC, **CORNER, **rectangles}).values)
    assert ((found.h < EXCLUDED) == [[1, 0, 0, 0, 0, 0]] * 2 + [[1, 0, 0, 0, 0, 1]] * 2).all()


def test_patches_of_a_planform_are_regions_with_the_factors_between_them() -> None:
    patches = {"IPLAN": 4, "NPATCH": 3, "PATCH_FACTORS": (0.5, 0.25, 0.0)}
    limits = (-3.0, -2.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 2.0, 3.0, 0.0, 1.0)
    values = basic_case(**{**QUADRATIC, **CORNER, **patches, "PATCH_LIMITS": limits}).values
    assert ((potential_contact(values).h < EXCLUDED) == [[1, 0, 1, 1, 0, 0]] * 2 + [[1, 0, 1, 1, 0, 1]] * 2).all()
    found = regions_of(values)
    assert found is not None
    assert found.limits[1] == RegionLimits((-1.0, 1.0), (-1.0, 1.0))
    assert found.shares == (1.0, 0.5, 0.25, 0.5, 1.0, 0.0, 0.25, 0.0, 1.0)
    assert regions_of(basic_case(**QUADRATIC, **CORNER).values) is None


def test_a_step_that_goes_on_keeps_the_size_of_its_elements_and_lies_whole_elements_away() -> None:
    before = Grid(6, 4, 1.0, 0.5, -3.0, -1.0)
    values = basic_case(**{**QUADRATIC, **CORNER, "MX": 8, "XL": -1.1, "DX": 0.9}).values
    assert potential_contact(values, before).grid == Grid(8, 4, 1.0, 0.5, -1.0, -1.0)
