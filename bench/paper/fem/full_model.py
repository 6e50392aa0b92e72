"""Checks Table 1 of the paper with the whole block, without any plane of symmetry, on linear prisms.

The mesh of the quarter is mirrored at x = 0 and y = 0, the whole element is loaded, and only u = 0 on the far faces is
prescribed. It is compared with the quarter under the conditions of Table 1 as the paper prints them. Both are small and
solved densely. contactd's own table of the same mesh is the third.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import numpy.typing as npt

from .block_system import FAR, FRONT, LOADED, RIGHT, Mesh

Array = npt.NDArray[np.float64]
AXES = "xyz"
OFFSETS = 2  #: along each axis: elements with centres at vertices of the meshes
#: Table 1: components that are zero at the front (x = 0) and at the right (y = 0), by the direction of the load.
ZERO = {
    "z": {FRONT: "x", RIGHT: "y"},
    "x": {FRONT: "yz", RIGHT: "y"},
    "y": {FRONT: "x", RIGHT: "xz"},
}  # fmt: skip


def stiffness(mesh: Mesh, nu: float) -> Array:
    """Returns the matrix of all prisms for G = 1, with three rows per vertex."""
    matrix = np.zeros((3 * len(mesh.vertices),) * 2)
    for element in mesh.elements:
        rows = (3 * np.array(element)[:, None] + np.arange(3)).ravel()
        matrix[np.ix_(rows, rows)] += prism_stiffness(mesh.vertices[element], nu)
    return matrix


def prism_stiffness(corners: Array, nu: float) -> Array:
    """This is exact: an extruded triangle is an affine image of MFEM's reference prism."""
    jacobian = (corners[[1, 2, 3]] - corners[0]).T
    inverse, volume = np.linalg.inv(jacobian), abs(np.linalg.det(jacobian))
    lame = 2 * nu / (1 - 2 * nu)
    result = np.zeros((18, 18))
    gauss = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3)
    for (xi, eta), zeta in product([(0.5, 0), (0.5, 0.5), (0, 0.5)], gauss):
        triangle, slopes = np.array([1 - xi - eta, xi, eta]), np.array([[-1, -1], [1, 0], [0, 1]])
        local = np.vstack([
            np.column_stack([slopes * (1 - zeta), -triangle]), np.column_stack([slopes * zeta, triangle]),
        ])  # fmt: skip
        gradients = local @ inverse  # shape [6, 3]
        divergence = gradients.ravel()
        # 2 eps : eps = grad u : grad v + grad u : (grad v)^T
        same = np.einsum("ak,bk,ij->aibj", gradients, gradients, np.eye(3))
        crossed = np.einsum("aj,bi->aibj", gradients, gradients)
        result += volume / 12 * ((same + crossed).reshape(18, 18) + lame * np.outer(divergence, divergence))
    return result


def mirrored(mesh: Mesh) -> Mesh:
    """Returns four copies of the quarter, which share their vertices on the planes of symmetry."""
    numbers: dict[tuple[float, ...], int] = {}
    vertices: list[Array] = []
    elements, faces = [], []

    def number_of(at: Array) -> int:
        key = tuple(np.round(at, 9) + 0.0)
        if key not in numbers:
            numbers[key] = len(vertices)
            vertices.append(at)
        return numbers[key]

    for signs in product((1, -1), (1, -1), (1,)):
        number = [number_of(vertex * signs) for vertex in mesh.vertices]
        elements += [[number[vertex] for vertex in element] for element in mesh.elements]
        faces += [
            (attribute, [number[vertex] for vertex in face])
            for attribute, face in mesh.faces if attribute not in (FRONT, RIGHT)
        ]  # fmt: skip
    return Mesh(np.array(vertices), elements, faces)


def displacements(mesh: Mesh, matrix: Array, load: str, zero: dict[int, str]) -> Array:
    """Returns displacements of all vertices under a unit traction along `load`. They are zero on the far faces, and
    components in `zero` on other faces."""
    forces, free = np.zeros((len(mesh.vertices), 3)), np.ones((len(mesh.vertices), 3), dtype=bool)
    for attribute, face in mesh.faces:
        for component in "xyz" if attribute == FAR else zero.get(attribute, ""):
            free[face, AXES.index(component)] = False
        if attribute == LOADED:  # a rectangle
            a, b, _, d = mesh.vertices[face]
            forces[face, AXES.index(load)] += np.linalg.norm(np.cross(b - a, d - a)) / 4
    rows = np.flatnonzero(free.ravel())
    result = np.zeros(free.size)
    result[rows] = np.linalg.solve(matrix[np.ix_(rows, rows)], forces.ravel()[rows])
    return result.reshape(-1, 3)


def surface_values(mesh: Mesh, u: Array, sign: int) -> Array:
    """Returns displacements at the offsets, shape [component, along y, along x], for these signs of x and y."""
    result = np.zeros((3, OFFSETS, OFFSETS))
    for k, l in product(range(OFFSETS), range(OFFSETS)):
        at = np.argmin(np.abs(mesh.vertices - [sign * k, sign * l, 0]).sum(axis=1))
        result[:, l, k] = u[at]
    return result


def compare(quarter: Mesh, table: Array, nu: float) -> dict[str, Any]:
    """Returns, by component, the differences of the quarter with Table 1 and of contactd's `table` to the whole block,
    and the largest value, all relative to A^zz under the load."""
    whole = mirrored(quarter)
    matrices = stiffness(whole, nu), stiffness(quarter, nu)
    full, paper = np.zeros((2, 3, 3, OFFSETS, OFFSETS))
    mirror = np.zeros_like(full)  # the whole block on the quarter's side
    for j, load in enumerate(AXES):
        u = displacements(whole, matrices[0], load, {})
        full[:, j], mirror[:, j] = surface_values(whole, u, 1), surface_values(whole, u, -1)
        paper[:, j] = surface_values(quarter, displacements(quarter, matrices[1], load, ZERO[load]), -1)
    scale = full[2, 2, 0, 0]
    return {
        component: {
            "paper_difference": float(np.abs(paper - mirror)[i, j].max() / scale),
            "contactd_difference": float(np.abs(table[:, :, :OFFSETS, :OFFSETS] - full)[i, j].max() / scale),
            "largest": float(np.abs(full)[i, j].max() / scale),
        }
        for i, j in product(range(3), range(3))
        for component in [AXES[i] + AXES[j]]
    }
