"""Shows the tables of the daemon's store: size and accuracy."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from contactd import StoredIc

from ..output import counted, size, span
from .panel import Panel, answer_of, column, table
from .view import View
from .watcher import Watcher

__all__ = ["TablesPanel"]

_COLUMNS = (column("key", "key", of_numbers=False), column("offsets", "offsets"), column("size", "size"),
            column("error", "largest error"), column("kind", "which is", of_numbers=False), column("elements", "elements"),
            column("took", "took"), column("solver", "solver", of_numbers=False))  # fmt: skip


class TablesPanel(Panel):
    """Lists the tables again when their number in the daemon changes."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        self._shown: tuple[float, ...] = ()
        self._total = ui.label().classes("text-gray-600")
        self._table = table(_COLUMNS, "name", "The store is empty.")

    async def show(self, view: View) -> None:
        if not view.is_there or view.store == self._shown:
            return
        self._shown = view.store
        found = await answer_of(self.watcher, self.watcher.tables)
        if found is None:
            self._shown = ()  # again with the next update
            return
        self._table.rows = [_row(stored) for stored in found]
        self._total.text = f"{counted(len(found), 'table')}, {size(sum(stored.bytes for stored in found))}"


def _row(stored: StoredIc) -> dict[str, Any]:
    row: dict[str, Any] = {"name": f"{stored.key}.{stored.nx}x{stored.ny}", "key": stored.key[:16], "offsets": f"{stored.nx} x {stored.ny}",
                           "size": size(stored.bytes)}  # fmt: skip
    if (evidence := stored.evidence) is None:
        return row
    seconds = evidence.seconds.get("total") if evidence.seconds else None
    row |= {"elements": evidence.elements, "solver": evidence.solver, "took": span(seconds) if seconds else None}
    errors = [error.largest for name in ("xx", "yy", "zz") if (error := getattr(evidence.errors, name, None)) is not None]
    if errors:
        kind = "estimated" if evidence.errors_estimated else "against the closed form"
        row |= {"error": f"{max(errors):.2g}", "kind": kind}
    elif evidence.modelling_error is not None:
        row |= {"error": f"{evidence.modelling_error:.2g}", "kind": "modelling error, estimated"}
    return row
