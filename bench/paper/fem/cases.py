"""Lists computations as plain data: a Case is a request to contactd-ic and the place of its answer in a figure."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

Ics = dict[str, Any]
Spec = dict[str, Any]

#: The contact problem of section 3: steel, 10 x 10 elements of 0.8 mm.
STEEL = {"G": 82000, "nu": 0.28}
H = 0.8
#: Sizes of the block (mm). The paper's largest is 1024.
LENGTHS = (8, 16, 32, 64, 128, 256, 512, 1024)
#: The contact grids of section 3 on [-4,4]^2: elements along an edge, of 8/n mm.
GRIDS = (10, 20, 40, 80)

#: Table 2: l/h, h/hs, f; the presets of the same names set these.
TESTS = {"test1": (2.5, 4, 1.5), "test2": (1, 4, 1.5), "test3": (1, 4, 1.2)}
#: Defaults of contactd.
DEFAULTS: Ics = {"mesh": "hex", "order": 2, "l_over_h": 1, "h_over_hs": 4, "f": 1.2, "t1_over_hs": 0, "L_over_h": 640}


@dataclass(frozen=True)
class Case:
    """Describes one point of a curve. Its largest error is taken over `table` x `table` offsets."""

    part: str  #: a key of PARTS
    curve: str
    parameter: str  #: what changes along the curve
    value: float
    table: int
    spec: Spec  #: the parameters of ic.get
    h: float = H  #: displayed element size (mm); a table serves all sizes


def spec_of(extent: int, **ics: Any) -> Spec:
    grid = {"nx": extent, "ny": extent, "dx": H, "dy": H}
    return {"material": STEEL, "grid": grid, "ics": {"source": "fem", **ics}}


def preset(mesh: str, test: str) -> str:
    return f"paper-{test}" if mesh == "hex" else f"paper-mesh2-{test}"


def clamped(mesh: str, test: str, L_over_h: float, **more: Any) -> Spec:
    """Returns the paper's method on its largest grid that fits into the block, so that one build serves all grids."""
    extent = max(n for n in GRIDS if n <= L_over_h)
    base: Ics = {"preset": preset(mesh, test)}
    known = full_ics(base)
    # Fields that equal the preset are omitted, so that equal meshes are equal requests.
    other = {name: value for name, value in more.items() if known.get(name) != value}
    return spec_of(extent, **{**base, "L_over_h": L_over_h, "solver": "amg_pcg", **other})


def fig5() -> list[Case]:
    """Returns TEST 1 on Mesh1, linear and quadratic."""
    return [
        Case("fig5", curve, "L", L, 10, clamped("hex", "test1", L / H, **({"order": 1} if curve == "linear" else {})))
        for curve in ("linear", "quadratic")
        for L in LENGTHS
    ]


def fig6() -> list[Case]:
    """Returns TEST 2 and TEST 3 on Mesh1, 10 x 10."""
    return [Case("fig6", test, "L", L, 10, clamped("hex", test, L / H)) for test in ("test2", "test3") for L in LENGTHS]


def fig7() -> list[Case]:
    """Returns TEST 3 on Mesh1 for finer contact grids. Cases with equal L/h share one mesh and one computation."""
    return [
        Case("fig7", f"{n}x{n}", "L", L, n, clamped("hex", "test3", L * n / 8), 8 / n)
        for n in GRIDS[1:]
        for L in LENGTHS
    ]


def fig8() -> list[Case]:
    """Returns TEST 1 to 3 on Mesh2, and TEST 2 with the other diagonals. TEST 3 ends at 512 as in the paper."""
    result = []
    for test in TESTS:
        for L in LENGTHS[:-1] if test == "test3" else LENGTHS:
            result.append(Case("fig8", test, "L", L, 10, clamped("prism", test, L / H)))
    for L in LENGTHS:
        spec = clamped("prism", "test2", L / H, diagonal="across")
        result.append(Case("fig8", "test2, across", "L", L, 10, spec))
    return result


def orders() -> list[Case]:
    """Returns figure 5 on Mesh2: linear elements for all tests, and the quadratic elements of the test that the paper
    selects, from the L/h recommended by Table 3 on."""
    linear = [
        Case("orders", f"{test}, linear", "L", L, 10, clamped("prism", test, L / H, order=1, solver="auto"))
        for test in TESTS
        for L in LENGTHS[3:]
    ]
    quadratic = [
        Case("orders", "test2, quadratic", "L", L, 10, clamped("prism", "test2", L / H)) for L in LENGTHS[3:]
    ]
    return linear + quadratic


