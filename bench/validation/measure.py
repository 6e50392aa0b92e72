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
from contactd.contact_files.case import Case
from contactd.contact_files.comparison import Compared
from contactd.contact_files.input_file import name_and_text
from contactd.contact_files.named_files import NamedFiles
from contactd.contact_files.out_file import lines_of, out_text
from contactd.contact_files.runner import Runner, chains_of, requests_of
from contactd.contact_files.solved_case import SolvedCase
from contactd.values.generated.wheel_rail.setup import WheelSurface

__all__ = ["WORKERS", "Computed", "Run", "compute"]

WORKERS = 2


@dataclass(frozen=True)
class Computed:
    """Holds the result of a case. Without numbers it was not computed."""

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
        name, text = name_and_text(file)
        cases = client.read_contact_file(text, name=name).cases
        runner = Runner(client, text, cases, NamedFiles(file.parent), wheel, name=name, fields=[])
        written = CaseFiles(Path(folder) / "cases.out")

        def run(some: Sequence[Case]) -> list[tuple[Computed, list[str]]]:
            return [_kept(solved, written) for solved in runner.run(some)]

        requests = requests_of(chains_of(cases), text)
        with ThreadPoolExecutor(WORKERS) as pool:
            found = {id(one.case): (one, lines) for some in pool.map(run, requests) for one, lines in some}
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


def _kept(solved: SolvedCase, written: CaseFiles) -> tuple[Computed, list[str]]:
    written.keep(solved)
    computed = Computed(solved.case, solved.status, solved.sentence, solved.answer.seconds, solved.compared)
    return computed, lines_of(solved)
