"""Shows a progress bar in the terminal or in a notebook for calls with `progress=True`. Needs rich."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from ..errors import MissingExtra
from ..values.generated.service import Progress

__all__ = ["progress_shown"]


@contextmanager
def progress_shown(method: str, requested: bool) -> Iterator[Callable[[Progress], None]]:
    """Yields the callback for progress during the block: a bar if `requested`, otherwise None."""
    if not requested:
        yield lambda progress: None
        return
    try:
        from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
        from rich.progress import Progress as Bar
    except ImportError:
        raise MissingExtra("progress=True", "rich", "progress", "python3-rich") from None
    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.percentage:>3.0f} %"), TimeElapsedColumn())
    with Bar(*columns, TextColumn("{task.fields[remark]}")) as bar:
        task = bar.add_task(method, total=1.0, remark="")

        def show(progress: Progress) -> None:
            stage, _, remark = str(progress).partition(", ")
            name = stage.rpartition(" ")[0].rpartition(" ")[0] if stage.endswith("%") else stage
            bar.update(task, completed=progress.fraction, description=f"{method}: {name}", remark=remark)

        yield show
        bar.update(task, completed=1.0, description=method, remark="")
