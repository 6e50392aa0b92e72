"""Makes cases.csv: a row for each case, and for wheels on rails also one for each patch, with printed numbers, ours,
and the difference over the tolerance."""

from __future__ import annotations

from contactd.contact_files.comparison import Compared, Difference, common
from contactd.contact_files.out_reader import PrintedCase
from paper.rows import Row

from .given import GivenFile
from .measure import Computed
from .quantities import QUANTITIES, by_quantity
from .reasons import reason_of

__all__ = ["COLUMNS", "is_case", "rows_of"]

COLUMNS = (
    "family", "file", "case", "line", "module", "patch", "status", "reason", "seconds", "over", "over_exact", "note",
    *(f"{quantity.name}{column}" for quantity in QUANTITIES for column in ("_printed", "", "_over")),
)  # fmt: skip

_Numbers = dict[str, Difference]


def rows_of(file: GivenFile, computed: Computed, printed: PrintedCase, exact: Computed | None) -> list[Row]:
    """Returns the rows of a case. `exact` is the same case on a wheel without a mesh, or None."""
    case = computed.case
    head: Row = {
        "family": file.family,
        "file": file.name,
        "case": case.number,
        "line": case.line,
        "module": case.module,
    }
    if computed.numbers is None:
        reason = reason_of(file.name, case.number) if computed.status == "failed" else None
        return [{**head, "status": computed.status, "reason": reason.name if reason else "", "note": computed.sentence}]
    blocks = _blocks(computed.numbers, printed)
    others = _blocks(exact.numbers, printed) if exact is not None and exact.numbers is not None else []
    note = _note(computed, printed)
    is_met = not _other_patches(computed.numbers, printed) and all(
        one.is_in_tolerance for block in blocks for one in block.values()
    )
    reason = None if is_met else reason_of(file.name, case.number)
    head |= {"status": "agrees" if is_met else "differs", "reason": reason.name if reason else ""}
    rows = [{**head, **_columns(block)} for block in blocks]
    rows[0] |= {"seconds": f"{computed.seconds:.3g}", "note": note}
    for row, block in zip(rows, others):
        row["over_exact"] = _largest(block)
    for patch, row in enumerate(rows[1:], 1):
        row["patch"] = patch
    return rows


def is_case(row: Row) -> bool:
    """Returns whether the row is that of a whole case, not of one of its patches."""
    return row["patch"] == ""


def _blocks(found: Compared, printed: PrintedCase) -> list[_Numbers]:
    """Returns the numbers of the whole case, and of each patch if both programs have the same number of patches."""
    blocks = [by_quantity(common(found.numbers, printed.numbers, found.bound))]
    if not _other_patches(found, printed):
        together = zip(found.patches, printed.patches, found.bounds)
        blocks += [by_quantity(common(ours, theirs, bound)) for ours, theirs, bound in together]
    return blocks


def _other_patches(found: Compared, printed: PrintedCase) -> bool:
    return len(found.patches) != len(printed.patches)


def _note(computed: Computed, printed: PrintedCase) -> str:
    assert computed.numbers is not None
    number = len(computed.numbers.patches)
    patches = f"{number} patches, printed {len(printed.patches)}." if _other_patches(computed.numbers, printed) else ""
    return f"{computed.sentence} {patches}".strip()


def _columns(block: _Numbers) -> Row:
    row: Row = {"over": _largest(block)}
    for name, one in block.items():
        row |= {f"{name}_printed": f"{one.printed:.8g}", name: f"{one.found:.7g}", f"{name}_over": f"{one.share:.3g}"}
    return row


def _largest(block: _Numbers) -> str:
    return f"{max(one.share for one in block.values()):.3g}" if block else ""
