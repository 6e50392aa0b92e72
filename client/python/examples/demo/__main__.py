"""Demonstrates contactd: a finite-element table, the cache, and the Cattaneo problem compared with its closed form; or
a wheelset compared with a published benchmark; or profiles, their contacts and conicity; or effects of cross-sections
in conformal contacts and near edges.

Run: python3 client/python/examples/demo [cattaneo | wheelrail | profiles | conformal] --bin build/production/bin [--output PICTURE]

Starts a daemon in a temporary folder and stops it again. Exit status: 0 if the numbers have the paper's accuracy, 1 if
one does not, 2 if the daemon failed.
"""

from __future__ import annotations

import argparse
import math
import signal
import sys
import time
import warnings
from pathlib import Path

from checks import Check, cattaneo_checks, table_checks
from conformal import show_conformal
from conicity import show_profiles
from terminal import ProgressBar, rows, say, section, styled, table, verdict
from wheelrail import show_wheelset

from contactd import (
    Client,
    ContactdError,
    ContactProblem,
    ContactSolution,
    ContactWarning,
    FemIcs,
    Friction,
    Grid,
    IcTable,
    LocalDaemon,
    Material,
    Paraboloid,
)
from contactd.demo.closed_form import Sphere
from contactd.demo.picture import draw

BLOCK = 1024.0  # L, the size of the finite-element block (mm)


def show_steel_table(client: Client) -> list[Check]:
    grid, steel = Grid(10, 10, 0.8, 0.8), Material(G=82000, nu=0.28)
    section(
        2,
        "Influence coefficients of steel, by finite elements",
        f"Section 3 of the paper: G = {steel.G:g} N/mm², nu = {steel.nu}, 10 x 10 elements of {grid.dx} mm,",
        f"quadratic hexahedra on Mesh1, TEST 3, a block of L = {BLOCK:g} mm with u = 0 on its far faces.",
    )
    ics = FemIcs("paper-test3", L_over_h=BLOCK / grid.dx)
    with ProgressBar() as progress:
        first = client.get_ic(steel, grid, ics, timeout=600, on_progress=progress)
    show_evidence(first)

    start = time.perf_counter()
    again = client.get_ic(steel, grid, ics)
    milliseconds = 1000 * (time.perf_counter() - start)
    counters = client.info().counters
    say()
    say(f"The second request gets it from {styled(again.origin, 'bold')} in {styled(f'{milliseconds:.1f} ms', 'bold')}.")
    say(f"Builds started: {counters['builds_started']}. Answered from memory: {counters['memory_hits']}.")
    cached = again.origin == "memory" and counters["builds_started"] == 1
    return [*table_checks(first), (cached, f"{'steel, second request':34} {again.origin:>9}, without another build")]


def show_evidence(ics: IcTable) -> None:
    evidence, errors = ics.evidence, ics.evidence.errors
    assert errors is not None
    seconds = evidence.seconds
    stages = ", ".join(f"{name} {seconds[name]:.1f}" for name in ("assembly", "setup", "solve"))
    rows(
        [
            ("elements", f"{evidence.elements}"),
            ("unknowns", f"{evidence.dofs}"),
            ("iterations", iterations_of(ics)),
            ("true residual", f"{max(case.residual for case in evidence.load_cases):.1e}"),
            ("time", f"{seconds['total']:.1f} s: {stages}"),
            ("made by", evidence.version),
        ]
    )
    say()
    body = []
    for name in ("zz", "xx", "yy"):
        error = getattr(errors, name)
        body.append([f"A_{name}", f"{100 * error.origin:+.3f} %", f"{100 * error.largest:.3f} %"])
    table(["error against the closed form", "at the origin", "largest of all"], body)


def iterations_of(ics: IcTable) -> str:
    cases = [f"{case.iterations} (load {case.load})" for case in ics.evidence.load_cases]
    if len(cases) == 2:
        cases.append("load y is load x mirrored")
    return ", ".join(cases)


def show_cattaneo(client: Client, output: Path) -> list[Check]:
    sphere = Sphere(G=200, nu=0.42, radius=50, approach=0.02, mu=0.4, shift=0.00817)
    grid = Grid.centred(40, 40, 2.4, 2.4)
    problem = ContactProblem(
        grid=grid,
        upper=Material(sphere.G, sphere.nu),
        gap=Paraboloid(sphere.radius, sphere.radius),
        approach=sphere.approach,
        friction=Friction(sphere.mu, (sphere.shift, 0)),
    )
    section(
        3,
        "The Cattaneo problem",
        f"Section 4 of the paper: a sphere of R = {sphere.radius:g} mm is pressed {sphere.approach} mm into a plane,",
        f"then shifted {sphere.shift} mm. G = {sphere.G:g} N/mm², nu = {sphere.nu}, mu = {sphere.mu}, 40 x 40 elements",
        "on 2.4 x 2.4 mm. Mesh1 ICs: finite elements as above, read linearly between nodes as the paper does.",
    )
    mesh_ics = FemIcs("paper-test3", L_over_h=BLOCK / grid.dx, sampling="linear_nodes")
    with ProgressBar() as progress:
        client.get_ic(problem.upper, grid, mesh_ics, timeout=600, on_progress=progress)
    analytic, analytic_ms = timed_solve(client, problem)
    mesh, mesh_ms = timed_solve(client, problem.replace(ics=mesh_ics))
    show_solutions(sphere, grid, (analytic, analytic_ms), (mesh, mesh_ms))
    draw(
        output,
        grid,
        mesh,
        sphere,
        "40 x 40 elements, coefficients by finite elements (Mesh1, TEST 3, L = 1024 mm)",
    )
    say()
    say(f"The picture: {styled(str(output), 'bold')}")
    return list(cattaneo_checks(sphere, analytic, mesh))


