"""Tests contact on curved strips through a daemon: solves, sessions, and refusals."""

import numpy as np
import pytest

from contactd import ContactColumns, ContactProblem, Friction, Grid, InvalidArgument, Material, Paraboloid, Rolling

STEEL = Material(G=82000, nu=0.28)
GRID = Grid.centred(21, 15, 10.5, 7.5)
X, Y = np.meshgrid((np.arange(21) - 10) * 0.5, (np.arange(15) - 7) * 0.5)
GAP = X**2 / 100 + Y**2 / 80
ROLLING = Friction(0.3, rolling=Rolling(xi=1e-3, eta=-5e-4, phi=1e-4))
CONTACT = {"grid": GRID, "upper": STEEL, "gap": GAP, "Fn": 5000.0}


def columns(angle_of_each, **more):
    """Places strips on a circle with this angle between neighbours, or on a plane if it is 0."""
    angle = angle_of_each * (np.arange(15) - 7)
    radius = 0.5 / (angle_of_each or 1)
    y, z = (radius * np.sin(angle), radius * np.cos(angle)) if angle_of_each else (Y[:, 0], 0 * angle)
    return ContactColumns(np.stack([y, z, angle], axis=1), **more)


@pytest.mark.parametrize("friction", [None, ROLLING])
def test_flat_strips_are_a_plane(shared, friction):
    plane = shared.solve(**CONTACT, friction=friction)
    solution = shared.solve(**CONTACT, friction=friction, columns=columns(0))
    assert plane.resultant is None
    assert solution.pressure == pytest.approx(plane.pressure, abs=1e-6 * plane.pmax)
    assert solution.Fx == pytest.approx(plane.Fx, abs=1e-6 * plane.Fn)
    assert solution.resultant.Fz == pytest.approx(plane.Fn, rel=1e-8)
    assert solution.resultant.Fy == pytest.approx(plane.Fy, abs=1e-6 * plane.Fn)


def test_the_force_on_an_arc_is_along_its_approach(shared):
    for direction in (0.0, 0.3):
        solution = shared.solve(**CONTACT, columns=columns(0.05, direction=direction))
        angle = 0.05 * (np.arange(15) - 7)
        along = np.sum(solution.pressure * np.cos(angle - direction)[:, None]) * 0.25
        assert along == pytest.approx(5000, rel=1e-8)
        assert solution.Fn == pytest.approx(5000, rel=1e-8)
        assert abs(solution.resultant.Mx) < 1e-6 * 5000  # about the axis of the cylinder


def test_a_session_keeps_its_strips(shared):
    alone = shared.solve(**CONTACT, friction=ROLLING, columns=columns(0.05))
    with shared.session(**CONTACT, friction=ROLLING, columns=columns(0.05)) as session:
        step = session.step()
    assert step.resultant == alone.resultant


@pytest.mark.parametrize(
    ("change", "field"),
    [
        ({"columns": ContactColumns(np.zeros((14, 3)))}, "columns.frames"),
        ({"columns": ContactColumns(np.zeros((15, 3)))}, "columns.frames[1]"),
        ({"columns": columns(0.05, direction=2.0)}, "columns.frames[0].angle"),
        ({"gap": Paraboloid(50, 40)}, "gap"),
        ({"derivatives": True}, "derivatives"),
        ({"model": "hertz", "gap": Paraboloid(50, 40)}, "model"),
        ({"friction": Friction(0.3, rolling=Rolling(xi=1e-3, chi=0.5))}, "friction.rolling.chi"),
    ],
)
def test_what_is_not_known_on_curved_strips_is_refused(shared, change, field):
    with pytest.raises(InvalidArgument) as refused:
        shared.solve(**{**CONTACT, "columns": columns(0.05), **change})
    assert refused.value.violations[0].field == field


def test_stresses_below_strips_turn_with_them(shared):
    points = np.array([[0, 0, -1.0], [1, 1, -0.5]])

    def stress(**more):
        problem = {**CONTACT, "friction": ROLLING, **more}
        return shared.subsurface(ContactProblem(**problem), shared.solve(**problem), points=points)

    plane, flat, curved = stress(), stress(columns=columns(0)), stress(columns=columns(0.05))
    np.testing.assert_allclose(flat.von_mises, plane.von_mises, rtol=1e-5)
    assert not np.allclose(curved.von_mises, plane.von_mises, rtol=1e-3)
