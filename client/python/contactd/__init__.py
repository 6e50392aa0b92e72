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

Units are N and mm, or any consistent system. contactd.errors draws the tree of exceptions.
"""

from typing import TYPE_CHECKING, Any

from ._version import __version__
from .client import Client
from .daemon import LocalDaemon
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
from .exchange import load_table, save_table
from .friction import Friction, KineticFriction, Rolling, Shift
from .gaps import Paraboloid, SemiAxes
from .grid import Grid
from .ics import AnalyticIcs, FemIcs, LineContact
from .local import local
from .materials import Layer, LayeredBody, Material, RigidBody
from .partial import PartialSolution
from .plain_values import from_dict, to_dict
from .problem import ContactColumns, ContactProblem, Estimate, SolverSettings
from .recent import RecentPatch, RecentSolve
from .saving import load, save
from .session import SavedState, Session, SessionSummary
from .solution import (
    ContactSolution,
    IcEvidence,
    IcTable,
    ImportedIc,
    Job,
    Limits,
    Progress,
    QuarantinedIc,
    SectionEvidence,
    ServerInfo,
    SolverEvidence,
    StoredIc,
)
from .steps import StepInput, StepSolution
from .subsurface import LargestStress, StressBlock, SubsurfaceStress
from .table_ics import TableIcs, combined_modulus
from .warned import ContactWarning
from .wheel_rail_session import WheelRailSession
from .wheel_rail_steps import WheelRailStepInput, WheelRailStepSolution

if TYPE_CHECKING:
    from .aio import AsyncClient, AsyncSession, AsyncWheelRailSession

__all__ = [
    "Aborted",
    "AnalyticIcs",
    "AsyncClient",
    "AsyncSession",
    "AsyncWheelRailSession",
    "Cancelled",
    "Client",
    "ConnectionFailed",
    "ContactColumns",
    "ContactProblem",
    "ContactSolution",
    "ContactWarning",
    "ContactdError",
    "DaemonFailed",
    "DeadlineExceeded",
    "Estimate",
    "FailedPrecondition",
    "FemIcs",
    "Friction",
    "Grid",
    "IcEvidence",
    "IcTable",
    "ImportedIc",
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
    "NotFound",
    "Paraboloid",
    "PartialSolution",
    "PermissionDenied",
    "Progress",
    "ProtocolError",
    "QuarantinedIc",
    "RecentPatch",
    "RecentSolve",
    "ResourceExhausted",
    "RigidBody",
    "Rolling",
    "SavedFileError",
    "SavedState",
    "SectionEvidence",
    "SemiAxes",
    "ServerInfo",
    "Session",
    "SessionSummary",
    "Shift",
    "SolverEvidence",
    "SolverSettings",
    "StatusError",
    "StepInput",
    "StepSolution",
    "StoredIc",
    "StressBlock",
    "SubsurfaceStress",
    "TableFileError",
    "TableIcs",
    "TimeoutExpired",
    "Unauthenticated",
    "Unavailable",
    "Unimplemented",
    "Violation",
    "WheelRailSession",
    "WheelRailStepInput",
    "WheelRailStepSolution",
    "__version__",
    "combined_modulus",
    "from_dict",
    "load",
    "load_table",
    "local",
    "save",
    "save_table",
    "to_dict",
]


def __getattr__(name: str) -> Any:
    """What takes asyncio along is imported when it is first wanted."""
    if name in ("AsyncClient", "AsyncSession", "AsyncWheelRailSession"):
        from . import aio

        return getattr(aio, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
