"""Checks section 3.4 of the paper with our numbers. Functions are as in findings.py."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..finding import Found, Rows, at, percent
from ..rows import Row, select
from . import tables
from .cases import COMPARED_LOADS
from .finding import TARGET, origin, signed


def orders(rows: Rows) -> Found:
    """Answers the question of figure 5 on Mesh2, from the L/h recommended by Table 3 on."""
    far = [row for row in rows["orders"] if row["L"] / row["h"] >= 79]
    linear = [row for row in far if row["curve"].endswith("linear")]
    quadratic = select(far, curve="test2, quadratic")
    best = min(linear, key=origin)
    # Compares a refined linear mesh with a quadratic one that is cheaper.
    finest, cheap = at(linear, "test3, linear", 1024), at(quadratic, "test2, quadratic", 64)
    values = {
        **{f"linear_{test}": signed(select(linear, curve=f"{test}, linear")) for test in ("test1", "test2", "test3")},
        "linear_least": percent(origin(best)),
        "linear_most": percent(max(map(origin, linear))),
        "quadratic_mesh2": signed(quadratic),
        "linear_finest": percent(origin(finest)),
        "linear_finest_dofs": f"{finest['dofs']:.0f}",
        "quadratic_cheap": percent(origin(cheap)),
        "quadratic_cheap_dofs": f"{cheap['dofs']:.0f}",
    }
    return values, {"quadratic_mesh2": origin(best) > TARGET > max(map(origin, quadratic))}


def finer_grids(rows: Rows) -> Found:
    """Answers the question of figure 7 on Mesh2."""
    points = [*rows["mesh2_grids"], *select(rows["fig8"], curve="test2")]
    from_80 = [row for row in points if row["L"] / row["h"] >= 79]
    names = ("20x20", "40x40", "80x80")
    values = {
        "mesh2_grids_80": percent(max(origin(row) for row in from_80)),
        **{f"mesh2_grids_{name}": signed([at(rows["mesh2_grids"], name, L) for L in (64, 512, 1024)])
           for name in names},
        "mesh2_grids_ratio": f"{max(row['L'] / row['h'] for row in points):.0f}",
    }  # fmt: skip
    return values, {"mesh2_target_from_80": all(origin(row) < TARGET for row in from_80)}


def components(rows: Rows) -> Found:
    """Returns the cost of the other load directions, and whether Table 3 holds for them."""
    points = {mesh: select(rows["components"], curve=mesh) for mesh in ("hex", "prism")}
    loads = {"hex": ("x",), "prism": ("x", "y")}  # on Mesh1, the load along y is the mirror image of the load along x
    iterations = [
        row[f"iterations_{load}"] / row["iterations_z"] for mesh in loads for load in loads[mesh] for row in points[mesh]
    ]
    times = {
        (mesh, load): sum(at(rows["incomplete"], f"{mesh}, load along {load}", L)[f"{stage}_seconds"]
                          for stage in ("setup", "update"))
        for mesh, L in COMPARED_LOADS.items() for load in "zxy"
    }  # fmt: skip
    shares = [times[mesh, load] / times[mesh, "z"] for mesh in COMPARED_LOADS for load in "xy"]
    inside = recommended(rows["table3"])
    worst = {name: max(abs(row[f"origin_{name}"]) for row in inside) for name in ("xx", "yy")}
    values = {
        **{f"recommended_worst_{name}": percent(size) for name, size in worst.items()},
        "recommended_worst_xy": percent(max(row["scaled_xy"] for row in inside)),
        "load_iterations": f"{min(iterations):.2f} to {max(iterations):.2f}",
        "load_times": f"{min(shares):.2f} to {max(shares):.2f}",
        **{f"load_{load}_iterations": ", ".join(f"{row[f'iterations_{load}']:.0f}" for row in points["prism"])
           for load in ("z", "x", "y")},
    }  # fmt: skip
    verdicts = {
        "table3_components": max(*worst.values(), *(row["scaled_xy"] for row in inside)) < TARGET,
        "equal_times": max(max(iterations), 1 / min(iterations), max(shares), 1 / min(shares)) < 1.25,
    }
    return values, verdicts


def recommended(scans: Sequence[Row]) -> list[Row]:
    """Returns the values that were tried inside the ranges of Table 3."""

    def inside(mesh: str, parameter: str, holds: Callable[[float], bool]) -> list[Row]:
        return [row for row in scans if row["curve"].startswith(f"{mesh},") and row["parameter"] == parameter
                and holds(row["value"])]  # fmt: skip

    return [
        *(row for mesh in ("hex", "prism") for row in select(scans, curve=mesh) if row["value"] >= 79),
        *(row for mesh in ("hex", "prism") for row in inside(mesh, "l_over_h", lambda size: 1 <= size <= 1.25)),
        *(row for mesh in ("hex", "prism") for row in inside(mesh, "h_over_hs", lambda r: r >= 4)),
        *inside("hex", "f", lambda f: f <= 1.5),
        *inside("prism", "f", lambda f: 1.5 <= f <= 2),
    ]


def table3(rows: Rows) -> Found:
    scans = rows["table3"]
    inside = recommended(scans)

    def coarse(L_over_h: int) -> dict[str, Row]:
        points = select(scans, curve=f"hex, L/h = {L_over_h}")
        return {
            "f2": select(points, parameter="f", value=2)[0],
            "f25": select(points, parameter="f", value=2.5)[0],
            "l": select(points, parameter="l_over_h", value=0.5)[0],
        }

    near, far = coarse(80), coarse(640)
    values = {
        "ranges_table": tables.ranges_table(scans),
        "recommended_worst": percent(max(map(origin, inside))),
        **{f"coarse_{name}_80": percent(origin(row)) for name, row in near.items()},
        **{f"coarse_{name}_640": percent(origin(row)) for name, row in far.items()},
    }
    verdicts = {
        "table3_ranges": all(origin(row) < TARGET for row in inside),
        "coarse_unsatisfactory": any(origin(row) > TARGET for row in near.values()),
    }
    return values, verdicts


def other_conclusions(rows: Rows) -> Found:
    checks = rows["checks"]
    three = at(rows["fig6"], "test3", 1024)
    bilinear = at(checks, "test3, bilinear", 1024)
    prism, prism_bilinear = at(rows["fig8"], "test2", 128), at(checks, "mesh2 test2, bilinear", 128)
    fem = at(checks, "test2, half_space, fem", 64)
    vertices, nodes = (at(checks, f"test2, half_space, {name}", 64) for name in ("linear", "linear_nodes"))
    values = {
        "xx_1024": percent(three["origin_xx"]),
        "xx_1024_largest": percent(three["largest_xx"]),
        "xy_1024": percent(three["scaled_xy"]),
        "bilinear_1024": percent(origin(bilinear)),
        "bilinear_xx_1024": percent(bilinear["origin_xx"]),
        "bilinear_1024_largest": percent(bilinear["largest_zz"]),
        "prism_128": percent(origin(prism)),
        "prism_bilinear_128": percent(origin(prism_bilinear)),
        "sampled_fem": percent(fem["largest_zz"]),
        "sampled_vertices": percent(vertices["largest_zz"]),
        "sampled_nodes": percent(nodes["largest_zz"]),
        "sampled_fem_xy": percent(fem["scaled_xy"]),
        "sampled_vertices_xy": percent(vertices["scaled_xy"]),
        "sampled_nodes_xy": percent(nodes["scaled_xy"]),
    }
    verdicts = {
        "other_components": max(abs(three["origin_xx"]), abs(three["origin_yy"]), three["scaled_xy"]) < TARGET,
        "bilinear_similar": max(origin(bilinear), abs(bilinear["origin_xx"]), origin(prism_bilinear)) < TARGET,
        "linear_interpolation_harmless": vertices["largest_zz"] < 2 * fem["largest_zz"],
    }
    return values, verdicts
