"""Checks section 5 of the paper on curved surfaces: errors of coefficients and of contacts. Functions are as in
findings.py."""

from __future__ import annotations

from ..finding import Found, PointMissing, Rows, markdown, percent
from ..rows import Row
from .findings_checks import signed
from .propagation import MESHES

PAPER_MESH = (2, 4)  # order, and edges per strip
TARGET = 0.01  # the paper's (3.1)
ALIKE = 2.0  # values within this factor are called similar
QUANTITIES = {"p0": "largest pressure", "extent": "extent", "approach": "approach"}


def _size(row: Row) -> float:
    """Returns the largest error of the contact over all quantities."""
    return max(abs(float(row[f"{name}_error"])) for name in QUANTITIES)


def _cells(row: Row) -> list[str]:
    return [percent(row["ic_largest"]), *(signed(row[f"{name}_error"], 3) for name in QUANTITIES)]


def propagation(rows: Rows) -> Found:
    def on(body: str, order: int, edges: int) -> Row:
        for row in rows["propagation"]:
            if row["curve"] == f"{body}, order {order}" and row["value"] == edges:
                return row
        raise PointMissing(f"{body}, order {order}, edges {edges}")

    pairs = {mesh: (on("flat", *mesh), on("curved", *mesh)) for mesh in MESHES}
    body = [[f"{order}", f"{edges}", *(cell for row in pair for cell in _cells(row))] for (order, edges), pair in pairs.items()]
    head = ["order", "edges", *(f"{shape}: {words}" for shape in ("flat", "curved")
                                for words in ("coefficients", *QUANTITIES.values()))]  # fmt: skip
    ratios = [two["ic_largest"] / one["ic_largest"] for one, two in pairs.values()]
    shares = {
        shape: [_size(pair[number]) / pair[number]["ic_largest"] for pair in pairs.values()]
        for number, shape in enumerate(("flat", "curved"))
    }
    flat, recommended = pairs[PAPER_MESH]
    values = {
        "propagation": markdown(head, body),
        "propagation_ratios": f"{min(ratios):.2f} to {max(ratios):.2f}",
        **{f"propagation_{shape}": f"{min(found):.2f} to {max(found):.2f}" for shape, found in shares.items()},
        "propagation_paper_ics": percent(recommended["ic_largest"]),
        "propagation_paper_contact": percent(_size(recommended)),
        "propagation_flat_end": percent(flat["finest_error"]),
        "propagation_curved_end": percent(recommended["finest_error"]),
    }
    return values, {
        "propagation_ics": all(1 / ALIKE < ratio < ALIKE for ratio in ratios),
        "propagation_contact": max(shares["curved"]) < ALIKE * max(1.0, *shares["flat"]),
        "propagation_paper": max(recommended["ic_largest"], _size(recommended)) < TARGET,
    }
