"""Holds the results of a rolling wheel, and keeps them in a file that is readable at any time."""

from __future__ import annotations

import contextlib
import json
import os
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from types import TracebackType
from typing import IO

import numpy as np

from ..errors import SavedFileError, invalid
from ..files.marks import can_be_written_over, written_by
from ..files.whole import read_whole
from .checks import Array

__all__ = ["COLUMNS", "Evidence", "Output", "Run", "read_run"]

COLUMNS = ("time", "x", "force", "wheel", "rail", "approach")
_HEADING = "time (s),x (m),force (N),wheel (m),rail (m),approach (m)"
_KIND = "run of contactd.track"
_ROW = ",".join(["{:.9g}"] * len(COLUMNS)) + "\n"
_END = "# end "
_MOST_BYTES = 1 << 32


@dataclass(frozen=True)
class Evidence:
    """Describes the solution of a run.

    Attributes:
        steps: Number of recorded steps.
        rolled: Distance (m) rolled before, on smooth rail.
        start_error: Change of the largest or smallest force over the last bay of that distance, over the load.
        trials: Mean number of evaluations of the contact law per step.
        most_trials: Largest number in a step.
        residual: Largest remaining error of a step's equation (N).
        losses: Number of times that contact was lost.
        work: Work (J) of the moving geometry: of rolling, and of irregularities.
        dissipation: Energy (J) dissipated by track and wheel.
        change: Change of the energy (J) of track, wheel and contact, less the work of the load.
        error: work - dissipation - change (J); NaN for laws without energy, whose contact energy is that of the forces.
    """

    steps: int = 0
    rolled: float = 0.0
    start_error: float = 0.0
    trials: float = 0.0
    most_trials: int = 0
    residual: float = 0.0
    losses: int = 0
    work: float = 0.0
    dissipation: float = 0.0
    change: float = 0.0
    error: float = 0.0


@dataclass(frozen=True, eq=False)
class Run:
    """The history of a rolling wheel; arrays have a value at the end of each step.

    Attributes:
        time: Time (s).
        x: Position along the rail (m).
        force: Force between wheel and rail (N).
        wheel: Displacement of the wheel at the contact (m), downwards.
        rail: Deflection of the rail at the contact (m), downwards.
        approach: Approach of the contact (m), negative without contact.
        evidence: Describes the solution. None in the file of a run that did not end.
    """

    time: Array
    x: Array
    force: Array
    wheel: Array
    rail: Array
    approach: Array
    evidence: Evidence | None = None

    @property
    def rate(self) -> float:
        """Steps per second (Hz)."""
        return (len(self.time) - 1) / float(self.time[-1] - self.time[0])


class Output:
    """Receives the blocks of a run: keeps them in memory, or appends them to a file (bounded memory)."""

    def __init__(self, path: str | os.PathLike[str] | None) -> None:
        self._blocks: list[Array] = []
        self._file: IO[str] | None = None
        if path is not None:
            place = Path(path)
            if not can_be_written_over(place):
                raise invalid("path", f"= {str(place)!r}: this file was written by another program. Give another path, or remove the file.")
            self._file = place.open("w", encoding="ascii", newline="\n")
            self._file.write(f"# {written_by()}: {_KIND}\n{_HEADING}\n")
            self._file.flush()

    def add(self, block: Array) -> None:
        """Adds rows [step, column]."""
        if self._file is None:
            self._blocks.append(block)
            return
        for row in block:
            self._file.write(_ROW.format(*row.tolist()))
        self._file.flush()

    def end(self, evidence: Evidence) -> Run:
        """Returns the run; its arrays are empty if it is in a file."""
        if self._file is not None:
            self._file.write(f"{_END}{json.dumps(asdict(evidence))}\n")
        rows = np.concatenate(self._blocks) if self._blocks else np.empty((0, len(COLUMNS)))
        return _run_of(rows, evidence)

    def __enter__(self) -> Output:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None) -> None:
        if self._file is not None:
            self._file.close()


def read_run(path: str | os.PathLike[str]) -> Run:
    """Reads the file of a run, also of one that was killed: an unfinished last line is left out.

    Raises SavedFileError for other files, and OSError if it cannot be read.
    """
    lines = read_whole(path, _MOST_BYTES).decode("ascii", "replace").split("\n")
    if len(lines) < 2 or not lines[0].endswith(_KIND) or lines[1] != _HEADING:
        raise SavedFileError(f"{os.fspath(path)} is not a run written by contactd.track.")
    rows, evidence = [], None
    for number, line in enumerate(lines[2:-1], 3):  # What follows the last line feed is unfinished.
        if line.startswith(_END):
            evidence = _evidence(line[len(_END) :])
            continue
        with contextlib.suppress(ValueError):
            values = [float(word) for word in line.split(",")]
            if len(values) == len(COLUMNS):
                rows.append(values)
                continue
        raise SavedFileError(f"{os.fspath(path)}, line {number}: expected {len(COLUMNS)} numbers. The file is damaged.")
    return _run_of(np.array(rows, dtype=np.float64).reshape(-1, len(COLUMNS)), evidence)


def _run_of(rows: Array, evidence: Evidence | None) -> Run:
    columns: dict[str, Array] = dict(zip(COLUMNS, np.ascontiguousarray(rows.T)))
    return Run(**columns, evidence=evidence)


def _evidence(text: str) -> Evidence | None:
    try:
        given = json.loads(text)
        return Evidence(**{field.name: given[field.name] for field in fields(Evidence)})
    except (ValueError, TypeError, KeyError):
        return None

