"""The work that waits and runs, and an end to it."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from contactd import Job

from ..output import size, span
from .panel import Panel, answer_of
from .view import View
from .watcher import Watcher

__all__ = ["JobsPanel"]


_MOMENT = 0.3  #: seconds: what is done sooner nobody could cancel


class JobsPanel(Panel):
    """A card with a line each, but for those that have only just come."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        self._lines: dict[str, _Line] = {}
        with ui.card().classes("w-full jobs p-3 gap-2"):
            ui.label("Jobs").classes("font-medium")
            self._none = ui.label("There are none.").classes("text-gray-600")
            self._place = ui.column().classes("w-full gap-2")

    async def show(self, view: View) -> None:
        jobs = {job.job: job for job in view.jobs if job.seconds > _MOMENT}
        for name in [*self._lines]:
            if name not in jobs:
                self._lines.pop(name).remove()
        for name, job in jobs.items():
            if name not in self._lines:
                with self._place:
                    self._lines[name] = _Line(self.watcher, name)
            self._lines[name].show(job)
        self._none.visible = not jobs


class _Line:
    """Kept for as long as its job is there, so that its button stays where it is pressed."""

    def __init__(self, watcher: Watcher, name: str) -> None:
        with ui.row().classes("w-full items-center no-wrap gap-3 job").props(f"data-job={name}") as self._row:
            ui.label(name).classes("w-24 font-mono")
            self._stage = ui.label().classes("w-32")
            self._bar: Any = ui.linear_progress(0, show_value=False, size="12px").classes("flex-1")
            self._part = ui.label().classes("w-12 text-right part")
            self._remark = ui.label().classes("w-72 text-gray-600")

            async def cancel() -> None:
                button.disable()
                ended = await answer_of(watcher, watcher.cancel, name)
                if ended is not None:
                    ui.notify(f"{name} is cancelled." if ended else f"{name} had ended before.")

            button = ui.button("Cancel", on_click=cancel).props("outline dense no-caps size=sm").classes("cancel px-2")

    def show(self, job: Job) -> None:
        self._stage.text = job.stage or job.state
        self._bar.value = job.fraction
        self._part.text = f"{100 * job.fraction:.0f} %"
        remarks = [f"since {span(job.seconds)}"]
        if job.seconds_left is not None:
            remarks.append(f"about {span(job.seconds_left)} to go")
        if job.memory_bytes is not None:
            remarks.append(f"about {size(job.memory_bytes)}")
        if job.callers != 1:
            remarks.append(f"{job.callers} wait for it")
        self._remark.text = ", ".join(remarks)

    def remove(self) -> None:
        self._row.delete()
