"""Accepts laws of wear as objects with their source, in place of a WearRequest."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..refusals import check_type
from .generated.wear_laws import ArchardWear, BrWear, EnergyWear, UsfdWear, WearLaw, WearRequest, ZoboryWear

__all__ = ["StatedLaw", "wear_request"]

StatedLaw = WearLaw | ArchardWear | EnergyWear | UsfdWear | BrWear | ZoboryWear
_KINDS: dict[type, str] = {ArchardWear: "archard", EnergyWear: "energy", UsfdWear: "usfd", BrWear: "br", ZoboryWear: "zobory"}
_BODIES = {"wheel": "lower", "rail": "upper"}
_WHOLE_RANGE = (0.0, 1e12)  #: Limit of the schema.


def wear_request(wear: WearRequest | StatedLaw | Iterable[StatedLaw]) -> WearRequest:
    """Returns a request from one or several laws. Raises TypeError for a law without a source."""
    if isinstance(wear, WearRequest):
        return wear
    listed: list[Any] = [wear] if isinstance(wear, (WearLaw, *_KINDS)) else list(wear)  # type: ignore[arg-type]
    return WearRequest(tuple(_law_of(one) for one in listed))


def _law_of(kind: Any) -> WearLaw:
    if isinstance(kind, WearLaw):
        return kind
    check_type("wear", kind, WearLaw, *_KINDS)
    name, key = type(kind).__name__, _KINDS[type(kind)]
    if kind.source is None:
        raise TypeError(f'{name} has no source: give the source of its coefficients, as in {name}(..., source="our twin-disc test").')
    body = kind.body or "wheel"
    if body not in _BODIES:
        raise TypeError(f'{name}.body is {kind.body!r}; it must be "wheel" or "rail".')
    stated: dict[str, Any] = {"name": kind.name or key, "source": kind.source, "body": _BODIES[body], key: kind}
    return WearLaw(range=_WHOLE_RANGE if kind.range is None else kind.range, **stated)
