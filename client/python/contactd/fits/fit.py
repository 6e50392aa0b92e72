"""Fits parameters of friction, or others, to a measured creep curve."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from ..calls.answer_warnings import ContactWarning
from ..calls.caller import ProgressCallback
from ..client import Client
from ..errors import invalid
from ..refusals import check_type, public
from ..values.arrays import Array
from ..values.contact_params import problem_params
from ..values.fit import Fit, FittedCurve, FittedParameter
from ..values.generated.problem import ContactProblem
from ..values.generated.service import Progress
from .creep_curves import CreepCurves, Response
from .measured_curve import MeasuredCurve
from .parameter import VariedParameter, varied
from .plausibility import check_coefficients, unlikely_forces
from .search import FitFailed, Found, Search
from .statistics import Certainty, certainty_of

__all__ = ["fit"]

_STARTS = 16  #: Default for parameters without a start.


@public
def fit(
    client: Client,
    problem: ContactProblem | Mapping[str, Any],
    creepage: npt.ArrayLike,
    measured: npt.ArrayLike,
    parameters: Mapping[str, tuple[float, float]],
    *,
    uncertainty: npt.ArrayLike | None = None,
    start: Mapping[str, float] | None = None,
    starts: int | None = None,
    by: str = "xi",
    quantity: str = "coefficient",
    force: str | None = None,
    confidence: float = 0.95,
    curve: npt.ArrayLike | None = None,
    max_evaluations: int = 100,
    timeout: float | None = None,
    on_progress: ProgressCallback | None = None,
) -> Fit:
    """Fits parameters of a contact to a measured creep curve by least squares::

        found = contactd.fit(client, problem, creepage, coefficient,
                             {"friction.mu": (0.1, 0.6), "friction.layer.flexibility": (1e-6, 1e-3)})
        print(found["friction.mu"].value, found["friction.mu"].interval, found.warnings)

    `problem` is a ContactProblem, or the parameters of contact.solve, usually of steady rolling; other motions are
    possible. `creepage` and `measured` are the points of the curve. `by` names the creepage: "xi", "eta", "phi", or any
    path. Measured values are traction coefficients, or forces (N) with `quantity="force"`; they are positive if they
    oppose a positive creepage. The force is Fx, or Fy if `by` is eta or phi; `force` overrides this. `parameters` are
    fields by their paths on the wire, each with its bounds. The logarithm of positive parameters is varied. The search
    begins at `start`, otherwise at the values of the problem. For parameters without a value, it begins at the best of
    `starts` points (16) between the bounds. `uncertainty` contains the standard uncertainties of the measured values,
    which determine the weights.

    Uncertainties of the parameters follow linear theory: from the covariance and the scatter of the residuals, with
    Student's quantile for the `confidence`. Parameters at bounds, and those that the curve does not determine, have no
    uncertainty, and `warnings` names them. With creepages as `curve`, the answer includes the fitted curve with its
    band.

    Problems are solved in batches on all workers of the daemon. Derivatives are those of the daemon where available,
    otherwise differences. If a solve fails or does not converge, the search rejects that curve.

    `timeout` applies to each batch. `on_progress` is called for each curve. Needs scipy ("contactd[fit]").

    Raises InvalidArgument for an invalid curve or parameter, and FitFailed, a ContactdError, if no curve can be
    computed.
    """
    check_type("client", client, Client)
    check_type("problem", problem, ContactProblem, Mapping)
    params = problem_params(problem) if isinstance(problem, ContactProblem) else dict(problem)
    if "setup" in params:
        raise invalid("problem", "has setup, as for wheelrail.solve, but a curve is fitted with a single contact, as for contact.solve")
    points = MeasuredCurve.of(creepage, measured, uncertainty)
    fields = varied(parameters, start or {}, params)
    response = Response.of(by, force, quantity)
    _check(fields, points, response, confidence, starts, max_evaluations)
    check_coefficients(points, response)
    asked = None if curve is None else MeasuredCurve.of(curve, np.ones(len(np.atleast_1d(curve))), None).creepage

    def report(evaluations: int, rms: float) -> None:
        if on_progress is not None:
            rest = "" if rms == float("inf") else f", residual {rms:.2e}"
            on_progress(Progress(f"curve {evaluations}{rest}", min(0.99, evaluations / max_evaluations)))

    def forward(progress: Progress) -> None:
        if on_progress is not None and progress.job:
            on_progress(progress)

    curves = CreepCurves(client.call, params, [one.path for one in fields], response, timeout, forward)
    search = Search(fields, points, curves, report)
    has_no_start = any(one.start is None for one in fields)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ContactWarning)  # only the last curve reports its warnings
        found = search.run(starts or (_STARTS if has_no_start else 1), max_evaluations)
        return _made(found, fields, points, search, curves, response, confidence, asked)


def _check(
    fields: list[VariedParameter], points: MeasuredCurve, response: Response, confidence: float, starts: int | None, most: int
) -> None:  # fmt: skip
    if len(points.creepage) < len(fields):
        raise invalid("measured", f"has {len(points.creepage)} points for {len(fields)} parameters; give at least as many points as parameters")
    if not 0 < confidence < 1:
        raise ValueError(f"confidence is {confidence}; it must be between 0 and 1, such as 0.95")
    if starts is not None and (not isinstance(starts, int) or starts < 1):
        raise ValueError(f"starts is {starts!r}; it must be a whole number, 1 or more")
    if not isinstance(most, int) or most < 1:
        raise ValueError(f"max_evaluations is {most!r}; it must be a whole number, 1 or more")
    if any(one.path == response.by for one in fields):
        raise invalid("parameters", f"has {response.by}, which is the creepage of the curve and cannot be fitted")


def _made(
    found: Found, fields: list[VariedParameter], points: MeasuredCurve, search: Search, curves: CreepCurves, response: Response,
    confidence: float, asked: Array | None,
) -> Fit:  # fmt: skip
    values = search.values(found.places)
    computed, sentences = curves.curve_with_warnings(values, points.creepage)
    if not np.all(np.isfinite(computed)):
        raise FitFailed(f"The curve of the fitted values cannot be recomputed: {curves.trouble}")
    residuals = points.residuals(computed)
    certainty = certainty_of(fields, found.places, found.jacobian * points.weight[:, None], residuals, confidence)
    own = [*certainty.sentences, *unlikely_forces(points, response, curves.problem(values))]
    if not found.converged:
        own.insert(0, f"The search did not converge: {found.reason}.")
    if found.trouble:
        own.append(f"Some curves could not be computed, and the search avoided them: {found.trouble}.")
    return Fit(
        parameters=tuple(_parameter(index, fields, found, certainty) for index in range(len(fields))),
        correlation=certainty.correlation(), creepage=points.creepage, measured=points.value, computed=computed,
        residuals=points.value - computed, rms=float(np.sqrt(np.mean(residuals**2)) / _usual_weight(points)), confidence=confidence,
        converged=found.converged, reason=found.reason, evaluations=found.evaluations, solves=curves.solves,
        params=_final(curves.problem(values)), quantity="coefficient" if response.is_coefficient else "force", by=response.by,
        curve=None if asked is None else _curve(asked, found, search, curves, certainty), warnings=(*own, *sentences),
    )  # fmt: skip


def _usual_weight(points: MeasuredCurve) -> float:
    """Returns the weight that makes weighted residuals as large as the values of the curve."""
    return float(np.sqrt(np.mean(points.weight**2)))


def _final(params: dict[str, Any]) -> dict[str, Any]:
    params.pop("fields", None)
    return params


def _parameter(index: int, fields: list[VariedParameter], found: Found, certainty: Certainty) -> FittedParameter:
    one, place = fields[index], float(found.places[index])
    at_bound = certainty.at_bound[index]
    made = FittedParameter(
        path=one.path, value=one.value(place), start=one.value(float(found.start[index])), low=one.low, high=one.high,
        is_logarithmic=one.is_logarithmic, at_bound=at_bound,
    )  # fmt: skip
    if not certainty.is_known[index] or certainty.quantile is None:
        return made
    error = float(np.sqrt(certainty.covariance[index, index]))
    reach = certainty.quantile * error
    known = {"standard_error": error * one.slope(place), "interval": (one.value(place - reach), one.value(place + reach))}
    return FittedParameter(**{**vars(made), **known})


def _curve(creepage: Array, found: Found, search: Search, curves: CreepCurves, certainty: Certainty) -> FittedCurve:
    value = curves.curves([search.values(found.places)], creepage)[0]
    half = certainty.band(search.jacobian(found.places, creepage))
    return FittedCurve(creepage, value, value - half, value + half)