def mesh2_grids() -> list[Case]:
    """Returns figure 7 on Mesh2: TEST 2 for finer contact grids."""
    return [
        Case("mesh2_grids", f"{n}x{n}", "L", L, n, clamped("prism", "test2", L * n / 8), 8 / n)
        for n in GRIDS[1:]
        for L in LENGTHS
    ]


def components() -> list[Case]:
    """Returns cases for the costs of the load directions, on the meshes that Table 3 recommends."""
    return [
        Case("components", mesh, "L", L, 10, clamped(mesh, OPTIMAL[mesh], L / H))
        for mesh in OPTIMAL
        for L in LENGTHS
        if L / H >= SCANNED_L_OVER_H[0]
    ]


#: Table 3 is scanned one parameter at a time around the test that the paper calls optimal.
OPTIMAL = {"hex": "test3", "prism": "test2"}
SCANS: dict[str, dict[str, tuple[float, ...]]] = {
    "hex": {"l_over_h": (0.5, 1, 1.25, 1.5), "h_over_hs": (2, 4, 6), "f": (1.2, 1.35, 1.5, 1.75, 2, 2.5, 3)},
    "prism": {"l_over_h": (0.5, 1, 1.25, 1.5), "h_over_hs": (2, 4, 6), "f": (1.35, 1.5, 1.75, 2, 2.5, 3)},
}
SCANNED_L_OVER_H = (80, 640)  # where Table 3 begins, and where the paper calls errors stable


def table3() -> list[Case]:
    result = []
    for mesh, test in OPTIMAL.items():
        for L in LENGTHS:
            result.append(Case("table3", mesh, "L_over_h", L / H, 10, clamped(mesh, test, L / H)))
        for L_over_h in SCANNED_L_OVER_H:
            for parameter, values in SCANS[mesh].items():
                for value in values:
                    spec = clamped(mesh, test, L_over_h, solver="auto", **{parameter: value})
                    result.append(Case("table3", f"{mesh}, L/h = {L_over_h}", parameter, value, 10, spec))
    return result


def checks() -> list[Case]:
    """Returns cases of single statements: iterations, another solver, sampling, the bilinear load."""
    result = []

    def add(curve: str, L: float, spec: Spec) -> None:
        result.append(Case("checks", curve, "L", L, 10, spec))

    for L in LENGTHS[4:]:
        add("test3, update", L, clamped("hex", "test3", L / H, stopping_criterion="update", tolerance=1e-6))
        add("mesh2 test2, direct", L, clamped("prism", "test2", L / H, solver="direct"))
    for test in ("test2", "test3"):
        for sampling in ("linear", "linear_nodes"):
            add(f"{test}, {sampling}", 1024, clamped("hex", test, 1024 / H, sampling=sampling, solver="auto"))
    far: Ics = {"L_over_h": 80, "far_boundary": "half_space", "solver": "auto"}
    for sampling in ("fem", "linear", "linear_nodes"):
        add(f"test2, half_space, {sampling}", 64, clamped("hex", "test2", **{**far, "sampling": sampling}))
    for L in LENGTHS[4:]:
        add("test3, bilinear", L, clamped("hex", "test3", L / H, load_shape="bilinear", solver="auto"))
    for L in LENGTHS[4:6]:
        add("mesh2 test2, bilinear", L, clamped("prism", "test2", L / H, load_shape="bilinear", solver="auto"))
    add("test3, half_space", 8, spec_of(10, preset="paper-test3", L_over_h=10, far_boundary="half_space"))
    add("test3, half_space", 1024, spec_of(10, preset="paper-test3", L_over_h=1280, far_boundary="half_space"))
    return result


#: Extents compared in the accuracy/time diagram, and values of L/h that reach slightly beyond them.
COMPARED = {10: 12.0, 40: 46.0}


