"""Displacements inside a half-space, and the file of points below the surface."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import Grid
from contactd.contact_files.answers.interior import interior_displacements
from contactd.contact_files.answers.subsurface import StressField
from contactd.contact_files.prints.out_subsurface import extremes
from contactd.contact_files.prints.subs_file import subs_text

NU, SHEAR = 0.28, 200.0


def by_point_loads(grid: Grid, tractions: np.ndarray, point: np.ndarray, n: int = 60) -> np.ndarray:
    """Boussinesq's and Cerruti's solutions (Johnson, 3.18 and 3.75), summed over small squares."""
    total = np.zeros(3)
    inside = (np.arange(n) + 0.5) / n - 0.5
    for iy, ix in np.ndindex(grid.shape):
        x = point[0] - (grid.x[ix] + inside[None, :] * grid.dx)
        y = point[1] - (grid.y[iy] + inside[:, None] * grid.dy)
        z = point[2]
        r = np.sqrt(x * x + y * y + z * z)
        area = grid.dx * grid.dy / n**2
        px, py, pn = tractions[:, iy, ix] * area
        down = 1 - 2 * NU
        total += pn * np.array([
            np.sum(x * z / r**3 - down * x / (r * (r + z))), np.sum(y * z / r**3 - down * y / (r * (r + z))),
            np.sum(z * z / r**3 + 2 * (1 - NU) / r),
        ])  # fmt: skip
        for p, along, across, axes in ((px, x, y, [0, 1, 2]), (py, y, x, [1, 0, 2])):
            mine = np.array([
                np.sum(1 / r + along**2 / r**3 + down * (1 / (r + z) - along**2 / (r * (r + z) ** 2))),
                np.sum(along * across / r**3 - down * along * across / (r * (r + z) ** 2)),
                np.sum(along * z / r**3 + down * along / (r * (r + z))),
            ])  # fmt: skip
            total += p * mine[axes]
    return total / (4 * np.pi * SHEAR)


@pytest.mark.parametrize("point", [(0.0, 0.0, 0.7), (0.3, -0.2, 0.4), (2.0, 1.0, 0.5), (-1.5, 0.25, 3.0)])
def test_displacements_are_sums_of_those_of_point_loads(point: tuple[float, float, float]) -> None:
    grid = Grid(3, 2, 0.5, 0.8)
    tractions = np.random.default_rng(7).normal(size=(3, *grid.shape))
    (found,) = interior_displacements(grid, tractions, np.array([point]), NU, SHEAR)
    assert found == pytest.approx(by_point_loads(grid, tractions, np.array(point)), rel=2e-3, abs=2e-6)


def test_elements_without_tractions_cost_nothing_and_add_nothing() -> None:
    grid = Grid(4, 4, 0.5, 0.5)
    one = np.zeros((3, *grid.shape))
    one[:, 1, 2] = 1.0
    points = np.array([[0.1, 0.2, 0.3]])
    alone = Grid(1, 1, 0.5, 0.5, float(grid.x[2]) - 0.25, float(grid.y[1]) - 0.25)
    assert interior_displacements(grid, one, points, NU, SHEAR) == pytest.approx(
        interior_displacements(alone, np.ones((3, 1, 1)), points, NU, SHEAR)
    )
    assert not interior_displacements(grid, 0 * one, points, NU, SHEAR).any()


def field() -> StressField:
    stress = np.zeros((6, 2, 1, 3))
    stress[0, 1, 0, 2], stress[5, 0, 0, 1], stress[2, 1, 0, 0] = 4.0, -7.0, 1.5
    return StressField(np.array([-1.0, 0.0, 1.0]), np.array([0.5]), np.array([-2.0, 0.1]), np.zeros((2, 1, 3, 3)), stress)


def test_a_file_of_points_has_x_fastest_and_one_width() -> None:
    table = np.loadtxt(subs_text([field()], all_components=True).splitlines(), comments="%")
    assert table.shape == (7, 14)
    assert table[0, :3].tolist() == [3, 1, 2]
    assert table[1:4, :3].tolist() == [[-1, 0.5, -2], [0, 0.5, -2], [1, 0.5, -2]]
    assert table[6, 8] == 4 and table[2, 13] == -7 and table[4, 10] == 1.5
    assert table[4, 7] == pytest.approx(np.sqrt(3) * 1.5, rel=1e-5)  # von Mises' stress of shear
    assert np.loadtxt(subs_text([field()], all_components=False).splitlines(), comments="%").shape == (7, 8)


def test_the_largest_of_each_kind_is_told_with_its_place() -> None:
    lines = list(extremes(field(), 1))
    assert lines[0] == " SUBSURFACE STRESSES BLOCK  1:"
    assert " ABSMAX SIGZZ =    -7.000 AT (X,Y,Z) = (   0.000,   0.500,  -2.000)".replace("SIGZZ", " SIGZZ") in lines
    assert " MAX    SIGMA1 =     4.000 AT (X,Y,Z) = (   1.000,   0.500,   0.100)" in lines
    assert all(line[7:14].strip() for line in lines[2:]) and all(line[16:].split() for line in lines[2:])
