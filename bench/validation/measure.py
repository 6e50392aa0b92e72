"""Computes the cases of a file as `contactctl contact run` does, and measures the time."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import contactd
from contactctl.cases.files import CaseFiles
from contactd import contact_files
from contactd.contact_files.answers.compared import Compared
from contactd.contact_files.case import Case
from contactd.contact_files.out_file import lines_of, out_text
from contactd.contact_files.profile_files import ProfileFiles
from contactd.contact_files.runner import Outcome, Runner, chains_of
from contactd.values.generated.wheel_rail.setup import WheelSurface

__all__ = ["WORKERS", "Computed", "Run", "compute"]

WORKERS = 2


@dataclass(frozen=True)
class Computed:
    """The result of a case. Without numbers it was not computed."""

    case: Case
    status: str
    sentence: str
    seconds: float
    numbers: Compared | None


@dataclass(frozen=True)
class Run:
    """All cases of a file in their order.

    Attributes:
        cases: Their results.
        seconds: Time of reading, computing and writing them (s).
        load: Number of processors used by other programs in that time.
    """

    cases: list[Computed]
    seconds: float
    load: float = 0.0


def compute(file: Path, wheel: WheelSurface) -> Run:
    """Computes the cases of a file on WORKERS workers of this process. Their output goes to a temporary folder."""
    with contactd.local(config={"workers": WORKERS}) as client, tempfile.TemporaryDirectory() as folder:
        began, others = time.monotonic(), _of_others()
        cases = contact_files.read(file, client).cases
        runner = Runner(client, ProfileFiles(file.parent, client), wheel)
        written = CaseFiles(Path(folder) / "cases.out")

        def run(chain: Sequence[Case]) -> list[tuple[Computed, list[str]]]:
            return [_kept(outcome, written) for outcome in runner.run(chain)]

        with ThreadPoolExecutor(WORKERS) as pool:
            found = {id(one.case): (one, lines) for chain in pool.map(run, chains_of(cases)) for one, lines in chain}
        ordered = [found[id(case)] for case in cases]
        (Path(folder) / "cases.out").write_text(out_text(lines for _, lines in ordered))
        seconds = time.monotonic() - began
        return Run([one for one, _ in ordered], seconds, max(0.0, (_of_others() - others) / seconds))


def _of_others() -> float:
    """Returns the processor time used by all other programs since the start of the machine (s)."""
    user, nice, system, _idle, _waiting, *interrupts = map(
        int, Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:9]
    )
    own = os.times()
    return (user + nice + system + sum(interrupts)) / os.sysconf("SC_CLK_TCK") - own.user - own.system


def _kept(outcome: Outcome, written: CaseFiles) -> tuple[Computed, list[str]]:
    written.keep(outcome)
    numbers = None if outcome.result is None else outcome.result.compared
    computed = Computed(outcome.case, outcome.status, outcome.sentence, outcome.seconds, numbers)
    return computed, lines_of(outcome)