def timed_solve(client: Client, problem: ContactProblem) -> tuple[ContactSolution, float]:
    """Returns the solution, and the milliseconds from request to answer with available coefficients."""
    client.solve(problem)
    start = time.perf_counter()
    solution = client.solve(problem)
    return solution, 1000 * (time.perf_counter() - start)


def show_solutions(
    sphere: Sphere, grid: Grid, analytic: tuple[ContactSolution, float], mesh: tuple[ContactSolution, float]
) -> None:
    solutions = [analytic[0], mesh[0]]
    adhesion = math.pi * sphere.adhesion_radius**2 / (grid.dx * grid.dy)
    slip = sphere.area / (grid.dx * grid.dy) - adhesion
    table(
        ["", "analytic ICs", "Mesh1 ICs", "Hertz, Cattaneo"],
        [
            ["Fz (N)", *(f"{s.Fn:.5f}" for s in solutions), f"{sphere.normal_force:.5f}"],
            ["pmax (N/mm²)", *(f"{s.pmax:.5f}" for s in solutions), f"{sphere.pmax:.5f}"],
            ["contact area (mm²)", *(f"{s.area.contact:.4f}" for s in solutions), f"{sphere.area:.4f}"],
            ["|Fx| (N)", *(f"{abs(s.Fx):.5f}" for s in solutions), f"{sphere.tangential_force:.5f} *"],
            [
                "adhesion / slip elements",
                *(f"{s.elements.adhesion} / {s.elements.slip}" for s in solutions),
                f"{adhesion:.0f} / {slip:.0f}",
            ],
            ["milliseconds", f"{analytic[1]:.1f}", f"{mesh[1]:.1f}", ""],
        ],
    )
    say(styled("* Cattaneo leaves the lateral tractions out; with them |Fx| tends to 3.2216 N.", "dim"))


def show_daemon(daemon: LocalDaemon, client: Client) -> None:
    info = client.info()
    libraries = ", ".join(f"{name} {version}" for name, version in sorted(info.libraries.items()))
    section(1, "The daemon")
    rows(
        [
            ("contactd", f"{info.version}, process {daemon.pid}"),
            ("listens at", daemon.endpoint),
            ("made with", libraries),
        ]
    )


def run(options: argparse.Namespace) -> int:
    with LocalDaemon(options.bin / "contactd") as daemon:
        with daemon.client(timeout=60) as client:
            show_daemon(daemon, client)
            if options.what == "wheelrail":
                checks, question = show_wheelset(client, options.output), "Do the results agree with the benchmark?"
            elif options.what == "profiles":
                checks, question = show_profiles(client, options.output), "Do the results agree with closed forms?"
            elif options.what == "conformal":
                checks, question = show_conformal(client, options.bin, options.output), "Is it as the prototype had it?"
            else:
                checks = [*show_steel_table(client), *show_cattaneo(client, options.output)]
                question = "Is it as accurate as the paper?"
        status = daemon.stop()
    checks.append((status == 0, f"{'daemon, exit status':34} {status:9}, after SIGTERM"))
    section(4 if options.what in ("cattaneo", "conformal") else 3, question)
    for passed, text in checks:
        verdict(passed, text)
    failed = sum(not passed for passed, _ in checks)
    print()
    say(
        styled(f"{failed} of {len(checks)} checks failed.", "red")
        if failed
        else styled("All as it should be.", "green")
    )
    print()
    return 1 if failed else 0


def main() -> int:
    warnings.simplefilter("ignore", ContactWarning)  # Grids are as coarse as those of the reference values.
    parser = argparse.ArgumentParser(prog="demo", description=(__doc__ or "").split("\n\n")[0])
    parser.add_argument(
        "what", nargs="?", choices=["cattaneo", "wheelrail", "profiles", "conformal"], default="cattaneo", help="the demonstration (cattaneo)"
    )
    parser.add_argument(
        "--bin", type=Path, default=Path("build/production/bin"), help="folder with contactd, contactd-ic"
    )
    parser.add_argument("--output", type=Path, default=Path("contactd-demo.png"), help="file of the picture (PNG); profiles writes five into its folder")
    options = parser.parse_args()
    # Stops the daemon however the demo ends.
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))
    signal.signal(signal.SIGHUP, lambda number, frame: sys.exit(128 + number))
    try:
        return run(options)
    except KeyboardInterrupt:
        print("\n   Interrupted; the daemon has been stopped.", file=sys.stderr)
        return 130
    except ContactdError as error:
        print(f"\n   The demo failed. {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
