"""Chains of cases by threads of this process, each with a client of all."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from contactd.contact_files.case import Case
from contactd.contact_files.runner import Outcome, Runner

from ..study.journal import Journal
from .rows import keys_of, row_of

__all__ = ["run_chains"]

_LONGEST_WAIT = 1.0  # seconds for what is nearly finished, when interrupted


def run_chains(
    runner: Runner, chains: Sequence[Sequence[Case]], options: Mapping[str, Any], journal: Journal, workers: int,
    keep: Callable[[Outcome], None], on_row: Callable[[], None],
) -> None:  # fmt: skip
    """Adds a row for each case to the journal, but for chains that are all there, and tells `on_row` in this thread. `keep`
    writes what an outcome has beside its row."""
    todo = iter([chain for chain in chains if any(key not in journal.rows for key in keys_of(chain, options))])
    lock, changed, ending, closed = threading.Lock(), threading.Event(), threading.Event(), threading.Event()
    errors: list[BaseException] = []

    def work() -> None:
        try:
            while not ending.is_set():
                with lock:
                    chain = next(todo, None)
                if chain is None:
                    return
                for key, outcome in zip(keys_of(chain, options), runner.run(chain)):
                    keep(outcome)
                    row = row_of(key, outcome)
                    with lock:
                        if closed.is_set():
                            return
                        journal.add(row)
                    changed.set()
                    if ending.is_set():
                        return
        except BaseException as error:  # told to who waits for the threads
            errors.append(error)
            ending.set()
        finally:
            changed.set()

    # Daemons, since a solve that takes long must not keep the program from ending.
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
        for thread in threads:
            thread.join(_LONGEST_WAIT / workers)
        raise
    finally:
        with lock:
            closed.set()  # whoever still runs must not write any more
    if errors:
        raise errors[0]
