"""Cases of a study by threads of this process, each with a request of its own at one client."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable

from contactd import Client

from ..asking import OwnBuilds
from .journal import Journal
from .plan import Case, Plan
from .solving import row_of

__all__ = ["run_here"]

_LONGEST_WAIT = 1.0  # seconds for what is nearly finished, when interrupted


def run_here(
    client: Client, plan: Plan, cases: Iterable[Case], journal: Journal, workers: int, on_row: Callable[[], None]
) -> None:
    """Adds a row for each case, and tells `on_row` in this thread. Interrupted, it ends the builds that it started; what
    else the daemon does for it ends with the connections."""
    todo, lock = iter(cases), threading.Lock()
    errors: list[BaseException] = []
    changed, ending, closed = threading.Event(), threading.Event(), threading.Event()
    builds = OwnBuilds(client)

    def work() -> None:
        try:
            while not ending.is_set():
                with lock:
                    case = next(todo, None)
                if case is None:
                    return
                row = row_of(client, plan.method, plan.params(case), plan.answers, builds.notice)
                with lock:
                    if not closed.is_set():
                        journal.add({"key": case.key, "values": case.values, **row})
                changed.set()
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
        builds.cancel()
        for thread in threads:
            thread.join(_LONGEST_WAIT / workers)
        raise
    finally:
        with lock:
            closed.set()  # whoever still runs must not write any more
    if errors:
        raise errors[0]
