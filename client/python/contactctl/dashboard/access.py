"""Who may look: what each request to the dashboard has to show before NiceGUI sees it.

Every user of the machine can reach a port of the loopback, and so can every page that a browser shows. What keeps them out:

* `Host` must be a name of the dashboard's. A foreign name that its owner lets point at this machine (DNS rebinding) is none.
* `Origin` must be the dashboard's own, of what a page sends and of every WebSocket.
* The link has a token. Opening it gives the browser a cookie, and the page a key.
* The cookie lets a browser read the door, which knows nothing. Cookies know no ports: what another user serves on the
  same address gets it, too, so that it may neither be the token nor be enough.
* The key is kept by the page's origin, which has a port, and is part of every other address, that of the WebSocket included.
"""

from __future__ import annotations

import secrets
from typing import Any
from urllib.parse import parse_qs

from .door import DOOR
from .names import Names

__all__ = ["Guard"]

_OPEN = "Open the address that contactctl dashboard has printed, with its token."
#: No other page may show this one in a frame, keep it, or learn its addresses.
_HEADERS = ((b"x-frame-options", b"DENY"), (b"content-security-policy", b"frame-ancestors 'none'"),
            (b"cross-origin-resource-policy", b"same-origin"), (b"referrer-policy", b"no-referrer"),
            (b"x-content-type-options", b"nosniff"))  # fmt: skip


class Guard:
    """Lets a request through to `app`, an application of ASGI, or answers it itself."""

    def __init__(self, app: Any, *, token: str, names: Names) -> None:
        self._app = app
        self._token = token
        self._session = secrets.token_urlsafe(24)
        self._key = secrets.token_urlsafe(24)
        self._names = names

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
        elif problem := self._problem(scope):
            await _refuse(scope, send, problem)
        elif scope["path"] == "/" and scope["type"] == "http":
            await self._open_door(scope, send)
        elif self._has_cookie(scope) and _same(_first_part(scope["path"]), self._key):
            await self._app(self._behind_key(scope), receive, _with_headers(send))
        else:
            await _refuse(scope, send, _OPEN)

    def _problem(self, scope: Any) -> str:
        """Says as a sentence what is wrong with Host and Origin; "" where nothing is."""
        hosts, origins = _values(scope, b"host"), _values(scope, b"origin")
        if len(hosts) != 1 or not self._names.hold(hosts[0]):
            asked = ", ".join(hosts)[:200]
            return f"This dashboard answers to {self._names}, and was asked as {asked!r}. Where browsers reach it so, start it with --name."
        if not origins and scope["type"] == "http" and scope["method"] in ("GET", "HEAD"):
            return ""  # a page tells none of what it reads from its own origin
        if len(origins) != 1 or not self._names.is_origin(origins[0], hosts[0]):
            return "Only the dashboard's own page may ask this: the request has another Origin, or none."
        return ""

    async def _open_door(self, scope: Any, send: Any) -> None:
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[-1]
        if _same(given, self._token):
            # Without the token in the address, which a browser shows and remembers; what is behind # is never sent.
            cookie = f"{_cookie_of(scope)}={self._session}; HttpOnly; SameSite=Strict; Path=/"
            headers = [(b"location", f"/#{self._key}".encode()), (b"set-cookie", cookie.encode())]
            await _answer(send, 303, b"", *headers)
        elif self._has_cookie(scope):
            await _answer(send, 200, DOOR, (b"content-type", b"text/html; charset=utf-8"))
        else:
            await _refuse(scope, send, _OPEN)

    def _has_cookie(self, scope: Any) -> bool:
        # Whatever else is served on this address may have left cookies, of this name, too, and of any form.
        pairs = (pair.partition("=") for value in _values(scope, b"cookie") for pair in value.split(";"))
        name = _cookie_of(scope)
        return any(found.strip() == name and _same(value.strip(), self._session) for found, _, value in pairs)

    def _behind_key(self, scope: Any) -> Any:
        """Returns the request as NiceGUI knows it: without the key, which it puts in front of the addresses in its page."""
        before = f"/{self._key}"
        headers = [(name, value) for name, value in scope["headers"] if name != b"x-forwarded-prefix"]
        path = scope["path"].removeprefix(before) or "/"
        raw = scope["raw_path"].removeprefix(before.encode()) or b"/"
        return {**scope, "path": path, "raw_path": raw, "headers": [*headers, (b"x-forwarded-prefix", before.encode())]}


def _cookie_of(scope: Any) -> str:
    """Its name, by the port that the browser knows: dashboards of several ports have one each."""
    (host,) = _values(scope, b"host")
    _, _, port = host.rpartition("]")[2].partition(":")
    return f"contactd_dashboard_{port or 80}"


def _values(scope: Any, name: bytes) -> list[str]:
    return [value.decode("latin-1") for found, value in scope["headers"] if found == name]


def _first_part(path: str) -> str:
    return path.split("/")[1] if path.startswith("/") else ""


def _same(given: str, wanted: str) -> bool:
    return secrets.compare_digest(given.encode(), wanted.encode())


def _with_headers(send: Any) -> Any:
    async def sent(message: Any) -> None:
        if message["type"] == "http.response.start":
            message = {**message, "headers": [*message.get("headers", ()), *_HEADERS]}
        await send(message)

    return sent


async def _answer(send: Any, status: int, body: bytes, *headers: tuple[bytes, bytes]) -> None:
    all_headers = [*headers, *_HEADERS, (b"cache-control", b"no-store"), (b"content-length", str(len(body)).encode())]
    await send({"type": "http.response.start", "status": status, "headers": all_headers})
    await send({"type": "http.response.body", "body": body})


async def _refuse(scope: Any, send: Any, why: str) -> None:
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 1008})  # before it is accepted: uvicorn answers 403
    else:
        await _answer(send, 403, f"{why}\n".encode(), (b"content-type", b"text/plain; charset=utf-8"))
