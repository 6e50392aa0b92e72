"""Tests the file of subsurface points, and its largest stresses."""


from __future__ import annotations

import numpy as np
import pytest

from contactd.contact_files.case_results import COMPONENTS, StressField
from contactd.contact_files.prints.out_subsurface import extremes
from contactd.contact_files.prints.subs_file import subs_text


def field() -> StressField:
    stress = np.zeros((6, 2, 1, 3))
    stress[0, 1, 0, 2], stress[5, 0, 0, 1], stress[2, 1, 0, 0] = 4.0, -7.0, 1.5
    block = {"X": np.array([-1.0, 0.0, 1.0]), "Y": np.array([0.5]), "Z": np.array([-2.0, 0.1])}
    block |= {f"U{axis}": np.zeros((2, 1, 3)) for axis in "XYZ"}
    return StressField(block | {f"SIG{name}": part for name, part in zip(COMPONENTS, stress)})


def test_a_file_of_points_has_x_fastest_and_one_width() -> None:
    table = np.loadtxt(subs_text([field()], all_components=True).splitlines(), comments="%")
    assert table.shape == (7, 14)
    assert table[0, :3].tolist() == [3, 1, 2]
    assert table[1:4, :3].tolist() == [[-1, 0.5, -2], [0, 0.5, -2], [1, 0.5, -2]]
    assert table[6, 8] == 4 and table[2, 13] == -7 and table[4, 10] == 1.5
    assert table[4, 7] == pytest.approx(np.sqrt(3) * 1.5, rel=1e-5)  # von Mises stress of shear
    assert np.loadtxt(subs_text([field()], all_components=False).splitlines(), comments="%").shape == (7, 8)


def test_the_largest_of_each_kind_is_told_with_its_place() -> None:
    lines = list(extremes(field(), 1))
    assert lines[0] == " SUBSURFACE STRESSES BLOCK  1:"
    assert " ABSMAX SIGZZ =    -7.000 AT (X,Y,Z) = (   0.000,   0.500,  -2.000)".replace("SIGZZ", " SIGZZ") in lines
    assert " MAX    SIGMA1 =     4.000 AT (X,Y,Z) = (   1.000,   0.500,   0.100)" in lines
    assert all(line[7:14].strip() for line in lines[2:]) and all(line[16:].split() for line in lines[2:])
