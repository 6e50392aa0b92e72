"""Separates the sources of the errors on 160 x 160: block, mesh, sampling, and the halves of the problem."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..finding import Found, Rows, at, markdown
from ..rows import Row
from .cases import CHOSEN_L, FINEST
from .finding import error, on, signed, size

_QUANTITIES = ("Fz", "pmax", "Fx")
_MESHES = {"mesh1": "Mesh1, L = 1024", "mesh2": "Mesh2, L = 128"}


def _errors(rows: Sequence[Row], curve: str) -> dict[str, float]:
    row = on(rows, curve, FINEST)
    return {quantity: error(row, quantity) for quantity in _QUANTITIES}


def _less(a: Mapping[str, float], b: Mapping[str, float]) -> dict[str, float]:
    return {quantity: a[quantity] - b[quantity] for quantity in _QUANTITIES}


def shares(rows: Rows, mesh: str) -> dict[str, dict[str, float]]:
    """Returns the contribution of each source: the difference of two solutions that differ only in that source."""
    checks = rows["sources"]
    function = _errors(checks, f"{mesh}, fem")
    far = _errors(checks, f"{mesh}, half_space, fem")
    contact = _errors(rows["fig12"], "analytic")
    return {
        "contact grid (analytic ICs)": contact,
        "finite-element mesh": _less(far, contact),
        "block, u = 0": _less(function, far),
        "reading between nodes": _less(_errors(checks, f"{mesh}, linear_nodes"), function),
        "sum: the paper's way": _errors(checks, f"{mesh}, linear_nodes"),
        "reading between vertices instead of nodes": _less(
            _errors(checks, f"{mesh}, linear"), _errors(checks, f"{mesh}, linear_nodes")
        ),
    }  # fmt: skip


def _shares_table(rows: Rows) -> str:
    found = {mesh: shares(rows, mesh) for mesh in CHOSEN_L}
    head = ["", *(f"{name}: {quantity}" for name in _MESHES.values() for quantity in _QUANTITIES)]
    body = [
        [source, *(signed(found[mesh][source][quantity]) for mesh in _MESHES for quantity in _QUANTITIES)]
        for source in found["mesh1"]
    ]
    return markdown(head, body)


#: Possible explanations of the paper's Fx, and their descriptions.
_WAYS = {
    "linear_nodes": "read between nodes (the paper)",
    "fem": "read from the function",
    "linear": "read between vertices",
    "half_space, linear_nodes": "half-space on the far faces, read between nodes",
    "half_space, fem": "half-space on the far faces, read from the function",
    "update": "as the first, CG stopped at an update of 1e-6",
    "no xy, linear_nodes": "as the first, A^xy and A^yx left out",
    "zz alone, linear_nodes": "A^zz as the first, the others exact",
    "tangential alone, linear_nodes": "A^zz exact, the others as the first",
    "linear_nodes, tangential linear": "A^zz between nodes, the others between vertices",
    "fem, tangential linear_nodes": "A^zz from the function, the others between nodes",
    "fem, tangential linear": "A^zz from the function, the others between vertices",
}


def _ways_table(rows: Rows) -> str:
    head = ["160 × 160", *(f"{name}: {quantity}" for name in _MESHES.values() for quantity in ("Fz", "Fx"))]
    body = [["**the paper**", "about 0.1 %", "about 0.03 %", "about 0.8 %", "0.17 %"]]
    for way, words in _WAYS.items():
        points = [on(rows["sources"], f"{mesh}, {way}", FINEST) for mesh in _MESHES]
        body.append([words, *(signed(error(row, quantity)) for row in points for quantity in ("Fz", "Fx"))])
    for sampling, words in (("linear_nodes", "read between nodes"), ("fem", "read from the function")):
        row = on(rows["sources"], f"mesh2, across, {sampling}", FINEST)
        body.append([f"the other diagonals, {words}", "", "", signed(error(row, "Fz")), signed(error(row, "Fx"))])
    return markdown(head, body)


def sources(rows: Rows) -> Found:
    checks = rows["sources"]
    block = {mesh: shares(rows, mesh)["block, u = 0"] for mesh in CHOSEN_L}
    reading = {mesh: shares(rows, mesh)["reading between nodes"] for mesh in CHOSEN_L}
    alone = {
        (mesh, half): on(checks, f"{mesh}, {half} alone, linear_nodes", FINEST)
        for mesh in CHOSEN_L for half in ("zz", "tangential")
    }  # fmt: skip
    coarse = {mesh: on(checks, f"{mesh}, linear_nodes, tangential linear", FINEST) for mesh in CHOSEN_L}
    changes = [
        abs(change) for mesh in CHOSEN_L
        for change in _less(_errors(checks, f"{mesh}, update"), _errors(checks, f"{mesh}, linear_nodes")).values()
    ]  # fmt: skip
    values = {
        "shares_table": _shares_table(rows),
        "ways_table": _ways_table(rows),
        **{f"block_{mesh}_{name}": signed(found[name]) for mesh, found in block.items() for name in ("Fz", "Fx")},
        **{f"reading_{mesh}_Fx": signed(found["Fx"]) for mesh, found in reading.items()},
        **{f"block_ratio_{mesh}": f"{found['Fx'] / found['Fz']:.2f}" for mesh, found in block.items()},
        **{f"{half}_alone_{mesh}": signed(error(row, "Fx")) for (mesh, half), row in alone.items()},
        **{f"coarse_{mesh}": signed(error(row, "Fx")) for mesh, row in coarse.items()},
        "block_growth": f"{block['mesh2']['Fz'] / block['mesh1']['Fz']:.1f}",
        "needed": signed(0.0017 - error(alone["mesh2", "zz"], "Fx")),
        **{f"mesh2_256_{name}": signed(error(at(rows["fig13"], "mesh2 160x160", 256), name)) for name in ("Fz", "Fx")},
        "update_change": f"{max(changes):.0e}",
    }
    sizes = [[size(on(checks, f"{mesh}, {way}", FINEST), "Fx") for mesh in CHOSEN_L] for way in _WAYS]
    explained = any(abs(one - 3e-4) < 1.5e-4 and abs(two - 1.7e-3) < 3e-4 for one, two in sizes)
    return values, {"fx_explained": explained}
