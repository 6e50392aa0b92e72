"""Tests contact.solve: the Cattaneo problem of the paper, and ways to request it."""

import numpy as np
import pytest

from contactd import (
    Estimate,
    FemIcs,
    Friction,
    Grid,
    Material,
    Paraboloid,
    SolverSettings,
)
from support.problems import CATTANEO, CATTANEO_PARAMS

# An established half-space code with the same discretisation: Fz, |Fx|, pmax, area, adhesion, slip.
ESTABLISHED = {
    10: (9.21043857, 3.22153276, 4.34658684, 2.9952, 16, 36),
    40: (9.19731113, 3.22211266, 4.38757728, 3.1680, 216, 664),
}
HERTZ_FORCE = 9.195402
LIMIT_FX = 3.2216  # limit of TangCG with analytic coefficients for h -> 0 (paper, section 4.2)


@pytest.fixture(scope="module")
def solution(shared_daemon):
    with shared_daemon.client() as client:
        return client.solve(CATTANEO)


@pytest.mark.parametrize("n", ESTABLISHED)
def test_the_cattaneo_problem_agrees_with_an_established_code(shared, n):
    force, shift_force, pmax, area, adhesion, slip = ESTABLISHED[n]
    solution = shared.solve(CATTANEO.replace(grid=Grid.centred(n, n, 2.4, 2.4)))
    assert solution.converged
    assert solution.Fn == pytest.approx(force, rel=1e-5)
    assert solution.Fx == pytest.approx(-shift_force, rel=1e-5)
    assert solution.Fy == pytest.approx(0, abs=1e-6)
    assert solution.pmax == pytest.approx(pmax, rel=1e-5)
    assert solution.area.contact == pytest.approx(area, rel=1e-9)
    assert (solution.elements.adhesion, solution.elements.slip) == (adhesion, slip)


def test_a_solution_adds_up(solution):
    element = CATTANEO.grid.dx * CATTANEO.grid.dy
    assert solution.pressure.sum() * element == pytest.approx(solution.Fn, rel=1e-12)
    assert solution.traction_x.sum() * element == pytest.approx(solution.Fx, rel=1e-12)
    assert solution.pressure.max() == solution.pmax
    assert (solution.pressure >= 0).all()
    assert np.count_nonzero(solution.element_division == 1) == solution.elements.adhesion
    assert np.count_nonzero(solution.element_division == 2) == solution.elements.slip
    assert solution.elements.contact == solution.elements.adhesion + solution.elements.slip
    assert solution.area.slip == pytest.approx(solution.elements.slip * element)
    assert (solution.pressure[solution.element_division == 0] == 0).all()


def test_tractions_keep_to_coulombs_bound(solution):
    size, bound = np.hypot(solution.traction_x, solution.traction_y), 0.4 * solution.pressure
    assert (size <= bound + 1e-5 * solution.pmax).all()
    slip = solution.element_division == 2
    np.testing.assert_allclose(size[slip], bound[slip], rtol=1e-9)


def test_a_gap_given_as_array_is_the_paraboloid(shared):
    x, y = np.meshgrid(CATTANEO.grid.x, CATTANEO.grid.y)
    # The values are exact, because solvers start from Hertz's pressures under a paraboloid.
    exact = CATTANEO.replace(normal=SolverSettings(tolerance=1e-12), tangential=SolverSettings(tolerance=1e-11))
    solution = shared.solve(exact)
    other = shared.solve(exact.replace(gap=x**2 / 100 + y**2 / 100))
    np.testing.assert_allclose(other.pressure, solution.pressure, rtol=1e-9, atol=1e-12)
    assert other.Fx == pytest.approx(solution.Fx, rel=1e-9)


def test_a_cylinder_is_flat_along_its_axis(shared):
    along_y = shared.solve(CATTANEO.replace(gap=Paraboloid(Rx=50), friction=None))
    along_x = shared.solve(CATTANEO.replace(gap=Paraboloid(Ry=50), friction=None))
    np.testing.assert_allclose(along_y.pressure.T, along_x.pressure, rtol=1e-5, atol=1e-5)
    assert (along_y.element_division[:, 20] != 0).all()


