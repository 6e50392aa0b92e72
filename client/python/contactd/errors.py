"""Defines the exceptions of this package.

::

    ContactdError +-- ConnectionFailed          no daemon at the endpoint, or the connection was lost (ConnectionError)
    +-- TimeoutExpired            no answer within the call's timeout (TimeoutError) |   +-- DeadlineExceeded      ...
    reported by the daemon; also a StatusError +-- ProtocolError an answer that breaks docs/protocol.md +-- DaemonFailed
    LocalDaemon: the daemon did not start or did not end normally +-- MissingExtra              an extra is not
    installed; the message names it                    (ImportError) +-- TableFileError            a file without a
    table of coefficients, or a damaged one          (ValueError) +-- SavedFileError            a file without a problem
    or solution, or a damaged one             (ValueError) +-- StatusError               the daemon refused the request;
    .code, .name, .reason, .message +-- Cancelled the job or the request was cancelled +-- UnknownError +--
    InvalidArgument .violations names the fields and the reasons                   (ValueError) +-- DeadlineExceeded +--
    NotFound no such job, session, saved state or table +-- AlreadyExists +-- PermissionDenied +-- ResourceExhausted the
    queue is full (.retry_delay, s), or too many sessions +-- FailedPrecondition    a step out of turn, or a table whose
    builds failed before +-- Aborted a step of a session did not converge +-- OutOfRange +-- Unimplemented no such
    method +-- InternalError a builder failed, or contactd has a defect +-- Unavailable           the daemon is ending
    +-- DataLoss +-- Unauthenticated       no connection without the right keys

Violations that this package finds before sending a request are InvalidArgument, too.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

__all__ = [
    "Aborted",
    "AlreadyExists",
    "Cancelled",
    "ConnectionFailed",
    "ContactdError",
    "DaemonFailed",
    "DataLoss",
    "DeadlineExceeded",
    "FailedPrecondition",
    "InternalError",
    "InvalidArgument",
    "MissingExtra",
    "NotFound",
    "OutOfRange",
    "PermissionDenied",
    "ProtocolError",
    "ResourceExhausted",
    "SavedFileError",
    "StatusError",
    "TableFileError",
    "TimeoutExpired",
    "Unauthenticated",
    "Unavailable",
    "Unimplemented",
    "UnknownError",
    "Violation",
    "invalid",
    "status_error",
]


class ContactdError(Exception):
    """Base class of every exception of this package."""

    is_defect = False  #: Errors of contactd or of a builder; tracebacks of other errors only show the caller's line.


class ConnectionFailed(ContactdError, ConnectionError):
    """No daemon listens at the endpoint, or the connection was lost before the answer."""


class TimeoutExpired(ContactdError, TimeoutError):
    """No answer within the timeout of the call. A build continues; repeat the call later to get its table from the
    cache.
    """


class ProtocolError(ContactdError):
    """The answer violates the protocol: other software, or another version, is listening at the endpoint."""


class DaemonFailed(ContactdError):
    """A daemon started by LocalDaemon did not become ready, or did not end normally."""


class MissingExtra(ContactdError, ImportError):
    """A package of one of contactd's extras is not installed. `extra` is the name of the extra.

    Attributes:
        extra: Name of the extra, as in ``pip install "contactd[pictures]"``.
    """

    def __init__(self, task: str, package: str, extra: str, debian: str = "") -> None:
        """`task` needs `package`; `debian` is its name in Debian."""
        on_debian = f", or on Debian {debian}" if debian else ""
        super().__init__(f'{task} needs {package}: pip install "contactd[{extra}]"{on_debian}.', name=package)
        self.extra = extra
        self._inputs = (task, package, extra, debian)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self._inputs


class TableFileError(ContactdError, ValueError):
    """A file without a table of influence coefficients, or a damaged one. The message names the line or the part."""


class SavedFileError(ContactdError, ValueError):
    """A file without a value written by `save`, or a damaged one."""


@dataclass(frozen=True)
class Violation:
    """An invalid field of a request. `field` is a path such as ``grid.nx`` or ``bodies.upper.nu``.

    Attributes:
        field: Path of the field, such as ``grid.nx``.
        description: The error, and the valid values.
    """

    field: str
    description: str


class StatusError(ContactdError):
    """The daemon answered with a status other than OK."""

    code = 2  #: Number of the status in gRPC.
    name = "UNKNOWN"  #: Name of the status in gRPC.

    def __init__(
        self, message: str, *, reason: str = "", violations: Iterable[Violation] = (), retry_delay: float = 0.0
    ) -> None:
        super().__init__(message)
        self.message = message
        self.reason = reason  #: Stable keyword of contactd, e.g. "BUILD_FAILED".
        self.violations = tuple(violations)  #: Invalid fields of an invalid argument; otherwise empty.
        self.retry_delay = retry_delay  #: Time to wait before a repetition if the queue is full (s), else 0.

    def __str__(self) -> str:
        return f"{self.message} ({self.name}{', ' + self.reason if self.reason else ''})"


class Cancelled(StatusError):
    """The job was cancelled."""

    code, name = 1, "CANCELLED"


class UnknownError(StatusError):
    """The daemon cannot determine the cause of the error."""

    code, name = 2, "UNKNOWN"


class InvalidArgument(StatusError, ValueError):
    """The request is invalid; `violations` names the fields."""

    code, name = 3, "INVALID_ARGUMENT"


class DeadlineExceeded(StatusError, TimeoutExpired):
    """The daemon stopped waiting because the call's timeout passed."""

    code, name = 4, "DEADLINE_EXCEEDED"


