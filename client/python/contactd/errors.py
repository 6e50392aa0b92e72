"""Everything this package raises on purpose.

::

    ContactdError
    +-- ConnectionFailed          nobody listens at the endpoint, or the daemon went away        (ConnectionError)
    +-- TimeoutExpired            no answer within the call's timeout                            (TimeoutError)
    |   +-- DeadlineExceeded      ... and the daemon said so itself; also a StatusError
    +-- ProtocolError             an answer that breaks docs/protocol.md
    +-- DaemonFailed              LocalDaemon: the daemon did not start or did not end in order
    +-- MissingExtra              what an extra brings is not installed; the sentence says which     (ImportError)
    +-- TableFileError            a file that holds no table of coefficients, or a damaged one      (ValueError)
    +-- SavedFileError            a file that holds no problem or solution, or a damaged one         (ValueError)
    +-- StatusError               the daemon refused; .code, .name, .reason, .message
        +-- Cancelled             the job or the request was cancelled
        +-- UnknownError
        +-- InvalidArgument       .violations says which fields, and why                         (ValueError)
        +-- DeadlineExceeded
        +-- NotFound              no such job, session, saved state or table
        +-- AlreadyExists
        +-- PermissionDenied
        +-- ResourceExhausted     the queue is full (.retry_delay, s), or too many sessions
        +-- FailedPrecondition    a step out of turn, or a table whose builds failed before
        +-- Aborted               a step of a session did not converge
        +-- OutOfRange
        +-- Unimplemented         no such method
        +-- InternalError         a builder failed, or contactd has a defect
        +-- Unavailable           the daemon is ending
        +-- DataLoss
        +-- Unauthenticated       no connection without the right keys

Violations of a request that this package finds before sending it are InvalidArgument too, so a caller handles one kind.
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
    """Base of every exception of this package."""

    is_defect = False  #: of contactd or of a builder; of others tracebacks show the caller's line only


class ConnectionFailed(ContactdError, ConnectionError):
    """Nobody listens at the endpoint, or the connection broke while an answer was awaited."""


class TimeoutExpired(ContactdError, TimeoutError):
    """No answer within the timeout of the call. A build goes on: ask again later and the cache answers."""


class ProtocolError(ContactdError):
    """The answer breaks the protocol: other software listens there, or another version of it."""


class DaemonFailed(ContactdError):
    """A daemon that LocalDaemon started did not become ready, or did not end in order."""


class MissingExtra(ContactdError, ImportError):
    """A package that one of contactd's extras brings is not installed. `extra` is the name of the extra.

    Attributes:
        extra: Name of the extra, as in ``pip install "contactd[pictures]"``.
    """

    def __init__(self, task: str, package: str, extra: str, debian: str = "") -> None:
        """`task` needs `package`, which Debian has as `debian`."""
        on_debian = f", or on Debian {debian}" if debian else ""
        super().__init__(f'{task} needs {package}: pip install "contactd[{extra}]"{on_debian}.', name=package)
        self.extra = extra
        self._inputs = (task, package, extra, debian)

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self._inputs


class TableFileError(ContactdError, ValueError):
    """A file that holds no table of influence coefficients, or a damaged one; the message names the line or the part."""


class SavedFileError(ContactdError, ValueError):
    """A file that holds no problem, solution or the like that `save` has written, or a damaged one."""


@dataclass(frozen=True)
class Violation:
    """One field of a request that cannot be used; `field` is a path such as ``grid.nx`` or ``bodies.upper.nu``.

    Attributes:
        field: Path of the field, such as ``grid.nx``.
        description: What is wrong with it, and what would be right.
    """

    field: str
    description: str


class StatusError(ContactdError):
    """The daemon answered with a status other than OK."""

    code = 2  #: gRPC's number
    name = "UNKNOWN"  #: gRPC's name

    def __init__(
        self, message: str, *, reason: str = "", violations: Iterable[Violation] = (), retry_delay: float = 0.0
    ) -> None:
        super().__init__(message)
        self.message = message
        self.reason = reason  #: contactd's stable word, e.g. "BUILD_FAILED"
        self.violations = tuple(violations)  #: of an invalid argument, else empty
        self.retry_delay = retry_delay  #: seconds to wait before trying again, of a full queue, else 0

    def __str__(self) -> str:
        return f"{self.message} ({self.name}{', ' + self.reason if self.reason else ''})"


class Cancelled(StatusError):
    """The job was cancelled, by whomever."""

    code, name = 1, "CANCELLED"


class UnknownError(StatusError):
    """The daemon cannot say what went wrong."""

    code, name = 2, "UNKNOWN"


class InvalidArgument(StatusError, ValueError):
    """The request cannot be used; `violations` names the fields."""

    code, name = 3, "INVALID_ARGUMENT"


class DeadlineExceeded(StatusError, TimeoutExpired):
    """The daemon gave up waiting because the call's timeout passed."""

    code, name = 4, "DEADLINE_EXCEEDED"


class NotFound(StatusError):
    """Raised where what the request names does not exist."""

    code, name = 5, "NOT_FOUND"


class AlreadyExists(StatusError):
    """Raised where what the request would make exists."""

    code, name = 6, "ALREADY_EXISTS"


class PermissionDenied(StatusError):
    """This client may not do that."""

    code, name = 7, "PERMISSION_DENIED"


class ResourceExhausted(StatusError):
    """The daemon has no room for the request; try again after `retry_delay` seconds."""

    code, name = 8, "RESOURCE_EXHAUSTED"


class FailedPrecondition(StatusError):
    """The request is well formed and cannot be answered as stated."""

    code, name = 9, "FAILED_PRECONDITION"


class Aborted(StatusError):
    """The operation was given up."""

    code, name = 10, "ABORTED"


class OutOfRange(StatusError):
    """The request lies outside what exists."""

    code, name = 11, "OUT_OF_RANGE"


class Unimplemented(StatusError):
    """The daemon does not know the method."""

    code, name = 12, "UNIMPLEMENTED"


class InternalError(StatusError):
    """A builder failed (reason BUILD_FAILED), or contactd has a defect."""

    code, name = 13, "INTERNAL"
    is_defect = True


class Unavailable(StatusError):
    """The daemon is ending."""

    code, name = 14, "UNAVAILABLE"


class DataLoss(StatusError):
    """Stored data are gone."""

    code, name = 15, "DATA_LOSS"


class Unauthenticated(StatusError):
    """The daemon does not know this client (any more), or one of the two encrypts and the other does not."""

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
    """The exception of a status code; a code without a class becomes UnknownError."""
    kind = _BY_CODE.get(code, UnknownError)
    return kind(message, reason=reason, violations=violations, retry_delay=retry_delay)


def invalid(field: str, problem: str, reason: str = "FIELD_INVALID") -> InvalidArgument:
    """An InvalidArgument for one field, worded as the daemon words it."""
    return InvalidArgument(f"{field} {problem}", reason=reason, violations=(Violation(field, problem),))
