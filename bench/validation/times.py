"""Makes times.csv: a row for each file, with the time printed by the CONTACT program, and ours."""

from __future__ import annotations

import os

import contactd
from pages import provenance
from paper.rows import Row

from .given import GivenFile
from .measure import Run

__all__ = ["COLUMNS", "row_of"]

COLUMNS = (
    "family", "file", "cases", "computed", "printed_seconds", "seconds", "exact_seconds", "processors", "load", "preset", "version", "commit", "machine",
)  # fmt: skip


def row_of(file: GivenFile, run: Run, exact: Run | None, preset: str) -> Row:
    """Returns the row of a file. `preset` is that of the build."""
    printed = file.printed_seconds()
    return {
        "family": file.family, "file": file.name, "cases": len(run.cases),
        "computed": sum(one.numbers is not None for one in run.cases),
        "printed_seconds": "" if printed is None else f"{printed:g}", "seconds": f"{run.seconds:.3g}",
        "exact_seconds": "" if exact is None else f"{exact.seconds:.3g}",
        "processors": os.cpu_count() or 1, "load": f"{run.load:.2f}", "preset": preset, "version": contactd.__version__,
        **{name: value for name, value in provenance().items() if name in COLUMNS},
    }  # fmt: skip
