"""Draws the picture of the demo of cross-sections: bodies and columns, meshes, tables, and pressures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

from contactd.wheel_rail_pictures import draw_patches

if TYPE_CHECKING:
    from conformal import Edge, Throat
    from section_meshes import SectionMesh

    from contactd import ContactSolution

INK, STEEL = "#1d1d2b", "0.88"
WAYS = {
    "off": ("one plane", "0.55", "-"),
    "half_space": ("curved, half-spaces", "C1", "-"),
    "rotated": ("curved, rotated half-spaces", "C0", "-"),
    "fem": ("curved, finite elements", "#c8401d", "--"),
}


def draw_conformal(path: Path, throat: Throat, edges: dict[float, Edge], meshes: dict[str, SectionMesh]) -> None:
    with plt.rc_context({"font.size": 10}):
        figure, ((bodies, along, columns), sections, (first, second, cuts)) = plt.subplots(
            3, 3, figsize=(16, 13.8), layout="constrained"
        )
        for axes, (name, mesh) in zip(sections, meshes.items(), strict=True):
            draw_mesh(axes, name, mesh)
        draw_bodies(bodies, throat)
        draw_along(along, throat)
        draw_table(figure, columns, throat)
        near = edges[0.5]
        largest = max(near.half_space.pmax, near.block.pmax)
        draw_pressure(first, near, near.half_space, largest, "half-space whose elements end at the edge")
        shades = draw_pressure(second, near, near.block, largest, "block, finite elements")
        figure.colorbar(shades, ax=[first, second], label="pressure (N/mm²)", shrink=0.85)
        draw_cuts(cuts, edges)
        figure.savefig(path, dpi=100)
        plt.close(figure)


def draw_bodies(axes: Any, throat: Throat) -> None:
    """Draws wheel and rail with the pressure, and the rows of elements with their normals."""
    solution = throat.solutions["fem"]
    draw_patches(axes, throat.profiles, throat.state, solution)
    rows = solution.patches[0].place.rows
    for row in rows[::2]:
        normal = np.array([-np.sin(row.angle), np.cos(row.angle)])
        axes.plot(*np.transpose([(row.y, row.z), (row.y, row.z) - 1.6 * normal]), color=INK, lw=0.7)
    at = solution.patches[0].place.reference
    axes.set(xlim=(at.y - 16, at.y + 22), ylim=(at.z + 16, at.z - 14))
    axes.set_title("S1002 in the gauge corner of 60E1,\nits pressure and the normals of its rows")


def draw_along(axes: Any, throat: Throat) -> None:
    """Plots the largest pressure of each row."""
    for way, solution in throat.solutions.items():
        name, color, style = WAYS[way]
        patch = solution.patches[0]
        pressure = np.asarray(patch.solution.pressure).max(axis=1)
        axes.plot(patch.place.grid.y, pressure, style, color=color, lw=1.6, label=f"{name}: {pressure.max():.0f}")
    axes.set(xlabel="distance from the reference along the rail (mm)", ylabel="largest pressure of a row (N/mm²)")
    axes.set(xlim=(-6, 4), ylim=(0, 3200))
    axes.legend(frameon=False, loc="upper left", title="largest pressure")
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_title("Pressure across the contact,\nfour ways to state it")


def draw_table(figure: Any, axes: Any, throat: Throat) -> None:
    """Plots the change by finite elements relative to the rotated half-space: zz between the columns of the head."""
    change = throat.rail["zz"][:, :, 0] - throat.rotated_rail["zz"][:, :, 0]
    change = 100 * change / throat.rotated_rail["zz"][0, 0, 0]
    bound = np.abs(change).max()
    shades = axes.imshow(change, cmap="RdBu_r", vmin=-bound, vmax=bound, origin="lower")
    figure.colorbar(shades, ax=axes, label="% of zz of an element on itself", shrink=0.85)
    axes.set(xlabel="loaded column", ylabel="observed column")
    axes.set_title("A_zz of the head: finite elements\nless rotated half-spaces")


def draw_mesh(axes: Any, name: str, mesh: SectionMesh) -> None:
    """Draws the whole section, and its columns magnified."""
    for part in (axes, axes.inset_axes((0.62, 0.02, 0.4, 0.36))):
        part.triplot(*mesh.points.T, mesh.triangles, color="0.45", lw=0.3)
        part.plot(*mesh.columns.T, color="#c8401d", lw=1.6)
        part.set_aspect("equal")
    middle, reach = mesh.columns.mean(axis=0), 0.62 * np.ptp(mesh.columns, axis=0).max()
    part.set(xlim=(middle[0] - reach, middle[0] + reach), ylim=(middle[1] - reach, middle[1] + reach))
    part.set(xticks=[], yticks=[])
    axes.set(xlabel="y (mm)", ylabel="z (mm), upwards")
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_title(f"{name}: {len(mesh.triangles)} triangles,\n{len(mesh.columns)} columns (red)")


def draw_pressure(axes: Any, edge: Edge, solution: ContactSolution, largest: float, title: str) -> Any:
    grid = edge.grid
    extent = (grid.x0, grid.x0 + grid.nx * grid.dx, grid.y0, grid.y0 + grid.ny * grid.dy)
    touching = np.ma.masked_less_equal(np.asarray(solution.pressure), 0)
    shades = axes.imshow(touching, cmap="inferno", vmin=0, vmax=largest, origin="lower", extent=extent)
    axes.axhline(extent[3], color=INK, lw=4)
    axes.set(xlim=(-1.75, 1.75), ylim=(extent[3] - 2.5, extent[3]), facecolor=STEEL)
    axes.set(xlabel="x, along the edge (mm)", ylabel="y across (mm); the edge above")
    axes.set_title(f"{title}\n0.5 mm from the edge: {solution.pmax:.0f} N/mm²")
    return shades


def draw_cuts(axes: Any, edges: dict[float, Edge]) -> None:
    """Plots pressures across the middle, from the edge on."""
    for color, (distance, edge) in zip(("C0", "C1", "#c8401d"), edges.items(), strict=True):
        grid = edge.grid
        from_edge = grid.y0 + grid.ny * grid.dy - grid.y
        for solution, style in ((edge.half_space, "--"), (edge.block, "-")):
            label = f"{distance:g} mm" if style == "-" else None
            axes.plot(from_edge, np.asarray(solution.pressure).max(axis=1), style, color=color, lw=1.6, label=label)
    axes.set(xlabel="distance from the edge (mm)", ylabel="largest pressure of a row (N/mm²)", xlim=(0, 6))
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, title="centre of the ball from the edge\nfull: block; dashed: half-space")
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_title("A ball near an edge:\npressure across it")