def accuracy() -> list[Case]:
    """Returns errors over the table against time, with one curve per method."""
    result = []
    for table, reach in COMPARED.items():
        lengths = [L for L in LENGTHS if L / H >= table + 1]
        for order, word in ((1, "linear"), (2, "quadratic")):
            for test in TESTS:
                for L in lengths:
                    spec = clamped("hex", test, L / H, **({"order": 1} if order == 1 else {}))
                    result.append(Case("accuracy", f"{test}, {word}, clamped", "L", L, table, spec))
        for L in lengths:
            direct = clamped("hex", "test3", L / H, solver="auto")
            result.append(Case("accuracy", "test3, quadratic, clamped, auto", "L", L, table, direct))
            result.append(Case("accuracy", "mesh2 test2, clamped", "L", L, table, clamped("prism", "test2", L / H)))
        result += [
            Case("accuracy", "mesh1, half_space", "f", f, table, half_space_mesh("hex", table, reach, f, solver="auto"))
            for f in (2, 1.5, 1.3, 1.2, 1.1)
        ]
        for order in (3, 4):
            for f in (1.8, 1.6, 1.5, 1.4):
                # The cube is the loaded quarter, and each layer is a copy of the previous one, f times as large.
                mesh = {"l_over_h": 0.5, "h_over_hs": 4, "t1_over_hs": 2 * (f - 1)}
                spec = spec_of(table, order=order, f=f, L_over_h=reach, far_boundary="half_space", **mesh)
                result.append(Case("accuracy", f"order {order}, half_space", "f", f, table, spec))
        for asked in (1e-2, 1e-3, 1e-4):
            result.append(Case("accuracy", "accuracy", "accuracy", asked, table, spec_of(table, accuracy=asked)))
        result += [
            Case("accuracy", "adaptive, half_space", "max_dofs", dofs, table, adaptive_mesh(table, reach, dofs))
            for dofs in ADAPTIVE_DOFS
        ]
    return result


ADAPTIVE_DOFS = (3_000, 6_000, 12_000, 25_000, 50_000)


def half_space_mesh(mesh: str, extent: int, L_over_h: float, f: float, **more: Any) -> Spec:
    """Returns TEST 2 and 3 with another f, and with half-space displacements on the far faces."""
    kind = {"mesh": "prism"} if mesh == "prism" else {}
    ics: Ics = {"order": 2, "f": f, "L_over_h": L_over_h, "far_boundary": "half_space", "solver": "amg_pcg", **kind}
    return spec_of(extent, **{**ics, **more})


def adaptive_mesh(extent: int, L_over_h: float, dofs: int, far_boundary: str = "half_space") -> Spec:
    mesh = {"mesh": "adaptive", "order": 2, "max_dofs": dofs}
    return spec_of(extent, L_over_h=L_over_h, far_boundary=far_boundary, solver="amg_pcg", **mesh)


def adaptive() -> list[Case]:
    """Returns adaptive refinement, Mesh1 and Mesh2 of increasing density, on the clamped block and the half-space."""
    result = []
    L_over_h = 1024 / H
    for dofs in ADAPTIVE_DOFS:
        spec = adaptive_mesh(80, L_over_h, dofs, "clamped")
        result.append(Case("adaptive", "adaptive, clamped", "max_dofs", dofs, 10, spec))
        spec = adaptive_mesh(10, COMPARED[10], dofs)
        result.append(Case("adaptive", "adaptive, half_space", "max_dofs", dofs, 10, spec))
    for mesh, growths in (("hex", (3, 2, 1.5, 1.3, 1.2)), ("prism", (3, 2, 1.5, 1.35, 1.2))):
        for f in growths:
            if mesh == "hex" or f >= 1.5:  # Mesh2 with L/h = 1280 has ten times the elements
                spec = clamped(mesh, "test3", L_over_h, f=f)
                result.append(Case("adaptive", f"{mesh}, clamped", "f", f, 10, spec))
            spec = half_space_mesh(mesh, 10, COMPARED[10], f)
            result.append(Case("adaptive", f"{mesh}, half_space", "f", f, 10, spec))
    for h_over_hs in (6, 8):
        spec = half_space_mesh("hex", 10, COMPARED[10], 1.2, h_over_hs=h_over_hs)
        result.append(Case("adaptive", "hex, half_space", "h_over_hs", h_over_hs, 10, spec))
    return result


#: Incomplete factorisations, and orders of the equations, which determine their quality.
FACTORISATIONS: dict[str, dict[str, Any]] = {
    "ILU(0), shell by shell": {"preconditioner": "ilu0", "numbering": "outward"},
    "ILU(0), reverse Cuthill-McKee": {"preconditioner": "ilu0", "numbering": "rcm"},
    "ILU(0), MFEM's numbers": {"preconditioner": "ilu0", "numbering": "mfem"},
    "ILU(0), MFEM's numbers, condensed": {"preconditioner": "ilu0", "numbering": "mfem", "condensed": 1},
    "IC, shell by shell": {"preconditioner": "ic", "numbering": "outward"},
}
#: The system that is solved for all meshes of figures 6 and 7.
PLAIN = "ILU(0), shell by shell"
#: The meshes of section 4, whose loads are compared by processor time.
COMPARED_LOADS = {"hex": 1024, "prism": 128}


