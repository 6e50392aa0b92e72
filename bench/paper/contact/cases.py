"""Lists the computations: one Case is one contact problem and the place of its solution in a figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from .problem import WINDOW, Ics, Spec, spec_of

#: Sizes of the block (mm), and the contact grids: elements along an edge of the window.
LENGTHS = (8, 16, 32, 64, 128, 256, 512, 1024)
#: Fine grids come first, because their tables serve the coarse ones with the same L/h.
GRIDS = (160, 40, 10)
COMPARED_GRIDS = (160, 80, 40, 20, 10)

PRESETS = {"mesh1": "paper-test3", "mesh2": "paper-mesh2-test2"}  # optimal according to the paper
CHOSEN_L = {"mesh1": 1024, "mesh2": 128}
#: The paper interpolates displacements linearly between the nodes of its mesh (section 2.2).
PAPER_SAMPLING = "linear_nodes"


@dataclass(frozen=True)
class Case:
    """One point of a curve."""

    part: str
    curve: str
    parameter: str  #: what changes along the curve: L or n
    value: float
    n: int
    L: float  #: 0 with closed-form coefficients
    spec: Spec


def fem(mesh: str, n: int, L: float, **more: Any) -> Ics:
    """Returns the ics of the paper's method, with the changes in `more`."""
    return {"preset": PRESETS[mesh], "L_over_h": L * n / WINDOW, "sampling": PAPER_SAMPLING, **more}


def against_n(part: str, curve: str, n: int, L: float, ics: Ics, **more: Any) -> Case:
    return Case(part, curve, "n", n, n, L, spec_of(n, ics, **more))


def against_L(part: str, curve: str, mesh: str, n: int, lengths: Sequence[float], **more: Any) -> list[Case]:
    return [Case(part, curve, "L", L, n, L, spec_of(n, fem(mesh, n, L, **more))) for L in lengths]


def analytic(part: str) -> list[Case]:
    return [against_n(part, "analytic", n, 0, {}) for n in COMPARED_GRIDS]


def fig9() -> list[Case]:
    return analytic("fig9")


def shared_lengths(mesh: str, n: int) -> list[float]:
    """Returns block sizes whose L/h on n x n elements also occur in figure 12 and need no additional table."""
    return [L for L in LENGTHS if L * n in {CHOSEN_L[mesh] * other for other in COMPARED_GRIDS}]


def curves_of(part: str, mesh: str, prefix: str = "") -> list[Case]:
    """Returns cases of constant load: interpolated as in the paper, and with the finite-element function itself."""
    result = []
    for n in GRIDS:
        result += against_L(part, f"{prefix}{n}x{n}", mesh, n, LENGTHS)
        lengths = LENGTHS if mesh == "mesh1" else shared_lengths(mesh, n)
        result += against_L(part, f"{prefix}{n}x{n}, fem", mesh, n, lengths, sampling="fem")
    return result


def fig10() -> list[Case]:
    return curves_of("fig10", "mesh1")


def fig11() -> list[Case]:
    return curves_of("fig11", "mesh2")


def fig13() -> list[Case]:
    """Returns the same computations as figures 10 and 11."""
    return [*curves_of("fig13", "mesh1", "mesh1 "), *curves_of("fig13", "mesh2", "mesh2 ")]


def comparison(part: str) -> list[Case]:
    bilinear: Ics = {"load_shape": "bilinear"}
    result = [*analytic(part), *(against_n(part, "analytic, Bi", n, 0, bilinear) for n in COMPARED_GRIDS)]
    for mesh, L in CHOSEN_L.items():
        kinds: dict[str, Ics] = {"PC": {}, "Bi": bilinear, "PC, fem": {"sampling": "fem"}}
        for kind, more in kinds.items():
            result += [against_n(part, f"{mesh}, {kind}", n, L, fem(mesh, n, L, **more)) for n in COMPARED_GRIDS]
    return result


#: These blocks exceed the paper's largest, on Mesh1.
LARGER_LENGTHS = (2048, 4096)


def larger() -> list[Case]:
    """Returns figure 10 with larger blocks, which continue the curves of the same names."""
    result = []
    for n in GRIDS:
        result += against_L("larger", f"{n}x{n}", "mesh1", n, LARGER_LENGTHS)
        result += against_L("larger", f"{n}x{n}, fem", "mesh1", n, LARGER_LENGTHS, sampling="fem")
    return result


def fig12() -> list[Case]:
    return comparison("fig12")


def fig14() -> list[Case]:
    """Returns the same computations as figure 12."""
    return comparison("fig14")


def bilinear() -> list[Case]:
    """Returns figures 10 and 11 with the bilinear load, which the paper omits."""
    result = []
    for mesh in CHOSEN_L:
        for n in GRIDS:
            result += against_L("bilinear", f"{mesh} {n}x{n}", mesh, n, LENGTHS, load_shape="bilinear")
    return result


#: Grids for the limit h -> 0, solved to a smaller tolerance than the paper's 1e-6.
LIMIT_GRIDS = (160, 240, 320, 480, 640, 960)


def limit() -> list[Case]:
    return [against_n("limit", "analytic", n, 0, {}, tolerance=1e-9) for n in LIMIT_GRIDS]


FINEST = 160


def sources() -> list[Case]:
    """Returns cases that separate the errors of Fz and Fx on 160 x 160: far faces, sampling, diagonals, components."""
    result = []

    def add(mesh: str, curve: str, ics: Ics, **more: Any) -> None:
        result.append(against_n("sources", f"{mesh}, {curve}", FINEST, CHOSEN_L[mesh], ics, **more))

    for mesh, L in CHOSEN_L.items():
        read = {sampling: fem(mesh, FINEST, L, sampling=sampling) for sampling in ("fem", "linear_nodes", "linear")}
        for sampling, ics in read.items():
            add(mesh, sampling, ics)
            add(mesh, f"half_space, {sampling}", fem(mesh, FINEST, 8, sampling=sampling, far_boundary="half_space"))
            # One half uses computed coefficients, and the other the closed form.
            add(mesh, f"zz alone, {sampling}", ics, tangential={})
            add(mesh, f"tangential alone, {sampling}", {}, tangential=ics)
            add(mesh, f"no xy, {sampling}", ics, no_xy=True)
        add(mesh, "linear_nodes, tangential linear", read["linear_nodes"], tangential=read["linear"])
        add(mesh, "fem, tangential linear_nodes", read["fem"], tangential=read["linear_nodes"])
        add(mesh, "fem, tangential linear", read["fem"], tangential=read["linear"])
        add(mesh, "update", fem(mesh, FINEST, L, stopping_criterion="update", tolerance=1e-6))
    for sampling in ("fem", "linear_nodes"):
        other = fem("mesh2", FINEST, CHOSEN_L["mesh2"], sampling=sampling, diagonal="across")
        add("mesh2", f"across, {sampling}", other)
    result.append(against_n("sources", "analytic, no xy", FINEST, 0, {}, no_xy=True))
    return result


#: In computation order: the largest extent of a table comes first, so that the table serves the others.
PARTS = {
    "fig9": fig9, "limit": limit, "fig10": fig10, "fig11": fig11, "larger": larger,
    "bilinear": bilinear, "fig12": fig12, "sources": sources, "fig13": fig13, "fig14": fig14,
}  # fmt: skip