def test_the_grid_may_lie_anywhere_with_its_gap(shared, solution):
    grid = Grid(40, 40, 0.06, 0.06, x0=-1.2 + 2 * 0.06, y0=-1.2)
    moved = shared.solve(CATTANEO.replace(grid=grid))
    # The window has moved by two elements along x; the contact stays where the gap is smallest.
    np.testing.assert_allclose(moved.pressure[:, :38], solution.pressure[:, 2:], atol=1e-4)
    assert moved.Fx == pytest.approx(solution.Fx, rel=1e-5)


def test_lists_and_frames_give_equal_answers(shared_daemon):
    gap = (np.arange(6.0).reshape(2, 3) - 2) ** 2 / 50
    params = {**CATTANEO_PARAMS, "grid": {"nx": 3, "ny": 2, "dx": 0.5, "dy": 0.5}}
    reference = {"$array": {"frame": 1, "dtype": "<f8", "shape": [2, 3]}}
    with shared_daemon.raw() as raw:
        framed = raw.ask("contact.solve", {**params, "gap": {"array": reference}}, gap.tobytes())
        listed = raw.ask("contact.solve", {**params, "gap": {"array": gap.tolist()}}, arrays="list")
    assert listed.frames == []
    for name in ["pressure", "traction_x", "traction_y", "element_division"]:
        np.testing.assert_array_equal(np.array(listed.result[name]), framed.array(name))
    assert listed.result["forces"] == framed.result["forces"]


def test_an_estimate_saves_iterations_and_changes_nothing_else(shared, solution):
    warm = shared.solve(CATTANEO.replace(initial=solution))
    assert warm.evidence.normal.iterations < solution.evidence.normal.iterations
    assert warm.evidence.tangential.iterations < solution.evidence.tangential.iterations
    assert warm.Fn == pytest.approx(solution.Fn, rel=1e-5)
    assert warm.Fx == pytest.approx(solution.Fx, rel=1e-5)


def test_an_absurd_estimate_does_no_harm(shared, solution):
    rng = np.random.default_rng(7)
    estimate = Estimate(pressure=rng.normal(size=(40, 40)), traction_x=1e3 * rng.normal(size=(40, 40)))
    other = shared.solve(CATTANEO.replace(initial=estimate))
    assert other.converged
    assert other.Fn == pytest.approx(solution.Fn, rel=1e-5)
    assert other.Fx == pytest.approx(solution.Fx, rel=1e-5)


def test_a_solve_that_does_not_converge_says_so(shared):
    solution = shared.solve(CATTANEO.replace(tangential=SolverSettings(max_iterations=1)))
    assert not solution.converged
    assert not solution.evidence.tangential.converged
    assert solution.evidence.normal.converged


def test_friction_between_dissimilar_bodies_takes_an_outer_iteration(shared, solution):
    dissimilar = shared.solve(CATTANEO.replace(lower=Material(G=400, nu=0.3)))
    assert dissimilar.converged
    assert dissimilar.evidence.outer.converged
    assert solution.evidence.outer is None


def test_bodies_with_equal_coupling_constants_take_friction(shared):
    # (1 - 2 nu) / G is equal, so the dissimilar bodies are quasi-identical.
    lower = Material(G=200 * (1 - 2 * 0.3) / (1 - 2 * 0.42), nu=0.3)
    assert shared.solve(CATTANEO.replace(lower=lower)).converged


def test_dissimilar_bodies_without_friction_follow_hertz(shared):
    upper, lower = Material(200, 0.42), Material(800, 0.3)
    solution = shared.solve(CATTANEO.replace(upper=upper, lower=lower, friction=None))
    modulus = 1 / sum((1 - body.nu) / (2 * body.G) for body in (upper, lower))
    assert solution.Fn == pytest.approx(4 / 3 * modulus * 50**0.5 * 0.02**1.5, rel=1e-3)


