"""Compares the whole block with its quarter: linear prisms, and meshes in MFEM's format."""

import numpy as np
import pytest

from paper.fem.block_system import FAR, FREE, FRONT, LOADED, RIGHT, faces_to_draw, read_mesh
from paper.fem.full_model import AXES, compare, displacements, mirrored, prism_stiffness, stiffness

NU = 0.28
CORNERS = np.array([[0, 0, 0], [0.2, 1, 0.1], [0, 0.3, -2], [-3, 0, 0.5], [-2.8, 1, 0.6], [-3, 0.3, -1.5]])


def quarter(n=4):
    """Writes [-2, 0]^3 in n x n x n boxes of two prisms, in MFEM's format; the load is the first box's."""
    number = {(x, y, z): (x * (n + 1) + y) * (n + 1) + z for x in range(n + 1) for y in range(n + 1) for z in range(n + 1)}
    elements, faces = [], []
    for x, y, z in np.ndindex(n, n, n):
        a, b, c, d = [(y, z), (y + 1, z), (y + 1, z + 1), (y, z + 1)]
        for triangle in ((a, b, c), (a, c, d)):
            elements.append([number[(X, *at)] for X in (x, x + 1) for at in triangle])
    for i, j in np.ndindex(n, n):
        for axis in range(3):
            for end in (0, n):
                square = [tuple(np.insert(at, axis, end)) for at in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
                at_zero = {0: FRONT, 1: RIGHT, 2: LOADED if i == j == 0 else FREE}
                faces.append((FAR if end else at_zero[axis], [number[at] for at in square]))
    lines = ["MFEM mesh v1.0", "", "# a comment", "dimension", "3", "", "elements", str(len(elements))]
    lines += [f"1 6 {' '.join(map(str, element))}" for element in elements]
    lines += ["", "boundary", str(len(faces)), *(f"{a} 3 {' '.join(map(str, face))}" for a, face in faces)]
    lines += ["", "vertices", str(len(number)), "3", *(f"{-2 * x / n} {-2 * y / n} {-2 * z / n}" for x, y, z in number)]
    return read_mesh("\n".join(lines) + "\n")


def test_a_prism_that_is_moved_and_rotated_has_no_energy():
    matrix = prism_stiffness(CORNERS, NU)
    rotated = np.cross([0.3, -0.2, 0.5], CORNERS)
    assert np.abs(matrix @ np.tile([1, 2, 3], 6)).max() < 1e-12
    assert np.abs(matrix @ rotated.ravel()).max() < 1e-12


def test_a_prism_that_is_strained_uniformly_has_the_energy_of_its_volume():
    gradient = np.array([[0.1, 0.2, 0], [0.05, -0.3, 0.1], [0, 0.4, 0.2]])
    u = (CORNERS @ gradient.T).ravel()
    strain = (gradient + gradient.T) / 2
    volume = abs(np.linalg.det((CORNERS[[1, 2, 3]] - CORNERS[0]).T)) / 2
    density = 2 * np.sum(strain**2) + 2 * NU / (1 - 2 * NU) * np.trace(strain) ** 2
    assert u @ prism_stiffness(CORNERS, NU) @ u == pytest.approx(density * volume)


def test_a_mesh_is_read_with_its_counts_and_boundaries():
    mesh = quarter(2)
    assert (len(mesh.vertices), len(mesh.elements), len(mesh.faces)) == (27, 16, 24)
    assert mesh.vertices.min() == -2
    drawn = faces_to_draw(mesh)
    assert drawn["elements"] == 16
    assert drawn["faces"].count(";") + 1 == 12  # excludes the far faces
    assert len(drawn["positions"].split()) == 81


def test_a_mirrored_mesh_has_each_vertex_once():
    whole = mirrored(quarter(2))
    assert len(whole.vertices) == 5 * 5 * 3
    assert len(whole.elements) == 4 * 16
    assert {attribute for attribute, _ in whole.faces} == {FREE, LOADED, FAR}


def test_the_load_of_a_face_is_its_area():
    whole = mirrored(quarter(2))
    matrix = stiffness(whole, NU)
    u = displacements(whole, matrix, "z", {})
    clamped = np.abs(whole.vertices).max(axis=1) == 2
    clamped |= whole.vertices[:, 2] == -2
    assert (matrix @ u.ravel()).reshape(-1, 3)[clamped, 2].sum() == pytest.approx(-4)  # 2 x 2 on the far faces


def table_of_the_whole(mesh):
    whole = mirrored(mesh)
    matrix = stiffness(whole, NU)
    table = np.zeros((3, 3, 2, 2))
    for j, load in enumerate(AXES):
        u = displacements(whole, matrix, load, {})
        for k, l in np.ndindex(2, 2):
            table[:, j, l, k] = u[np.abs(whole.vertices - [k, l, 0]).sum(axis=1).argmin()]
    return table


def test_the_conditions_of_table_1_are_those_of_the_whole_block():
    mesh = quarter()
    found = compare(mesh, table_of_the_whole(mesh), NU)
    assert sorted(found) == sorted(i + j for i in AXES for j in AXES)
    assert max(one["paper_difference"] for one in found.values()) < 1e-9
    assert max(one["contactd_difference"] for one in found.values()) < 1e-9
    assert min(one["largest"] for one in found.values()) > 1e-3


def test_a_condition_that_is_wrong_is_seen(monkeypatch):
    mesh = quarter()
    monkeypatch.setitem(compare.__globals__["ZERO"], "x", {FRONT: "x", RIGHT: "y"})
    found = compare(mesh, table_of_the_whole(mesh), NU)
    assert found["xx"]["paper_difference"] > 1e-2
    assert found["zz"]["paper_difference"] < 1e-9
