"""Shows a live progress bar on standard error if that is a terminal."""

from __future__ import annotations

import sys
from types import TracebackType

from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
from rich.progress import Progress as Bars

from contactd import Progress

from .output import console, note, on_terminal, size, span

__all__ = ["Bar"]


class Bar:
    """Appears with the first report, and disappears at the end of the work."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._bars: Bars | None = None
        self._is_seen = on_terminal(sys.stderr)  # checked once, because a bar replaces the stream
        self._has_reported = self._has_reported_memory = False

    def __enter__(self) -> Bar:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        if self._bars is not None:
            self._bars.stop()

    def report(self, progress: Progress) -> None:
        """Shows the progress of a request."""
        left = "" if progress.seconds_left is None else f"about {span(progress.seconds_left)} to go"
        if progress.memory_bytes is not None and not self._has_reported_memory:
            self._has_reported_memory = True
            self._tell(f"{progress.job or self._what}: about {size(progress.memory_bytes)} of memory, estimated by the builder.")
        if progress.seconds_left is not None and not self._has_reported:
            self._has_reported = True
            self._tell(f"{progress.job or self._what}: {left}, estimated by the daemon.")
        if progress.iteration:
            left = f"iteration {progress.iteration}, residual {progress.residual:.1e}  {left}"
        self.show(progress.fraction, f"{progress.job}: {progress.stage}" if progress.job else progress.stage, left)

    def _tell(self, sentence: str) -> None:
        """Prints a line above the bar, if there is one."""
        if self._bars is None:
            note(sentence)
        else:
            self._bars.console.print(sentence)

    def show(self, fraction: float, stage: str, remark: str = "") -> None:
        """Shows a `fraction` from 0 to 1."""
        if not self._is_seen:
            return
        if self._bars is None:
            columns = (
                TextColumn("{task.description}", markup=False),
                BarColumn(bar_width=30),
                TextColumn("{task.percentage:>3.0f} %"),
                TimeElapsedColumn(),
                TextColumn("{task.fields[stage]}  {task.fields[remark]}", markup=False),
            )
            self._bars = Bars(*columns, console=console(stderr=True), transient=True, refresh_per_second=5)
            self._task = self._bars.add_task(self._what, total=1.0, stage=stage, remark=remark)
            self._bars.start()
        self._bars.update(self._task, completed=fraction, stage=stage, remark=remark)
