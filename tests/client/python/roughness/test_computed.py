"""Tests weights of computed contacts, and full solves with rough surfaces."""

from __future__ import annotations

import warnings
from types import SimpleNamespace

import numpy as np
import pytest

from contactd import ContactProblem, ContactWarning, Grid, InvalidArgument, Paraboloid
from contactd.materials import steel
from contactd.roughness import (
    ContactFilter,
    Record,
    chi_of,
    contact_weights,
    heights_at,
    hertz_weights,
    roll_over,
    wheel_rail_weights,
)
from contactd.wheel_rail import ProfilePoints, Track, WheelRailSetup, WheelRailState, WheelsetPosition

WHEEL = hertz_weights(50e3, 460, 300, steel)
MODULUS = 82e3 / 0.72
WAVES = np.array([100, 50, 40, 31.5, 25, 20, 16])


def problem(across: int, Rx: float = 460, Ry: float = 300) -> ContactProblem:
    ellipse = hertz_weights(50e3, Rx, Ry, steel)
    side = round(1.25 * across)
    return ContactProblem(Grid.centred(side, side, 2.5 * ellipse.a, 2.5 * ellipse.b), steel, Paraboloid(Rx, Ry), Fn=50e3)


def coarse(elements: float = 0.5) -> ContactProblem:
    return ContactProblem(Grid.centred(round(18 / elements), round(14 / elements), 18, 14), steel, Paraboloid(460, 300), Fn=50e3)


@pytest.mark.parametrize("across", ["isotropic", "alike"])
def test_computed_weights_have_the_filter_of_hertz(client, across):
    weights = contact_weights(client, problem(32))
    found, exact = ContactFilter(weights, across), ContactFilter(WHEEL, across)
    np.testing.assert_allclose(found.band_levels(WAVES), exact.band_levels(WAVES), atol=0.1)
    assert weights.stiffness == pytest.approx(WHEEL.stiffness, rel=5e-3)


def test_the_stiffness_is_the_derivative_of_the_force(client):
    given = problem(32)
    solution = client.solve(given.replace(Fn=None, approach=client.solve(given).approach, derivatives=True), fields=["pressure"])
    weights = contact_weights(client, given, solution)
    assert weights.stiffness == pytest.approx(solution.derivatives.Fn.approach, rel=1e-5)


def test_derivatives_of_pressures_need_no_further_solve(client):
    given = problem(32)
    steps = [client.solve(given.replace(Fn=None, approach=at), fields=["pressure"]) for at in (0.06599, 0.06601)]
    gains = np.where((steps[0].pressure > 0) & (steps[1].pressure > 0), (steps[1].pressure - steps[0].pressure) / 2e-5, 0)
    middle = contact_weights(client, given.replace(Fn=None, approach=0.066))
    found = contact_weights(None, given, SimpleNamespace(pressure_by_approach=gains))
    assert len(found.values) == len(middle.values)
    np.testing.assert_allclose(found.values, middle.values, rtol=1e-3)
    assert found.stiffness == pytest.approx(middle.stiffness, rel=1e-4)


def test_weights_are_symmetric_and_rotate_with_the_contact(client):
    weights = contact_weights(client, problem(32))
    assert weights.values @ weights.x == pytest.approx(0, abs=1e-9)
    assert weights.values @ weights.x**2 == pytest.approx(WHEEL.a**2 / 3, rel=0.02)
    turned = contact_weights(client, problem(32, 300, 460))
    order = np.lexsort((turned.x, turned.y)), np.lexsort((weights.y, weights.x))
    np.testing.assert_allclose(turned.values[order[0]], weights.values[order[1]], rtol=1e-6)


def test_a_wheel_on_its_rail_has_the_given_filter(client):
    setup = WheelRailSetup(dx=0.25, dy=0.25, friction=None)
    solution = client.wheel_rail(setup, WheelRailState(Fz=50e3), fields=["pressure"])
    weights = wheel_rail_weights(client, setup, solution)
    found = ContactFilter(weights).band_levels([40, 25, 20, 16])
    np.testing.assert_allclose(found, [-2.77, -5.06, -6.79, -9.26], atol=0.05)
    assert weights.stiffness == pytest.approx(1.555e6, rel=3e-3)


def test_several_patches_have_one_approach(client):
    y = np.linspace(-30, 30, 601)
    groove, head = (ProfilePoints(np.stack([y, z], axis=1)) for z in (0.3 * np.abs(y), y**2 / 80))
    setup = WheelRailSetup(wheel=groove, rail=head, track=Track(rail_origin=(750, 0)), dx=0.2, dy=0.2, friction=None)
    solution = client.wheel_rail(setup, WheelRailState(Fz=40e3), fields=["pressure"])
    assert len(solution.patches) == 2
    weights = wheel_rail_weights(client, setup, solution)
    low, high = (
        client.wheel_rail(setup, WheelRailState(position=WheelsetPosition(z=solution.z + dz)), fields=[]).forces.track.Fz for dz in (-1e-4, 1e-4)
    )
    assert weights.stiffness == pytest.approx((high - low) / 2e-4, rel=2e-3)
    assert weights.values[weights.y > 0].sum() == pytest.approx(0.5, rel=1e-6)


