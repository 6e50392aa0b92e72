"""Keywords that calls take and hand on, for type checkers and editors: ``**fields: Unpack[ProblemFields]``.

They are those of the dataclasses and calls whose names they have, all of which say what they mean.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TypedDict

import numpy.typing as npt

from .values.friction import Friction
from .values.gaps import Paraboloid, SemiAxes
from .values.grid import Grid
from .values.ics import Ics
from .values.materials import LayeredBody, Material, RigidBody
from .values.problem import ContactColumns, Estimate, Model, SolverSettings
from .values.profiles import Profile
from .values.solution import ContactSolution
from .values.table_ics import TableIcs
from .values.wheel_rail.setup import (
    Conformal,
    PatchRules,
    RigidSlipKind,
    Side,
    Track,
    WheelRailFriction,
    Wheelset,
    WheelSurface,
)

__all__ = ["ClientOptions", "ProblemFields", "WheelRailFields"]


class ClientOptions(TypedDict, total=False):
    """Of Client, beside the endpoint."""

    timeout: float | None
    build_timeout: float | None
    connect_timeout: float | None
    server_key: str | Path | None
    own_key: str | Path | None
    spin: float


class ProblemFields(TypedDict, total=False):
    """Of ContactProblem. Which of them must be there is told when it is made."""

    grid: Grid
    upper: Material | RigidBody | LayeredBody | None
    gap: Paraboloid | SemiAxes | npt.ArrayLike
    approach: float | None
    lower: Material | RigidBody | LayeredBody | None
    ics: Ics | TableIcs
    friction: Friction | None
    normal: SolverSettings | None
    tangential: SolverSettings | None
    initial: Estimate | ContactSolution | None
    Fn: float | None
    model: Model | None
    previous: Estimate | ContactSolution | None
    outer: SolverSettings | None
    upper_ics: Ics | TableIcs | None
    lower_ics: Ics | TableIcs | None
    derivatives: bool
    columns: ContactColumns | None


class WheelRailFields(TypedDict, total=False):
    """Of WheelRailSetup."""

    side: Side | None
    wheel: Profile | None
    rail: Profile | None
    rail_slices: Sequence[tuple[float, Profile]] | None
    wheel_slices: Sequence[tuple[float, Profile]] | None
    track: Track | None
    wheelset: Wheelset | None
    upper: Material | RigidBody | None
    lower: Material | RigidBody | None
    model: Model | None
    friction: WheelRailFriction | None
    dx: float | None
    dy: float | None
    dq: float | None
    patches: PatchRules | None
    wheel_surface: WheelSurface | None
    rigid_slip: RigidSlipKind | None
    conformal: Conformal | None
    normal: SolverSettings | None
    tangential: SolverSettings | None
    outer: SolverSettings | None
    force: SolverSettings | None
