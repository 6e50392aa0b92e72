"""Solves the rows of a table or of its check, which are resumed and shared as those of studies."""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..codes import Code, Ended
from ..common import connected, setting
from ..output import counted, note, span
from ..progress import Bar
from ..study.journal import Journal
from ..study.shares import best, check_ended, rows_beside, share_of
from .building import Solve, Unit, solve_by_dask, solve_here

__all__ = ["Work"]


class Work:
    """Solves rows in a journal, or a share of them, and finds those of other shares."""

    def __init__(self, rows: Path, share: str | None, workers: int, dask: str | None, retry: bool) -> None:
        self.part = None if share is None else share_of(share)
        self.file, self.workers, self.dask, self.retry = rows, workers, dask, retry

    def solved(
        self, solve: Solve, units: Sequence[Unit], counts: Sequence[dict[str, int]]
    ) -> list[dict[str, Any]] | None:
        """Returns the rows of all units, or None while other shares have not solved theirs. `counts` contains the lengths
        of their answers. Raises Ended if rows failed.
        """
        own = units if self.part is None else self.part.cases(units)
        sizes = {unit.key: count for unit, count in zip(units, counts, strict=True)}
        with Journal(self.file if self.part is None else self.part.file(self.file)) as journal:
            if self.part is None:
                check_ended(self.file)
            there = best(journal.rows, rows_beside(self.file, journal.path))
            unwanted = {
                key
                for key, lengths in sizes.items()
                if key in there and (not _fits(there[key], lengths) or (self.retry and there[key]["code"]))
            }
            if unwanted & journal.rows.keys():
                journal.forget(unwanted)
            there = {key: there[key] for key in (sizes.keys() & there.keys()) - unwanted}
            self._solve(solve, [unit for unit in own if unit.key not in there], len(own), journal)
            found = best(journal.rows, there)
        failed = [found[key] for key in sizes if key in found and "answers" not in found[key]]
        if failed:
            raise Ended(
                Code(min(row["code"] for row in failed)),
                f"{counted(len(failed), 'row')} failed: {failed[0]['error']} --retry solves them again.",
            )
        return [found[key] for key in sizes] if sizes.keys() <= found.keys() else None

    def _solve(self, solve: Solve, todo: Sequence[Unit], total: int, journal: Journal) -> None:
        known, began = len(journal.rows), time.monotonic()
        there = total - len(todo)
        if there:
            note(f"{there} of {total} rows are solved.")
        if not todo:
            return
        with Bar("table") as bar:

            def on_row() -> None:
                done = len(journal.rows) - known
                left = f"about {span((time.monotonic() - began) / done * (len(todo) - done))} to go" if done else ""
                bar.show((there + done) / total, f"{there + done} of {total} rows", left)

            try:
                on_row()
                if self.dask is not None:
                    solve_by_dask(self.dask, setting(), solve, todo, journal, on_row)
                    return
                with connected(workers=self.workers, local_unless_named=True) as client:
                    solve_here(client, solve, todo, journal, min(self.workers, len(todo)), on_row)
            except BaseException:
                note(f"{there + len(journal.rows) - known} of {total} rows are solved; repeat the command to continue.")
                raise


def _fits(found: dict[str, Any], counts: dict[str, int]) -> bool:
    """Returns whether a row of a file is a failure, or its answers have these lists, of these lengths if not negative."""
    answers = found.get("answers")
    if answers is None:
        return "error" in found
    lists = [(answers.get(name), count) for name, count in counts.items()]
    are_lists = all(
        isinstance(numbers, list) and all(isinstance(number, (int, float)) for number in numbers)
        for numbers, _ in lists
    )
    return are_lists and all(count in (-1, len(numbers)) for numbers, count in lists)
