"""Implements construction of contact problems; `problem` declares the fields."""

from __future__ import annotations

import reprlib
from collections.abc import Mapping
from typing import Any

from ..refusals import check_either
from .generated.ics import AnalyticIcs
from .params import check_fields

__all__ = ["CLOSED_FORMS", "REQUIRED", "ProblemMethods", "check_field_types"]

CLOSED_FORMS = AnalyticIcs()
REQUIRED: Any = object()  #: Follows the optional `upper`, but is required.


class ProblemMethods:
    """Methods of a ContactProblem."""

    def __post_init__(self: Any) -> None:
        if self.gap is REQUIRED:
            raise TypeError("ContactProblem() lacks gap")
        check_either("ContactProblem", "approach or Fn", approach=self.approach, Fn=self.Fn)
        check_field_types(type(self), vars(self))


def check_field_types(kind: type, fields: Mapping[str, Any]) -> None:
    """Raises TypeError if a field of a problem has a wrong type, is required and missing, or has an unknown name. Any
    value with tractions may replace tractions.
    """
    tractions = {name: fields[name] for name in ("initial", "previous") if fields.get(name) is not None}
    check_fields(kind, {name: value for name, value in fields.items() if name not in tractions})
    for name, value in tractions.items():
        if not hasattr(type(value), "pressure") and not hasattr(value, "pressure"):
            raise TypeError(f"{name} is {reprlib.repr(value)}; it must be a solution or an Estimate")
