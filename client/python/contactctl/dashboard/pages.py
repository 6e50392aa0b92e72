"""Builds the page: data of the watcher in panels that are updated every second."""

from __future__ import annotations

from nicegui import ui

from .panel import Panel
from .panel_configuration import ConfigurationPanel
from .panel_jobs import JobsPanel
from .panel_rates import RatesPanel
from .panel_sessions import SessionsPanel
from .panel_solves import SolvesPanel
from .panel_state import StatePanel
from .panel_tables import TablesPanel
from .watcher import Watcher

__all__ = ["add_page"]

_STYLE = """
body { background: #f6f5f2; color: #1d1d2b; }
body.body--dark { background: #16161c; color: #e6e6ea; }
.q-tab-panel { padding: 16px 0; }
.q-card { box-shadow: none; border: 1px solid #e4e1da; }
.body--dark .q-card, .body--dark .q-table__card { background: #1e1e26; border-color: #3a3a46; }
.body--dark .text-gray-600 { color: #a2a2ae; }
.body--dark .text-primary { color: #7ea6ff !important; }
.body--dark .away { background: #4a1d1d; }
.body--dark .warnings { background: #453514; }
.figures b { font-variant-numeric: tabular-nums; }
.q-table td, .q-table th { font-variant-numeric: tabular-nums; }
@media (max-width: 480px) {
    .q-tab { padding: 0 6px; }
    .q-tab__label { font-size: 13px; }
}
"""
_TABS = (("Work", (RatesPanel, JobsPanel)), ("Solves", (SolvesPanel,)), ("Tables", (TablesPanel,)),
         ("Sessions", (SessionsPanel,)), ("Configuration", (ConfigurationPanel,)))  # fmt: skip


def add_page(watcher: Watcher) -> None:
    """Adds the page at /, for each browser that opens it."""

    def page() -> None:
        ui.add_css(_STYLE)
        ui.dark_mode(None)  # light or dark, as set in the browser
        ui.colors(primary="#1449b8")
        panels: list[Panel] = []
        with ui.column().classes("w-full max-w-6xl mx-auto gap-3"):
            panels.append(StatePanel(watcher))
            with ui.tabs().props("align=left dense no-caps").classes("max-w-full") as tabs:
                for name, _ in _TABS:
                    ui.tab(name)
            with ui.tab_panels(tabs, value=_TABS[0][0], animated=False).classes("w-full bg-transparent"):
                for name, kinds in _TABS:
                    with ui.tab_panel(name).classes("gap-4"):
                        panels.extend(kind(watcher) for kind in kinds)
        shown = None

        async def bring_up_to_date() -> None:
            nonlocal shown
            if (view := watcher.view) is shown:
                return
            shown = view
            for panel in panels:
                await panel.show(view)

        # Not while the page is created: a daemon that does not answer would delay it.
        ui.timer(0.5, bring_up_to_date)

    ui.page("/", title="contactd")(page)
