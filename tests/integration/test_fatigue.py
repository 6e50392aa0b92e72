"""Tests rolling contact fatigue from a daemon: of contacts, of wheels on rails, and stresses below curved columns."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactColumns,
    ContactProblem,
    DamageFunction,
    Estimate,
    FatigueRequest,
    FatigueStrength,
    Friction,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    Passage,
    Rolling,
    SemiAxes,
    StressBlock,
)
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

STEEL = Material(82000, 0.28)
REQUEST = FatigueRequest(
    "upper",
    FatigueStrength("rail", "a test", 300, a_DV=1 / 3, tau_e=200),
    [DamageFunction("ours", "a test", (0, 1000), [(0, 0, 0), (15, 0, 2e-7), (65, 1e-5, -1e-5 / 110)])],
    Passage(),
)
STATE = WheelRailState(
    position=WheelsetPosition(y=6, yaw=0.0144, roll=-6.272e-4),
    velocity=WheelsetVelocity(x=2000, pitch=-4.3293718),
    Fz=10_000,
)


@pytest.mark.parametrize(("b", "shear", "dang_van"), [(5, 0.2137, 0.1602), (50, 0.2499, 0.1659)])
def test_solved_ellipses_have_the_shear_and_the_stress_of_dang_van_that_are_known(shared, b, shear, dang_van):
    a, p0, margin = 5, 1000, 1.1
    problem = ContactProblem(
        grid=Grid(60, 60, 2 * a * margin / 60, 2 * b * margin / 60, x0=-a * margin, y0=-b * margin), upper=STEEL, gap=SemiAxes(a, b),
        Fn=2 / 3 * np.pi * a * b * p0, friction=Friction(1e-6, rolling=Rolling(xi=0.01)), fatigue=REQUEST,
    )  # fmt: skip
    fatigue = shared.solve(problem).fatigue
    assert fatigue.shear.value / p0 == pytest.approx(shear, abs=1e-3)
    assert fatigue.dang_van.value / p0 == pytest.approx(dang_van, abs=1e-3)
    assert fatigue.limit == pytest.approx(1 / shear, rel=5e-3)


def test_a_wheel_on_its_rail_says_where_cracks_start(shared):
    (patch,) = shared.wheel_rail(WheelRailSetup(dx=0.4, dy=0.4, fatigue=REQUEST), STATE, fields=[]).patches
    fatigue = patch.solution.fatigue
    assert fatigue.driven == (patch.solution.forces.Fx < 0)
    assert fatigue.limit == pytest.approx(patch.solution.pmax / fatigue.shear.value, rel=1e-12)
    assert fatigue.utilisation == pytest.approx(fatigue.dang_van.value / 200, rel=1e-12)
    assert fatigue.damage("ours") == pytest.approx((fatigue.T_gamma - 15) * 2e-7, rel=1e-9)
    assert fatigue.shear_of_rows.max() == fatigue.shear.value
    assert np.nanmax(fatigue.dang_van_of_rows) == fatigue.dang_van.value
    assert fatigue.load == pytest.approx(patch.solution.pmax / 300)


def test_a_conformal_contact_has_limits_of_its_own(shared):
    setup = WheelRailSetup(dx=0.5, dy=0.5, conformal="half_space", fatigue=REQUEST)
    (patch,) = shared.wheel_rail(setup, STATE, fields=[]).patches
    assert np.ptp([row.angle for row in patch.solution.fatigue.rows]) > 0.01
    assert 2 < patch.solution.fatigue.limit < 4.7


def test_stresses_below_columns_of_one_angle_are_those_below_a_plane(shared):
    grid = Grid(8, 6, 0.5, 0.5, x0=-2, y0=-1.5)
    pressure = np.ones(grid.shape)
    problem = ContactProblem(grid=grid, upper=STEEL, gap=Paraboloid(100, 100), approach=0.01, ics=AnalyticIcs())
    block = StressBlock(grid.x, grid.y, [-0.5, -1])
    plane = shared.subsurface(problem, Estimate(pressure=pressure), block=block, body="upper")
    frames = [(y, 0, 0.3) for y in grid.y]
    columns = problem.replace(columns=ContactColumns(frames, direction=0.3))
    curved = shared.subsurface(columns, Estimate(pressure=pressure), block=block, body="upper")
    np.testing.assert_allclose(curved.von_mises, plane.von_mises, atol=1e-9)
    bent = problem.replace(columns=ContactColumns([(y, 0, 0.4 * y) for y in grid.y]))
    lower = shared.subsurface(bent, Estimate(pressure=pressure), block=block)
    assert np.abs(lower.von_mises - plane.von_mises).max() > 1e-3
    with pytest.raises(InvalidArgument, match="angles"):
        shared.subsurface(bent, Estimate(pressure=pressure), block=block, displacements=True)


def test_what_makes_no_sense_is_refused(shared):
    function = DamageFunction("ours", "a test", (0, 10), [(1, 0, 0)])
    with pytest.raises(InvalidArgument, match=r"pieces\[0\].from"):
        shared.wheel_rail(WheelRailSetup(fatigue=FatigueRequest("upper", damages=[function])), STATE)
    with pytest.raises(InvalidArgument, match="setup.fatigue|fatigue"):
        shared.wheel_rail(WheelRailSetup(friction=None, fatigue=FatigueRequest("upper")), STATE)
