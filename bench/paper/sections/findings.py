"""Computes values and verdicts of the page from the rows."""

from __future__ import annotations

from collections.abc import Sequence

from ..finding import Found, PointMissing, Rows, markdown, merge, percent
from ..rows import Row, select
from . import findings_checks as checks
from .findings_propagation import propagation

MU_FZ = 0.3 * 80e3  # N
CORNER, BOTH_ENDS = 6.5, 6.75  # shifts (mm) with contact in the corner, and their extremes


def more(rows: Sequence[Row], quantity: str, curve: str, reference: str) -> list[tuple[float, float]]:
    """Returns the relative excess of a curve over another one, at each common parameter."""
    known = {row["value"]: row[quantity] for row in select(rows, curve=reference)}
    return [
        (row["value"], row[quantity] / known[row["value"]] - 1)
        for row in select(rows, curve=curve)
        if known.get(row["value"])
    ]


def signed(value: float) -> str:
    return f"{100 * value:+.1f} %".replace("-", "−")


def at(pairs: Sequence[tuple[float, float]], value: float) -> float:
    for x, y in pairs:
        if x == value:
            return y
    raise PointMissing(f"{value:g}")


def edges(rows: Rows) -> Found:
    points = {quantity: more(rows["edges"], quantity, "block", "half-space") for quantity in ("pmax", "approach")}
    body = [[f"{d:g} mm", signed(y), signed(at(points["approach"], d))] for d, y in points["pmax"]]
    pmax = dict(points["pmax"])
    return {"edges": markdown(["from the edge", "largest pressure", "approach"], body)}, {
        "edge_matters": at(points["pmax"], 0.5) < -0.1,
        "edge_far": abs(at(points["pmax"], 3)) < 0.01,
        "edge_approach": all(y > abs(pmax[d]) for d, y in points["approach"]),
    }


def creep_forces(rows: Sequence[Row], way: str) -> list[tuple[float, float]]:
    """Returns the difference of Fx from that with sections, over mu Fz."""
    known = {row["value"]: row["Fx"] for row in select(rows, curve="fem")}
    points = select(rows, curve=way)
    return [(row["value"], (row["Fx"] - known[row["value"]]) / MU_FZ) for row in points if row["value"] in known]


def throat(rows: Rows) -> Found:
    ways = ("off", "half_space", "rotated")
    pmax = {way: more(rows["throat"], "pmax", way, "fem") for way in ways}
    force = {way: creep_forces(rows["throat"], way) for way in ways}
    body = [
        [f"{y:g} mm", *(signed(at(pmax[way], y)) for way in ways), *(signed(at(force[way], y)) for way in ways)]
        for y, _ in pmax["rotated"]
    ]
    head = ["shift", *(f"pmax, {way}" for way in ways), *(f"Fx, {way}" for way in ways)]
    smooth = {way: max(abs(y) for shift, y in pmax[way] if shift <= CORNER) for way in ways}
    corner = {way: abs(at(pmax[way], CORNER)) for way in ways}
    return {
        "throat": markdown(head, body),
        "smooth_rotated": percent(smooth["rotated"]),
        **{f"corner_{way}": percent(value) for way, value in corner.items()},
        "both_ends": percent(at(pmax["rotated"], BOTH_ENDS)),
    }, {
        "rotated_enough": smooth["rotated"] < 0.02,
        "frames_most": corner["rotated"] < corner["half_space"] < corner["off"],
        "approach_decides": min(abs(at(pmax[way], BOTH_ENDS)) for way in ways) > 0.1,
    }


def _stated_and_found(row: Row) -> str:
    found = f"{row['found']:.1e}" if row["finest_asked"] < row["value"] else "(reference)"
    return f"{row['stated']:.1e} / {found}"


def tables(rows: Rows) -> Found:
    names = list(dict.fromkeys(str(row["curve"]) for row in rows["tables"]))
    body = []
    for name in names:
        points = {row["value"]: row for row in select(rows["tables"], curve=name)}
        one = points[1e-3]
        body.append(
            [name, *(_stated_and_found(points[a]) for a in (1e-2, 1e-3)),
             f"{one['reciprocity']:.1e}", f"{one['finest_asked']:g}: {one['finest']:.1e}", f"{one['seconds']:.1f}"]
        )  # fmt: skip
    bounds = all(row["found"] <= row["stated"] + row["finest"] for row in rows["tables"])
    # Strips beside an edge have an error that no mesh reduces; it is stated in addition to the accuracy.
    within = all(row["stated"] - row["reciprocity"] <= row["value"] for row in rows["tables"])
    head = ["body", "1e-2: stated / found", "1e-3: stated / found", "of which reciprocity", "the finest: stated",
            "processor seconds for 1e-3"]  # fmt: skip
    seconds = [row["seconds"] for row in rows["tables"] if row["value"] == 1e-3]
    values = {
        "tables": markdown(head, body),
        "tables_seconds": f"{min(seconds):.1f} to {max(seconds):.1f}",
        "tables_preset": " and ".join(sorted({str(row["preset"]) for row in rows["tables"]})),
    }
    return values, {"stated_bounds": bounds, "stated_within": within}


def find(rows: Rows) -> Found:
    return merge(function(rows) for function in (edges, throat, tables, checks.persson, checks.groove, propagation, checks.solid))
