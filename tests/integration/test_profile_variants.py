"""Tests hundreds of variants of measured profiles: the orientation and the unit must be correct, and every doubt must
cause a warning.

The files are public ones of the CONTACT program, which are read from their folder next to the repository.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from contactd import InvalidArgument
from contactd.wheel_rail import ProfileFile, Track, WheelRailSetup

FOLDER = Path(__file__).parents[3] / "shared" / "contact" / "testbank" / "profiles"
WHEELS = [
    "Car7216_0001r.whl", "Car7358_0001r.whl", "Car7422_0001r.whl", "Car7813_0001r.whl", "avg_wheel.whl", "left-wheel-v1-pre-dry.whl",
    "right-wheel-v1-pre-dry.whl", "whl_left_iter288.whl", "whl_left_iter795.whl", "MBench_S1002_v3.prw", "worn_high_mileage.prw",
]  # fmt: skip
RAILS = [
    "avg_HR.BAN", "avg_low2.ban", "left-roller-v1-pre-dry.ban", "right-roller-v1-pre-dry.ban", "rail_left_iter288.ban",
    "rail_left_iter795.ban", "MBench_UIC60_v3.prr", "site_b_hr.prr", "uic60_true.prr",
]  # fmt: skip
TRACK = Track(rail_origin=(750.0, 0.0))


@dataclass(frozen=True)
class Variant:
    """Describes a variant of a profile's file, its options, and the expected result: the profile, these points, or a
    refusal that contains one of some words."""

    name: str
    ending: str
    text: str
    options: dict[str, Any] = field(default_factory=dict)
    points: Any = None
    refusal: tuple[str, ...] = ()
    warning: str = ""  #: that does in place of a refusal
    part: bool = False  #: it may also be refused, with what to say


def rows(points: Any, between: str = " ", behind: str = "", comma: bool = False) -> str:
    """Writes one point per line, with all significant digits."""
    lines = [f"{y:.7f}{between}{z:.7f}" for y, z in points]
    return "".join(f"{line.replace('.', ',') if comma else line}{behind}\n" for line in lines)


def simpack(kind: str, body: str, keys: str = "units.len.f = 1000\n", type_line: str = "type = {}\n") -> str:
    """Writes a file's head like other programs."""
    head = "header.begin\n  version = 1\n" + type_line.format(1 if kind == "wheel" else 0) + "header.end\nspline.begin\n"
    return f"{head}approx.smooth = 0.0\nfile = 'none'\n{keys}point.begin\n{body}point.end\nspline.end\nanything = at all\n"


#: Heads of MiniProf of several years.
HEADS = {
    "none": "\n",
    "keys": "ProgramName=MINIPROF\nProgramVer=2.9.97\nDate=18/09/2022\nXYPoints=600\nColumnDef=X,Y\nXOffset=0.0000\nYOffset=0.0000\n\n",
    "keys without a blank line": "ProgramName=MINIPROF\nStock=%Talent\nSide=%L\nTilt=\n",
    "keys alone": "#MINIPROF\nwheel\nStock.......:\nSide........: L\n32.58 37.11 14.71\n(Sd/Sh/qR)\n\n",
    "quoted": '"ColumnDef=A,Y,X\nRail=left\nRefPoint1=0.0000, 0.0000\n\n',
}


