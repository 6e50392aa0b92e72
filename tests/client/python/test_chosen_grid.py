"""Tests problems without a grid: it is chosen by Hertz's ellipse, and corrected once."""

from __future__ import annotations

import asyncio
import warnings

import numpy as np
import pytest

import contactd
from contactd import (
    AnalyticIcs,
    AsyncClient,
    ContactProblem,
    ContactWarning,
    FemIcs,
    Friction,
    Grid,
    HalfEllipses,
    InvalidArgument,
    Layer,
    LayeredBody,
    LineContact,
    Paraboloid,
    RigidBody,
    Rolling,
    SemiAxes,
    ViscoelasticBody,
    steel,
)
from contactd.materials import aluminium
from contactd.values.hertz import Load, compliance_of, ellipse_of_curvatures

BALL = Paraboloid(50, 50)


def ellipse(gap, load, upper=steel, lower=steel):
    compliance = compliance_of((upper.nu, lower.nu), (upper.G, lower.G))
    return ellipse_of_curvatures(0.5 / gap.Rx, 0.5 / gap.Ry, Load(*load, compliance))


@pytest.mark.parametrize("gap", [BALL, Paraboloid(460, 300), Paraboloid(10, 1000), Paraboloid(2000, 1)])
def test_a_force_gives_the_largest_pressure_of_hertz(client, gap):
    solution = client.solve(gap, steel, aluminium, Fn=100)
    found = ellipse(gap, (100, True), steel, aluminium)
    assert solution.pmax == pytest.approx(1.5 * 100 / (np.pi * found.aa * found.bb), rel=0.02)
    assert solution.approach == pytest.approx(found.approach, rel=2e-3)
    assert (solution.grid.nx, solution.grid.ny) == (40, 40)
    assert solution.grid.nx * solution.grid.dx == pytest.approx(2.5 * found.aa)
    assert solution.grid.ny * solution.grid.dy == pytest.approx(2.5 * found.bb)


def test_an_approach_gives_the_force_of_hertz(client):
    solution = client.solve(BALL, steel, approach=0.01)
    modulus = steel.G / (1 - steel.nu)  # E* of two bodies of one material
    assert solution.Fn == pytest.approx(4 / 3 * modulus * 50**0.5 * 0.01**1.5, rel=2e-3)


def test_a_rigid_body_leaves_the_compliance_of_the_other(client):
    one, two = client.solve(BALL, steel, RigidBody(), Fn=100), client.solve(BALL, steel, Fn=50)
    assert one.grid.dx == pytest.approx(two.grid.dx)
    assert one.approach == pytest.approx(two.approach, rel=1e-6)


def test_semi_axes_are_taken_as_they_are(client):
    grid = client.solve(SemiAxes(1, 0.5), steel, Fn=100).grid
    assert grid == Grid.centred(40, 40, 2.5, 1.25)


def test_the_answer_is_that_on_the_same_grid_given(client):
    chosen = client.solve(BALL, steel, Fn=100, friction=Friction(0.3, rolling=Rolling(xi=1e-3)))
    given = client.solve(
        grid=chosen.grid, gap=BALL, upper=steel, Fn=100, friction=Friction(0.3, rolling=Rolling(xi=1e-3))
    )
    assert np.array_equal(chosen.traction_x, given.traction_x)


def test_fields_alone_serve_as_well(client):
    assert client.solve(gap=BALL, upper=steel, Fn=100).grid == client.solve(BALL, steel, Fn=100).grid
    assert not hasattr(client.solve(BALL, steel, Fn=100, fields=[]), "pressure")


def test_a_grid_that_is_given_is_taken(client):
    grid = Grid.centred(10, 10, 1, 1)
    assert client.solve(BALL, steel, Fn=100, grid=grid).grid == grid


def test_a_contact_that_reaches_the_border_is_solved_once_more_on_a_larger_grid(client):
    with warnings.catch_warnings():
        warnings.simplefilter("error", ContactWarning)  # warnings of the first grid are not reported
        solution = client.solve(BALL, steel, approach=0.01, sheet_flexibility=2e-5)
    hertz = ellipse(BALL, (0.01, False))
    assert (solution.grid.nx, solution.elements.border) == (60, 0)
    assert solution.grid.nx * solution.grid.dx == pytest.approx(5 * hertz.aa)


