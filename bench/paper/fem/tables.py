"""Makes the page's tables, and findings beyond the paper: accuracy against time, and adaptive refinement."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from ..finding import at, markdown
from ..rows import Row, select
from .cases import COMPARED, H
from .diagrams import ACCURACY, ADAPTIVE, table_error
from .recommended import ranges

GOALS = (1e-2, 1e-3)


def ranges_table(scans: Sequence[Row]) -> str:
    names = {"L_over_h": "L/h", "l_over_h": "l/h", "h_over_hs": "h/hs", "f": "f"}
    meshes = {"hex": "Mesh1", "prism": "Mesh2"}
    body = []
    for row in ranges(scans):
        where = "" if row["L_over_h"] == "scanned" else f", L/h = {row['L_over_h']}"
        paper = row["paper"].replace("<=", "≤").replace(">=", "≥")
        cells = [meshes[row["mesh"]] + where, names[row["parameter"]], paper, row["within"] or "none"]
        body.append([*cells, row["outside"] or "none"])
    return markdown(["", "", "paper", "under 1 %", "over 1 %"], body)


def origin_error(row: Row) -> float:
    return abs(float(row["origin_zz"]))


def cheapest(points: Sequence[Row], goal: float, error: Callable[[Row], float] = table_error) -> Row | None:
    good = [row for row in points if error(row) <= goal]
    return min(good, key=lambda row: row["cpu_seconds"]) if good else None


def _cost(row: Row | None) -> str:
    return f"{row['cpu_seconds']:.2g} s, {row['dofs']:.0f}" if row else "not reached"


def _smaller(row: Row | None, other: Row | None, column: str) -> bool:
    return row is not None and other is not None and bool(row[column] < other[column])


def cost_table(rows: Sequence[Row]) -> str:
    """Returns CPU time and unknowns of the cheapest sufficient point of each curve."""
    head = ["method", *(f"{100 * goal:g} % over {n} × {n}" for n in COMPARED for goal in GOALS)]
    body, failed = [], []
    for curve, look in ACCURACY.items():
        points, name = select(rows, curve=curve), look.label.replace("$", "")
        found = [cheapest(select(points, table=n), goal) for n in COMPARED for goal in GOALS]
        if any(found):
            body.append([name, *map(_cost, found)])
        else:
            failed.append(name)
    return markdown(head, body) + "\n\nNone of them is reached by: " + "; ".join(failed or ["(all reach one)"]) + "."


#: Criteria for meshes in the comparison: far faces, error, goal, and their description.
ADAPTIVE_GOALS: tuple[tuple[str, Callable[[Row], float], float, str], ...] = (
    ("clamped", origin_error, 3e-3, "zz at the origin within 0.3 %, u = 0 at L = 1024"),
    ("half_space", table_error, 1e-2, "zz and xx over 10 × 10 within 1 %, half-space"),
    ("half_space", table_error, 2e-3, "the same within 0.2 %"),
)


def adaptive_goals(rows: Sequence[Row]) -> dict[str, list[Row | None]]:
    """Returns the cheapest point of each mesh for each goal."""
    return {
        mesh: [cheapest(select(rows, curve=f"{mesh}, {far}"), goal, error) for far, error, goal, _ in ADAPTIVE_GOALS]
        for mesh in ADAPTIVE
    }


def adaptive_goals_table(rows: Sequence[Row]) -> str:
    head = ["mesh", *(words for *_, words in ADAPTIVE_GOALS)]
    body = [
        [ADAPTIVE[mesh].label.split(",")[0], *map(_cost, found)] for mesh, found in adaptive_goals(rows).items()
    ]  # fmt: skip
    return markdown(head, body)


def beyond(rows: Mapping[str, Sequence[Row]]) -> tuple[dict[str, str], dict[str, bool]]:
    own = at(rows["fig6"], "test3", 1024)
    asked = {(row["value"], row["table"]): row for row in select(rows["accuracy"], curve="accuracy")}
    times = {value: asked[value, 40]["cpu_seconds"] / own["cpu_seconds"] for value in (1e-2, 1e-3, 1e-4)}
    clamped_rows = [row for row in rows["accuracy"] if row["curve"].endswith("clamped")]
    clamped = {n: min(map(table_error, select(clamped_rows, table=n))) for n in COMPARED}
    found = adaptive_goals(rows["adaptive"])
    pairs = list(zip(found["adaptive"], found["hex"], strict=True))
    values = {
        "cost_table": cost_table(rows["accuracy"]),
        **{f"clamped_best_{n}": f"{100 * error:.2g} %" for n, error in clamped.items()},
        **{f"clamped_reach_{n}": f"{max(row['L'] for row in clamped_rows) / (n * H):.0f}" for n in COMPARED},
        "own_cpu": f"{own['cpu_seconds']:.2g}",
        "accuracy_2": f"{times[1e-2]:#.2g}",
        "accuracy_3": f"{times[1e-3]:#.2g}",
        "accuracy_4": f"{times[1e-4]:#.2g}",
        "accuracy_3_error": f"{100 * table_error(asked[1e-3, 40]):.2g} %",
        "accuracy_4_error": f"{100 * table_error(asked[1e-4, 40]):.2g} %",
        "accuracy_2_dofs": f"{asked[1e-2, 10]['dofs']:.0f}",
        "accuracy_2_error": f"{100 * table_error(asked[1e-2, 10]):.2g} %",
        "adaptive_goals_table": adaptive_goals_table(rows["adaptive"]),
    }
    verdicts = {
        "adaptive_origin": _smaller(*pairs[0], "dofs") and _smaller(*pairs[0], "cpu_seconds"),
        "adaptive_coarse": _smaller(*pairs[1], "dofs"),
        "adaptive_fine": _smaller(*pairs[2], "dofs") or _smaller(*pairs[2], "cpu_seconds"),
    }
    return values, verdicts
