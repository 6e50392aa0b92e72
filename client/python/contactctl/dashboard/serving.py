"""The process of the dashboard: who may look, and where it listens."""

from __future__ import annotations

import secrets
import socket
from collections.abc import Callable
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qs

import uvicorn
from fastapi import FastAPI
from nicegui import ui

from .pages import add_page
from .watcher import Watcher

__all__ = ["serve"]

_COOKIE = "contactd_dashboard"


class _OnlyWithToken:
    """Lets in who opened the link with the token, and from then on has it as a cookie.

    Without it every user of the machine, and every page that a browser shows, could end jobs in the dashboard's name.
    """

    def __init__(self, app: Any, token: str) -> None:
        self._app = app
        self._token = token

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "lifespan" or self._has_cookie(scope):
            await self._app(scope, receive, send)
        elif scope["type"] == "http":
            given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[-1]
            await (_welcome(send, self._token) if self._is_token(given) else _refuse(send))
        else:
            await send({"type": "websocket.close", "code": 1008})

    def _has_cookie(self, scope: Any) -> bool:
        for name, value in scope["headers"]:
            if name == b"cookie":
                try:
                    found = SimpleCookie(value.decode("latin-1")).get(_COOKIE)
                except CookieError:
                    continue
                if found is not None and self._is_token(found.value):
                    return True
        return False

    def _is_token(self, given: str) -> bool:
        return secrets.compare_digest(given.encode(), self._token.encode())


async def _welcome(send: Any, token: str) -> None:
    """Without the token in the address, which a browser shows and remembers."""
    cookie = f"{_COOKIE}={token}; HttpOnly; SameSite=Strict; Path=/"
    headers = [(b"location", b"/"), (b"set-cookie", cookie.encode()), (b"content-length", b"0")]
    await send({"type": "http.response.start", "status": 303, "headers": headers})
    await send({"type": "http.response.body", "body": b""})


async def _refuse(send: Any) -> None:
    text = b"Open the address that contactctl dashboard has printed, with its token.\n"
    headers = [(b"content-type", b"text/plain; charset=utf-8"), (b"content-length", str(len(text)).encode())]
    await send({"type": "http.response.start", "status": 403, "headers": headers})
    await send({"type": "http.response.body", "body": text})


def serve(watcher: Watcher, host: str, port: int, say: Callable[[str], None]) -> None:
    """Until a signal ends it. `say` hears the address, once it can be opened. Raises OSError where it cannot listen."""
    listener = _listening(host, port)
    shown, number = listener.getsockname()[:2]
    token = secrets.token_urlsafe(24)
    link = f"http://{f'[{shown}]' if ':' in shown else shown}:{number}/?token={token}"
    app = FastAPI(openapi_url=None)
    add_page(watcher)
    ui.run_with(app, title="contactd", show_welcome_message=False, reconnect_timeout=5)
    app.add_middleware(_OnlyWithToken, token=token)
    config = uvicorn.Config(app, log_level="warning", timeout_graceful_shutdown=1, server_header=False)
    server = uvicorn.Server(config)
    begin = server.startup

    async def startup(sockets: list[socket.socket] | None = None) -> None:
        await begin(sockets)
        if server.started:  # and heeds signals
            say(link)

    server.startup = startup
    server.run(sockets=[listener])


def _listening(host: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    listener = socket.socket(family, socket.SOCK_STREAM)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((host, port))
        listener.listen()
    except BaseException:
        listener.close()
        raise
    return listener
