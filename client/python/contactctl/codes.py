"""Defines exit codes, and the code of each error. docs/contactctl.md and the manual page list them."""

from __future__ import annotations

import errno
from enum import IntEnum

from contactd import (
    Cancelled,
    ConnectionFailed,
    DaemonFailed,
    InternalError,
    MissingExtra,
    ProtocolError,
    StatusError,
    TimeoutExpired,
    Unauthenticated,
    Unavailable,
)

__all__ = ["Code", "Ended", "HungUp", "Terminated", "code_of"]


#: Errors of a named file or folder, not of a full or broken disk.
_UNUSABLE = {
    errno.EACCES, errno.EPERM, errno.EROFS, errno.ENOENT, errno.ENOTDIR, errno.EISDIR, errno.EEXIST, errno.ELOOP, errno.ENAMETOOLONG,
    errno.EINVAL, errno.EFBIG, errno.ENXIO,
}  # fmt: skip


class Code(IntEnum):
    """The result of a command."""

    DONE = 0
    DEFECT = 1  #: An unexpected error: a full disk, or a defect.
    USAGE = 2  #: The command line, or a named file, is invalid.
    CONNECTION = 3  #: No daemon answers, or it is stopping, or does not accept the key.
    REFUSED = 4  #: The daemon refuses the request.
    NOT_CONVERGED = 5  #: There is an answer, but a solver missed its tolerance.
    CANCELLED = 6  #: Another client cancelled the job.
    TIMEOUT = 7  #: no answer within --timeout
    FAILED = 8  #: The daemon failed: a build, or a defect.
    OUTSIDE = 9  #: There is an answer, but a value lies outside the limits of a standard.
    HUNG_UP = 129  #: SIGHUP
    INTERRUPTED = 130  #: Ctrl-C
    PIPE = 141  #: The reader of the output has closed it.
    TERMINATED = 143  #: SIGTERM


class Ended(Exception):
    """Ends a command with an exit code and a sentence."""

    def __init__(self, code: Code, message: str) -> None:
        super().__init__(message)
        self.code = code

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.code, str(self))  # It is pickled by workers of a cluster.


class HungUp(KeyboardInterrupt):
    """SIGHUP: the terminal is closed. It interrupts like Ctrl-C."""


class Terminated(KeyboardInterrupt):
    """Represents SIGTERM, which interrupts like Ctrl-C."""


def code_of(error: BaseException) -> Code:
    """Returns the exit code of an error of the client, or of a file."""
    kinds: tuple[tuple[type[BaseException], Code], ...] = (
        (HungUp, Code.HUNG_UP),
        (Terminated, Code.TERMINATED),
        (KeyboardInterrupt, Code.INTERRUPTED),
        (TimeoutExpired, Code.TIMEOUT),
        (ConnectionFailed, Code.CONNECTION),
        (ProtocolError, Code.CONNECTION),
        (DaemonFailed, Code.CONNECTION),
        (Unauthenticated, Code.CONNECTION),
        (Unavailable, Code.CONNECTION),
        (Cancelled, Code.CANCELLED),
        (InternalError, Code.FAILED),
        (MissingExtra, Code.USAGE),
    )
    for kind, code in kinds:
        if isinstance(error, kind):
            return code
    if isinstance(error, StatusError):
        if error.reason == "NOT_CONVERGED":
            return Code.NOT_CONVERGED
        return Code.FAILED if error.reason == "BUILD_OUT_OF_MEMORY" else Code.REFUSED
    if isinstance(error, OSError) and error.filename is not None and error.errno in _UNUSABLE:
        return Code.USAGE
    return Code.DEFECT
