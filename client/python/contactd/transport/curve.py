"""Reads keys of encrypted connections: CURVE key files."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import zmq
import zmq.auth

from ..files.whole import read_whole

__all__ = ["CurveKeys", "load_curve_keys"]

_MOST_BYTES = 1 << 16  #: Largest size of a key file.


@dataclass(frozen=True)
class CurveKeys:
    """Holds the daemon's public key and the client's own pair, in Z85.

    Attributes:
        server: The daemon's public key.
        public: The client's public key.
        secret: The client's secret key.
    """

    server: bytes
    public: bytes
    secret: bytes = field(repr=False)

    def apply(self, socket: zmq.Socket[bytes]) -> None:
        """Makes the socket encrypt its messages; call it before the socket connects."""
        socket.curve_serverkey = self.server
        socket.curve_publickey = self.public
        socket.curve_secretkey = self.secret


def load_curve_keys(server_key: str | Path | None, own_key: str | Path | None) -> CurveKeys | None:
    """Reads the daemon's public key file and the client's secret key file; returns None if neither is given.

    Raises ValueError naming the invalid file or the missing option.
    """
    if server_key is None and own_key is None:
        return None
    if server_key is None or own_key is None:
        missing = "server_key" if server_key is None else "own_key"
        raise ValueError(f"{missing} is missing: an encrypted connection requires the daemon's public key and your own key.")
    server, _ = _load(server_key)
    public, secret = _load(own_key)
    if secret is None:
        raise ValueError(f"{own_key} contains no secret key; set own_key to the file NAME.key_secret.")
    if Path(own_key).stat().st_mode & 0o077:
        raise ValueError(f"{own_key} contains a secret that other users can read; run: chmod 600 {own_key}")
    return CurveKeys(server, public, secret)


def _load(path: str | Path) -> tuple[bytes, bytes | None]:
    try:
        read_whole(path, _MOST_BYTES)  # does not wait for a pipe
        public, secret = zmq.auth.load_certificate(path)
    except OSError as error:
        raise ValueError(f"The key file {path} cannot be read: {error.strerror or error}.") from None
    except ValueError:
        raise ValueError(f'The key file {path} has no line public-key = "...".') from None
    for key in (public, secret):
        if key is not None and len(key) != 40:
            raise ValueError(f"The key file {path} contains no key of 40 characters of Z85.")
    return public, secret
