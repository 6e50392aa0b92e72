"""Tests fits of creep curves by a running daemon: they find the values with which a curve was made."""

from __future__ import annotations

import numpy as np
import pytest

import contactd
from contactd import (
    ContactProblem,
    FitFailed,
    Friction,
    FrictionMemory,
    Grid,
    InterfacialLayer,
    KineticFriction,
    Material,
    Paraboloid,
    Rolling,
    SimplifiedSettings,
    SlopeReduction,
    SolverSettings,
)
from contactd.fits.creep_curves import CreepCurves, Response
from contactd.values.contact_params import problem_params

CREEPAGE = np.concatenate([np.linspace(4e-4, 4e-3, 7), np.geomspace(6e-3, 0.04, 5)])
GRID = Grid.centred(17, 17, 11, 9)


def problem(friction: Friction, **more) -> ContactProblem:
    return ContactProblem(grid=GRID, upper=Material(82000, 0.28), gap=Paraboloid(460, 300), Fn=30000, friction=friction, **more)


def rolling(**creepages: float) -> Rolling:
    return Rolling(dq=GRID.dx, velocity=8000, **creepages)


BARE = problem(Friction(0.3, rolling=rolling()))


def curve(client, of, by="xi", force="Fx", creepage=CREEPAGE):
    """Returns traction coefficients of problems that `of` makes of a Rolling."""
    answers = client.solve_many([of(rolling(**{by: float(x)})) for x in creepage], fields=[])
    assert all(answer.converged for answer in answers)
    return np.array([-getattr(answer.forces, force) / answer.Fn for answer in answers])


def test_an_elastic_layer_comes_back(shared):
    measured = curve(shared, lambda motion: problem(Friction(0.35, rolling=motion, layer=InterfacialLayer(2e-5))))
    bounds = {"friction.mu": (0.1, 0.6), "friction.layer.flexibility": (1e-6, 1e-3)}
    found = contactd.fit(shared, BARE, CREEPAGE, measured, bounds)
    assert found["friction.mu"].value == pytest.approx(0.35, rel=1e-5)
    assert found["friction.layer.flexibility"].value == pytest.approx(2e-5, rel=1e-4)
    assert found.converged
    assert found.rms < 1e-6
    with contactd.local(in_process=True) as here:
        again = contactd.fit(here, BARE, CREEPAGE, measured, bounds)
    assert again.parameters == found.parameters


def test_noise_leaves_errors_of_its_size(shared):
    layered = curve(shared, lambda motion: problem(Friction(0.35, rolling=motion, layer=InterfacialLayer(2e-5))))
    measured = layered + np.random.default_rng(7).normal(0, 0.004, len(layered))
    bounds = {"friction.mu": (0.1, 0.6), "friction.layer.flexibility": (1e-6, 1e-3)}
    found = contactd.fit(shared, BARE, CREEPAGE, measured, bounds, curve=np.linspace(0, 0.04, 9))
    for path, right in (("friction.mu", 0.35), ("friction.layer.flexibility", 2e-5)):
        one = found[path]
        assert 0 < one.standard_error < 0.1 * right
        assert abs(one.value - right) < 4 * one.standard_error
    assert 0.001 < found.rms < 0.008
    assert np.all(found.curve.low <= found.curve.value)
    assert found.curve.high[-1] > found.curve.low[-1]


def test_a_layer_that_flows_and_hardens_comes_back(shared):
    layer = InterfacialLayer(3e-5, yield_stress=110, hardening=5000)
    measured = curve(shared, lambda motion: problem(Friction(0.35, rolling=motion, layer=layer)))
    start = problem(Friction(0.35, rolling=rolling(), layer=InterfacialLayer(1e-5, yield_stress=150, hardening=2000)))
    bounds = {
        "friction.layer.flexibility": (1e-6, 1e-3), "friction.layer.yield_stress": (20, 400), "friction.layer.hardening": (100, 1e5),
    }  # fmt: skip
    found = contactd.fit(shared, start, CREEPAGE, measured, bounds)
    values = [one.value for one in found.parameters]
    assert values == pytest.approx([3e-5, 110, 5000], rel=1e-2)
    assert found.rms < 1e-4


def test_falling_friction_with_memory_comes_back_from_noise(shared):
    memory = FrictionMemory(0.02, 1)
    law = KineticFriction(0.15, 90, memory=memory)
    layer = InterfacialLayer(2e-5)
    measured = curve(shared, lambda motion: problem(Friction(0.35, rolling=motion, kinetic=law, layer=layer)))
    measured = measured + np.random.default_rng(2).normal(0, 0.002, len(measured))
    start = problem(Friction(0.3, rolling=rolling(), kinetic=KineticFriction(0.2, 200, memory=memory), layer=layer))
    bounds = {"friction.mu": (0.25, 0.6), "friction.kinetic.mu": (0.05, 0.25), "friction.kinetic.slip_velocity": (20, 1000)}
    found = contactd.fit(shared, start, CREEPAGE, measured, bounds)
    for path, right in (("friction.mu", 0.35), ("friction.kinetic.mu", 0.15), ("friction.kinetic.slip_velocity", 90)):
        assert abs(found[path].value - right) < 4 * found[path].standard_error, path


