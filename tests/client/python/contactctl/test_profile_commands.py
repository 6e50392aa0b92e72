"""Tests profile show and convert, and files of profiles in problems."""

from __future__ import annotations

import numpy as np
import pytest

from contactd.files.profile_text import format_profile
from contactd.wheel_rail import S1002, WheelRailSetup


@pytest.fixture
def wheel(shared):
    """S1002 by its points."""
    return shared.placed_profiles(WheelRailSetup(wheel=S1002())).right.wheel


def rows(points, between=" "):
    return "".join(f"{y:.9f}{between}{z:.9f}\n" for y, z in points)


HEAD = rows([(y, y * y / 600) for y in range(-36, 37)])


def test_show_says_what_a_file_is_taken_for(ctl, wheel):
    ctl.write("0815.WHL", "Stock=%Talent\nColumnDef=X,Y\n\n" + rows(wheel * (1, -1)))
    shown = ctl("profile", "show", "0815.WHL", "--smoothing", 5)
    assert shown.code == 0, shown.err
    for said in ("a wheel", "MiniProf", "turned, from the shape", "omitted lines", "half the amplitude of a wave of 5 mm remains", "smallest radius, hollow"):
        assert said in shown.out
    assert "by its shape\n" not in shown.out
    told = ctl("profile", "show", "0815.WHL", "--json").json
    assert told["kind"] == "wheel"
    assert told["evidence"]["file"] == {
        "format": "miniprof", "unit": 1, "mirror_y": False, "mirror_z": True, "oriented_by": "shape", "lines_left_out": 1,
    }  # fmt: skip
    np.testing.assert_allclose(told["points"], wheel, atol=1e-6)


def test_whose_profile_it_is_is_seen_by_its_shape(ctl, wheel):
    ctl.write("a.csv", rows(wheel, ";"))
    ctl.write("b.csv", HEAD)
    assert "a wheel, by its shape" in ctl("profile", "show", "a.csv").out
    assert "a rail, by its shape" in ctl("profile", "show", "b.csv").out
    refused = ctl("profile", "show", "b.csv", "--wheel")
    assert refused.code == 4
    assert "b.csv: its points do not determine the direction of z" in refused.err and "mirror_z" in refused.err
    assert ctl("profile", "show", "b.csv", "--wheel", "--keep-z").code == 0
    assert ctl("profile", "show", "b.csv", "--wheel", "--rail").code == 2


def test_options_say_what_a_file_does_not(ctl, wheel):
    ctl.write("inches.txt", rows(wheel * (-1, 1) / 25.4))
    assert "give unit" in ctl("profile", "show", "inches.txt", "--wheel").err
    assert "change mirror_y" in ctl("profile", "show", "inches.txt", "--wheel", "--unit", 25.4).err
    told = ctl("profile", "show", "inches.txt", "--wheel", "--unit", 25.4, "--mirror-y", "--shift-z", 0.5, "--json").json
    np.testing.assert_allclose(told["points"], np.add(wheel, (0, 0.5)), atol=1e-6)


def test_a_picture_is_drawn(ctl):
    pytest.importorskip("matplotlib")
    ctl.write("head.csv", HEAD)
    assert ctl("profile", "show", "head.csv", "--smoothing", 5, "-o", "head.png").code == 0
    assert (ctl.folder / "head.png").read_bytes()[1:4] == b"PNG"
    assert ctl("profile", "show", "head.csv", "-o", "head.doc").code == 2
    assert ctl("profile", "show", "head.csv", "-o", "nowhere/head.png").code == 2


@pytest.mark.parametrize("name", ["a.prw", "a.csv", "a.txt", "a.whl"])
def test_a_converted_file_is_the_same_profile(ctl, wheel, name):
    ctl.write("0815.whl", "\n" + rows(wheel * (1, -1)))
    made = ctl("profile", "convert", "0815.whl", name)
    assert (made.code, made.out) == (0, f"{name}: {len(wheel)} points of a wheel\n"), made.err
    before, after = (ctl("profile", "show", file, "--wheel", "--json").json for file in ("0815.whl", name))
    assert after["points"] == before["points"]
    assert after["evidence"]["file"]["mirror_z"] is (name == "a.whl")  # in which z is upwards


