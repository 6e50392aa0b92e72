"""Jobs done by threads of this process, whose results are rows of a journal."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from .journal import Journal

__all__ = ["Add", "by_threads"]

Job = TypeVar("Job")
#: Adds a row to the journal; False where the thread has to end.
Add = Callable[[dict[str, Any]], bool]

_LONGEST_WAIT = 1.0  # seconds for what is nearly finished, when interrupted


def by_threads(
    jobs: Iterable[Job], do: Callable[[Job, Add], None], journal: Journal, workers: int, on_row: Callable[[], None],
    interrupted: Callable[[], None] = lambda: None,
) -> None:  # fmt: skip
    """Has `do` called with each job, and tells `on_row` of rows in this thread. Raises what one of them raised.

    Interrupted, it calls `interrupted`, and waits a moment for the threads.
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
        except BaseException as error:  # told to who waits for the threads
            errors.append(error)
            ending.set()
        finally:
            changed.set()

    # Daemons, since a request that waits for long must not keep the program from ending.
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
            closed.set()  # whoever still runs must not write any more
    if errors:
        raise errors[0]
