"""Shows the load of the daemon: current figures, and rates and times of the last minutes."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from ..output import counted, size, span
from .charts import latency_chart, throughput_chart
from .panel import Panel
from .view import View
from .watcher import Watcher

__all__ = ["RatesPanel"]

_FIGURES = ("running for", "workers", "waiting", "builds", "sessions", "tables in memory", "store", "connections", "memory", "processor")

_CHARTS = (("Throughput", throughput_chart), ("Latency from receiving a request to its answer", latency_chart))


class RatesPanel(Panel):
    """Figures above two charts."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        self._figures: dict[str, Any] = {}
        with ui.row().classes("figures w-full gap-x-6 gap-y-2"):
            for name in _FIGURES:
                with ui.column().classes("gap-0"):
                    ui.label(name).classes("text-xs text-gray-600")
                    self._figures[name] = ui.label("-").classes("text-base font-medium")
        with ui.row().classes("w-full gap-4"):
            self._charts = [(_chart(title, make), make) for title, make in _CHARTS]

    async def show(self, view: View) -> None:
        for name, text in _figures(view).items():
            self._figures[name].text = text
        for chart, make in self._charts:
            chart.options.update(make(view.samples))
            chart.update()


def _chart(title: str, make: Any) -> Any:
    with ui.card().classes("flex-1 min-w-72 p-3"):
        ui.label(title).classes("font-medium")
        return ui.echart(make(())).classes("h-56")


def _figures(view: View) -> dict[str, str]:
    if not view.is_there or not view.samples:
        return dict.fromkeys(_FIGURES, "-")
    said = view.samples[-1].said
    texts = (
        span(said["uptime_seconds"]),
        f"{said['workers_busy']:.0f} of {said['workers']:.0f} busy",
        f"{said['solves_waiting'] + said['builds_waiting']:.0f}",
        f"{said['builds_running']:.0f} running",
        f"{said['sessions']:.0f}, {size(said['session_bytes'])}",
        f"{said['tables']:.0f}",
        f"{counted(int(said['store_tables']), 'table')}, {size(said['store_bytes'])}",
        f"{said['connections']:.0f}",
        size(said["resident_bytes"]),
        f"{100 * said['processors']:.0f} % of one",
    )
    return dict(zip(_FIGURES, texts))