def variants(kind: str, points: Any) -> Iterator[Variant]:
    """All forms of a profile."""
    miniprof, spline = (".whl", ".prw") if kind == "wheel" else (".ban", ".prr")
    up, aside = points * (1, -1), points * (-1, 1)
    # A rail may be accepted as a groove.
    wrong: dict[str, Any] = {"refusal": ("mirror_z", "out of order"), "warning": "upside down" if kind == "rail" else ""}
    # Variants change the order, and the direction of z.
    for name, given in (("", points), (", z upwards", up), (", reversed", points[::-1]), (", reversed and upwards", up[::-1])):
        yield Variant(f"columns{name}", ".txt", rows(given))
        yield Variant(f"MiniProf{name}", miniprof, HEADS["keys"] + rows(given))
    yield Variant("Simpack, reversed", spline, simpack(kind, rows(points[::-1])))
    yield Variant("Simpack that says mirror.z", spline, simpack(kind, rows(up), "units.len.f = 1000\nmirror.z = 1\n"))
    yield Variant("Simpack that lies about z", spline, simpack(kind, rows(up)), **wrong)
    yield Variant("Simpack, mirrored by the request", spline, simpack(kind, rows(up)), {"mirror_z": True})
    yield Variant("columns, mirrored by the request", ".txt", rows(up), {"mirror_z": True})
    yield Variant("columns, mirrored wrongly", ".txt", rows(points), {"mirror_z": True}, **wrong)
    # Sides: a flange says where it is, a rail's head does not.
    other = {"refusal": ("mirror_y",)} if kind == "wheel" else {"points": aside}
    yield Variant("columns, mirrored", ".txt", rows(aside), **other)
    yield Variant("MiniProf, mirrored and upwards", miniprof, HEADS["keys"] + rows(aside * (1, -1)), **other)
    yield Variant("columns, mirrored back", ".txt", rows(aside), {"mirror_y": True})
    yield Variant("Simpack, mirrored twice", spline, simpack(kind, rows(points), "units.len.f = 1000\nmirror.y = 1\n"), {"mirror_y": True})
    # Units.
    for unit, name in ((25.4, "inches"), (1000.0, "metres")):
        yield Variant(f"columns in {name}", ".csv", rows(points / unit), refusal=("give unit",))
        yield Variant(f"columns in {name}, said", ".csv", rows(points / unit), {"unit": unit})
        yield Variant(f"MiniProf in {name}, upwards", miniprof, HEADS["none"] + rows(up / unit), refusal=("give unit",))
        yield Variant(f"Simpack in {name}", spline, simpack(kind, rows(points / unit), f"units.len.f = {1000 / unit}\n"))
    yield Variant("Simpack in metres without a word", spline, simpack(kind, rows(points / 1000), ""))
    yield Variant("Simpack in mm without a word", spline, simpack(kind, rows(points), ""), refusal=("give unit", "correct the point or the unit"))
    yield Variant("columns in micrometres", ".csv", rows(points * 1000), refusal=("give unit", "or the unit"))
    # How numbers are written.
    for between, name in ((" ", "blanks"), ("\t", "tabs"), (";", "semicolons"), ("; ", "semicolons and blanks")):
        yield Variant(f"decimal commas and {name}", ".csv", "y;z\n" + rows(points, between, comma=True))
        yield Variant(f"{name} in MiniProf with decimal commas", miniprof, HEADS["keys"] + rows(up, between, comma=True))
    yield Variant("Simpack with decimal commas", spline, simpack(kind, rows(points, comma=True)), refusal=("instead of a number",))
    yield Variant("commas", ".csv", "Y [mm],Z [mm]\n" + rows(points, ","))
    yield Variant("quotation marks", ".csv", '"y";"z"\n' + "".join(f'"{y:.7f}";"{z:.7f}"\n' for y, z in points))
    yield Variant("exponents of Fortran", ".dat", "".join(f"{y:.9E} {z:.9E}\n".replace("E", "D") for y, z in points))
    yield Variant("BOM and CRLF", ".csv", "\ufeffy,z\n".replace("\n", "\r\n") + rows(points, ",").replace("\n", "\r\n"))
    # Comments.
    yield Variant("comments in columns", ".txt", "% head\n! head\n# head\n" + rows(points, behind=" # 1 2"))
    yield Variant("comments in MiniProf", miniprof, HEADS["keys"] + '"1 2\n' + rows(up, behind="  % dent 5"))
    yield Variant("words in MiniProf", miniprof, HEADS["keys"] + rows(up, behind="  added by hand"))
    yield Variant("comments in Simpack", spline, "! head\n% head\n" + simpack(kind, "! y z\n" + rows(points, behind=" 1.0 ! weight")))
    # Heads of other years.
    for name, head in HEADS.items():
        yield Variant(f"MiniProf, head: {name}", miniprof, head + rows(up))
    columns = "".join(f"{i} {z:.7f} 0.5 {y:.7f}\n" for i, (y, z) in enumerate(up))
    yield Variant("MiniProf, other columns", miniprof, "ColumnDef=N,Y,A,X\n\n" + columns)
    yield Variant("MiniProf with offsets", miniprof, "XOffset=10\nYoffset=-2.5\n\n" + rows(up - (10, -2.5)))
    # Variants contain only parts, which may not show the original orientation.
    for name, kept in (("first", slice(None, -len(points) // 3)), ("last", slice(len(points) // 3, None)), ("middle", slice(len(points) // 4, -len(points) // 4))):
        yield Variant(f"the {name} part", ".txt", rows(points[kept]), points=points[kept], part=True)
        yield Variant(f"the {name} part, upwards", miniprof, HEADS["keys"] + rows(up[kept]), points=points[kept], part=True)
        yield Variant(f"the {name} part, said", ".txt", rows(up[kept]), {"mirror_z": True, "unit": 1}, points=points[kept], part=True)
    # These files are not profiles.
    yield Variant("a word in the place of a number", ".txt", rows(points[:9]) + "0,1 zwei\n", refusal=("line 10",))
    yield Variant("a third number", ".txt", rows(points[:9]) + "1 2 3\n", refusal=("line 10",))
    yield Variant("a file that was cut off", spline, simpack(kind, rows(points)).partition("point.end")[0], refusal=("point.end",))
    yield Variant("the other type", spline, simpack(kind, rows(points), type_line="type = {}9\n"), refusal=("type",))
    yield Variant("points in no order", ".txt", rows(points[np.random.default_rng(1).permutation(len(points))]), refusal=("cross themselves", "out of order", "mirror_z"))


def distance(points: Any, line: Any) -> float:
    """Returns the largest distance of every third point from the lines between others (mm)."""
    points = points[::3]
    begin, along = line[:-1], np.diff(line, axis=0)
    from_begin = points[:, None] - begin
    share = np.clip((from_begin * along).sum(2) / (along**2).sum(1), 0, 1)
    return float(np.sqrt(((from_begin - share[..., None] * along) ** 2).sum(2).min(1)).max())


def read(client: Any, kind: str, profile: ProfileFile) -> Any:
    """Returns the curve's points and their evidence."""
    setup = WheelRailSetup(wheel=profile, track=TRACK) if kind == "wheel" else WheelRailSetup(rail=profile, track=TRACK)
    placed = client.placed_profiles(setup).right
    return (placed.wheel, placed.wheel_evidence) if kind == "wheel" else (placed.rail, placed.rail_evidence)


@pytest.mark.slow  # thousands of files
@pytest.mark.timeout(900)
@pytest.mark.parametrize(("kind", "name"), [*(("wheel", name) for name in WHEELS), *(("rail", name) for name in RAILS)])
def test_a_measured_profile_is_what_it_is_in_every_form(shared, kind, name):
    if not FOLDER.exists():
        pytest.skip(f"there is no {FOLDER}")
    original, evidence = read(shared, kind, ProfileFile(FOLDER / name))
    if kind == "wheel":
        places = evidence.wheel
        assert places.tip.y < places.throat.y < places.tread.y, name
        assert places.tip.z > places.throat.z > places.tread.z, name
        assert 25 < places.tip.z - places.tread.z < 40, name  # the height of a flange
        assert abs(places.tread.y - places.tip.y - 55) < 1e-6, name
    counted = 0
    for variant in variants(kind, original):
        counted += 1
        where = f"{name}: {variant.name}"
        profile = ProfileFile(f"a{variant.ending}", text=variant.text, **variant.options)
        sentence = ""
        try:
            points, found = read(shared, kind, profile)
        except InvalidArgument as refused:
            sentence = str(refused)
        if sentence:
            words = variant.refusal or (("mirror_z", "give unit", "mirror_y") if variant.part else ())
            assert any(word in sentence for word in words), f"{where}: {sentence}"
            assert f"a{variant.ending}" in sentence, f"{where}: {sentence}"
            continue
        if variant.warning and any(variant.warning in warning for warning in found.warnings):
            continue
        assert not variant.refusal, f"{where} was taken"
        expected = original if variant.points is None else variant.points
        assert distance(points, expected) < 2e-3, where
        assert found.points_kept > 0.5 * found.points_given, where
        if not variant.part:
            assert distance(expected, points) < 2e-3, where
        source = "request" if "mirror_z" in variant.options else "file" if variant.ending in (".prw", ".prr") else "shape"
        assert found.file.oriented_by == source, where
    assert counted > 50
