"""Describes profiles of wheels and rails, and their form on the wire."""

from __future__ import annotations

from typing import Any, get_args

from ..refusals import check_type
from .generated.profile_shapes import Profile
from .params import params_of

__all__ = ["profile_params"]


def profile_params(profile: Profile, field: str) -> dict[str, Any]:
    """Returns a profile as on the wire; `field` is its path."""
    check_type(field, profile, *get_args(Profile))
    params: dict[str, Any] = params_of(profile, field)
    return params
