"""Exit codes, and which of them an error has. docs/contactctl.md and the manual page list them."""

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


#: These errors are those of a file or folder that was named, as opposed to a disk that is full or broken.
_UNUSABLE = {
    errno.EACCES, errno.EPERM, errno.EROFS, errno.ENOENT, errno.ENOTDIR, errno.EISDIR, errno.EEXIST, errno.ELOOP, errno.ENAMETOOLONG,
    errno.EINVAL, errno.EFBIG, errno.ENXIO,
}  # fmt: skip


class Code(IntEnum):
    """How a command ended."""

    DONE = 0
    DEFECT = 1  #: something that should not happen: a full disk, a defect
    USAGE = 2  #: a command line, or a file that was named, cannot be used
    CONNECTION = 3  #: no daemon answers, or it ends, or does not know the key
    REFUSED = 4  #: the daemon does not do what was asked for
    NOT_CONVERGED = 5  #: there is an answer, and a solver missed its tolerance
    CANCELLED = 6  #: somebody else cancelled the job
    TIMEOUT = 7  #: no answer within --timeout
    FAILED = 8  #: the daemon tried, and failed: a build, or a defect there
    HUNG_UP = 129  #: SIGHUP
    INTERRUPTED = 130  #: Ctrl-C
    PIPE = 141  #: who read the output has gone
    TERMINATED = 143  #: SIGTERM


class Ended(Exception):
    """A command that cannot go on: an exit code, and a sentence for people."""

    def __init__(self, code: Code, message: str) -> None:
        super().__init__(message)
        self.code = code

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (self.code, str(self))  # workers of a cluster send it


class HungUp(KeyboardInterrupt):
    """SIGHUP: the terminal has gone. It interrupts as Ctrl-C does."""


class Terminated(KeyboardInterrupt):
    """SIGTERM, which interrupts as Ctrl-C does."""


def code_of(error: BaseException) -> Code:
    """The exit code that an error of the client, or of a file, has."""
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
