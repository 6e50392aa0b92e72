"""Tests forces of steady rolling that are extrapolated to a requested accuracy."""

import math

import pytest

from contactd import Client, Friction, Grid, InvalidArgument, KineticFriction, Material, Paraboloid, Rolling, SemiAxes

STEEL = Material(82_000, 0.28)
MU, FN, SIZE = 0.3, 50_000, 5.0  # SIZE is sqrt(ab), in mm.

#: a/b, nu, the scaled creepages (xi, eta, phi c) G c^2/(mu Fn), the forces (Fx, Fy, Mz/c)/(mu Fn) with their sign, and the
#: errors of these: from extrapolations by two other families of grids with up to 216 x 108 elements.
CONVERGED = {
    "a circle, much spin": (1, 0.28, (0.029625, -0.034875, 0.47415), (0.0655, 0.4949, 0.3485), 0.8e-4),
    "nearly full slip": (0.3, 0.28, (1.0039, 0.70634, 0.10723), (0.8210, 0.5686, 0.0190), 0.5e-4),
    "incompressible, wide": (0.0841, 0.5, (-0.40246, -1.6548, 0.26282), (-0.2284, -0.9413, 0.3664), 0.5e-4),
    "long": (10.1, 0.28, (0.061677, 0.12426, 0.044423), (0.3363, 0.9331, 0.0668), 0.5e-4),
    "no spin": (5, 0.28, (0.20909, 0.2363, 0), (0.6574, 0.7528, 0.0032), 0.5e-4),
    "pure spin": (1, 0.28, (0, 0, 0.27094), (0, 0.3768, 0.2266), 2.2e-4),
    "almost no creepage": (0.2, 0.25, (0.0070444, 0.0054853, 0.0024909), (0.0236, 0.0158, 0.0073), 0.5e-4),
}


def problem(state, **changes):
    ratio, nu, creepages, _, _ = state
    unit = MU * FN / (STEEL.G * SIZE**2)
    xi, eta, phi = (unit * creepage for creepage in creepages)
    a, b = SIZE * math.sqrt(ratio), SIZE / math.sqrt(ratio)
    fields = {
        "grid": Grid.centred(12, 12, 2.4 * a, 2.4 * b), "upper": Material(STEEL.G, nu), "gap": SemiAxes(a, b), "Fn": FN,
        "friction": Friction(MU, rolling=Rolling(xi=xi, eta=eta, phi=phi / SIZE)), "accuracy": 1e-3,
    }  # fmt: skip
    return {**fields, **changes}


def scaled(solution):
    return -solution.Fx / (MU * FN), -solution.Fy / (MU * FN), -solution.Mz / (MU * FN * SIZE)


@pytest.mark.parametrize("name", CONVERGED)
def test_forces_deviate_from_converged_ones_by_at_most_the_stated_error(shared, name):
    state = CONVERGED[name]
    solution = shared.solve(**problem(state), fields=())
    stated = solution.evidence.accuracy
    assert stated.converged
    assert max(stated.force_error, stated.moment_error) <= 1e-3
    bounds = (stated.force_error, stated.force_error, stated.moment_error)
    for found, value, bound in zip(scaled(solution), state[3], bounds, strict=True):
        assert found == pytest.approx(value, abs=bound + state[4] + 0.5e-4)  # The values have four digits.


def test_arrays_and_areas_are_those_of_the_grid(shared):
    fields = problem(CONVERGED["long"])
    found, plain = shared.solve(**fields), shared.solve(**{**fields, "accuracy": None})
    assert (found.traction_x == plain.traction_x).all()
    assert found.area == plain.area
    assert found.pmax == plain.pmax
    assert found.Fx != plain.Fx
    assert plain.evidence.accuracy is None


def test_rolling_along_y_is_rolling_along_x_rotated(shared):
    fields = problem(CONVERGED["long"])
    a, b = fields["gap"].a, fields["gap"].b
    along = fields["friction"].rolling
    across = Rolling(xi=-along.eta, eta=along.xi, phi=along.phi, chi=math.pi / 2)
    rotated = {
        **fields, "grid": Grid.centred(12, 12, 2.4 * b, 2.4 * a), "gap": SemiAxes(b, a), "friction": Friction(MU, rolling=across),
    }  # fmt: skip
    along_x, along_y = shared.solve(**fields), shared.solve(**rotated)
    assert along_y.Fy == pytest.approx(along_x.Fx, rel=1e-5)
    assert along_y.Fx == pytest.approx(-along_x.Fy, rel=1e-5)
    assert along_y.Mz == pytest.approx(along_x.Mz, rel=1e-4)
    assert (along_y.evidence.accuracy.fine.nx, along_y.evidence.accuracy.fine.ny) == (
        along_x.evidence.accuracy.fine.ny,
        along_x.evidence.accuracy.fine.nx,
    )


def test_a_session_extrapolates_the_forces_of_each_step(shared):
    fields = problem(CONVERGED["nearly full slip"])
    solution = shared.solve(**fields)
    with shared.session(**fields) as session:
        step = session.step()
    assert (step.Fx, step.Fy, step.Mz) == pytest.approx((solution.Fx, solution.Fy, solution.Mz), rel=1e-9)
    assert step.evidence.accuracy.fine.nx == solution.evidence.accuracy.fine.nx


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"model": "fastsim"}, "model"),
        ({"friction": None}, "friction"),
        ({"friction": Friction(MU, rigid_shift=(1e-3, 0))}, "friction"),
        ({"friction": Friction(MU, rolling=Rolling(xi=1e-3, kind="transient"))}, "friction.rolling.kind"),
        ({"friction": Friction(MU, rolling=Rolling(force=(1000, None)))}, "friction.rolling.force"),
        ({"friction": Friction(MU, rolling=Rolling(xi=1e-3), kinetic=KineticFriction(0.1, 100))}, "friction.kinetic"),
        ({"lower": Material(1000, 0.28)}, "bodies"),
        ({"gap": Paraboloid(1, 5000)}, "gap"),
        ({"accuracy": 5}, "accuracy"),
    ],
)
def test_what_it_does_not_support_is_refused_by_name(shared, changes, field):
    with Client(shared.endpoint) as client, pytest.raises(InvalidArgument) as refused:
        client.solve(**problem(CONVERGED["long"], **changes))
    assert refused.value.violations[0].field == field