def incomplete() -> list[Case]:
    """Returns TEST 3 with the paper's solver, bench/block_system.cpp, and the three loads on both meshes."""
    result = []
    ratios = sorted({L / h for L in LENGTHS for h in (8 / n for n in GRIDS)})
    for curve, options in FACTORISATIONS.items():
        for ratio in ratios if curve == PLAIN else [L / H for L in LENGTHS[4:]]:
            spec = {"solve": {"preset": "paper-test3", "L_over_h": ratio, **options}}
            result.append(Case("incomplete", curve, "L", ratio * H, 1, spec))
    for mesh, L in COMPARED_LOADS.items():
        for load in "zxy":
            options = {"preset": preset(mesh, OPTIMAL[mesh]), "L_over_h": L / H, "load": load, **FACTORISATIONS[PLAIN]}
            result.append(Case("incomplete", f"{mesh}, load along {load}", "L", L, 1, {"solve": options}))
    return result


#: Returns linear prisms of TEST 2 in a block small enough to be solved densely as a whole.
SMALL_QUARTER: Spec = {"preset": "paper-mesh2-test2", "L_over_h": 4, "h_over_hs": 2, "order": 1}
COMPONENTS = [i + j for i in "xyz" for j in "xyz"]


def table1() -> list[Case]:
    """Returns the conditions of Table 1, for each of the nine coefficients."""
    spec = spec_of(2, **SMALL_QUARTER, solver="direct")
    spec = {**spec, "whole_block": SMALL_QUARTER}
    return [Case("table1", name, "component", number, 2, spec) for number, name in enumerate(COMPONENTS)]


def meshes() -> list[Case]:
    """Returns figure 4: the visible faces of Mesh1 and Mesh2."""
    return [
        Case("meshes", mesh, "L", 8, 1, {"mesh": {"preset": preset(mesh, "test2"), "L_over_h": 10}})
        for mesh in OPTIMAL
    ]


#: In computation order: slow computations come late.
PARTS = {
    "fig5": fig5, "fig6": fig6, "fig7": fig7, "fig8": fig8,
    "meshes": meshes, "table1": table1, "incomplete": incomplete,
    "orders": orders, "mesh2_grids": mesh2_grids, "components": components,
    "checks": checks, "table3": table3, "accuracy": accuracy, "adaptive": adaptive,
}  # fmt: skip


def full_ics(ics: Ics) -> Ics:
    """Returns the mesh of a request, with the values of its preset and the defaults."""
    result = dict(DEFAULTS)
    name = ics.get("preset")
    if name is not None:
        l_over_h, h_over_hs, f = TESTS[name.rsplit("-", 1)[1]]
        mesh = "prism" if "mesh2" in name else "hex"
        result.update(mesh=mesh, l_over_h=l_over_h, h_over_hs=h_over_hs, f=f)
    result.update(ics)
    return result


def elements(ics: Ics) -> int:
    """Returns the number of elements of Mesh1 and Mesh2: m^3 + 3 m^2 k hexahedra, 2 (m^2 + 2 m k) (m + k) prisms."""
    full = full_ics(ics)
    f, hs, thickness = full["f"], 1 / full["h_over_hs"], full["L_over_h"] - full["l_over_h"]
    t1 = hs * (full["t1_over_hs"] or f)
    layers = thickness / t1 if f == 1 else math.log1p(thickness * (f - 1) / t1) / math.log(f)
    m, k = round(full["l_over_h"] * full["h_over_hs"]), max(1, math.floor(layers + 0.5))
    count: int = 2 * (m * m + 2 * m * k) * (m + k) if full["mesh"] == "prism" else m * m * (m + 3 * k)
    return count


def effort(spec: Spec) -> float:
    """Estimates the CPU seconds of a build, for the remaining time."""
    if "mesh" in spec:
        return 0.2
    if "solve" in spec:
        return 5
    ics = spec["ics"]
    if "accuracy" in ics:
        return {1e-2: 0.3, 1e-3: 1, 1e-4: 6}.get(ics["accuracy"], 1)
    order = ics.get("order", 2)
    if ics.get("mesh") == "adaptive":
        return 4e-4 * float(ics["max_dofs"])  # every intermediate mesh is solved, too
    prism = full_ics(ics)["mesh"] == "prism"
    dofs: float = elements(ics) * order**3 * (1.75 if prism else 3.4)
    return 3e-5 * dofs * (3 if prism else 2) * math.pow(dofs / 3e4, 0.15)
