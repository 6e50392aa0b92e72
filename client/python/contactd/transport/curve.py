"""Encrypted connections: the key files of CURVE, and what a handshake that failed says."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import zmq
import zmq.auth

from ..errors import ConnectionFailed, Unauthenticated
from ..files.whole import read_whole

if TYPE_CHECKING:
    from .sockets import Event

__all__ = ["HANDSHAKE_EVENTS", "CurveKeys", "Handshakes", "load_curve_keys"]

#: What a socket tells of the handshakes of its connection.
HANDSHAKE_EVENTS = (
    zmq.EVENT_HANDSHAKE_FAILED_AUTH | zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL | zmq.EVENT_HANDSHAKE_FAILED_NO_DETAIL
)
#: A daemon that cannot read what a client says hangs up without a word, and so does one that is ending, once.
SILENT_ENDS = 3
_MOST_BYTES = 1 << 16  #: of a key file


@dataclass(frozen=True)
class CurveKeys:
    """The daemon's public key and the client's own pair, in Z85.

    Attributes:
        server: The daemon's public key.
        public: The client's public key.
        secret: The client's secret key.
    """

    server: bytes
    public: bytes
    secret: bytes = field(repr=False)

    def apply(self, socket: zmq.Socket[bytes]) -> None:
        """Makes the socket encrypt what it sends; before it connects."""
        socket.curve_serverkey = self.server
        socket.curve_publickey = self.public
        socket.curve_secretkey = self.secret


def load_curve_keys(server_key: str | Path | None, own_key: str | Path | None) -> CurveKeys | None:
    """Reads the daemon's public file and the client's own secret one; None when neither is given.

    Raises ValueError naming the file that cannot be used or the option that is missing.
    """
    if server_key is None and own_key is None:
        return None
    if server_key is None or own_key is None:
        missing = "server_key" if server_key is None else "own_key"
        raise ValueError(f"{missing} is missing: an encrypted connection needs the daemon's public key and an own one.")
    server, _ = _load(server_key)
    public, secret = _load(own_key)
    if secret is None:
        raise ValueError(f"{own_key} holds no secret key; own_key is the file NAME.key_secret.")
    if Path(own_key).stat().st_mode & 0o077:
        raise ValueError(f"{own_key} holds a secret that others can get at; run: chmod 600 {own_key}")
    return CurveKeys(server, public, secret)


def _load(path: str | Path) -> tuple[bytes, bytes | None]:
    try:
        read_whole(path, _MOST_BYTES)  # no pipe that waits
        public, secret = zmq.auth.load_certificate(path)
    except OSError as error:
        raise ValueError(f"The key file {path} cannot be read: {error.strerror or error}.") from None
    except ValueError:
        raise ValueError(f'The key file {path} has no line public-key = "...".') from None
    for key in (public, secret):
        if key is not None and len(key) != 40:
            raise ValueError(f"The key file {path} holds no key of 40 characters of Z85.")
    return public, secret


class Handshakes:
    """Judges why a socket gets no connection, from the events of its monitor."""

    def __init__(self, endpoint: str, encrypted: bool) -> None:
        self._endpoint, self._encrypted, self._silent_ends = endpoint, encrypted, 0

    def judge(self, event: Event) -> Unauthenticated | ConnectionFailed | None:
        """The exception that an event amounts to, or None while there is hope."""
        if event.kind == zmq.EVENT_HANDSHAKE_FAILED_AUTH:
            return self._refused("the daemon does not know this client's key; ask who runs it to allow own_key")
        if event.kind == zmq.EVENT_HANDSHAKE_FAILED_PROTOCOL:
            if event.value != zmq.PROTOCOL_ERROR_ZMTP_MECHANISM_MISMATCH:
                return ConnectionFailed(f"What listens at {self._endpoint} is no contactd daemon.")
            if self._encrypted:
                return self._refused("the daemon does not use encryption; leave server_key and own_key out")
            return self._refused("the daemon takes encrypted connections only; give server_key and own_key")
        self._silent_ends += 1
        if self._silent_ends < SILENT_ENDS:
            return None
        if self._encrypted:
            return self._refused(
                "it cannot read what this client says; either server_key is not the daemon's key, or the daemon does "
                "not use encryption"
            )
        return self._refused("it hangs up; if it takes encrypted connections only, give server_key and own_key")

    def _refused(self, why: str) -> Unauthenticated:
        return Unauthenticated(f"No connection to {self._endpoint}: {why}.", reason="HANDSHAKE_FAILED")
