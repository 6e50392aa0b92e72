"""Influence coefficients by finite elements: how tables of them are asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

__all__ = [
    "Body",
    "Diagonal",
    "FarBoundary",
    "FemIcs",
    "FemSolver",
    "LoadShape",
    "MeshKind",
    "Preset",
    "Sampling",
    "StoppingCriterion",
]

Body = Literal["half_space", "block", "longitudinally_uniform"]
LoadShape = Literal["constant", "bilinear"]
Preset = Literal[
    "paper-test1", "paper-test2", "paper-test3", "paper-mesh2-test1", "paper-mesh2-test2", "paper-mesh2-test3"
]
MeshKind = Literal["hex", "prism", "adaptive"]
Diagonal = Literal["outward", "across"]
FarBoundary = Literal["clamped", "half_space"]
Sampling = Literal["fem", "linear", "linear_nodes"]
FemSolver = Literal["auto", "amg_pcg", "direct"]
StoppingCriterion = Literal["residual", "update"]


@dataclass(frozen=True, kw_only=True)
class FemIcs:
    """Influence coefficients computed with finite elements; what is None takes the daemon's default.

    There are two ways to ask (docs/ic-tables.md). Either for an accuracy, and the daemon chooses mesh and solver::

        FemIcs(accuracy=1e-3)
        FemIcs(accuracy=1e-3, body="block", L_over_h=20, load_shape="bilinear", any_nu=True)

    or for a mesh, by one of the paper's presets, by fields, or both (fields win)::

        FemIcs("paper-test3", L_over_h=1280)

    ``FemIcs()`` asks for an accuracy of 1e-3. Lengths are ratios to the element size h of the grid (paper, Table 2), so
    that a table serves every element size.

    Attributes:
        preset: A test of the paper's Table 2 on its Mesh1 or Mesh2: sets mesh, order, l_over_h, h_over_hs, f, and
            far_boundary "clamped"; does not go with accuracy.
        L_over_h: Size L of the mesh over h, default 640; of a block that of the body, which goes with accuracy too.
        accuracy: Largest error, 1e-4 to 0.1: of xx, yy, zz relative, of the others times 2 pi G rho / (dx dy). Of the
            other fields any_nu, body, load_shape and (of a block) L_over_h go with it.
        any_nu: True: one build for every Poisson's ratio from 0 to 0.49; material.nu is the value to interpolate to.
        body: "half_space" (default), "block": [-L, L]^2 x [-L, 0], u = 0 on all faces but the top, or
            "longitudinally_uniform": the same cross-section everywhere along x, for which an accuracy is asked for.
        load_shape: Traction of the loaded element: "constant" (default), or "bilinear", the tent
            (1 - |x|/dx) (1 - |y|/dy).
        l_over_h: Of meshes "hex" and "prism": size of the uniform cube around the load over h, 0.5 to 64; default 1.
        h_over_hs: Of meshes "hex" and "prism": elements of the cube per element of the grid, even; l_over_h times it is
            whole; default 4.
        f: Of meshes "hex" and "prism": growth of the layers outside the cube, 1 to 10; default 1.2.
        t1_over_hs: Of meshes "hex" and "prism": first layer's thickness over the cube's element size; default 0, which
            means f.
        order: Polynomial order of the displacement, 1 to 6; default 2.
        mesh: "hex" (default, the paper's Mesh1), "prism" (its Mesh2) or "adaptive".
        diagonal: Of mesh "prism": the diagonal that halves a quadrilateral starts "outward" (default) from its corner
            nearest to the load, or runs "across".
        max_dofs: Of mesh "adaptive": no refinement beyond, 1000 to 5000000; default 60000.
        far_boundary: On the mesh's far faces: "clamped" (u = 0; with a preset, and for a block), or "half_space" (the
            displacements of the half-space under the load; the default otherwise).
        sampling: How displacements are read at the element centres: "fem" (default, the finite-element function), or
            linear between the vertices ("linear") or all nodes ("linear_nodes") of the surface mesh.
        solver: "auto" (default, the faster one), "amg_pcg" (with a preset) or "direct" (sparse Cholesky).
        stopping_criterion: Compared with tolerance: the true relative "residual" (default), or the relative "update"
            (the paper's).
        tolerance: Of the stopping criterion, 1e-13 to 1; default 1e-8.
        max_iterations: Of conjugate gradients, per load case; default 1000.
        strength_threshold: Of BoomerAMG, 0 to 1; chosen for the mesh when left out.
        section: Cross-section of a longitudinally uniform body as the wire has it (docs/protocol.md, docs/sections.md), for
            example {"rail_60e1": {"from": 2}} or {"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}, or
            {"profile_section": {"kind": "rail", "profile": ProfilePoints(...), "depth": 60}} of contactd.wheel_rail. Its
            columns are the rows of the grid, dy wide along the outline.
    """

    preset: Preset | None = field(default=None, kw_only=False)
    L_over_h: float | None = field(default=None, kw_only=False)

    accuracy: float | None = None
    any_nu: bool | None = None
    body: Body | None = None
    load_shape: LoadShape | None = None

    l_over_h: float | None = None
    h_over_hs: float | None = None
    f: float | None = None
    t1_over_hs: float | None = None
    order: int | None = None
    mesh: MeshKind | None = None
    diagonal: Diagonal | None = None
    max_dofs: int | None = None
    far_boundary: FarBoundary | None = None
    sampling: Sampling | None = None
    solver: FemSolver | None = None
    stopping_criterion: StoppingCriterion | None = None
    tolerance: float | None = None
    max_iterations: int | None = None
    strength_threshold: float | None = None
    section: Mapping[str, Any] | None = None

    @staticmethod
    def _is_told(told: dict[str, Any]) -> bool:
        return told.get("source") == "fem"
