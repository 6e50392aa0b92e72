"""Evaluates comparisons with a closed form, a prototype, and three dimensions."""

from __future__ import annotations

from ..finding import Found, Rows, markdown, percent
from ..rows import Row, select


def signed(value: float, digits: int = 2) -> str:
    return f"{100 * value:+.{digits}f} %".replace("-", "−")


def persson(rows: Rows) -> Found:
    points = [
        (row["value"], row["p0"], row["p0"] / row["p0_exact"] - 1, row["half_angle"] / row["value"] - 1)
        for row in rows["persson"]
    ]
    body = [[f"{a:g}°", f"{p0:.4f}", signed(p), signed(angle)] for a, p0, p, angle in points]
    head = ["half angle", "largest pressure p R/Q", "its error", "error of the half angle"]
    pressures, angles = ([abs(point[i]) for point in points] for i in (2, 3))
    return {
        "persson": markdown(head, body),
        "persson_pressure": percent(max(pressures)),
        "persson_angle": percent(max(angles)),
    }, {"persson_pressures": max(pressures) <= 5e-3, "persson_angles": max(angles) <= 1e-2}


#: Relative differences to an independent prototype: of the largest pressure, over that of finite elements, and of the
#: approach, over that of rotated half-spaces. The prototype's roller has another curvature along x.
GROOVE_PROTOTYPE = {10.25: (0.0064, 0.033), 10.1: (0.0093, 0.037), 10.05: (0.0129, 0.042), 10.02: (0.0210, 0.046)}


def groove(rows: Rows) -> Found:
    by_body = {
        body: {row["value"]: row for row in select(rows["groove"], curve=body)}
        for body in ("half_space", "rotated", "sections")
    }
    points = []
    for radius, row in by_body["sections"].items():
        frames, rotated = (by_body[body][radius]["pmax"] / row["pmax"] - 1 for body in ("half_space", "rotated"))
        points.append((radius, row["pmax"], frames, rotated, row["approach"] / by_body["rotated"][radius]["approach"] - 1))
    body = [[f"R{r:g}", f"{pmax:.1f}", signed(f), signed(t), signed(a)] for r, pmax, f, t, a in points]
    head = ["groove", "largest pressure", "half-spaces with frames", "rotated", "approach over rotated"]
    off = max(abs(frames - GROOVE_PROTOTYPE[radius][0]) for radius, _, frames, _, _ in points)
    return {
        "groove": markdown(head, body),
        "groove_off": percent(off),
        "groove_rotated": percent(max(abs(point[3]) for point in points)),
    }, {
        "groove_prototype": off < 5e-3,
        "groove_rotated_enough": all(abs(rotated) < 5e-3 for _, _, _, rotated, _ in points),
        "groove_approach": all(0.02 < approach < 0.06 for *_, approach in points),
    }


def a_load(row: Row) -> float:
    """Returns processor seconds of the preconditioner's setup and the iterations; `seconds` are wall-clock time."""
    solving = row["setup_seconds"] + row["solve_seconds"]
    return float(row["seconds"] * solving / (solving + row["assembly_seconds"]) / row["loads"])


def solid_seconds(row: Row) -> float:
    """Scales by the number of strips of the transform: with their loads, and the unknowns of their mesh."""
    return float(a_load(row) * row["many_loads"] * row["many_dofs"] / row["dofs"])


def solid(rows: Rows) -> Found:
    points = rows["solid"]
    paper = [row for row in points if row["iterations"] > 0]  # by the paper's solver; the others by factorisation
    body = [
        [
            f"{row['value']:g}",
            f"{row['dofs']:.0f}",
            f"{row['iterations'] / row['loads']:.0f}" if row in paper else "a factor",
            f"{row['found']:.1e}",
            f"{a_load(row):.2g} s",
            f"{row['many_dofs']:.0f}",
            *([f"{solid_seconds(row) / 60:.0f} min", f"{solid_seconds(row) / row['transform_seconds']:.0f}"]
              if row in paper else ["", ""]),
        ]
        for row in points
    ]  # fmt: skip
    head = ["order", "unknowns", "iterations", "difference", "a load takes", "unknowns of 80 strips", "which take", "over the transform's"]
    found = [row["found"] for row in points]
    last = paper[-1]
    return {
        "solid": markdown(head, body),
        "solid_found": f"{found[-1]:.1e}",
        "solid_stated": f"{last['stated']:.1e}",
        "transform_seconds": f"{last['transform_seconds']:.1f}",
        "solid_ratio": f"{solid_seconds(last) / last['transform_seconds']:.0f}",
    }, {
        "solid_converges": all(later < 0.5 * earlier for earlier, later in zip(found, found[1:], strict=False)),
        "solid_meets": found[-1] <= last["stated"] + (found[-2] - found[-1]) / 2,
        "solid_dear": solid_seconds(last) >= 100 * last["transform_seconds"],
    }
