"""Converts a case of basic contact (module 3) to a problem of contactd, by the conventions of the CONTACT program."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ...values.generated.evidence import SolverSettings
from ...values.generated.friction import Friction
from ...values.generated.grid import Grid
from ...values.generated.ics import AnalyticIcs
from ...values.generated.motion import Rolling
from ...values.generated.problem import ContactProblem, Estimate
from ...values.tables import TableIcs
from .areas import PotentialContact, potential_contact
from .bodies import Pair, bodies_of, pair_of, sheet_of
from .distances import regions_of
from .features import Missing, missing, prescribes_pressures
from .frictions import coefficients, layer, shares, static
from .heat import temperature_friction, thermal_bodies
from .models import models_of, without_memory
from .solvers import solver_settings

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["BasicContact", "ReadCoefficients", "State", "goes_on"]

NormalForce = Callable[[ContactProblem], float]
#: Reads the table named in a case, with the combined modulus of its bodies (N/mm^2), by which the file's values are
#: divided.
ReadCoefficients = Callable[["Case", float], TableIcs]

_BILINEAR, _OF_FILE = 3, 9  #: C
_NONE, _SHIFT, _TRANSIENT, _STEADY = range(4)
_NEAR = 0.01  #: Largest angle (rad) of a rolling direction along an axis.


@dataclass(frozen=True, eq=False)
class State:
    """The end of a step, from which the next one may start."""

    grid: Grid
    pressure: npt.NDArray[np.float64]
    traction_x: npt.NDArray[np.float64]
    traction_y: npt.NDArray[np.float64]
    yield_stress: npt.NDArray[np.float64] | None = None
    friction_coefficient: npt.NDArray[np.float64] | None = None
    plastic: tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]] | None = None


@dataclass(frozen=True, eq=False)
class BasicContact:
    """A prepared case.

    Attributes:
        case: The case as read.
        area: Its elements.
        pair: Its bodies.
        friction_unit: Unit of tangential forces: the static coefficient (1 if rows have their own).
        chi: The rolling direction (rad).
        dq: The step as printed by the program (mm).
        ics: Its coefficients.
        problem: The problem for contactd.
        plastic: Plastic slip of a layer at the start of the step (mm); None if there is none.
    """

    case: Case
    area: PotentialContact
    pair: Pair
    friction_unit: float
    chi: float
    dq: float
    ics: AnalyticIcs | TableIcs
    problem: ContactProblem
    plastic: tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]] | None = None

    @property
    def phi(self) -> float:
        """The spin of the whole plane (rad, rad/mm); 0 if it acts in one direction only, which is slip of the
        elements.
        """
        is_split = self.case.digits["E"] != 0 and self.case.values.get("EXRHS") in (2, 3)
        return 0.0 if is_split else float(self.case.values["CPHI"])

    @classmethod
    def of(
        cls, case: Case, normal_force: NormalForce, before: State | None = None, coefficients: ReadCoefficients | None = None
    ) -> BasicContact:
        """`normal_force` solves a problem without friction, `before` is the initial state of a step that continues
        another one, and `coefficients` reads those of a file.

        Raises Missing for unsupported features.
        """
        if names := missing(case):
            raise Missing(", ".join(names))
        values = case.values
        area = potential_contact(values, None if before is None else before.grid)
        pair = pair_of(values)
        if prescribes_pressures(case) and not pair.is_quasi_identical:
            raise Missing("prescribed pressures of dissimilar bodies (B = 2, 3, 4)")
        load = {"Fn": values["FN"]} if case.digits["N"] == 1 else {"approach": values["PEN"]}
        ics = _ics(case, area.grid, pair, coefficients)
        upper, lower = (None, None) if isinstance(ics, TableIcs) else bodies_of(case, pair)
        problem = ContactProblem(
            grid=area.grid, upper=upper, lower=lower, gap=area.gap, ics=ics, **load,
            **_settings(values, pair), **models_of(case), sheet_flexibility=sheet_of(case),
            regions=regions_of(values),
        )  # fmt: skip
        unit = 1.0 if values["VARFRC"] == 3 else static(values["FRCLAW"], case.friction[0])
        chi, dq = _rolling_step(case, area.grid)
        if case.digits["T"] != _NONE:
            force = shares(values, case.digits["F"], unit * _normal_force(problem, case, pair, normal_force))
            # ConvexGS prints the step as given; its steady rolling also uses one element.
            step = area.grid.dx if case.digits["T"] == _STEADY else dq
            friction = _friction(case, area.grid, chi, step, force)
            previous = None if before is None else _moved(before, area.grid, friction)
            problem = problem.replace(friction=friction, previous=previous, temperature=thermal_bodies(case))
        plastic = None if before is None else _moved_plastic(before, area.grid)
        return cls(case, area, pair, unit, chi, dq, ics, problem, plastic)


def _ics(case: Case, grid: Grid, pair: Pair, coefficients: ReadCoefficients | None) -> AnalyticIcs | TableIcs:
    kind = case.values["INFLCF"]
    if kind != _OF_FILE:
        return AnalyticIcs(load_shape="bilinear") if kind == _BILINEAR else AnalyticIcs()
    if coefficients is None:
        raise Missing("influence coefficients from a file (C = 9) in this call")
    table = coefficients(case, pair.G)
    beyond = [max(0, there - here) for here, there in zip(table.shape, grid.shape)]
    # The program treats offsets beyond those of the file as zero.
    return TableIcs(np.pad(table.array, [(0, 0), (0, 0), *((0, more) for more in beyond)]), table.dx, table.dy, table.G)


def goes_on(case: Case) -> bool:
    """Returns whether a case starts from the end of an earlier one. A case without digits, which could not be read,
    does not.
    """
    return case.digits.get("P") != 2 and case.digits.get("T") in (_SHIFT, _TRANSIENT)


def _rolling_step(case: Case, grid: Grid) -> tuple[float, float]:
    """Returns CHI and DQ as printed by the program: steady rolling is along x by elements, unless ConvexGS solves
    it.
    """
    values = case.values
    chi, dq = values["CHI"], values["DQ"]
    is_along_x = (case.digits["T"] == _STEADY and values["GAUSEI"] != 2) or case.digits["M"] in (3, 5)
    if not is_along_x or case.digits["T"] not in (_TRANSIENT, _STEADY):
        return chi, dq
    goes_back = abs(abs(math.remainder(chi, 2 * math.pi)) - math.pi) < _NEAR
    return (math.pi if goes_back else 0.0), grid.dx


def _settings(values: Any, pair: Pair) -> dict[str, Any]:
    settings = solver_settings(values)
    if not pair.is_quasi_identical and values["MAXOUT"] == 1:
        settings["outer"] = SolverSettings(max_iterations=1)
    return settings


def _normal_force(problem: ContactProblem, case: Case, pair: Pair, normal_force: NormalForce) -> float:
    """Returns the force to which shares of tangential forces refer."""
    if case.digits["F"] == 0:
        return 0.0
    if problem.Fn is not None:
        return problem.Fn
    if not pair.is_quasi_identical:
        raise Missing("shares of a normal force that is not known before the solve (N = 0, F > 0, dissimilar bodies)")
    return normal_force(problem)


def _friction(case: Case, grid: Grid, chi: float, dq: float, force: Any) -> Friction:
    values, digits = case.values, case.digits
    mu, kinetic = coefficients(values, case.friction, grid)
    kinetic = without_memory(case, kinetic)
    phi, rolls = values["CPHI"], digits["T"] != _SHIFT
    xi = values.get("CKSI", 0.0) + phi * values["SPINYO"]
    eta = values.get("CETA", 0.0) - phi * values["SPINXO"]
    ahead = values["FACPHI"] * dq if rolls else 0.0
    extra = _extra_slip(values, digits["E"], grid, ahead * math.cos(chi), ahead * math.sin(chi))
    if extra is not None and values["EXRHS"] in (2, 3):
        phi, xi, eta = 0.0, values.get("CKSI", 0.0), values.get("CETA", 0.0)
    between = layer(case)
    if not rolls:
        return Friction(
            mu=mu, kinetic=kinetic, rigid_shift=(xi, eta), rotation=phi, force=force, rigid_slip=extra, layer=between
        )
    rolling = Rolling(
        xi=xi, eta=eta, phi=phi, chi=chi, dq=dq, spin_offset=values["FACPHI"], velocity=values["VELOC"], force=force,
        kind="steady" if digits["T"] == _STEADY else "transient",
    )  # fmt: skip
    by_temperature = temperature_friction(values, case.friction)
    return Friction(
        mu=mu, kinetic=kinetic, rolling=rolling, rigid_slip=extra, layer=between, temperature=by_temperature
    )


def _extra_slip(values: Any, digit: int, grid: Grid, ahead_x: float, ahead_y: float) -> tuple[Any, Any] | None:
    """Returns the slip of the elements in addition to that of the motion. Spin in one direction only is slip of the
    elements, too, evaluated `ahead` of their centres.
    """
    if digit == 0 or values.get("EXRHS", 0) == 0:  # A first case with E = 1 has none to keep.
        return None
    if values["EXRHS"] == 9:
        return np.reshape(values["SLIP_X"], grid.shape), np.reshape(values["SLIP_Y"], grid.shape)
    none, phi = np.zeros(grid.shape), values["CPHI"]
    if values["EXRHS"] == 2:
        return none - phi * (grid.y[:, None] + ahead_y - values["SPINYO"]), none
    return none, none + phi * (grid.x[None, :] + ahead_x - values["SPINXO"])


def _moved(before: State, grid: Grid, friction: Friction) -> Estimate:
    """Returns tractions and the state of friction on elements shifted by whole elements, whose number may differ."""
    stress, mu = before.yield_stress, before.friction_coefficient
    if grid == before.grid:
        return Estimate(before.pressure, before.traction_x, before.traction_y, stress, mu)

    def on_grid(array: npt.NDArray[np.float64], elsewhere: Any = 0.0) -> npt.NDArray[np.float64]:
        return _on_grid(array, before.grid, grid, elsewhere)

    return Estimate(
        on_grid(before.pressure), on_grid(before.traction_x), on_grid(before.traction_y),
        None if stress is None or friction.layer is None else on_grid(stress, friction.layer.yield_stress or 0.0),
        None if mu is None else on_grid(mu, friction.mu),
    )  # fmt: skip


def _moved_plastic(before: State, grid: Grid) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]] | None:
    if before.plastic is None:
        return None
    along_x, along_y = before.plastic
    return _on_grid(along_x, before.grid, grid), _on_grid(along_y, before.grid, grid)


def _on_grid(array: npt.NDArray[np.float64], before: Grid, grid: Grid, elsewhere: Any = 0.0) -> npt.NDArray[np.float64]:
    """Returns values on elements shifted by whole elements; new elements have `elsewhere`."""
    dx, dy = round((grid.x[0] - before.x[0]) / grid.dx), round((grid.y[0] - before.y[0]) / grid.dy)
    rows, columns = np.arange(grid.ny) + dy, np.arange(grid.nx) + dx
    has_rows, has_columns = (rows >= 0) & (rows < before.ny), (columns >= 0) & (columns < before.nx)
    placed: npt.NDArray[np.float64] = np.zeros(grid.shape) + elsewhere
    placed[np.ix_(has_rows, has_columns)] = array[np.ix_(rows[has_rows], columns[has_columns])]
    return placed