def test_a_rail_goes_to_a_file_of_miniprof(ctl):
    ctl.write("head.prr", format_profile(np.array([(y, y * y / 600) for y in range(-36, 37)]), "rail", ".prr"))
    assert ctl("profile", "convert", "head.prr", "head.ban").out == "head.ban: 73 points of a rail\n"
    before, after = (ctl("profile", "show", file, "--json").json for file in ("head.prr", "head.ban"))
    assert after["points"] == before["points"] and after["kind"] == "rail"
    assert after["evidence"]["file"]["format"] == "miniprof" and after["evidence"]["file"]["mirror_z"]
    assert "Remark=rail, made of head.prr by contactctl" in (ctl.folder / "head.ban").read_text()


def test_what_cannot_be_converted_is_refused_before_it_is_written(ctl):
    ctl.write("head.csv", HEAD)
    for wheel in ("head.prw", "head.whl"):
        assert "name ends in .prr or .ban" in ctl("profile", "convert", "head.csv", wheel).err
    assert "must end in" in ctl("profile", "convert", "head.csv", "head.doc").err
    assert ctl("profile", "convert", "none.csv", "head.prr").code == 2
    ctl.write("words.csv", "y z\n1 2\n3 four\n")
    ended = ctl("profile", "convert", "words.csv", "head.prr", "--rail")
    assert ended.code == 4 and 'words.csv, line 3, has "four"' in ended.err
    assert not (ctl.folder / "head.prr").exists() and not (ctl.folder / "head.prw").exists()


def test_an_empty_profile_is_refused_as_any_other_one(ctl):
    ctl.write("empty.csv", "")
    ctl.write("blank.csv", " \n\n")
    ctl.write("empty.yaml", "{setup: {rail: {file: empty.csv}}, state: {Fz: 80e3}}")
    ended = ctl("profile", "show", "empty.csv")
    assert ended.code == 4 and "file = empty.csv: the file is empty. Give a file with the points of a profile" in ended.err
    assert ctl("profile", "show", "blank.csv", "--rail").code == 4
    ended = ctl("wheelrail", "solve", "empty.yaml")
    assert ended.code == 4 and "empty.csv: the file is empty" in ended.err and "INVALID_ARGUMENT" in ended.err


def test_texts_that_are_written_say_what_they_are():
    text = format_profile(np.array([[0.1, -2.0], [3.0, 1e-7]]), "rail", ".prr", ["two\npoints"])
    assert text.startswith("! two points\nheader.begin\n")
    assert "type     = 0" in text and "0.1 -2.0\n    3.0 1e-07\n  point.end\nspline.end\n" in text
    assert format_profile(np.array([[0.1, -2.0]]), "rail", ".csv", ["one"]) == "# one\ny,z\n0.1,-2.0\n"


def test_problems_name_files_beside_them(ctl):
    folder = ctl.folder / "rails"
    folder.mkdir()
    (folder / "head.csv").write_text(HEAD)
    rest = "track: {rail_origin: {y: 750, z: 0}}}, state: {Fz: 80e3}}"
    ctl.write("plain.yaml", "{setup: {rail: {file: rails/head.csv}, " + rest)
    ctl.write("said.yaml", "{setup: {rail: {file: {name: rails/head.csv, mirror_y: true}}, " + rest)
    one, other = (ctl("wheelrail", "geometry", name, "--json") for name in ("plain.yaml", "said.yaml"))
    assert one.code == other.code == 0, one.err + other.err
    found, mirrored = (ended.json["geometries"][0]["places"][0] for ended in (one, other))
    assert found["penetration"] == pytest.approx(mirrored["penetration"], rel=1e-6)
    origin = ["--set", 'setup.track.rail_origin={"y": 750, "z": 0}']
    by_option = ctl("wheelrail", "geometry", "--Fz", 80e3, "--set", "setup.rail.file=rails/head.csv", *origin, "--json")
    assert by_option.json == one.json
    ctl.write("missing.yaml", "{setup: {rail: {file: none.csv}}, state: {Fz: 80e3}}")
    ended = ctl("wheelrail", "solve", "missing.yaml")
    assert ended.code == 2 and "missing.yaml names none.csv, which cannot be read" in ended.err
