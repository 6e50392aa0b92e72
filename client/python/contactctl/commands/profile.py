"""Implements profile, which reads a profile file, and converts it to other formats."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Literal

import click
import numpy as np
import typer

from contactd import Client, ContactWarning, InvalidArgument, __version__
from contactd.files.profile_text import ENDINGS, format_profile
from contactd.wheel_rail import ProfileEvidence, ProfileFile, Track, WheelRailSetup
from contactd.wheel_rail_pictures import curvature_of

from ..common import Command, Group, connected, setting
from ..files import writable, write_text
from ..output import emit, facts, number, plain_json, warn
from ..saving import check_picture
from ..writing.profile_picture import save_profile_picture

__all__ = ["add_to"]

Kind = Literal["wheel", "rail"]
File = Annotated[Path, typer.Argument(help="Profile file: Simpack (.prr, .prw), MiniProf (.ban, .whl), or two columns y and z.")]
IsWheel = Annotated[bool, typer.Option("--wheel", help="The profile is that of a wheel.")]
IsRail = Annotated[bool, typer.Option("--rail", help="The profile is that of a rail.")]
Unit = Annotated[float | None, typer.Option("--unit", help="Unit of its points in mm: 25.4 for inches, 1000 for metres. Default: that in the file.")]
MirrorY = Annotated[bool, typer.Option("--mirror-y", help="Mirror y.")]
MirrorZ = Annotated[bool | None, typer.Option("--mirror-z/--keep-z", help="Mirror z or not. Default: according to the file or its shape.")]
ShiftY = Annotated[float, typer.Option("--shift-y", help="Added to y last (mm).")]
ShiftZ = Annotated[float, typer.Option("--shift-z", help="Added to z last (mm).")]
Smoothing = Annotated[float, typer.Option("--smoothing", help="Wavelength whose amplitude smoothing halves (mm); 5 suits measured profiles.")]
_WIDTHS_OF_WHEELS = (95, 180)  #: mm
_BY_ENDING: dict[str, Kind] = {".whl": "wheel", ".prw": "wheel", ".ban": "rail", ".prr": "rail"}


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Profile files.", rich_markup_mode=None)
    family.command(cls=Command)(show)
    family.command(cls=Command)(convert)
    app.add_typer(family, name="profile")


def show(
    file: File, wheel: IsWheel = False, rail: IsRail = False, unit: Unit = None, mirror_y: MirrorY = False, mirror_z: MirrorZ = None,
    shift_y: ShiftY = 0, shift_z: ShiftZ = 0, smoothing: Smoothing = 0,
    output: Annotated[str | None, typer.Option("--output", "-o", metavar="FILE", help="Write a picture: .png, .svg or .pdf.")] = None,
) -> None:  # fmt: skip
    """Show the detected properties of a file, its points, their curvature, and warnings."""
    if output is not None:
        check_picture("--output", output)
    profile = _file(file, unit, mirror_y, mirror_z, shift_y, shift_z, smoothing)
    with connected(local_unless_named=True) as client:
        found = _Found(client, profile, _kind(wheel, rail))
        measured = _Found(client, replace(profile, smoothing_length=None), found.kind).points if smoothing else None
    if output is not None:
        save_profile_picture(Path(output), f"{file.name}: a {found.kind}", found.points, found.evidence, measured)
    given = {"kind": found.kind, "evidence": found.evidence, "points": found.points}
    emit(setting().json, plain_json(given), facts(file.name, _rows(found, smoothing)))
    warn(found.evidence.warnings)


def convert(
    file: File,
    target: Annotated[Path, typer.Argument(help="Simpack (.prr, .prw), MiniProf (.ban, .whl), or two columns (.csv, .txt), in mm; z downwards, in MiniProf upwards.")],
    wheel: IsWheel = False, rail: IsRail = False, unit: Unit = None, mirror_y: MirrorY = False, mirror_z: MirrorZ = None,
    shift_y: ShiftY = 0, shift_z: ShiftZ = 0, smoothing: Smoothing = 0,
) -> None:  # fmt: skip
    """Write the interpreted points of a file: cleaned, oriented, in mm."""
    if target.suffix not in ENDINGS:
        raise click.UsageError(f"{target}: the name must end in {', '.join(ENDINGS)}.")
    writable("the target", target)
    profile = _file(file, unit, mirror_y, mirror_z, shift_y, shift_z, smoothing)
    with connected(local_unless_named=True) as client:
        found = _Found(client, profile, _kind(wheel, rail))
    if target.suffix in _BY_ENDING and _BY_ENDING[target.suffix] != found.kind:
        raise click.UsageError(f"{target}: {file.name} is a {found.kind}'s, whose name ends in {'.prw or .whl' if found.kind == 'wheel' else '.prr or .ban'}.")
    smoothed = f", smoothed over {smoothing:g} mm" if smoothing else ""
    remark = f"{found.kind}, made of {file.name} by contactctl {__version__}{smoothed}: y to the field side, z {'upwards' if target.suffix in ('.ban', '.whl') else 'downwards'}, mm"
    write_text(target, format_profile(found.points, found.kind, target.suffix, [remark]))
    given = {"kind": found.kind, "target": str(target), "points": len(found.points)}
    emit(setting().json, given, f"{target}: {len(found.points)} points of a {found.kind}")
    warn(found.evidence.warnings)
    warn(found.evidence.warnings)


def _file(
    file: Path, unit: float | None, mirror_y: bool, mirror_z: bool | None, shift_y: float, shift_z: float, smoothing: float
) -> ProfileFile:
    return ProfileFile(
        file, unit=unit, mirror_y=mirror_y or None, mirror_z=mirror_z, shift_y=shift_y or None, shift_z=shift_z or None,
        smoothing_length=smoothing or None,
    )  # fmt: skip


def _kind(wheel: bool, rail: bool) -> Kind | None:
    if wheel and rail:
        raise click.UsageError("--wheel and --rail: a file can be that of one only.")
    return "wheel" if wheel else "rail" if rail else None


class _Found:
    """A profile as read by the daemon, and its side."""

    def __init__(self, client: Client, profile: ProfileFile, kind: Kind | None) -> None:
        named = _BY_ENDING.get(Path(profile.name).suffix.lower())
        self.by_shape = kind is None and named is None
        self.kind: Kind = kind or named or "wheel"
        try:
            self._read(client, profile)
            width = float(np.ptp(self.points[:, 0]))
            is_wheel = _WIDTHS_OF_WHEELS[0] <= width <= _WIDTHS_OF_WHEELS[1]
        except InvalidArgument as error:
            if not self.by_shape or "direction of z" not in str(error):
                raise
            is_wheel = False
        if self.by_shape and not is_wheel:
            self.kind = "rail"
            self._read(client, profile)

    def _read(self, client: Client, profile: ProfileFile) -> None:
        # The position needs no gauge face, which some rails do not have.
        track = Track(rail_origin=(750.0, 0.0))
        setup = WheelRailSetup(wheel=profile, track=track) if self.kind == "wheel" else WheelRailSetup(rail=profile, track=track)
        with warnings.catch_warnings():  # `show` prints their warnings.
            warnings.simplefilter("ignore", ContactWarning)
            placed = client.placed_profiles(setup).right
        self.points = placed.wheel if self.kind == "wheel" else placed.rail
        self.evidence: ProfileEvidence = placed.wheel_evidence if self.kind == "wheel" else placed.rail_evidence


def _rows(found: _Found, smoothing: float) -> list[tuple[str, Any]]:
    evidence, reading = found.evidence, found.evidence.file
    formats = {"simpack": "Simpack", "miniprof": "MiniProf", "columns": "two columns"}
    sources = {"file": "from the file", "shape": "from the shape", "request": "as requested"}
    (left, right), (top, low) = ((float(of.min()), float(of.max())) for of in found.points.T)
    rows: list[tuple[str, Any]] = [("profile of", f"a {found.kind}{', by its shape' if found.by_shape else ''}")]
    if reading is not None:
        rows += [
            ("format", formats[reading.format]),
            ("unit", f"{number(float(reading.unit))} mm"),
            ("y", "turned" if reading.mirror_y else "as given"),
            ("z", f"{'turned' if reading.mirror_z else 'as given'}, {sources[reading.oriented_by]}"),
            ("omitted lines", reading.lines_left_out or None),
        ]
    rows += [
        ("points", f"{evidence.points_kept} of {evidence.points_given}, {number(round(evidence.spacing, 4))} mm apart"),
        ("rounded to (mm)", float(evidence.rounded_to) if evidence.rounded_to else None),
        ("y (mm)", f"{left:.3f} to {right:.3f}"),
        ("z (mm)", f"{top:.3f} to {low:.3f}"),
        ("kinks at y (mm)", ", ".join(f"{y:.3f}" for y in evidence.kinks[:20]) or None),
    ]
    if evidence.wheel is not None:
        places = ((name, getattr(evidence.wheel, name)) for name in ("tip", "throat", "tread"))
        rows.append(("flange", ", ".join(f"{name} at ({at.y:.2f}, {at.z:.2f})" for name, at in places)))
    if smoothing:
        moved = f"{1e3 * evidence.largest_distance:.3g} um at most, {1e3 * evidence.rms_distance:.3g} um rms"
        rows.append(("smoothing", f"half the amplitude of a wave of {smoothing:g} mm remains; points moved by {moved}"))
    if len(found.points) > 2:
        outwards = curvature_of(found.points)[1] * (1 if found.kind == "rail" else -1)
        rows += [("smallest radius, outwards (mm)", _radius(outwards)), ("smallest radius, hollow (mm)", _radius(-outwards))]
    return rows


def _radius(curvature: Any) -> float | None:
    largest = float(np.max(curvature))
    return 1 / largest if largest > 0 and math.isfinite(largest) else None
