"""The models of a case according to its digits B and M."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from ...values.generated.evidence import Model, NormalModel, SimplifiedSettings, SlopeReduction, TractionBound

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case
    from ...values.generated.motion import KineticFriction

__all__ = ["is_parabolic", "models_of", "without_memory"]

_PARABOLIC = 3
_NORMAL: dict[int, NormalModel] = {4: "elliptic", 5: "kpec", 6: "analyn"}
_PRESCRIBED: dict[int, NormalModel] = {2: "elliptic", 3: "parabolic"}  #: Full theory; bounds simplified models, too.
_TANGENTIAL: dict[int, Model] = {3: "fastsim", 5: "fastrip"}


def is_parabolic(case: Case) -> bool:
    """Returns whether tractions are bounded by a paraboloid, whose values the program prints as pressures."""
    return case.digits["B"] == _PARABOLIC


def models_of(case: Case) -> dict[str, Any]:
    """Returns the fields of a problem, or of a set-up on rails, that differ from the full theory.

    The program integrates FASTSIM in whole elements, blends its flexibilities, and reads creepage coefficients from the
    printed table.
    """
    found: dict[str, Any] = {}
    if case.digits["B"] in _NORMAL:
        found["normal_model"] = _NORMAL[case.digits["B"]]
    model = _TANGENTIAL.get(case.digits["M"])
    if model is None and case.digits["B"] in _PRESCRIBED:
        found["normal_model"] = _PRESCRIBED[case.digits["B"]]
    if model is None or case.digits["T"] == 0:
        return found
    found["model"] = model
    k0, alpha, beta = (case.values[name] for name in ("K0", "ALFA", "BETA"))
    slope = SlopeReduction(k0, alpha, beta) if (k0, alpha) != (1, 1) else None
    is_fastsim = model == "fastsim"
    bound: TractionBound | None = "elliptic" if is_fastsim and not is_parabolic(case) and "normal_model" not in found else None
    found["simplified"] = SimplifiedSettings(
        slope=slope, bound=bound, on_elements=True if is_fastsim else None, blended=True, coefficients="printed"
    )
    return found


def without_memory(case: Case, kinetic: KineticFriction | None) -> KineticFriction | None:
    """The fall of friction; that of simplified models, which have one coefficient for all of a contact, has no memory."""
    if kinetic is None or case.digits["M"] not in _TANGENTIAL:
        return kinetic
    return replace(kinetic, memory=None)
