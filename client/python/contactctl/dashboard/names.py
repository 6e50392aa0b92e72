"""Determines host names by which browsers reach the dashboard."""

from __future__ import annotations

import ipaddress
import socket
from collections.abc import Sequence

__all__ = ["Names"]

_ADDRESSES = ("127.0.0.1", "[::1]")


class Names:
    """Lists valid values of Host, such as ``127.0.0.1:5580``. A name that others can point at this machine must be
    given explicitly.
    """

    def __init__(self, address: str, port: int, others: Sequence[str] = ()) -> None:
        """Takes the numeric `address` on which the dashboard listens; `others` are NAME or NAME:PORT."""
        listens = ipaddress.ip_address(address)
        self._port = port
        self._takes_addresses = listens.is_unspecified  # all addresses of this machine, including later ones
        names = [f"[{address}]" if listens.version == 6 else address]
        if listens.is_loopback or listens.is_unspecified:
            names += ["localhost", *_ADDRESSES]
        if not listens.is_loopback:
            names.append(socket.gethostname())
        own = [_with_port(name, port) for name in names]
        given = [other.lower() for name in others for other in (name, f"{name}:{port}")]
        self._own = tuple(dict.fromkeys(name.lower() for name in own))
        self._given = tuple(dict.fromkeys(given))

    def __str__(self) -> str:
        return ", ".join((*self._own, *self._given))

    def hold(self, host: str) -> bool:
        """Returns whether a request with this Host is for the dashboard."""
        host = host.lower()
        return host in self._own or host in self._given or (self._takes_addresses and self._is_address(host))

    def is_origin(self, origin: str, host: str) -> bool:
        """Returns whether a page of the valid `host` has this `origin`; https if there is a proxy."""
        schemes = ("http", "https") if host.lower() in self._given else ("http",)
        return origin.lower() in [f"{scheme}://{host.lower()}" for scheme in schemes]

    def _is_address(self, host: str) -> bool:
        name = host.removesuffix(f":{self._port}") if self._port != 80 else host
        try:
            ipaddress.ip_address(name.removeprefix("[").removesuffix("]"))
        except ValueError:
            return False
        return host == _with_port(name, self._port)


def _with_port(name: str, port: int) -> str:
    """Writes a name like browsers, which omit HTTP's default port."""
    return name if port == 80 else f"{name}:{port}"
