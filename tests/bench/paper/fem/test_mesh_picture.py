"""Tests figure 4: faces in a row, and their positions in the drawing."""

import numpy as np
import pytest

from paper.fem.block_system import FRONT, RIGHT, Mesh, faces_to_draw
from paper.fem.mesh_picture import faces_of, projected


def test_faces_come_back_from_a_row_with_their_corners():
    vertices = np.array([[0, 0, 0], [0, -1, 0], [0, -1, -2], [-1.5, 0, 0]])
    mesh = Mesh(vertices, [[0, 1, 2, 3]], [(FRONT, [0, 1, 2]), (5, [1, 2, 3]), (RIGHT, [0, 2, 3])])
    found = faces_of(faces_to_draw(mesh))
    assert [attribute for attribute, _ in found] == [FRONT, RIGHT]
    assert found[0][1].tolist() == vertices[[0, 1, 2]].tolist()


def test_the_axes_are_equally_long_and_apart():
    x, y, z = projected(np.eye(3))
    assert [np.hypot(*axis) for axis in (x, y, z)] == pytest.approx([1, 1, 1])
    assert [x @ y, y @ z, z @ x] == pytest.approx([-0.5, -0.5, -0.5])
    assert z.tolist() == [0, 1]
    assert x[0] < 0 < y[0]