@pytest.mark.parametrize(
    ("length", "amplitude", "first", "mean", "second"),
    [(40, 50, 0.8457, 6.16, -0.0859), (20, 20, 0.5317, 2.65, -0.0164), (10, 10, -0.1067, 0.99, 0.0038)],
)
def test_waves_alike_across_have_the_given_harmonics(client, length, amplitude, first, mean, second):
    given = ContactProblem(Grid.centred(80, 56, 20, 14), steel, Paraboloid(460, 300), Fn=50e3)
    places = length / 16 * np.arange(16)
    run = roll_over(client, given, lambda x, y: 1e-3 * amplitude * np.cos(2 * np.pi * x / length), places)
    found = np.fft.rfft(run.roughness).real * 1e3 / 16
    assert 2 * found[1] / amplitude == pytest.approx(first, abs=5e-4)
    assert 2 * found[2] / amplitude == pytest.approx(second, abs=5e-4)
    assert found[0] == pytest.approx(mean, abs=0.01)


def test_small_roughness_is_that_of_the_first_order(client):
    weights = contact_weights(client, coarse())
    run = roll_over(client, coarse(), lambda x, y: 1e-6 * np.cos(2 * np.pi * x / 20), [0.0, 3.0])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ContactWarning)  # of few elements
        gain = weights.values @ np.cos(2 * np.pi * weights.x / 20)
    np.testing.assert_allclose(run.roughness, 1e-6 * gain * np.cos(2 * np.pi * np.array([0, 3.0]) / 20), rtol=2e-3)


def test_a_constant_moves_the_wheel_and_nothing_else(client):
    run = roll_over(client, coarse(), Record(1.0, np.full(100, 0.02)), [40.0, 50.0])
    np.testing.assert_allclose(run.roughness, 0.02, atol=1e-9)
    np.testing.assert_allclose(run.areas, 1)


def test_records_and_functions_are_one_surface(client):
    x = np.arange(120.0)
    record = Record(1.0, 1e-2 * np.cos(2 * np.pi * x / 20))
    one = roll_over(client, coarse(), record, [50.0, 57.0])
    other = roll_over(client, coarse(), lambda x, y: 1e-2 * np.cos(2 * np.pi * x / 20), [50.0, 57.0])
    np.testing.assert_allclose(one.roughness, other.roughness, atol=2e-5)


def test_heights_between_lines_are_linear_across():
    record = Record(1.0, np.outer([0.0, 1.0], np.ones(60)), np.array([0.0, 10.0]))
    np.testing.assert_allclose(heights_at(record, np.array([30.3]), np.array([-5.0, 2.5, 20.0]))[:, 0], [0, 0.25, 1], atol=1e-12)


def test_runs_report_progress_and_can_be_cancelled(client):
    seen: list[float] = []

    def stop(fraction: float, text: str) -> None:
        seen.append(fraction)
        if len(seen) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        roll_over(client, coarse(), lambda x, y: 0 * x, range(1000), on_progress=stop)
    assert seen == [0.001, 0.002, 0.003]
    assert not client.sessions()


@pytest.mark.parametrize(
    ("run", "words"),
    [
        (lambda c: roll_over(c, coarse().replace(Fn=None, approach=0.05), Record(1.0, np.zeros(99)), [50]), "problem.Fn = None"),
        (lambda c: roll_over(c, coarse(), Record(1.0, np.zeros(99)), [5]), "the record must extend 8 mm beyond"),
        (lambda c: roll_over(c, coarse(), Record(1.0, np.zeros(99)), [np.nan]), "places = "),
        (lambda c: contact_weights(c, coarse().replace(Fn=500e3)), "a contact that reaches its border"),
        (lambda c: contact_weights(c, coarse().replace(Fn=0)), "no contact"),
        (lambda c: contact_weights(c, coarse(), c.solve(coarse(), fields=[])), "Request fields="),
    ],
)
def test_wrong_problems_are_refused(client, run, words):
    with warnings.catch_warnings(), pytest.raises(InvalidArgument, match=words):
        warnings.simplefilter("ignore", ContactWarning)
        run(client)


def test_chi_bounds_the_first_order(client):
    line = Record(0.01, 1e-3 * np.sin(2 * np.pi * np.arange(20_000) * 0.01 / 20))
    expected = MODULUS * (2 * np.pi * 1e-3 / 20 / np.sqrt(2)) / (2 * 50e3 / (np.pi * WHEEL.a * WHEEL.b))
    assert chi_of(line, WHEEL, 50e3, across="alike") == pytest.approx(expected, rel=1e-3)
    assert chi_of(line, WHEEL, 50e3) == pytest.approx(expected * np.sqrt(2), rel=1e-3)
    assert chi_of(line, contact_weights(client, problem(32)), 50e3, across="alike") == pytest.approx(expected, rel=0.02)
    with pytest.warns(ContactWarning, match=r"chi = 0.31.*roll_over"):
        chi_of(line.with_heights(0.31 / expected * line.heights), WHEEL, 50e3, across="alike")
