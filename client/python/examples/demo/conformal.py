"""Effects of cross-sections: a wheel's throat in a gauge corner, and a ball near an edge."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from conformal_picture import draw_conformal
from section_meshes import SectionMesh, section_mesh
from terminal import ProgressBar, say, section, styled, table

from contactd import (
    AnalyticIcs,
    Client,
    ContactSolution,
    FemIcs,
    Grid,
    IcTable,
    Material,
    Paraboloid,
    Progress,
    RigidBody,
)
from contactd.wheel_rail import (
    PlacedProfiles,
    Rail60E1,
    WheelRailSetup,
    WheelRailSolution,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)

Check = tuple[bool, str]

STEEL = Material(G=82000, nu=0.28)
SHIFT, FZ, SPEED, RADIUS, SIZE = 6.5, 80e3, 20e3, 460.0, 0.4  # mm, N, mm/s, mm, mm
STATE = WheelRailState(
    position=WheelsetPosition(y=SHIFT), velocity=WheelsetVelocity(x=SPEED, pitch=-SPEED / RADIUS), Fz=FZ
)
WAYS = {
    "off": "one plane",
    "half_space": "curved, half-spaces",
    "rotated": "curved, rotated half-spaces",
    "fem": "curved, finite elements",
}
CORNER = {"rail_60e1": {"from": 20}}
RIM = {"rim_s1002": {"from": 18}}
BALL, LOAD, BLOCK, EDGE_SIZE = 50.0, 5e3, {"width": 100, "height": 50}, 0.25  # mm, N, mm, mm
DISTANCES = {3.0: (0.003, 0.09), 0.5: (-0.22, 0.43), 0.0: (-0.45, 0.50)}  # errors of pmax and approach, by a prototype


@dataclass(frozen=True)
class Throat:
    """Solves one contact with each method, and builds the tables of a rail's head by finite elements and by rotated
    half-spaces."""

    state: WheelRailState
    solutions: dict[str, WheelRailSolution]
    profiles: PlacedProfiles
    rail: IcTable
    rotated_rail: IcTable


@dataclass(frozen=True)
class Edge:
    """Solves a ball over an edge: on the truncated half-space, and on the block."""

    grid: Grid
    half_space: ContactSolution
    block: ContactSolution


def show_conformal(client: Client, binaries: Path, output: Path) -> list[Check]:
    throat = show_throat(client)
    edges = show_edges(client)
    output.parent.mkdir(parents=True, exist_ok=True)
    draw_conformal(output, throat, edges, meshes(client, binaries))
    say(f"The picture: {styled(str(output), 'bold')}")
    return [*throat_checks(throat.solutions), *edge_checks(edges)]


def meshes(client: Client, binaries: Path) -> dict[str, SectionMesh]:
    """Returns meshes of the sections, with columns like those above."""
    found = {}
    for name, shape, columns, size in (
        ("head of 60E1", CORNER, 64, SIZE),
        ("rim of S1002", RIM, 64, SIZE),
        ("block with an edge", {"edge_block": BLOCK}, 24, EDGE_SIZE),
    ):
        grid = Grid.centred(1, columns, size, columns * size)
        frames = client.get_ic(STEEL, grid, AnalyticIcs(body="longitudinally_uniform", section=shape)).frames
        found[name] = section_mesh(binaries, STEEL, grid, {"section": shape, "accuracy": 1e-2}, frames)
    return found


# --- a wheel's throat in a gauge corner ------------------------------------------------------------------------------


def show_throat(client: Client) -> Throat:
    section(
        2,
        "A wheel's throat in a gauge corner",
        f"S1002 on 60E1 at 1/40, {FZ / 1000:g} kN, {SHIFT:g} mm to the side, elements of {SIZE:g} mm, mu = 0.3: the rail turns",
        "by 0.8 rad below the contact. Half-spaces are in closed form, sections by finite elements to 1 %.",
    )
    solutions, milliseconds = {}, {}
    with ProgressBar() as progress:
        for way in WAYS:
            setup = WheelRailSetup(rail=Rail60E1(1 / 40), dx=SIZE, dy=SIZE, conformal=way)  # type: ignore[arg-type]
            client.wheel_rail(setup, STATE, timeout=600, on_progress=progress)
            start = time.perf_counter()
            solutions[way] = client.wheel_rail(setup, STATE, gap=True)
            milliseconds[way] = 1000 * (time.perf_counter() - start)
        grid = Grid.centred(2, 64, 2 * SIZE, 64 * SIZE)  # columns from R80 round the corner to the side
        by_elements = FemIcs(body="longitudinally_uniform", section=CORNER, accuracy=1e-2)
        rail = client.get_ic(STEEL, grid, by_elements, timeout=600, on_progress=progress)
        rotated_rail = client.get_ic(STEEL, grid, AnalyticIcs(body="longitudinally_uniform", section=CORNER))
    show_ways(solutions, milliseconds)
    return Throat(STATE, solutions, client.placed_profiles(setup).right, rail, rotated_rail)


def show_ways(solutions: dict[str, WheelRailSolution], milliseconds: dict[str, float]) -> None:
    reference = solutions["fem"].patches[0].solution.pmax
    body = []
    for way, name in WAYS.items():
        solution = solutions[way]
        patch, track = solution.patches[0], solution.forces.track
        pmax = patch.solution.pmax
        body.append(
            [name, f"{pmax:.0f} ({100 * (pmax / reference - 1):+.1f} %)", f"{track.Fx:.0f}", f"{track.Fy:.0f}",
             f"{1000 * patch.place.approach:.1f}", f"{milliseconds[way]:.0f}"]
        )  # fmt: skip
    table(["contact", "pmax (N/mm²)", "Fx (N)", "Fy (N)", "approach (µm)", "ms"], body)
    say()
    bends = solutions["off"].warnings
    say(styled(bends[0] if bends else "The plane has no warning.", "dim"))


def throat_checks(solutions: dict[str, WheelRailSolution]) -> list[Check]:
    pmax = {way: solution.patches[0].solution.pmax for way, solution in solutions.items()}
    missed = max(abs(solution.forces.track.Fz / FZ - 1) for solution in solutions.values())
    rotated = abs(pmax["rotated"] / pmax["fem"] - 1)
    warned = any("too strongly curved" in warning for warning in solutions["off"].warnings)
    converged = all(solution.converged for solution in solutions.values())
    return [
        (converged, f"{'solvers of the throat converged':42} {converged!s:>8}"),
        (missed <= 1e-5, f"{'the force that was asked for, relative':42} {missed:8.1e}, at most 1e-05"),
        (warned, f"{'the planar contact warns':42} {warned!s:>8}"),
        (rotated <= 0.02, f"{'pmax, rotated against finite elements':42} {rotated:8.1e}, at most 0.02"),
    ]


# --- a ball near an edge ---------------------------------------------------------------------------------------------


def show_edges(client: Client) -> dict[float, Edge]:
    section(
        3,
        "A ball near an edge",
        f"A rigid ball of {BALL:g} mm under {LOAD / 1000:g} kN on a steel block of {BLOCK['width']} x {BLOCK['height']} mm, elements of "
        f"{EDGE_SIZE} mm; what is",
        "compared is a half-space whose elements end at the edge.",
    )
    edges = {}
    with ProgressBar() as progress:
        for count, distance in enumerate(DISTANCES):
            progress(Progress(f"{distance:g} mm from the edge", count / len(DISTANCES)))
            edges[distance] = edge_at(client, distance)
    body = []
    for distance, edge in edges.items():
        body.append(
            [f"{distance:g} mm from the edge", f"{edge.half_space.pmax:.0f}", f"{edge.block.pmax:.0f}",
             f"{100 * more(edge.block.pmax, edge.half_space.pmax):+.1f} %",
             f"{100 * more(edge.block.approach, edge.half_space.approach):+.1f} %"]
        )  # fmt: skip
    table(["centre of the ball", "pmax, half-space", "pmax, block", "pmax", "approach"], body)
    say()
    return edges


def edge_at(client: Client, distance: float) -> Edge:
    grid = Grid(20, 24, EDGE_SIZE, EDGE_SIZE, -2.5, distance - 6)

    def solve(ics: FemIcs | AnalyticIcs) -> ContactSolution:
        return client.solve(
            grid=grid, upper=RigidBody(), lower=STEEL, lower_ics=ics, gap=Paraboloid(BALL, BALL), Fn=LOAD, timeout=600
        )

    return Edge(grid, solve(AnalyticIcs()), solve(FemIcs(body="longitudinally_uniform", section={"edge_block": BLOCK}, accuracy=1e-2)))


def more(value: float, reference: float) -> float:
    return value / reference - 1


def edge_checks(edges: dict[float, Edge]) -> list[Check]:
    checks = []
    for distance, edge in edges.items():
        found = more(edge.block.pmax, edge.half_space.pmax), more(edge.block.approach, edge.half_space.approach)
        off = max(np.abs(np.subtract(found, DISTANCES[distance])))
        checks.append((bool(off <= 0.03), f"{f'{distance:g} mm from the edge, against a prototype':42} {off:8.1e}, at most 0.03"))
    return checks
