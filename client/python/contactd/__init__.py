"""Client of contactd: elastic contact with computed influence coefficients, as a service.

::

    from contactd import Client, Friction, Grid, Material, Paraboloid

    with Client("tcp://127.0.0.1:5555", timeout=60) as client:
        solution = client.solve(
            grid=Grid.centred(40, 40, 2.4, 2.4),
            upper=Material(G=200, nu=0.42),
            gap=Paraboloid(Rx=50, Ry=50),
            approach=0.02,
            friction=Friction(mu=0.4, rigid_shift=(0.00817, 0)),
        )
        print(solution.Fn, solution.Fx, solution.elements)

Units are N and mm, or any consistent system. contactd.errors shows the hierarchy of exceptions.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any
from warnings import warn

from ._version import __version__
from .callable_wheel_rail import WheelRailModule
from .calls.answer_warnings import ContactWarning
from .calls.contact_session import Session
from .calls.wheel_rail_session import WheelRailSession
from .client import Client
from .creep_tables import CreepForces, CreepTable
from .direct import creep_curve, solve
from .errors import (
    Aborted,
    Cancelled,
    ConnectionFailed,
    ContactdError,
    DaemonFailed,
    DeadlineExceeded,
    FailedPrecondition,
    InternalError,
    InvalidArgument,
    MissingExtra,
    NotFound,
    PermissionDenied,
    ProtocolError,
    ResourceExhausted,
    SavedFileError,
    StatusError,
    TableFileError,
    TimeoutExpired,
    Unauthenticated,
    Unavailable,
    Unimplemented,
    Violation,
)
from .extras import FUNCTIONS
from .files.saved import load, save
from .files.table_files import load_table, save_table
from .fits.fit import fit
from .fits.search import FitFailed
from .local import LocalDaemon, default_client, local
from .materials import steel
from .operators import operator
from .values.creep_curves import CreepCurve
from .values.dictionaries import from_dict, to_dict
from .values.fit import Fit, FittedCurve, FittedParameter
from .values.generated.evidence import (
    IcEvidence,
    SectionEvidence,
    SimplifiedSettings,
    SlopeReduction,
    SolverEvidence,
    SolverSettings,
    TangentialSettings,
)
from .values.generated.fatigue import DamageFunction, FatigueRequest, FatigueStrength, Passage
from .values.generated.fem_ics import FemIcs
from .values.generated.friction import Friction, InterfacialLayer
from .values.generated.grid import Grid, HalfEllipses, Paraboloid, SemiAxes
from .values.generated.ics import AnalyticIcs, LineContact
from .values.generated.materials import Layer, LayeredBody, Material, RigidBody, ViscoelasticBody
from .values.generated.motion import FrictionMemory, KineticFriction, Rolling, SecondTerm, Shift, TemperatureFriction
from .values.generated.problem import ContactColumns, ContactProblem, Estimate
from .values.generated.profile_shapes import ProfileFile
from .values.generated.records import ImportedIc, QuarantinedIc, RecentPatch, RecentSolve, StoredIc
from .values.generated.regions import ContactRegions, RegionLimits
from .values.generated.result import ContactFatigue, ContactTemperature, ContactWear, RollingResistance
from .values.generated.service import Job, Limits, Progress, ServerInfo, SessionSummary
from .values.generated.step_input import StepInput
from .values.generated.subsurface import LargestStress, StressBlock, SubsurfaceStress
from .values.generated.temperature import SurfaceTemperatures
from .values.generated.thermal import ThermalBodies, ThermalBody
from .values.generated.wear_laws import (
    ArchardWear,
    BrWear,
    EnergyWear,
    SeizureWear,
    SevereWear,
    UsfdWear,
    WearLaw,
    WearRequest,
    ZoboryWear,
)
from .values.generated.wheel_rail.step_input import WheelRailStepInput
from .values.registry import register
from .values.solution import ContactSolution
from .values.step_solution import SavedState, StepSolution
from .values.tables import IcTable, TableIcs, combined_modulus
from .values.wheel_rail.comparison import ComparedModel, ModelComparison, ModelErrors
from .values.wheel_rail.passage_wear import PassageWear
from .values.wheel_rail.solution import WheelRailStepSolution

if TYPE_CHECKING:
    from .aio import AsyncClient, AsyncSession, AsyncWheelRailSession

__all__ = [
    "Aborted",
    "AnalyticIcs",
    "ArchardWear",
    "AsyncClient",
    "AsyncSession",
    "AsyncWheelRailSession",
    "BrWear",
    "Cancelled",
    "Client",
    "ComparedModel",
    "ConnectionFailed",
    "ContactColumns",
    "ContactFatigue",
    "ContactProblem",
    "ContactRegions",
    "ContactSolution",
    "ContactTemperature",
    "ContactWarning",
    "ContactWear",
    "ContactdError",
    "CreepCurve",
    "CreepForces",
    "CreepTable",
    "DaemonFailed",
    "DamageFunction",
    "DeadlineExceeded",
    "EnergyWear",
    "Estimate",
    "FailedPrecondition",
    "FatigueRequest",
    "FatigueStrength",
    "FemIcs",
    "Fit",
    "FitFailed",
    "FittedCurve",
    "FittedParameter",
    "Friction",
    "FrictionMemory",
    "Grid",
    "HalfEllipses",
    "IcEvidence",
    "IcTable",
    "ImportedIc",
    "InterfacialLayer",
    "InternalError",
    "InvalidArgument",
    "Job",
    "KineticFriction",
    "LargestStress",
    "Layer",
    "LayeredBody",
    "Limits",
    "LineContact",
    "LocalDaemon",
    "Material",
    "MissingExtra",
    "ModelComparison",
    "ModelErrors",
    "NotFound",
    "Paraboloid",
    "Passage",
    "PassageWear",
    "PermissionDenied",
    "ProfileFile",
    "Progress",
    "ProtocolError",
    "QuarantinedIc",
    "RecentPatch",
    "RecentSolve",
    "RegionLimits",
    "ResourceExhausted",
    "RigidBody",
    "Rolling",
    "RollingResistance",
    "SavedFileError",
    "SavedState",
    "SecondTerm",
    "SectionEvidence",
    "SeizureWear",
    "SemiAxes",
    "ServerInfo",
    "Session",
    "SessionSummary",
    "SevereWear",
    "Shift",
    "SimplifiedSettings",
    "SlopeReduction",
    "SolverEvidence",
    "SolverSettings",
    "StatusError",
    "StepInput",
    "StepSolution",
    "StoredIc",
    "StressBlock",
    "SubsurfaceStress",
    "SurfaceTemperatures",
    "TableFileError",
    "TableIcs",
    "TangentialSettings",
    "TemperatureFriction",
    "ThermalBodies",
    "ThermalBody",
    "TimeoutExpired",
    "Unauthenticated",
    "Unavailable",
    "Unimplemented",
    "UsfdWear",
    "Violation",
    "ViscoelasticBody",
    "WearLaw",
    "WearRequest",
    "WheelRailSession",
    "WheelRailStepInput",
    "WheelRailStepSolution",
    "ZoboryWear",
    "__version__",
    "combined_modulus",
    "creep_curve",
    "default_client",
    "fit",
    "from_dict",
    "load",
    "load_table",
    "local",
    "operator",
    "save",
    "save_table",
    "solve",
    "steel",
    "to_dict",
]

register(FUNCTIONS)

from . import wheel_rail as _wheel_rail_module  # noqa: E402

#: The module of wheels on rails can also be called as a function.
wheel_rail: WheelRailModule = _wheel_rail_module  # type: ignore[assignment]


def __getattr__(name: str) -> Any:
    """Imports the names that need asyncio, and files of CONTACT, on first use; warns of names that have changed."""
    if name in ("AsyncClient", "AsyncSession", "AsyncWheelRailSession"):
        from . import aio

        return getattr(aio, name)
    if name == "contact_files":
        return import_module(f"{__name__}.{name}")
    if name == "PartialSolution":
        warn("PartialSolution is an alias of ContactSolution; use ContactSolution.", DeprecationWarning, stacklevel=2)
        return ContactSolution
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
