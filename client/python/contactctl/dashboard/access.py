"""Access control: requirements for each request to the dashboard before it reaches NiceGUI.

Every user of the machine can reach a loopback port, and so can every page in a browser. The protection consists of:

* `Host` must be a name of the dashboard. This excludes foreign names that point at this machine (DNS rebinding).
* `Origin` must be that of the dashboard, for requests of a page and for every WebSocket.
* The link contains a token. Opening it sets a cookie in the browser, and a key in the page.
* The cookie gives access to the door page, which contains no data. Cookies do not depend on ports, so a server of
  another user at the same address receives it, too. It is therefore neither the token nor sufficient.
* The key is stored for the page's origin, which includes the port, and is part of all other addresses, including that
  of the WebSocket.
"""

from __future__ import annotations

import secrets
from typing import Any
from urllib.parse import parse_qs

from .door import DOOR
from .names import Names

__all__ = ["Guard"]

_OPEN = "Open the address that contactctl dashboard printed, including its token."
#: Headers against frames in other pages, caching, and leaked addresses.
_HEADERS = ((b"x-frame-options", b"DENY"), (b"content-security-policy", b"frame-ancestors 'none'"),
            (b"cross-origin-resource-policy", b"same-origin"), (b"referrer-policy", b"no-referrer"),
            (b"x-content-type-options", b"nosniff"))  # fmt: skip


class Guard:
    """Passes a request to `app`, an ASGI application, or answers it itself."""

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
        """Returns a sentence about an invalid Host or Origin; "" if both are valid."""
        hosts, origins = _values(scope, b"host"), _values(scope, b"origin")
        if len(hosts) != 1 or not self._names.hold(hosts[0]):
            asked = ", ".join(hosts)[:200]
            return f"This dashboard accepts requests for {self._names}, not for {asked!r}. If browsers reach it by this name, start it with --name."
        if not origins and scope["type"] == "http" and scope["method"] in ("GET", "HEAD"):
            return ""  # Pages send none for reads from their own origin.
        if len(origins) != 1 or not self._names.is_origin(origins[0], hosts[0]):
            return "Only the dashboard's own page may send this request, which has a different Origin or none."
        return ""

    async def _open_door(self, scope: Any, send: Any) -> None:
        given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[-1]
        if _same(given, self._token):
            # Without the token in the visible address; the part after # is never sent.
            cookie = f"{_cookie_of(scope)}={self._session}; HttpOnly; SameSite=Strict; Path=/"
            headers = [(b"location", f"/#{self._key}".encode()), (b"set-cookie", cookie.encode())]
            await _answer(send, 303, b"", *headers)
        elif self._has_cookie(scope):
            await _answer(send, 200, DOOR, (b"content-type", b"text/html; charset=utf-8"))
        else:
            await _refuse(scope, send, _OPEN)

    def _has_cookie(self, scope: Any) -> bool:
        # Other servers at this address may have set cookies of any form, also with this name.
        pairs = (pair.partition("=") for value in _values(scope, b"cookie") for pair in value.split(";"))
        name = _cookie_of(scope)
        return any(found.strip() == name and _same(value.strip(), self._session) for found, _, value in pairs)

    def _behind_key(self, scope: Any) -> Any:
        """Returns the request in NiceGUI's form: without the key, which is its root path."""
        before = f"/{self._key}"
        headers = [(name, value) for name, value in scope["headers"] if name != b"x-forwarded-prefix"]
        path = scope["path"].removeprefix(before) or "/"
        raw = scope["raw_path"].removeprefix(before.encode()) or b"/"
        return {**scope, "path": path, "raw_path": raw, "headers": [*headers, (b"x-forwarded-prefix", before.encode())]}


def _cookie_of(scope: Any) -> str:
    """Returns the name of the cookie, which contains the port in the browser: dashboards on several ports have separate
    cookies.
    """
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
