"""Shows waiting and running jobs, with a button to end each."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from contactd import Job

from ..output import counted, size, span
from .panel import Panel, answer_of
from .view import View
from .watcher import Watcher

__all__ = ["JobsPanel"]


_MOMENT = 0.3  #: Seconds; shorter jobs cannot be cancelled in time.
_WORK = {"build": "It is building a table", "solve": "It solves", "subsurface": "It is computing stresses", "step": "It is taking a step"}


class JobsPanel(Panel):
    """Shows a card with one line per job, except very recent ones."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__(watcher)
        self._lines: dict[str, _Line] = {}
        with ui.card().classes("w-full jobs p-3 gap-2"):
            ui.label("Jobs").classes("font-medium")
            self._none = ui.label("There are no jobs.").classes("text-gray-600")
            self._place = ui.column().classes("w-full gap-3")
        self._question = _Question(watcher)

    async def show(self, view: View) -> None:
        jobs = {job.job: job for job in view.jobs if job.seconds > _MOMENT}
        for name in [*self._lines]:
            if name not in jobs:
                self._lines.pop(name).remove()
        for name, job in jobs.items():
            if name not in self._lines:
                with self._place:
                    self._lines[name] = _Line(name, self._question.ask)
            self._lines[name].show(job)
        self._question.show(jobs)
        self._none.visible = not jobs


class _Line:
    """Exists as long as its job, so that its button does not move."""

    def __init__(self, name: str, ask: Callable[[Job], None]) -> None:
        with ui.column().classes("w-full gap-1 job").props(f"data-job={name}") as self._all:
            with ui.row().classes("w-full items-center gap-x-3 gap-y-1"):
                ui.label(name).classes("w-24 font-mono")
                self._stage = ui.label().classes("w-32")
                self._bar: Any = ui.linear_progress(0, show_value=False, size="12px").classes("flex-1 min-w-24")
                self._part = ui.label().classes("w-12 text-right part")
                self._remark = ui.label().classes("w-72 text-gray-600")
                button = ui.button("Cancel", on_click=lambda: ask(self._job))
                button.props("outline dense no-caps size=sm").classes("cancel px-2")
            self._what = ui.label().classes("what text-gray-600 text-sm break-words")

    def show(self, job: Job) -> None:
        self._job = job
        self._stage.text = job.stage or job.state
        self._bar.value = job.fraction
        self._part.text = f"{100 * job.fraction:.0f} %"
        remarks = [f"since {span(job.seconds)}"]
        if job.seconds_left is not None:
            remarks.append(f"about {span(job.seconds_left)} to go")
        if job.memory_bytes is not None:
            remarks.append(f"about {size(job.memory_bytes)}")
        if job.callers != 1:
            remarks.append(f"{job.callers} waiting requests")
        self._remark.text = ", ".join(remarks)
        words = [job.description, f"for {_users(job)}" if job.callers else "no waiting requests"]
        self._what.text = "; ".join(filter(None, words))

    def remove(self) -> None:
        self._all.delete()


class _Question:
    """Asks for confirmation before a job is ended. It disappears when the job ends."""

    def __init__(self, watcher: Watcher) -> None:
        self._watcher = watcher
        self._job = ""
        with ui.dialog() as self._dialog, ui.card().classes("question max-w-full gap-3"):
            self._title = ui.label().classes("font-medium")
            self._what = ui.label().classes("break-words")
            self._whose = ui.label().classes("break-words")
            with ui.row().classes("gap-2"):
                ui.button("End it", color="negative", on_click=self._cancel).props("no-caps").classes("end")
                ui.button("Let it run", on_click=self._dialog.close).props("flat no-caps").classes("keep")

    def ask(self, job: Job) -> None:
        self._job = job.job
        self._title.text = f"End {job.job}?"
        self._say(job)
        self._dialog.open()

    def show(self, jobs: dict[str, Job]) -> None:
        if not self._dialog.value:
            return
        if (job := jobs.get(self._job)) is not None:
            self._say(job)
            return
        self._dialog.close()
        ui.notify(f"{self._job} has ended.")

    def _say(self, job: Job) -> None:
        work = _WORK.get(job.kind, f"It is a {job.kind}")
        self._what.text = f"{work}: {job.description}." if job.description else f"{work}."
        if job.callers:
            self._whose.text = f"It belongs to {_users(job)}. Waiting requests end with an error: {counted(job.callers, 'request')}."
        else:
            self._whose.text = "No request waits for it any more."

    async def _cancel(self) -> None:
        name = self._job
        self._dialog.close()
        ended = await answer_of(self._watcher, self._watcher.cancel, name)
        if ended is not None:
            ui.notify(f"{name} is cancelled." if ended else f"{name} had ended before.")


def _users(job: Job) -> str:
    return ", ".join(job.users) or "a user without a name"
