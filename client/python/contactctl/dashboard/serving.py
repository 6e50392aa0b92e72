"""Runs the dashboard as a process on a port."""

from __future__ import annotations

import secrets
import socket
from collections.abc import Callable, Sequence

import uvicorn
from fastapi import FastAPI
from nicegui import ui

from .access import Guard
from .names import Names
from .pages import add_page
from .watcher import Watcher

__all__ = ["serve"]


def serve(watcher: Watcher, host: str, port: int, say: Callable[[str], None], names: Sequence[str] = ()) -> None:
    """Runs until a signal. Calls `say` with the address when it is ready. Raises OSError if it cannot listen.

    `names` are further names by which browsers reach it (Names).
    """
    listener = _listening(host, port)
    shown, number = listener.getsockname()[:2]
    token = secrets.token_urlsafe(24)
    link = f"http://{f'[{shown}]' if ':' in shown else shown}:{number}/?token={token}"
    app = FastAPI(openapi_url=None)
    add_page(watcher)
    ui.run_with(app, title="contactd", show_welcome_message=False, reconnect_timeout=5)
    app.add_middleware(Guard, token=token, names=Names(shown, number, names))
    config = uvicorn.Config(app, log_level="warning", timeout_graceful_shutdown=1, server_header=False, proxy_headers=False)
    server = uvicorn.Server(config)
    begin = server.startup

    async def startup(sockets: list[socket.socket] | None = None) -> None:
        await begin(sockets)
        if server.started:  # and handles signals
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
