"""Runs jobs in threads of this process; their results are rows of a journal."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from .journal import Journal

__all__ = ["Add", "by_threads"]

Job = TypeVar("Job")
#: Adds a row to the journal; returns False if the thread must end.
Add = Callable[[dict[str, Any]], bool]

_LONGEST_WAIT = 1.0  # seconds to finish jobs after an interrupt


def by_threads(
    jobs: Iterable[Job], do: Callable[[Job, Add], None], journal: Journal, workers: int, on_row: Callable[[], None],
    interrupted: Callable[[], None] = lambda: None,
) -> None:  # fmt: skip
    """Calls `do` with each job, and `on_row` for rows in this thread. Raises the exception of a job.

    If interrupted, it calls `interrupted`, and waits briefly for the threads.
    """
    todo, lock = iter(jobs), threading.Lock()
    errors: list[BaseException] = []
    changed, ending, closed = threading.Event(), threading.Event(), threading.Event()

    def add(row: dict[str, Any]) -> bool:
        with lock:
            if closed.is_set():
                return False
            journal.add(row)
        changed.set()
        return not ending.is_set()

    def work() -> None:
        try:
            while not ending.is_set():
                with lock:
                    try:
                        job = next(todo)
                    except StopIteration:
                        return
                do(job, add)
        except BaseException as error:  # raised in the thread that waits
            errors.append(error)
            ending.set()
        finally:
            changed.set()

    # Daemon threads, because a long request must not keep the program from ending.
    threads = [threading.Thread(target=work, daemon=True) for _ in range(workers)]
    for thread in threads:
        thread.start()
    try:
        while any(thread.is_alive() for thread in threads):
            changed.wait(0.2)
            changed.clear()
            on_row()
    except BaseException:
        ending.set()
        interrupted()
        for thread in threads:
            thread.join(_LONGEST_WAIT / workers)
        raise
    finally:
        with lock:
            closed.set()  # Running threads must not write any more.
    if errors:
        raise errors[0]
