"""Tests profiles in files: a client reads the file, a daemon its text."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import InvalidArgument
from contactd.wheel_rail import (
    S1002,
    ProfileFile,
    ProfilePoints,
    Track,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
)

COARSE = {"dx": 1, "dy": 1, "model": "hertz", "friction": None}


@pytest.fixture
def wheel(shared):
    """S1002 by its points."""
    return shared.placed_profiles(WheelRailSetup(wheel=S1002())).right.wheel


def text_of(points, between=" "):
    return "".join(f"{y:.9g}{between}{z:.9g}\n" for y, z in points)


def test_a_wheel_in_a_file_is_that_of_its_points(shared, wheel, tmp_path):
    path = tmp_path / "wheel.whl"
    path.write_text("ProgramName=MINIPROF\nStock=%Talent\nColumnDef=X,Y\n\n" + text_of(wheel * (1, -1)))
    state = WheelRailState(position=WheelsetPosition(y=3.0), Fz=8e4)
    by_file = shared.wheel_rail(WheelRailSetup(wheel=ProfileFile(path), **COARSE), state)
    rounded = np.array([[float(f"{value:.9g}") for value in point] for point in wheel])
    by_points = shared.wheel_rail(WheelRailSetup(wheel=ProfilePoints(rounded), **COARSE), state)
    assert by_file.z == by_points.z
    assert by_file.forces == by_points.forces
    placed = shared.placed_profiles(WheelRailSetup(wheel=ProfileFile(path))).right
    reading = placed.wheel_evidence.file
    assert (reading.format, reading.unit, reading.mirror_y, reading.mirror_z) == ("miniprof", 1, False, True)
    assert (reading.oriented_by, reading.lines_left_out) == ("shape", 2)
    assert placed.wheel_evidence.points_given == placed.wheel_evidence.points_kept == len(wheel)
    assert placed.rail_evidence.file is None


def test_what_neither_file_nor_points_say_is_asked_for(shared, wheel):
    def setup(**options):
        return WheelRailSetup(wheel=ProfileFile("wheel.csv", text=text_of(wheel / 25.4, "\t"), **options))

    with pytest.raises(InvalidArgument, match=r"setup\.wheel\.file.*wheel\.csv: its points span 5\.\d+ .* give unit, 25\.4 for inches"):
        shared.placed_profiles(setup())
    np.testing.assert_allclose(shared.placed_profiles(setup(unit=25.4)).right.wheel, wheel, atol=1e-6)
    cone = ProfileFile("cone.csv", text="-60;3\n60;-3\n")
    with pytest.raises(InvalidArgument, match=r"setup\.wheel\.file.*give mirror_z"):
        shared.wheel_rail(WheelRailSetup(wheel=cone, **COARSE), WheelRailState(Fz=8e4))


def test_a_refusal_has_the_line(shared):
    rail = ProfileFile("/home/me/head.csv", text="y z\n-20 3\n0 0\n20 drei\n")
    with pytest.raises(InvalidArgument) as refused:
        shared.wheel_rail(WheelRailSetup(rail=rail, **COARSE), WheelRailState(Fz=8e4))
    assert [violation.field for violation in refused.value.violations] == ["setup.rail.file"]
    assert 'head.csv, line 4, has "drei"' in str(refused.value) and "/home" not in str(refused.value)


def test_slices_and_sections_take_files(shared):
    head = "".join(f"{y} {y * y / 600}\n" for y in range(-30, 31))
    slices = [(x, ProfileFile("a.txt", text=head, mirror_y=x > 0)) for x in (-100.0, 100.0)]
    setup = WheelRailSetup(rail_slices=slices, track=Track(rail_origin=(750, 0)), **COARSE)
    solution = shared.wheel_rail(setup, WheelRailState(Fz=8e4))
    assert solution.patches
    steep = [(x, ProfileFile("a.txt", text="-30 3\n30 -3\n")) for x in (-100.0, 100.0)]
    with pytest.raises(InvalidArgument, match=r"setup\.rail_slices\[0\]\.profile\.file"):
        shared.wheel_rail(WheelRailSetup(rail_slices=steep, track=Track(rail_origin=(750, 0)), **COARSE), WheelRailState(Fz=8e4))