class NotFound(StatusError):
    """The object named in the request does not exist."""

    code, name = 5, "NOT_FOUND"


class AlreadyExists(StatusError):
    """The object that the request would create already exists."""

    code, name = 6, "ALREADY_EXISTS"


class PermissionDenied(StatusError):
    """This client has no permission for the request."""

    code, name = 7, "PERMISSION_DENIED"


class ResourceExhausted(StatusError):
    """The daemon's resources do not suffice for the request. Repeat it after `retry_delay` seconds."""

    code, name = 8, "RESOURCE_EXHAUSTED"


class FailedPrecondition(StatusError):
    """The request is valid, but the current state does not allow it."""

    code, name = 9, "FAILED_PRECONDITION"


class Aborted(StatusError):
    """The operation was aborted."""

    code, name = 10, "ABORTED"


class OutOfRange(StatusError):
    """The request is outside the existing range."""

    code, name = 11, "OUT_OF_RANGE"


class Unimplemented(StatusError):
    """The daemon does not have the method."""

    code, name = 12, "UNIMPLEMENTED"


class InternalError(StatusError):
    """A builder failed (reason BUILD_FAILED), or contactd has a defect."""

    code, name = 13, "INTERNAL"
    is_defect = True


class Unavailable(StatusError):
    """The daemon is stopping."""

    code, name = 14, "UNAVAILABLE"


class DataLoss(StatusError):
    """Stored data are lost."""

    code, name = 15, "DATA_LOSS"


class Unauthenticated(StatusError):
    """The daemon does not accept the key of this client, or only one side encrypts."""

    code, name = 16, "UNAUTHENTICATED"


_BY_CODE: dict[int, type[StatusError]] = {
    kind.code: kind
    for kind in (
        Cancelled, UnknownError, InvalidArgument, DeadlineExceeded, NotFound, AlreadyExists, PermissionDenied,
        ResourceExhausted, FailedPrecondition, Aborted, OutOfRange, Unimplemented, InternalError, Unavailable,
        DataLoss, Unauthenticated,
    )
}  # fmt: skip


def status_error(
    code: int, message: str, *, reason: str = "", violations: Iterable[Violation] = (), retry_delay: float = 0.0
) -> StatusError:
    """Returns the exception of a status code; UnknownError for a code without a class."""
    kind = _BY_CODE.get(code, UnknownError)
    return kind(message, reason=reason, violations=violations, retry_delay=retry_delay)


def invalid(field: str, problem: str, reason: str = "FIELD_INVALID") -> InvalidArgument:
    """Returns an InvalidArgument for one field, worded like the daemon's."""
    return InvalidArgument(f"{field} {problem}", reason=reason, violations=(Violation(field, problem),))
