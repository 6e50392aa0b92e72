"""Shares states of a wear study among processes, such as the tasks of a job array.

The process with share 0 computes the steps and writes the record. The others read it, solve their states on its last
section, and write the answers to files next to it. So processes need not compute the same bits.
"""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from contactd.files.marks import can_be_written_over
from contactd.files.whole import read_whole, write_whole
from contactd.wear import WearStudy, read_record
from contactd.wear.evolution import Solve
from contactd.wear.placed import StudyPlace

from ..codes import Code, Ended
from ..study.journal import MOST_BYTES
from ..study.shares import Share

__all__ = ["ShareFiles", "work"]

_PAUSE = 0.1  #: Interval between checks of a file (s).
Answers = list[dict[str, Any]]


class ShareFiles:
    """Files of answers by steps and shares; those of other studies are ignored."""

    def __init__(self, record: Path, study: WearStudy, share: Share, longest_wait: float) -> None:
        self._record, self._share, self._longest_wait = record, share, longest_wait
        described = json.dumps(study.described(), sort_keys=True, default=lambda value: np.asarray(value).tolist())
        self._study = hashlib.sha256(described.encode()).hexdigest()

    def path(self, step: int, index: int) -> Path:
        """Returns the file of a share's answers for the section of a step."""
        return Path(f"{self._record}.{step:06d}.{index}-of-{self._share.count}")

    def read(self, step: int, index: int) -> Answers | None:
        """Returns the answers, or None while there are none."""
        try:
            found = json.loads(read_whole(self.path(step, index), MOST_BYTES))
        except (OSError, ValueError):
            return None
        return list(found["answers"]) if found.get("study") == self._study else None

    def write(self, step: int, answers: Answers) -> None:
        """Writes the answers of this share."""
        content = json.dumps({"study": self._study, "answers": answers}).encode()
        path = self.path(step, self._share.index)
        if not can_be_written_over(path):
            raise Ended(Code.USAGE, f"{path} exists, and contactd did not write it; give another file with --output.")
        write_whole(path, lambda into: into.write(content))

    def wait(self, step: int, index: int) -> Answers:
        """Waits for the answers of another share. Raises Ended if they do not arrive."""
        until = time.monotonic() + self._longest_wait
        while (answers := self.read(step, index)) is None:
            if time.monotonic() > until:
                raise Ended(Code.TIMEOUT, f"Share {index}/{self._share.count} has not answered for {self._longest_wait:g} s; start it as well.")
            time.sleep(_PAUSE)
        return answers

    def forget(self, step: int) -> None:
        """Removes the files that all shares have answered."""
        for index in range(self._share.count):
            if can_be_written_over(path := self.path(step, index)):
                path.unlink(missing_ok=True)

    def solving(self, own: Solve, number: Callable[[], int]) -> Solve:
        """Solves all states in this and the other shares; `number` is the step of the section."""

        def solve(requests: Sequence[dict[str, Any]], tell: Callable[[int], None]) -> Answers:
            step = number()
            mine = self.read(step, self._share.index) or own(requests[self._share.index :: self._share.count], tell)
            self.write(step, mine)
            merged: Answers = [{} for _ in requests]
            for index in range(self._share.count):
                merged[index :: self._share.count] = mine if index == self._share.index else self.wait(step, index)
            if step >= 1:
                self.forget(step - 1)
            return merged

        return solve


def work(
    files: ShareFiles, record: Path, study: WearStudy, place: StudyPlace, share: Share, own: Solve, longest_wait: float, on_step: Callable[[float], None]
) -> None:
    """Runs the other processes: solves their states on each section of the record, until the study's end."""
    done, until = -1, time.monotonic() + longest_wait
    while True:
        steps = read_record(record, study)
        if steps and steps[-1].distance >= study.until:
            return
        if steps and steps[-1].number != done:
            last = steps[-1]
            if files.read(last.number, share.index) is None:
                requests = study.params(place.profiles({part: last.of(part).points for part in study.parts}))
                files.write(last.number, own(requests[share.index :: share.count], lambda _: None))
            done, until = last.number, time.monotonic() + longest_wait
            on_step(last.distance)
        elif time.monotonic() > until:
            raise Ended(Code.TIMEOUT, f"{record} has had no new step for {longest_wait:g} s; start share 0/{share.count} as well.")
        time.sleep(_PAUSE)
