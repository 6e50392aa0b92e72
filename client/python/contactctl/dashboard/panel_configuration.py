"""Shows the configuration of the daemon, without secrets and without names of files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from nicegui import ui

from ..output import number, size
from .panel import Panel, column, table
from .view import View
from .watcher import Watcher

__all__ = ["ConfigurationPanel"]

_COLUMNS = (column("field", "field", of_numbers=False), column("value", "value", of_numbers=False))


class ConfigurationPanel(Panel):
    """Shows one line per field, with the names of the configuration file."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        self._table = table(_COLUMNS, "field", "The daemon does not report any.").props("hide-pagination")
        self._table.pagination = {"rowsPerPage": 0}
        ui.label("Keys, folders, programs and addresses are not shown.").classes("text-gray-600 text-sm")

    async def show(self, view: View) -> None:
        rows = [{"field": name, "value": value} for name, value in _fields(view.config or {})]
        if rows != self._table.rows:
            self._table.rows = rows


def _fields(config: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, str]]:
    for name, value in sorted(config.items()):
        if isinstance(value, Mapping):
            yield from _fields(value, f"{before}{name}.")
        elif name.endswith("_bytes") and value:
            yield before + name, f"{value} ({size(value)})"
        else:
            yield before + name, number(value)
