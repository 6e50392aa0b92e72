"""Shows identification and state of the daemon."""

from __future__ import annotations

import time

from nicegui import ui

from ..output import span
from .panel import Panel
from .view import AWAY, View
from .watcher import Watcher

__all__ = ["StatePanel"]

_COLOURS = {"serving": "positive", "stopping": "warning", AWAY: "negative"}


class StatePanel(Panel):
    """Shows the head of the page, above all tabs."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        with ui.row().classes("items-center w-full gap-3 pt-3"):
            ui.label("contactd").classes("text-xl font-bold")
            self._state = ui.badge().classes("state text-sm")
            ui.label(watcher.endpoint).classes("font-mono break-all")
            self._version = ui.label().classes("text-gray-600")
        with ui.card().classes("w-full away bg-red-50") as self._away:
            self._why = ui.label()
        with ui.card().classes("w-full warnings bg-amber-50") as self._warned:
            self._warnings = ui.label().classes("whitespace-pre-line")
        self._away.visible = self._warned.visible = False

    async def show(self, view: View) -> None:
        self._state.text = view.state
        self._state.props(f"color={_COLOURS.get(view.state, 'grey')}")
        if view.info is not None:
            self._version.text = f"{view.info.version} ({view.info.commit})"
        self._away.visible = view.state == AWAY
        self._why.text = f"The daemon has not answered for {span(time.time() - view.since)}. The dashboard keeps trying. {view.why}"
        self._warned.visible = bool(view.warnings) and view.is_there
        self._warnings.text = "\n".join(view.warnings)
