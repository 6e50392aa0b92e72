"""Tests fits of creep curves with a client of closed-form contacts: results, errors, and refusals."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest

import contactd
from contactd import Client, FitFailed, InvalidArgument, MissingExtra, ResourceExhausted

PROBLEM: dict[str, Any] = {"Fn": 1000.0, "friction": {"mu": 0.3, "rolling": {}}}
CREEPAGE = np.concatenate([np.linspace(2e-4, 3e-3, 12), np.linspace(4e-3, 0.03, 10)])
MU, FLEXIBILITY = "friction.mu", "friction.layer.flexibility"
BOUNDS = {MU: (0.05, 0.8), FLEXIBILITY: (1e-6, 1e-3)}


class Closed(Client):
    """Provides a client whose contacts have the traction coefficient `law`(mu, flexibility, xi); None does not
    converge."""

    def __init__(self, law: Any, most: int = 1000, derivative: Any = None) -> None:
        self.law, self.most, self.derivative = law, most, derivative
        self.batches: list[int] = []
        self.differentiated = 0

    def call(self, method: str, params: Any = None, **options: Any) -> dict[str, Any]:
        assert method == "contact.solve_many"
        problems = params["problems"]
        if len(problems) > self.most:
            raise ResourceExhausted("too much", reason="LIMIT_EXCEEDED")
        self.batches.append(len(problems))
        return {"solutions": [self.answer(problem) for problem in problems]}

    def answer(self, problem: Any) -> dict[str, Any]:
        assert problem["fields"] == []
        friction = problem["friction"]
        given = friction["mu"], friction.get("layer", {}).get("flexibility"), friction["rolling"]["xi"]
        value = self.law(*given)
        if isinstance(value, str):
            return {"status": {"code": 9, "name": "FAILED_PRECONDITION", "message": value}}
        result: dict[str, Any] = {"forces": {"Fn": 1000.0, "Fx": -1000.0 * (value or 0), "Fy": 0.0, "Mz": 0.0}, "converged": value is not None}
        if problem.get("derivatives") and self.derivative is not None:
            self.differentiated += 1
            result["derivatives"] = {"Fx": {"mu": -1000.0 * self.derivative(*given)}}
        return {"status": {"code": 0, "name": "OK", "message": ""}, "result": result}


def tanh(mu: float, flexibility: float, xi: float) -> float:
    return mu * np.tanh(xi * 6e-3 / (flexibility * mu))


def straight(mu: float, flexibility: float, xi: float) -> float:
    return mu + flexibility * xi


def curve(law: Any, mu: float = 0.3, flexibility: float = 2e-5) -> np.ndarray[Any, Any]:
    return np.array([law(mu, flexibility, x) for x in CREEPAGE])


def test_a_curve_gives_back_the_values_that_it_was_made_with():
    found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, curve(tanh), BOUNDS)
    assert found[MU].value == pytest.approx(0.3, rel=1e-6)
    assert found[FLEXIBILITY].value == pytest.approx(2e-5, rel=1e-6)
    assert found.converged
    assert found.rms < 1e-8
    assert found.warnings == ()
    assert found.params["friction"]["layer"]["flexibility"] == found[FLEXIBILITY].value
    assert "fields" not in found.params
    np.testing.assert_allclose(found.residuals, found.measured - found.computed)


@pytest.mark.parametrize("unit", [1.0, 1e6])  # coefficients, and mN
def test_forces_that_are_no_part_of_the_normal_force_are_doubted(unit):
    found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, unit * curve(tanh), BOUNDS, quantity="force")
    assert any("of the normal force, 1000 N. Give forces in N, not in kN" in one for one in found.warnings)
    sound = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, 1000 * curve(tanh), BOUNDS, quantity="force")
    assert sound.warnings == ()


def test_intervals_hold_the_values_as_often_as_they_say():
    """Expected are 190 of 200 curves with noise; three binomial deviations are 9."""
    inside = {MU: 0, FLEXIBILITY: 0}
    for seed in range(200):
        noisy = curve(tanh) + np.random.default_rng(seed).normal(0, 0.005, len(CREEPAGE))
        found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, noisy, BOUNDS, start={MU: 0.25, FLEXIBILITY: 1e-5})
        for path, right in ((MU, 0.3), (FLEXIBILITY, 2e-5)):
            low, high = found[path].interval
            inside[path] += low < right < high
    assert all(181 <= count <= 199 for count in inside.values()), inside


def test_errors_of_a_straight_line_are_the_textbook_ones():
    noisy = curve(straight, 0.1, 5.0) + np.random.default_rng(3).normal(0, 0.01, len(CREEPAGE))
    found = contactd.fit(Closed(straight), PROBLEM, CREEPAGE, noisy, {MU: (-1, 1), FLEXIBILITY: (-20, 20)}, curve=[0, 0.01])
    design = np.stack([np.ones_like(CREEPAGE), CREEPAGE], axis=1)
    right = np.linalg.lstsq(design, noisy, rcond=None)[0]
    variance = np.sum((noisy - design @ right) ** 2) / (len(noisy) - 2)
    covariance = variance * np.linalg.inv(design.T @ design)
    assert [one.value for one in found.parameters] == pytest.approx(right, rel=1e-6)
    assert [one.standard_error for one in found.parameters] == pytest.approx(np.sqrt(np.diag(covariance)), rel=1e-6)
    assert found.correlation[0, 1] == pytest.approx(covariance[0, 1] / np.sqrt(np.prod(np.diag(covariance))), rel=1e-6)
    assert not found[MU].is_logarithmic
    quantile = 2.0859634472658644  # quantile of Student's distribution with 20 degrees of freedom, at 0.975
    half = quantile * np.sqrt(np.einsum("ij,jk,ik->i", [[1, 0], [1, 0.01]], covariance, [[1, 0], [1, 0.01]]))
    np.testing.assert_allclose(found.curve.high - found.curve.value, half, rtol=1e-5)
    low, high = found[MU].interval
    assert high - low == pytest.approx(2 * quantile * np.sqrt(covariance[0, 0]), rel=1e-5)


def test_points_weigh_by_their_uncertainties():
    measured, sigma = curve(tanh), np.full(len(CREEPAGE), 1e-3)
    measured[5] += 0.2
    sigma[5] = 1e3
    found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, measured, BOUNDS, uncertainty=sigma)
    assert found[MU].value == pytest.approx(0.3, rel=1e-5)
    assert contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, measured, BOUNDS)[MU].value != pytest.approx(0.3, rel=1e-3)


def test_a_parameter_at_its_bound_is_warned_of():
    found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, curve(tanh), {MU: (0.05, 0.25), FLEXIBILITY: (1e-6, 1e-3)})
    assert found[MU].at_bound == "high"
    assert found[MU].standard_error is None
    assert found[FLEXIBILITY].standard_error > 0
    assert np.isnan(found.correlation[0, 1])
    assert any(sentence.startswith("friction.mu is at its upper bound, 0.25") for sentence in found.warnings)


def test_parameters_that_cannot_be_told_apart_are_warned_of():
    found = contactd.fit(Closed(lambda mu, layer, xi: mu * layer * xi), PROBLEM, CREEPAGE, 6e-3 * CREEPAGE, {MU: (0.05, 0.8), FLEXIBILITY: (1e-3, 1)})
    assert found[MU].value * found[FLEXIBILITY].value == pytest.approx(6e-3)
    assert [one.interval for one in found.parameters] == [None, None]
    assert any("friction.mu and friction.layer.flexibility cannot be determined separately" in sentence for sentence in found.warnings)


def test_parameters_that_can_hardly_be_told_apart_are_warned_of():
    def law(mu: float, flexibility: float, xi: float) -> float:
        return xi * (mu + 1.01 * flexibility * (1 + 0.2 * xi))

    noisy = curve(law, 0.3, 0.2) + np.random.default_rng(0).normal(0, 1e-7, len(CREEPAGE))
    found = contactd.fit(Closed(law), PROBLEM, CREEPAGE, noisy, {MU: (0.05, 0.8), FLEXIBILITY: (0.01, 1)})
    assert any("can hardly be determined separately" in sentence for sentence in found.warnings)
    assert found.correlation[0, 1] < -0.98


def test_a_parameter_that_changes_nothing_is_warned_of():
    found = contactd.fit(Closed(lambda mu, _, xi: mu * xi), PROBLEM, CREEPAGE, 0.3 * CREEPAGE, BOUNDS)
    assert found[MU].value == pytest.approx(0.3)
    assert found[FLEXIBILITY].standard_error is None
    assert any(sentence.startswith("friction.layer.flexibility has no effect") for sentence in found.warnings)


def test_as_many_parameters_as_points_have_no_errors():
    found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE[[2, -1]], curve(tanh)[[2, -1]], BOUNDS)
    assert found[MU].value == pytest.approx(0.3, rel=1e-5)
    assert found[MU].interval is None
    assert any("so their errors cannot be estimated" in sentence for sentence in found.warnings)


def test_the_search_turns_back_where_curves_cannot_be_computed():
    def law(mu: float, flexibility: float, xi: float) -> Any:
        return None if flexibility < 1e-5 and xi > 0.02 else "mu is too large." if mu > 0.5 else tanh(mu, flexibility, xi)

    found = contactd.fit(Closed(law), PROBLEM, CREEPAGE, curve(tanh), BOUNDS, start={MU: 0.45, FLEXIBILITY: 5e-4})
    assert found[MU].value == pytest.approx(0.3, rel=1e-5)
    assert np.all(np.isfinite(found.computed))


def test_another_start_is_taken_where_the_search_gets_stuck():
    def law(mu: float, flexibility: float, xi: float) -> Any:
        return None if 3e-5 < flexibility < 1e-4 else tanh(mu, flexibility, xi)

    found = contactd.fit(Closed(law), PROBLEM, CREEPAGE, curve(tanh), BOUNDS, start={FLEXIBILITY: 3e-4}, starts=16)
    assert found[FLEXIBILITY].value == pytest.approx(2e-5, rel=1e-5)


def test_a_search_that_gets_stuck_everywhere_fails():
    def law(mu: float, flexibility: float, xi: float) -> Any:
        return None if flexibility < 1e-4 else tanh(mu, flexibility, xi)

    with pytest.raises(FitFailed, match="The search cannot continue from friction.mu"):
        contactd.fit(Closed(law), PROBLEM, CREEPAGE, curve(tanh), BOUNDS)


def test_a_start_without_a_curve_says_why():
    with pytest.raises(FitFailed, match="No curve can be computed at the start, friction.mu 0.3, .*a solve did not converge"):
        contactd.fit(Closed(lambda *_: None), PROBLEM, CREEPAGE, curve(tanh), BOUNDS)
    with pytest.raises(FitFailed, match="grid is too coarse"):
        contactd.fit(Closed(lambda *_: "grid is too coarse"), PROBLEM, CREEPAGE, curve(tanh), BOUNDS)


def test_a_search_that_is_cut_short_says_so():
    found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, curve(tanh), BOUNDS, start={FLEXIBILITY: 5e-4}, max_evaluations=2)
    assert not found.converged
    assert found.warnings[0] == "The search did not converge: the largest number of evaluations was reached."
    assert "converged NO" in repr(found)


def test_derivatives_of_the_daemon_are_taken_where_it_knows_them():
    def by_mu(mu: float, flexibility: float, xi: float) -> float:
        z = xi * 6e-3 / (flexibility * mu)
        return np.tanh(z) - z / np.cosh(z) ** 2

    client = Closed(tanh, derivative=by_mu)
    found = contactd.fit(client, PROBLEM, CREEPAGE, curve(tanh), BOUNDS)
    assert found[MU].value == pytest.approx(0.3, rel=1e-6)
    assert client.differentiated >= len(CREEPAGE)


def test_batches_are_halved_where_they_are_too_large():
    client = Closed(tanh, most=5)
    found = contactd.fit(client, PROBLEM, CREEPAGE, curve(tanh), BOUNDS)
    assert found[MU].value == pytest.approx(0.3, rel=1e-6)
    assert max(client.batches) <= 5
    assert found.solves == sum(client.batches)


def test_news_tell_the_curves():
    stages = []
    contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, curve(tanh), BOUNDS, on_progress=lambda progress: stages.append(progress))
    assert stages[0].stage.startswith("curve 1")
    assert stages[-1].fraction < 1
    assert [one.fraction for one in stages] == sorted(one.fraction for one in stages)


def test_an_interrupt_ends_it():
    def law(*_: float) -> float:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        contactd.fit(Closed(law), PROBLEM, CREEPAGE, curve(tanh), BOUNDS)


@pytest.mark.parametrize(
    ("changes", "error", "said"),
    [
        ({"creepage": []}, InvalidArgument, "creepage has shape"),
        ({"creepage": CREEPAGE[1:]}, InvalidArgument, "measured has 22 values, but creepage has 21"),
        ({"measured": ["a"] * 22}, InvalidArgument, "measured is not a list of numbers"),
        ({"measured": np.full(22, np.nan)}, InvalidArgument, r"measured\[0\] is nan; every value must be finite"),
        ({"measured": np.zeros(22)}, InvalidArgument, "measured is zero everywhere"),
        ({"measured": -curve(tanh)}, InvalidArgument, "negative where the creepage is positive"),
        ({"measured": 9600 * curve(tanh)}, InvalidArgument, 'traction coefficients are below 2. For forces in N set quantity to "force"'),
        ({"uncertainty": np.zeros(22)}, InvalidArgument, r"uncertainty\[0\] is 0; standard uncertainties must be above 0"),
        ({"uncertainty": [1.0]}, InvalidArgument, "uncertainty has 1 values"),
        ({"parameters": {}}, InvalidArgument, "parameters is empty"),
        ({"parameters": {MU: 0.3}}, InvalidArgument, "it must be two numbers, the bounds"),
        ({"parameters": {MU: (0.5, 0.1)}}, InvalidArgument, "two finite numbers, the lower one first"),
        ({"parameters": {"mu mu": (0.1, 0.5)}}, InvalidArgument, "not the path of a field"),
        ({"parameters": {"friction.rolling.xi": (0.1, 0.5)}}, InvalidArgument, "which is the creepage of the curve"),
        ({"start": {"friction.nu": 0.3}}, InvalidArgument, "friction.nu, which is not one of the parameters"),
        ({"start": {MU: 0.9}}, InvalidArgument, "outside its bounds 0.05 to 0.8"),
        ({"creepage": [1e-3], "measured": [0.1]}, InvalidArgument, "1 points for 2 parameters"),
        ({"by": "zeta"}, ValueError, '"xi", "eta", "phi", or a path'),
        ({"quantity": "stress"}, ValueError, '"coefficient" or "force"'),
        ({"force": "Fz"}, ValueError, '"Fx" or "Fy"'),
        ({"confidence": 95}, ValueError, "between 0 and 1"),
        ({"starts": 0}, ValueError, "starts is 0"),
        ({"max_evaluations": 0}, ValueError, "max_evaluations is 0"),
        ({"problem": {"setup": {}, "state": {}}}, InvalidArgument, "problem has setup, as for wheelrail.solve"),
        ({"problem": 3}, TypeError, "problem is 3"),
        ({"client": "tcp://"}, TypeError, "client is 'tcp://'"),
    ],
)
def test_what_cannot_be_fitted_is_refused(changes, error, said):
    given = {"client": Closed(tanh), "problem": PROBLEM, "creepage": CREEPAGE, "measured": curve(tanh), "parameters": BOUNDS, **changes}
    with pytest.raises(error, match=said):
        contactd.fit(**given)


def test_without_scipy_it_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.optimize", None)
    with pytest.raises(MissingExtra, match=r'pip install "contactd\[fit\]"'):
        contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, curve(tanh), BOUNDS)


def test_it_is_drawn_with_points_curve_and_band():
    import matplotlib

    matplotlib.use("Agg")
    noisy = curve(tanh) + np.random.default_rng(1).normal(0, 0.005, len(CREEPAGE))
    found = contactd.fit(Closed(tanh), PROBLEM, CREEPAGE, noisy, BOUNDS, curve=np.linspace(0, 0.03, 31))
    axes = found.plot()
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["95 % confidence", "fitted", "measured"]
    assert axes.get_xlabel() == "longitudinal creepage"
    matplotlib.pyplot.close("all")
