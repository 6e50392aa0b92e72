"""One row of a CSV file. What a part does not have is empty there."""

from __future__ import annotations

from typing import Any

from ..rows import Row
from .cases import Case

RESULTS = ["pmax", "approach", "Fx", "Fy", "stated", "found", "finest", "seconds"]
COLUMNS = ["curve", "parameter", "value", *RESULTS]


def row(case: Case, result: dict[str, Any]) -> Row:
    return {
        "curve": case.curve,
        "parameter": case.parameter,
        "value": case.value,
        **{name: result[name] for name in RESULTS if name in result},
    }