def test_without_friction_nothing_holds_the_contact(shared):
    solution = shared.solve(CATTANEO.replace(friction=None))
    assert solution.evidence.tangential is None
    assert (solution.Fx, solution.Fy) == (0, 0)
    assert (solution.elements.adhesion, solution.elements.slip) == (0, 880)


def test_a_shift_the_other_way_turns_the_traction(shared, solution):
    rotated = shared.solve(CATTANEO.replace(friction=Friction(0.4, (0, -0.00817))))
    assert rotated.Fy == pytest.approx(-solution.Fx, rel=1e-5)
    np.testing.assert_allclose(rotated.traction_y.T, -solution.traction_x, rtol=1e-3, atol=1e-3)


def test_a_large_shift_slips_everywhere(shared):
    solution = shared.solve(CATTANEO.replace(friction=Friction(0.4, (0.05, 0))))
    assert solution.elements.adhesion == 0
    assert solution.Fx == pytest.approx(-0.4 * solution.Fn, rel=1e-3)


def test_bodies_that_do_not_touch_have_no_contact(shared):
    solution = shared.solve(CATTANEO.replace(approach=-0.01))
    assert solution.converged
    assert (solution.Fn, solution.Fx, solution.elements.contact) == (0, 0, 0)


def test_a_single_element_can_be_solved(shared):
    solution = shared.solve(CATTANEO.replace(grid=Grid(1, 1, 0.5, 0.5)))
    assert solution.elements.contact == 1


def test_a_solve_brings_the_arrays_that_it_is_asked_for(shared, solution):
    forces, pressure = shared.solve(CATTANEO, fields=[]), shared.solve(CATTANEO, fields="pressure")
    assert (forces.forces, forces.area, forces.motion) == (solution.forces, solution.area, solution.motion)
    assert not any(hasattr(forces, name) for name in ("pressure", "element_division", "slip_x"))
    np.testing.assert_array_equal(pressure.pressure, solution.pressure)
    assert not hasattr(pressure, "traction_x")
    slips = shared.solve_many([CATTANEO, CATTANEO.replace(friction=None)], fields=["slip_x", "traction_x"])
    np.testing.assert_array_equal(slips[0].slip_x, solution.slip_x)
    assert (slips[1].slip_x, slips[1].traction_x.any(), hasattr(slips[1], "pressure")) == (None, False, False)


@pytest.mark.slow  # builds the table of a block with the paper's finest mesh, and solves on 160 x 160 elements
@pytest.mark.timeout(600)
def test_finite_elements_reach_the_accuracy_of_the_paper(shared):
    """Tables interpolated between all nodes reproduce the paper's Fx (0.03 %)."""
    grid = Grid.centred(160, 160, 2.4, 2.4)
    ics = FemIcs("paper-test3", L_over_h=1024 / grid.dx, sampling="linear_nodes")
    solution = shared.solve(CATTANEO.replace(grid=grid, ics=ics), timeout=500)
    assert solution.converged
    assert solution.Fn == pytest.approx(HERTZ_FORCE, rel=0.002)
    assert solution.Fx == pytest.approx(-LIMIT_FX, rel=0.001)
    assert solution.evidence.ics["upper"].evidence.load_cases[0].residual <= 1e-8


@pytest.mark.slow  # builds the table of a block with the paper's finest mesh, and solves on 160 x 160 elements
@pytest.mark.timeout(600)
def test_what_the_clamped_block_costs_goes_with_its_size(shared):
    """Clamping at 1024 mm alone shifts Fx by 0.10 % on any mesh; a thousand times farther away the shift vanishes."""
    grid = Grid.centred(160, 160, 2.4, 2.4)
    ics = FemIcs("paper-test3", L_over_h=1_024_000 / grid.dx)
    solution = shared.solve(CATTANEO.replace(grid=grid, ics=ics), timeout=500)
    assert solution.Fn == pytest.approx(HERTZ_FORCE, rel=0.0005)
    assert solution.Fx == pytest.approx(-LIMIT_FX, rel=0.0003)
