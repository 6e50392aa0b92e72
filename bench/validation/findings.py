"""Computes the texts of the page from the rows of both CSV files."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence

from paper.finding import Found, markdown
from paper.rows import Row

from .figures import has_numbers
from .quantities import QUANTITIES
from .reasons import REASONS, Reason
from .table import is_case

__all__ = ["find", "ratio"]

_MISSING = "contactd does not have: "
_BETWEEN = re.compile(r", (?![^(]*\))")  #: features whose parentheses contain commas
_NONE = "–"
_FINE = 5e-4 / 4e-3  #: of the tolerance of largest pressures


def find(cases: Sequence[Row], times: Sequence[Row], folder: str) -> Found:
    """Returns texts and verdicts of the page, which is next to the folder with tables and pictures."""
    whole = [row for row in cases if is_case(row)]
    counts = Counter(row["status"] for row in whole)
    open_ones = [row for row in whole if row["status"] == "differs" and not row["reason"]]
    shown = {reason.name for reason in REASONS if reason.shown}
    values = {
        "cases": str(len(whole)), "computed": str(counts["agrees"] + counts["differs"]), "agree": str(counts["agrees"]),
        "differ": str(counts["differs"]), "not_computed": str(len(whole) - counts["agrees"] - counts["differs"]),
        "families": _families(cases, times), "pictures": _pictures(cases, folder), "folder": folder, "reasons": _reasons(cases),
        "unexplained": _listed("Differences without a reason", open_ones), "missing": _missing(whole),
        "not_shown": str(sum(row["status"] == "differs" and row["reason"] not in shown for row in whole)),
        **_on_wheels(cases), "ratio": _ratio_text(ratio(times)), "ratio_whole": _ratio_text(ratio(_entirely_computed(times))),
        "version": ", ".join(sorted({str(row["version"]) for row in times})),
        "machine": _machine(times),
    }  # fmt: skip
    return values, {"explained": not open_ones}


def ratio(times: Sequence[Row]) -> float | None:
    """Returns our time over the printed one. If some cases of a file were not computed, its printed time is multiplied
    by the share of those that were, because there are no printed times of single cases."""
    timed = [row for row in times if row["printed_seconds"] != "" and row["computed"]]
    printed = sum(row["printed_seconds"] * row["computed"] / row["cases"] for row in timed)
    return sum(row["seconds"] for row in timed) / printed if printed else None


def _entirely_computed(times: Sequence[Row]) -> list[Row]:
    return [row for row in times if row["computed"] == row["cases"]]


def _ratio_text(value: float | None) -> str:
    return _NONE if value is None else f"1/{1 / value:.1f}" if value < 1 else f"{value:.1f}"


def _names(rows: Iterable[Row]) -> list[str]:
    return list(dict.fromkeys(str(row["family"]) for row in rows))


def _families(cases: Sequence[Row], times: Sequence[Row]) -> str:
    lines = []
    for name in _names(cases):
        rows, timed = [row for row in cases if row["family"] == name], [row for row in times if row["family"] == name]
        lines.append(
            [f"`{name}`", *_counts([row for row in rows if is_case(row)]), _largest(rows), _ratio_text(ratio(timed))]
        )
    total = [row for row in cases if is_case(row)]
    lines.append(["all", *_counts(total), "", _ratio_text(ratio(times))])
    return markdown(
        [
            "family",
            "cases",
            "agree",
            "differ",
            "not computed",
            "largest difference over tolerance",
            "contactd's time / printed",
        ],
        lines,
    )


def _counts(whole: Sequence[Row]) -> list[str]:
    counts = Counter(row["status"] for row in whole)
    agree, differ = counts["agrees"], counts["differs"]
    return [str(len(whole)), str(agree), str(differ), str(len(whole) - agree - differ)]


def _largest(rows: Sequence[Row]) -> str:
    """Returns the largest difference over tolerance, with its quantity and case."""
    found = [
        (row[f"{one.name}_over"], one.name, row) for one in QUANTITIES for row in rows if row[f"{one.name}_over"] != ""
    ]
    if not found:
        return _NONE
    over, name, row = max(found, key=lambda one: one[0])
    return f"{_over(over)}: `{name}` of {_case(row)}"


def _over(value: float) -> str:
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def _case(row: Row) -> str:
    return f"`{str(row['file']).rpartition('/')[2].rpartition('.')[0]}` {row['case']:g}"


def _pictures(cases: Sequence[Row], folder: str) -> str:
    blocks = []
    for name in _names(cases):
        rows = [row for row in cases if row["family"] == name]
        if has_numbers(rows):
            blocks.append(f"### {name}\n\n![Differences over tolerance, {name}: by quantity]({folder}/{name}.png)")
    return "\n\n".join(blocks)


def _reasons(cases: Sequence[Row]) -> str:
    lines = []
    for reason in REASONS:
        rows = [row for row in cases if row["reason"] == reason.name]
        if whole := [row for row in rows if is_case(row)]:
            over = [row["over"] for row in rows if row["over"] != ""]
            largest = _over(max(over)) if over else _NONE
            lines.append([reason.what, _where(whole, reason), largest, reason.why, reason.shown or _NONE])
    return markdown(["Kind", "Cases", "Largest difference over tolerance", "Difference and reason", "Evidence"], lines)


def _where(whole: Sequence[Row], reason: Reason) -> str:
    """Returns the cases by file, with their number where they are not a whole range."""
    parts = []
    for file in dict.fromkeys(str(row["file"]) for row in whole):
        numbers = [int(row["case"]) for row in whole if row["file"] == file]
        listed = reason.cases[file]
        few = ", ".join(map(str, numbers))
        name = file.rpartition("/")[2].rpartition(".")[0]
        parts.append(f"`{name}` {few}" if len(numbers) <= 7 else f"{len(numbers)} of {len(listed)} of `{name}`")
    return "; ".join(parts)


def _listed(head: str, rows: Sequence[Row]) -> str:
    if not rows:
        return ""
    lines = [[_case(row), _over(row["over"]), str(row["note"])] for row in rows]
    return "\n" + markdown([head, "Difference over tolerance", "Remark"], lines)


def _missing(whole: Sequence[Row]) -> str:
    """Counts the cases that are not computed, by the missing feature; a case may count for two features."""
    counts: Counter[str] = Counter()
    for row in whole:
        note = str(row["note"])
        if row["status"] == "refused" and note.startswith(_MISSING):
            counts.update(_BETWEEN.split(note.removeprefix(_MISSING).rstrip(".")))
        elif row["status"] == "follows":
            counts["continues from a case that is not computed"] += 1
        elif row["status"] not in ("agrees", "differs"):
            known = [reason.what for reason in REASONS if reason.name == row["reason"]]
            counts[f"{_case(row)}: {(known or [note.rstrip('.')])[0]}"] += 1
    return markdown(["Missing feature", "Cases"], [[name, str(count)] for name, count in counts.most_common()])


def _on_wheels(cases: Sequence[Row]) -> dict[str, str]:
    """Counts the cases of wheels on rails that differ for wheels given as a mesh, and for other wheels. Also counts
    the patches that agree with a largest pressure much closer than required."""
    both = [row for row in cases if row["over_exact"] != ""]
    patches = [row for row in both if not is_case(row) and row["status"] == "agrees"]

    def number(rows: Iterable[Row]) -> str:
        return str(len({(row["file"], row["line"]) for row in rows}))

    return {
        "wheels": number(both), "exact": number(row for row in both if row["over_exact"] > 1),
        "mesh": number(row for row in both if row["over"] > 1), "patches": str(len(patches)),
        "fine": str(sum(row["pmax_over"] <= _FINE for row in patches)),
    }  # fmt: skip


def _machine(times: Sequence[Row]) -> str:
    processors = max((row["processors"] for row in times), default=0)
    seconds = sum(row["seconds"] for row in times)
    load = sum(row["load"] * row["seconds"] for row in times) / seconds if seconds else 0.0
    presets = ", ".join(sorted({str(row["preset"]) for row in times}))
    return f"{processors:g} processors, of which other programs took {load:.1f} meanwhile, preset {presets}"
