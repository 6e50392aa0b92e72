"""Tests bodies whose influence coefficients come from different sources, and rigid slip of the elements."""

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactProblem,
    FemIcs,
    Friction,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    Rolling,
    SolverSettings,
    TableIcs,
)

STEEL, SOFT = Material(G=82000, nu=0.28), Material(G=200, nu=0.42)
GRID = Grid.centred(12, 10, 2.4, 2.4)
#: A steel sphere that rolls on a soft body.
PROBLEM = ContactProblem(
    grid=GRID,
    upper=STEEL,
    lower=SOFT,
    gap=Paraboloid(50, 50),
    approach=0.02,
    friction=Friction(0.3, rolling=Rolling(xi=2e-3, phi=1e-3)),
)
BLOCK = FemIcs(accuracy=1e-1, body="block", L_over_h=30)


def table_of(client, material, ics):
    return TableIcs.of_body(client.get_ic(material, GRID, ics))


@pytest.mark.parametrize("body", ["upper", "lower"])
def test_a_given_table_stands_for_the_body_it_was_made_of(shared, body):
    expected = shared.solve(PROBLEM)
    table = table_of(shared, {"upper": STEEL, "lower": SOFT}[body], AnalyticIcs())

    solution = shared.solve(PROBLEM.replace(**{f"{body}_ics": table}))

    assert solution.converged
    np.testing.assert_allclose(solution.pressure, expected.pressure, rtol=1e-9, atol=1e-9 * expected.pmax)
    # Displacements one step ahead are interpolated from a table, but exact for half-spaces.
    assert solution.Fx == pytest.approx(expected.Fx, rel=1e-6)
    assert solution.evidence.ics[body].origin == "given"
    other = {"upper": "lower", "lower": "upper"}[body]
    assert solution.evidence.ics[other].origin in ("closed_form", "memory")


def test_tables_of_both_bodies_are_their_pair(shared):
    upper, lower = (shared.get_ic(material, GRID, AnalyticIcs()) for material in (STEEL, SOFT))
    # The bodies of a pair are unknown, so its solve starts differently, and ends at a different point within the
    # tolerance.
    exact = PROBLEM.replace(normal=SolverSettings(1e-12), tangential=SolverSettings(1e-11), outer=SolverSettings(1e-11))
    each = shared.solve(exact.replace(upper_ics=TableIcs.of_body(upper), lower_ics=TableIcs.of_body(lower)))
    pair = shared.solve(exact.replace(ics=TableIcs.from_table(upper, lower)))
    np.testing.assert_allclose(each.pressure, pair.pressure, rtol=1e-9, atol=1e-9 * pair.pmax)
    assert each.Fy == pytest.approx(pair.Fy, rel=1e-6)


def test_a_block_under_a_half_space_yields_between_two_blocks_and_two_half_spaces(shared):
    problem = PROBLEM.replace(lower=STEEL, friction=None)
    force = {
        "half-spaces": shared.solve(problem).Fn,
        "both": shared.solve(problem.replace(upper_ics=BLOCK, lower_ics=AnalyticIcs())).Fn,
        "blocks": shared.solve(problem.replace(ics=BLOCK)).Fn,
    }
    # Smaller bodies are stiffer.
    assert force["half-spaces"] < force["both"] < force["blocks"]
    assert 1 / force["both"] == pytest.approx(0.5 * (1 / force["half-spaces"] + 1 / force["blocks"]), rel=0.02)


def test_which_body_is_the_block_does_not_matter_to_normal_contact(shared):
    problem = PROBLEM.replace(lower=STEEL, friction=None)
    below = shared.solve(problem.replace(lower_ics=BLOCK))
    above = shared.solve(problem.replace(upper_ics=BLOCK, lower_ics=AnalyticIcs()))
    assert below.Fn == pytest.approx(above.Fn, rel=1e-12)


def test_a_session_takes_bodies_of_different_sources(shared):
    problem = PROBLEM.replace(lower_ics=table_of(shared, SOFT, AnalyticIcs()))
    expected = shared.solve(problem)
    with shared.session(problem) as session:
        assert session.ics["lower"].origin == "given"
        assert session.step().Fx == pytest.approx(expected.Fx, rel=1e-12)


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"lower_ics": AnalyticIcs(load_shape="bilinear")}, "bodies.lower.ics.load_shape"),
        ({"lower_ics": TableIcs(np.ones((3, 3, 4, 4)), 0.2, 0.24)}, "bodies.lower.ics.table"),
        ({"upper_ics": TableIcs(np.ones((3, 3, 10, 12)), 0.1, 0.24)}, "bodies.upper.ics.dx"),
        ({"ics": TableIcs(np.ones((3, 3, 10, 12)), 0.2, 0.24), "upper_ics": AnalyticIcs()}, "ics.table"),
        ({"lower": Material(200, 0.5), "lower_ics": BLOCK}, "bodies.lower.nu"),
    ],
)
def test_coefficients_of_a_body_that_do_not_fit_are_named(shared, changes, field):
    with pytest.raises(InvalidArgument) as error:
        shared.solve(PROBLEM.replace(**changes))
    assert error.value.violations[0].field == field


# --- rigid slip of the elements --------------------------------------------------------------------------------------


def spinning(phi):
    x, y = np.meshgrid(GRID.x, GRID.y)
    return (-phi * y, phi * x)


def test_the_rigid_slip_of_a_spin_is_that_spin(shared):
    expected = shared.solve(PROBLEM)
    rolling = Friction(0.3, rolling=Rolling(xi=2e-3), rigid_slip=spinning(1e-3))
    solution = shared.solve(PROBLEM.replace(friction=rolling))
    assert solution.converged
    assert solution.Fy == pytest.approx(expected.Fy, rel=1e-6)


def test_a_shift_may_be_said_by_the_elements_alone(shared):
    ones = np.ones(GRID.shape)
    expected = shared.solve(PROBLEM.replace(friction=Friction(0.3, rigid_shift=(4e-3, 1e-3))))
    solution = shared.solve(PROBLEM.replace(friction=Friction(0.3, rigid_slip=(4e-3 * ones, 1e-3 * ones))))
    np.testing.assert_array_equal(solution.traction_x, expected.traction_x)


def test_a_step_brings_a_rigid_slip_of_its_own(shared):
    with shared.session(PROBLEM.replace(friction=Friction(0.3, rolling=Rolling(xi=2e-3)))) as session:
        plain, spun = session.step(), session.step(rigid_slip=spinning(1e-3))
        assert spun.Fy == pytest.approx(shared.solve(PROBLEM).Fy, rel=1e-4)
        assert session.step().Fy == pytest.approx(plain.Fy, rel=1e-4, abs=1e-4 * abs(spun.Fy))


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"friction": Friction(0.3, rigid_slip=(np.ones((2, 2)), np.ones(GRID.shape)))}, "friction.rigid_slip.x"),
        ({"friction": Friction(0.3, rolling=Rolling(xi=1e-3), rigid_slip=spinning(1e-3)), "model": "fastsim"},
         "friction.rigid_slip"),
    ],
)  # fmt: skip
def test_a_rigid_slip_that_cannot_be_taken_is_named(shared, changes, field):
    with pytest.raises(InvalidArgument) as error:
        shared.solve(PROBLEM.replace(lower=STEEL, **changes))
    assert error.value.violations[0].field == field