def test_a_slope_of_fastsim_comes_back_of_a_lateral_curve(shared):
    def of(k0, alpha):
        settings = SimplifiedSettings(slope=SlopeReduction(k0=k0, alpha=alpha, beta=0.5))
        return lambda motion: problem(Friction(0.35, rolling=motion), model="fastsim", simplified=settings)

    measured = curve(shared, of(0.5, 0.2), "eta", "Fy")
    bounds = {"simplified.slope.k0": (0.1, 1), "simplified.slope.alpha": (0.01, 1)}
    found = contactd.fit(shared, of(0.9, 0.9)(rolling()), CREEPAGE, measured, bounds, by="eta")
    assert [one.value for one in found.parameters] == pytest.approx([0.5, 0.2], rel=1e-3)


def test_a_curve_of_forces_gives_the_same(shared):
    measured = curve(shared, lambda motion: problem(Friction(0.35, rolling=motion)))
    found = contactd.fit(shared, BARE, CREEPAGE, 30000 * measured, {"friction.mu": (0.1, 0.6)}, quantity="force")
    assert found["friction.mu"].value == pytest.approx(0.35, rel=1e-6)


def test_derivatives_of_the_daemon_are_those_of_the_curve(shared):
    for quantity in ("coefficient", "force"):
        curves = CreepCurves(shared.call, problem_params(BARE), ["friction.mu", "Fn"], Response.of("xi", None, quantity), None, lambda _: None)
        for index, path in enumerate(("friction.mu", "Fn")):
            at, step = np.array([0.3, 30000.0]), np.array([0.3e-4, 3.0])
            step[1 - index] = 0
            up, down = curves.curves([at + step, at - step], CREEPAGE)
            known = curves.derivatives(list(at), CREEPAGE, path)
            np.testing.assert_allclose(known, (up - down) / (2 * step[index]), rtol=2e-3, atol=1e-3 * np.abs(known).max())


def test_a_value_that_the_daemon_refuses_is_avoided(shared):
    """The kinetic coefficient may not be above the static one, which bounds alone do not say."""
    law = KineticFriction(0.2, 90, memory=FrictionMemory(0.02, 1))
    measured = curve(shared, lambda motion: problem(Friction(0.3, rolling=motion, kinetic=law)))
    start = problem(Friction(0.45, rolling=rolling(), kinetic=law))
    found = contactd.fit(shared, start, CREEPAGE, measured, {"friction.mu": (0.1, 0.6)})
    assert found["friction.mu"].value == pytest.approx(0.3, rel=1e-4)
    with pytest.raises(FitFailed, match=r"friction\.kinetic\.mu"):
        contactd.fit(shared, start, CREEPAGE, measured, {"friction.mu": (0.1, 0.19)})


def test_what_does_not_converge_is_no_curve(shared):
    stopped = BARE.replace(tangential=SolverSettings(max_iterations=1))
    with pytest.raises(FitFailed, match="a solve did not converge"):
        contactd.fit(shared, stopped, CREEPAGE, 0.3 + 0 * CREEPAGE, {"friction.mu": (0.1, 0.6)})


def test_layer_and_law_of_a_published_curve_come_back(shared):
    """Uses four forces that the CONTACT program prints of its example tractcurv, second series: an elastic layer of
    1.25 mm and 8200 N/mm^2, and 0.14 + 0.19 2^(-v/1250 mm/s) with memory, for Polach's Eurosprinter (Wear 2005)."""
    creepage = np.array([1e-5, 0.003, 0.015, 0.15])
    printed = 0.33 * np.array([1.869e-3, 0.4928, 0.9442, 0.6755])
    a, b = 6.30360, 12.60719
    grid = Grid.centred(48, 44, 2.2 * a, 2.2 * b)
    kinetic = KineticFriction(0.1, 1000, memory=FrictionMemory(0.003, 1))
    friction = Friction(0.33, rolling=Rolling(dq=grid.dx, velocity=10000), kinetic=kinetic, layer=InterfacialLayer(5e-5))
    start = ContactProblem(grid=grid, upper=Material(82000, 0.28), gap=Paraboloid(1 / (2 * 8e-4), 1 / (2 * 2.814173e-4)), Fn=106700, friction=friction)
    bounds = {"friction.layer.flexibility": (1e-5, 1e-3), "friction.kinetic.mu": (0.05, 0.3), "friction.kinetic.slip_velocity": (300, 10000)}
    found = contactd.fit(shared, start, creepage, printed, bounds, uncertainty=1e-3 * printed)
    values = [one.value for one in found.parameters]
    assert values == pytest.approx([1.25 / 8200, 0.14, 1250 / np.log(2)], rel=5e-3)
    assert found.rms < 1e-4
