"""Provides common parts of the panels of the page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from nicegui import run, ui

from contactd import ContactdError

from .view import View
from .watcher import Watcher

__all__ = ["Panel", "answer_of", "column", "table"]

T = TypeVar("T")


class Panel:
    """Represents a part of the page. It is created once with the layout, and then shows one view after the other."""

    def __init__(self, watcher: Watcher) -> None:
        self.watcher = watcher

    async def show(self, view: View) -> None:
        """Updates the panel."""
        raise NotImplementedError


async def answer_of(watcher: Watcher, ask: Callable[..., T], *arguments: Any) -> T | None:
    """Returns the answer to a query of the daemon, for which a thread waits; on failure None, with a note on the
    page.
    """
    try:
        found: T = await run.io_bound(ask, *arguments)
        return found
    except ContactdError as error:
        ui.notify(watcher.explain(error), type="negative", multi_line=True)
        return None


def column(name: str, label: str, *, of_numbers: bool = True) -> dict[str, Any]:
    """Describes a column of a table."""
    return {"name": name, "label": label, "field": name, "align": "right" if of_numbers else "left"}


def table(columns: Sequence[dict[str, Any]], key: str, empty: str) -> Any:
    """Creates a table without rows; it shows `empty` while there are none."""
    made = ui.table(columns=list(columns), rows=[], row_key=key, pagination={"rowsPerPage": 15})
    made.classes("w-full").props(f'dense flat bordered no-data-label="{empty}"')
    return made
