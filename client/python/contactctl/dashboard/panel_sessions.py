"""The open sessions."""

from __future__ import annotations

from nicegui import ui

from ..output import size, span
from .panel import Panel, column, table
from .view import View
from .watcher import Watcher

__all__ = ["SessionsPanel"]

_COLUMNS = (column("age", "open for"), column("idle", "idle for"), column("lease", "lease"), column("step", "step"),
            column("states", "saved states"), column("elements", "elements"), column("bytes", "memory"))  # fmt: skip


class SessionsPanel(Panel):
    """Shows one line per session. Names are keys to sessions and are not shown."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        self._table = table(_COLUMNS, "number", "No session is open.")
        ui.label("Names of sessions are not shown, because they give access to them.").classes("text-gray-600 text-sm")

    async def show(self, view: View) -> None:
        self._table.rows = [
            {
                "number": number, "age": span(session.age_seconds), "idle": span(session.idle_seconds),
                "lease": span(session.lease_seconds), "step": session.step, "states": session.states,
                "elements": session.elements, "bytes": size(session.bytes),
            }
            for number, session in enumerate(view.sessions)
        ]  # fmt: skip