def test_only_once(client):
    with pytest.warns(ContactWarning, match="border"):
        solution = client.solve(BALL, steel, Fn=100, sheet_flexibility=10)
    assert solution.grid.nx == 60


def test_a_contact_with_few_elements_is_solved_once_more_on_a_smaller_grid(client):
    body = ViscoelasticBody(G=1000, nu=0.4, f=30, tau=1e3)  # too slow to creep: it has its instantaneous stiffness
    solution = client.solve(BALL, body, Fn=100, friction=Friction(0.3, rolling=Rolling(velocity=1e3)))
    at_once = ellipse(BALL, (100, True), contactd.Material(G=1000, nu=0.4), contactd.Material(G=1000, nu=0.4))
    assert solution.approach == pytest.approx(at_once.approach, rel=0.01)
    assert solution.elements.contact > 250
    assert solution.elements.border == 0


def test_a_coroutine_does_the_same(shared_daemon, client):
    async def solved():
        async with AsyncClient(shared_daemon.endpoint) as asking:
            return await asking.solve(BALL, steel, approach=0.01, sheet_flexibility=2e-5)

    expected = client.solve(BALL, steel, approach=0.01, sheet_flexibility=2e-5)
    assert np.array_equal(asyncio.run(solved()).pressure, expected.pressure)


LAYERS = LayeredBody([Layer(G=1, nu=0.49, thickness=0.1)], base=steel)


@pytest.mark.parametrize(
    ("gap", "fields", "why"),
    [
        (np.zeros((3, 3)), {}, "gap is neither a Paraboloid nor SemiAxes"),
        (HalfEllipses(1, 1, 1), {}, "gap is neither"),
        (Paraboloid(Rx=50), {}, "gap.Ry is None"),
        (Paraboloid(50, -80), {}, "gap has a negative radius, and a saddle has no contact ellipse"),
        (BALL, {"ics": FemIcs()}, "ics is not that of half-spaces"),
        (BALL, {"ics": AnalyticIcs(line_contact=LineContact(10))}, "ics is not that of half-spaces"),
        (BALL, {"lower": LAYERS}, "lower is a LayeredBody"),
        (BALL, {"previous": contactd.Estimate(np.zeros((3, 3)))}, "previous is given"),
    ],
)
def test_where_no_grid_can_be_chosen_one_is_asked_for(client, gap, fields, why):
    with pytest.raises(TypeError, match=rf"grid is missing: {why}.*Give grid=Grid\.centred"):
        client.solve(gap, steel, Fn=100, **fields)


@pytest.mark.parametrize(
    ("gap", "fields", "sentence"),
    [
        (BALL, {"Fn": -1}, "Fn is -1"),
        (BALL, {"Fn": "much"}, 'Fn is "much"; it must be a number'),
        (BALL, {"Fn": np.nan}, "Fn"),
        (Paraboloid(0, 50), {"Fn": 1}, "gap.paraboloid.Rx is 0"),
        (SemiAxes(-1, 1), {"Fn": 1}, "gap.semi_axes.a is -1"),
        (BALL, {"Fn": 1, "lower": contactd.Material(G=-1, nu=0.3)}, "bodies.lower.G is -1"),
    ],
)
def test_bad_values_are_refused_by_the_usual_sentences(client, gap, fields, sentence):
    with pytest.raises(InvalidArgument) as refused:
        client.solve(gap, steel, **fields)
    assert sentence in str(refused.value)


def test_loads_without_contact_have_an_answer(client):
    assert client.solve(BALL, steel, Fn=0).elements.contact == 0
    assert client.solve(BALL, steel, approach=-0.01).Fn == 0


def test_what_is_given_twice_is_refused(client):
    with pytest.raises(TypeError, match="got upper twice"):
        client.solve(BALL, steel, upper=steel, Fn=1)
    with pytest.raises(TypeError, match="a ContactProblem or its fields, not both: upper"):
        client.solve(ContactProblem(grid=Grid(4, 4, 1, 1), gap=BALL, upper=steel, Fn=1), steel)
    with pytest.raises(TypeError, match="lacks gap"):
        client.solve(upper=steel, Fn=1)
    with pytest.raises(TypeError, match="approach or Fn"):
        client.solve(BALL, steel)
    with pytest.raises(TypeError, match="Did you mean approach"):
        client.solve(BALL, steel, aproach=1)
