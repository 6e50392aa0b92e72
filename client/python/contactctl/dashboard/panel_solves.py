"""The last solves, and the picture of one."""

from __future__ import annotations

import time
from typing import Any

from nicegui import run, ui

from contactd import RecentSolve

from ..output import above_rounding, number, span
from .panel import Panel, answer_of, column, table
from .picture import picture_of
from .view import View
from .watcher import Watcher

__all__ = ["SolvesPanel"]

_COLUMNS = (column("number", "number"), column("at", "at", of_numbers=False), column("method", "method", of_numbers=False),
            column("grid", "elements"), column("converged", "converged", of_numbers=False), column("iterations", "iterations"),
            column("residual", "residual"), column("took", "took"), column("Fx", "Fx (N)"), column("Fy", "Fy (N)"),
            column("F", "Fn or Fz (N)"), column("pmax", "pmax (N/mm²)"), column("id", "request", of_numbers=False))  # fmt: skip


class SolvesPanel(Panel):
    """One row per solve. A click on a row plots its pressures."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        self._shown: tuple[RecentSolve, ...] = ()
        ui.label("Solves of the user of this dashboard, one row per solve. Click a row to plot its pressures.").classes("text-gray-600")
        self._table = table(_COLUMNS, "number", "There are no solves, or the daemon keeps none (recent_solves.count).")
        self._table.classes("solves cursor-pointer").on("row-click", self._draw, js_handler="(event, row) => emit(row.number)")
        with ui.dialog() as self._dialog, ui.card().classes("max-w-full"):
            self._title = ui.label().classes("font-medium")
            self._picture = ui.image().props("no-spinner no-transition").classes("picture")
            ui.button("Close", on_click=self._dialog.close).props("flat no-caps")

    async def show(self, view: View) -> None:
        if view.solves == self._shown:
            return
        self._shown = view.solves
        self._table.rows = [_row(solve) for solve in view.solves]

    async def _draw(self, event: Any) -> None:
        found = next((solve for solve in self._shown if solve.number == event.args), None)
        if found is None:
            ui.notify("This solve is no longer among the recent ones.")
            return
        if not found.has_pressures:
            ui.notify("Its pressures are not kept, because it has no contact, or more elements than recent_solves.max_bytes allows.")
            return
        patches = await answer_of(self.watcher, self.watcher.pressures, found.number)
        if patches is None:
            return
        self._title.text = f"Solve {found.number}, {found.method} at {_time_of(found)}" + ("" if found.converged else ", NOT CONVERGED")
        self._picture.source = await run.io_bound(picture_of, patches)
        self._picture.style(f"width: {504 * len(patches)}px; max-width: 100%")
        self._dialog.open()


def _time_of(solve: RecentSolve) -> str:
    return time.strftime("%H:%M:%S", time.localtime(solve.at))


def _row(solve: RecentSolve) -> dict[str, Any]:
    elements = str(solve.elements) if solve.grid is None else f"{solve.grid.nx} x {solve.grid.ny}"
    if solve.patches != 1:
        elements += f" in {solve.patches} patches" if solve.patches else " (no contact)"
    largest = max(map(abs, solve.forces))
    forces = dict(zip(("Fx", "Fy", "F"), (f"{above_rounding(force, largest) + 0.0:.5g}" for force in solve.forces)))
    return {
        "number": solve.number, "at": _time_of(solve), "method": solve.method, "grid": elements,
        "converged": number(solve.converged), "iterations": solve.iterations, "residual": f"{solve.residual:.1e}",
        "took": span(solve.seconds), "pmax": f"{solve.pmax:.5g}", "id": solve.id, **forces,
    }  # fmt: skip
