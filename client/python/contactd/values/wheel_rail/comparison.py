"""Compares one case with several contact models, and their errors against the full theory."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from ..generated.evidence import Model, NormalModel
from ..generated.wheel_rail.result import WheelRailPatch, WheelRailSolution
from ..registry import extra
from ..representation import Rows, Shown
from ..solution import ContactSolution

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["FULL", "ComparedModel", "ModelComparison", "ModelErrors", "combinations", "errors_of", "model_names"]

FULL = "full"  #: The reference model.
_NO_PRESSURES_OF_OTHERS = ("hertz",)  #: These have their own pressures and cannot be combined with a normal_model.
_OF_MODEL = "of_model"
_PRESCRIBED = ("elliptic", "parabolic")  #: Prescribed pressures, which no model computes.


def combinations() -> dict[str, tuple[str, str]]:
    """Returns model and normal_model of each combination by its name: ``fastsim``, ``kpec+fastsim``."""
    found = {model: (model, _OF_MODEL) for model in get_args(Model)}
    for normal in get_args(NormalModel):
        if normal not in (_OF_MODEL, *_PRESCRIBED):
            models = [model for model in get_args(Model) if model not in _NO_PRESSURES_OF_OTHERS]
            found.update({f"{normal}+{model}": (model, normal) for model in models})
    return found


def model_names(models: Iterable[str] | None, has_friction: bool) -> list[str]:
    """Returns the full theory, then those of `models` (None: all). Without friction, models that only differ in
    tractions are omitted from all. Raises ValueError for an unknown name.
    """
    known = combinations()
    if models is None:
        chosen = [
            name for name, (model, _) in known.items() if has_friction or model in (FULL, *_NO_PRESSURES_OF_OTHERS)
        ]
    else:
        chosen = [models] if isinstance(models, str) else list(models)
    if unknown := [name for name in chosen if name not in known]:
        raise ValueError(f"models has {unknown[0]!r}; it must contain names from {', '.join(known)}")
    return list(dict.fromkeys([FULL, *chosen]))


@dataclass(frozen=True)
class ModelErrors:
    """Errors of a model against the full theory.

    Attributes:
        Fn: Relative error of the normal force; for a wheel, of the vertical force.
        Fx: Error of the longitudinal force over mu Fn; None without friction.
        Fy: Error of the lateral force over mu Fn.
        Mz: Error of the spin moment over mu Fn sqrt(A/pi), with A the contact area; None for wheels.
        pmax: Relative error of the largest pressure.
        area: Relative error of the contact area.
        patch: Area where only one of both has contact, over the contact area; None for wheels.
        approach: Relative error of the approach; for a wheel, the error of its height (mm).
        creepage: Relative error of the creepages for prescribed forces; None if the motion is prescribed.
    """

    Fn: float
    Fx: float | None
    Fy: float | None
    Mz: float | None
    pmax: float
    area: float
    patch: float | None
    approach: float
    creepage: float | None = None

    @property
    def force(self) -> float | None:
        """Size of the error of the tangential force over mu Fn; None without friction."""
        return None if self.Fx is None or self.Fy is None else float(np.hypot(self.Fx, self.Fy))


@dataclass(frozen=True, eq=False)
class ComparedModel:
    """The results of one model.

    Attributes:
        name: Name such as ``fastsim``, or ``kpec+fastsim`` for pressures by the first and tractions by the second.
        model: Its model.
        normal_model: Its model of pressures; "of_model" if the model determines it.
        solution: Its solution; check `converged`. None if the model does not support the case.
        refusal: Reason why it does not support the case; otherwise empty.
        seconds: Duration of a request without arrays (s), the shortest of several.
        left_out: Options of `simplified` in the case that this model does not have.
        errors: Errors against the full theory, if both have a solution and that of the full theory converged.
    """

    name: str
    model: str
    normal_model: str
    solution: ContactSolution | WheelRailSolution | None = None
    refusal: str = ""
    seconds: float | None = None
    left_out: tuple[str, ...] = ()
    errors: ModelErrors | None = None


@dataclass(frozen=True, eq=False, repr=False)
class ModelComparison(Shown):
    """One case with several models, also available as `comparison["fastsim"]`.

    Attributes:
        models: All models, the full theory first; unsupported ones contain the reason.
        request_seconds: Duration of a request without computation (s), which is part of all others.
    """

    models: tuple[ComparedModel, ...]
    request_seconds: float

    def __getitem__(self, name: str) -> ComparedModel:
        for one in self.models:
            if one.name == name:
                return one
        raise KeyError(name)

    @property
    def computed(self) -> tuple[ComparedModel, ...]:
        """The models with a solution."""
        return tuple(one for one in self.models if one.solution is not None)

    @property
    def refused(self) -> tuple[ComparedModel, ...]:
        """The models without a solution."""
        return tuple(one for one in self.models if one.solution is None)

    def plot(self) -> Figure:
        """Plots pressures, forces, computing times and errors of all models. Needs matplotlib
        ("contactd[pictures]").
        """
        drawn: Figure = extra("ModelComparison.plot")(self)
        return drawn

    def _rows(self) -> Rows:
        return [(one.name, one.refusal or _summary(one)) for one in self.models]


def _summary(one: ComparedModel) -> str:
    error = ""
    if one.errors is not None and one.name != FULL:
        what, value = ("pmax", one.errors.pmax) if one.errors.force is None else ("force", one.errors.force)
        error = f"{what} off by {100 * abs(value):.2g} %, "
    return f"{error}{1e3 * (one.seconds or 0):.3g} ms"


def errors_of(found: Any, full: Any, mu: float | None) -> ModelErrors:
    """Returns the errors of one solution against another, both of a contact or both of a wheel; `mu` is the largest
    friction coefficient, or None.
    """
    if isinstance(full, WheelRailSolution):
        return _errors_of_wheel(found, full, mu)
    bound = None if not mu else mu * full.forces.Fn
    arm = float(np.sqrt(full.area.contact / np.pi))

    def off(name: str, scale: float | None) -> float | None:
        return None if not scale else (getattr(found.forces, name) - getattr(full.forces, name)) / scale

    return ModelErrors(
        Fn=_relative(found.forces.Fn, full.forces.Fn), Fx=off("Fx", bound), Fy=off("Fy", bound), Mz=off("Mz", bound and bound * arm),
        pmax=_relative(found.pmax, full.pmax), area=_relative(found.area.contact, full.area.contact), patch=_patch_error(found, full),
        approach=_relative(found.approach, full.approach), creepage=_creepage_error(found.motion, full.motion),
    )  # fmt: skip


def _relative(value: float, right: float) -> float:
    return value / right - 1 if right else (0.0 if not value else float("inf"))


def _patch_error(found: Any, full: Any) -> float | None:
    if not hasattr(found, "pressure") or not hasattr(full, "pressure") or not full.elements.contact:
        return None
    return float(np.count_nonzero((found.pressure > 0) != (full.pressure > 0)) / np.count_nonzero(full.pressure > 0))


def _creepage_error(found: Any, full: Any) -> float | None:
    force = getattr(full, "force", None)
    if force is None or not hasattr(full, "xi") or all(part is None for part in force):
        return None
    size = float(np.hypot(full.xi, full.eta))
    return float(np.hypot(found.xi - full.xi, found.eta - full.eta)) / size if size else None


def _errors_of_wheel(found: WheelRailSolution, full: WheelRailSolution, mu: float | None) -> ModelErrors:
    right, forces = full.forces.track, found.forces.track
    normal = sum(patch.solution.forces.Fn for patch in full.patches)
    bound = None if not mu or not normal else mu * normal

    def largest(patches: Iterable[WheelRailPatch]) -> float:
        return max((patch.solution.pmax for patch in patches), default=0.0)

    def area(patches: Iterable[WheelRailPatch]) -> float:
        return sum(patch.solution.area.contact for patch in patches)

    return ModelErrors(
        Fn=_relative(forces.Fz, right.Fz),
        Fx=None if bound is None else (forces.Fx - right.Fx) / bound,
        Fy=None if bound is None else (forces.Fy - right.Fy) / bound,
        Mz=None, pmax=_relative(largest(found.patches), largest(full.patches)), area=_relative(area(found.patches), area(full.patches)),
        patch=None, approach=found.z - full.z,
    )  # fmt: skip
