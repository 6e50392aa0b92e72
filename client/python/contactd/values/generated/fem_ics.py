"""Requests for finite-element tables of influence coefficients.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import KW_ONLY, dataclass
from typing import Any, Literal

__all__ = [
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

LoadShape = Literal["constant", "bilinear"]
Preset = Literal["paper-test1", "paper-test2", "paper-test3", "paper-mesh2-test1", "paper-mesh2-test2", "paper-mesh2-test3"]
MeshKind = Literal["hex", "prism", "adaptive"]
Diagonal = Literal["outward", "across"]
FarBoundary = Literal["clamped", "half_space"]
Sampling = Literal["fem", "linear", "linear_nodes"]
FemSolver = Literal["auto", "amg_pcg", "direct"]
StoppingCriterion = Literal["residual", "update"]


@dataclass(frozen=True)
class FemIcs:
    """Influence coefficients computed with finite elements.

    Request either an accuracy or a mesh (docs/ic-tables.md). For an accuracy, the daemon chooses mesh and solver;
    ``FemIcs()`` requests 1e-3. Describe a mesh by one of the paper's presets, by fields, or both; fields override the
    preset. Lengths are ratios to the element size h of the grid (paper, Table 2), so a table applies to every element
    size. None is the daemon's default.

    ::

        FemIcs(accuracy=1e-3)
        FemIcs(accuracy=1e-3, body="block", L_over_h=20, load_shape="bilinear", any_nu=True)
        FemIcs("paper-test3", L_over_h=1280)

    Attributes:
        preset: A test of the paper's Table 2, on Mesh1 or (mesh2) on Mesh2. It sets mesh, order, l_over_h, h_over_hs
            and f, and far_boundary clamped. Fields in the request override it.
        L_over_h: Edge of the block over the element size (> 0). For body block it is the size of the body and may be
            combined with accuracy. Default 640.
        accuracy: Largest requested error (0.0001 to 0.1): relative for xx, yy, zz, times 2 pi G rho / (dx dy) for the
            others. Mesh and solver are chosen to reach it. Default 1e-3 if no field names a mesh.
        any_nu: True to build a family of tables over Poisson's ratio from 0 to 0.49. The answer is interpolated to
            material.nu. Default False.
        body: The elastic body: the half-space z <= 0; the block [-L, L]^2 x [-L, 0] with u = 0 on all faces except the
            top; or longitudinally_uniform, with the same cross-section everywhere along x, which requires an accuracy.
            Default "half_space".
        load_shape: Traction of the loaded element: 1 over it, or the bilinear hat function (1 - |x|/dx)(1 - |y|/dy).
            Default "constant".
        l_over_h: Edge of the uniform cube over the element size, for meshes hex and prism (0.5 to 64); l_over_h *
            h_over_hs is an integer. Default 1.
        h_over_hs: Element size over that of the cube's mesh, an even integer, for meshes hex and prism (2 to 128).
            Default 4.
        f: Growth of the layers outside of the cube, of meshes hex and prism (1 to 10). Default 1.2.
        t1_over_hs: Thickness of the first layer outside the cube over the element size of the cube's mesh, for meshes
            hex and prism (>= 0); 0 selects f, the paper's choice. Default 0.
        order: Polynomial order of the displacement (1 to 6). Default 2.
        mesh: Kind of mesh. hex is the paper's Mesh1 and prism its Mesh2. adaptive consists of hexahedra refined where
            an error estimate requires it. Default "hex".
        diagonal: Diagonal that divides a quadrilateral of the cross-section, for mesh prism: outward from its corner
            nearest to the load, or across. Default "outward".
        max_dofs: Number of unknowns beyond which an adaptive mesh is not refined. An adaptive mesh starts from its own
            initial mesh, is built by one process, and cannot be combined with any_nu. Default 60000.
        far_boundary: Condition on the far faces of the mesh: clamped is u = 0; half_space prescribes the displacements
            of the half-space under the load. Default half_space; clamped with a preset and for body block, which
            accepts only this value.
        sampling: Displacements at the element centres: the finite-element function, or linear between the vertices
            (linear) or all nodes (linear_nodes) of the surface mesh. Default "fem".
        solver: Conjugate gradients preconditioned by BoomerAMG, sparse Cholesky, or auto, the faster of both. Default
            auto; amg_pcg with a preset.
        stopping_criterion: Quantity compared with the tolerance: the true relative residual, or the relative update of
            the displacements, as in the paper. Default "residual".
        tolerance: Bound of the stopping criterion of each solve (>= 1e-13, < 1). Default 1e-08.
        max_iterations: Bound of the conjugate-gradient iterations, per load case. Default 1000.
        strength_threshold: Strength threshold of BoomerAMG (>= 0, < 1). If None, chosen for the mesh.
        section: Cross-section of a longitudinally uniform body as on the wire (docs/protocol.md, docs/sections.md), for
            example {"rail_60e1": {"from": 2}} or {"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}, or
            {"profile_section": {"kind": "rail", "profile": ProfilePoints(...), "depth": 60}} of contactd.wheel_rail.
            Its columns are the rows of the grid, dy wide along the outline.
    """

    _fixed = ("source", "fem")

    preset: Preset | None = None
    L_over_h: float | None = None
    _: KW_ONLY
    accuracy: float | None = None
    any_nu: bool | None = None
    body: Literal["half_space", "block", "longitudinally_uniform"] | None = None
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
