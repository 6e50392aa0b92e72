"""Profiles, and coefficients, that cases name: files beside the file of cases, placed as the CONTACT program has them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import InvalidArgument
from ..files.case_text import text_of
from ..files.profile_text import read_profile_text
from ..files.whole import digest_of
from ..values.profile_shapes import KinkRule, Profile, ProfileFile
from ..values.tables import TableIcs
from ..values.wheel_rail.setup import Track, WheelRailSetup
from .case import Case
from .problems.rails import Slices
from .slice_list import SPLINES, placed_slices

if TYPE_CHECKING:
    from ..client import Client
    from ..values.arrays import Array

__all__ = ["ProfileFiles"]

_DRIVE = re.compile(r"[A-Za-z]:")
_LISTS = (".slcs", ".slcw")
_SIMPACK = (".prr", ".prw")
_NAMES = ("RFNAME", "WFNAME", "CFNAME")
_QUOTED = re.compile(r"'([^'\n]+)'")
_LENGTHS = re.compile(rb"^\s*units\.len\.f\s*=\s*([-+.\deE]+)", re.MULTILINE)
_MIRRORED = re.compile(rb"^\s*mirror\.y\s*=\s*\+?1(?:\.0*)?\s*(?:[!%].*)?$", re.MULTILINE)
_ORIENTED = (*_SIMPACK, ".ban", ".whl")  #: whose formats say which way z points
_FACE = 0.05  #: part of a wheel's width at an end
_METRE = 1000.0  # mm
_OPTIONS = ("MIRRORY", "SCALE", "SMOOTH", "MIRRORZ", "ISMOOTH", "KINKHIGH", "KINKLOW", "KINKWID")


class ProfileFiles:
    """Reads each file once. Names are relative to `folder`; both kinds of separators serve. The `client` reads the text of
    lists of slices."""

    def __init__(self, folder: str | os.PathLike[str], client: Client) -> None:
        self._folder, self._client = Path(folder), client
        self._read: dict[tuple[Any, ...], Profile | tuple[Slices, str]] = {}
        self._lock = Lock()

    def __call__(self, case: Case, which: str) -> Profile | tuple[Slices, str]:
        """The profile of "RAIL" or "WHEEL". Raises OSError where it cannot be read."""
        values = case.values
        name = str(values["RFNAME" if which == "RAIL" else "WFNAME"])
        options = {option: values[f"{which}_{option}"] for option in _OPTIONS}
        key = (name, *options.values())
        with self._lock:
            if key not in self._read:
                place = self.place(name)
                is_list = name.lower().endswith(_LISTS)
                self._read[key] = self._slices(place, options) if is_list else self._profile(place, options, which)
            return self._read[key]

    def coefficients(self, case: Case, modulus: float) -> TableIcs:
        """The influence coefficients that a case names (C = 9). Raises OSError where they cannot be read, and TableFileError
        where they are none."""
        return TableIcs.from_contact_text(self.place(str(case.values["CFNAME"])), modulus)

    def digests(self, cases: Iterable[Case]) -> dict[str, str]:
        """What the files have in them that cases name, those of slices too: a digest each, empty of one that cannot be read."""
        named = {self.place(str(case.values[name])) for case in cases for name in _NAMES if name in case.values}
        lists = [path for path in named if path.suffix.lower() in _LISTS]
        slices = {path.parent / name.replace("\\", "/") for path in lists for name in _names_in(path)}
        return {os.fspath(path): digest_of(path) for path in named | slices}

    def _profile(self, path: Path, options: Mapping[str, Any], which: str) -> ProfileFile:
        profile = _profile(path, options)
        if profile.mirror_z is not None or path.suffix.lower() in _ORIENTED or self._points(profile, which) is not None:
            return profile
        points = self._points(_profile(path, {**options, "MIRRORZ": -1}), which)
        upwards = points is not None and _runs_upwards(points, which)
        return profile if points is None else _profile(path, {**options, "MIRRORZ": 1 if upwards else -1})

    def _points(self, profile: ProfileFile, which: str) -> Array | None:
        """Its points as the service reads them, y and z; None where it cannot."""
        track = Track(rail_origin=(750.0, 0.0))  # needs no gauge face, which not every rail has
        setup = WheelRailSetup(wheel=profile, track=track) if which == "WHEEL" else WheelRailSetup(rail=profile, track=track)
        try:
            placed = self._client.placed_profiles(setup).right
        except InvalidArgument:
            return None
        return placed.wheel if which == "WHEEL" else placed.rail

    def _slices(self, path: Path, options: Mapping[str, Any]) -> tuple[Slices, str]:
        read = self._client.read_contact_slices(text_of(path), name=path.name)
        is_wheel = path.suffix.lower() == ".slcw"
        which = "WHEEL" if is_wheel else "RAIL"
        slices = placed_slices(read, path.parent, lambda place: self._profile(place, options, which))
        return [one[:2] if is_wheel else one for one in slices], SPLINES[read.is_approximated]

    def place(self, name: str) -> Path:
        """Where a file lies that is named in another one."""
        path = Path(name.replace("\\", "/"))
        is_absolute = path.is_absolute() or _DRIVE.match(name) is not None
        return path if is_absolute else self._folder / path


def _names_in(path: Path) -> list[str]:
    """The profiles that a list of slices names; none where it cannot be read."""
    try:
        return _QUOTED.findall(text_of(path))
    except OSError:
        return []


def _profile(path: Path, options: Mapping[str, Any]) -> ProfileFile:
    text = read_profile_text(path)
    is_simpack = path.suffix.lower() in _SIMPACK
    # MIRRORY = -1 takes back what a file of Simpack says itself.
    mirrored_back = options["MIRRORY"] == -1 and is_simpack and _MIRRORED.search(text) is not None
    smooth = options["SMOOTH"]
    smoothing: dict[str, Any] = {}
    if smooth > 0:
        smoothing = {"smoothing_lambda": smooth} if options["ISMOOTH"] == 0 else {"smoothing_length": smooth}
    if smooth > 0 and options["ISMOOTH"] == 2:
        smoothing["smoothing_order"] = 3
    return ProfileFile(
        path, text, unit=_unit(text, options["SCALE"], is_simpack), mirror_y=options["MIRRORY"] == 1 or mirrored_back,
        mirror_z=None if options["MIRRORZ"] == 0 else options["MIRRORZ"] == 1,
        kinks=KinkRule(options["KINKHIGH"], options["KINKLOW"], options["KINKWID"]), **smoothing,
    )  # fmt: skip


def _runs_upwards(points: Array, which: str) -> bool:
    """As the CONTACT program decides where neither a flange nor the ends of a rail show it: by where the least z lies."""
    y, z = points.T
    if which == "RAIL":
        outer = len(z) // 10
        return not outer <= int(np.argmin(z)) < len(z) - outer
    edge = _FACE * np.ptp(y)
    highest, lowest = int(np.argmin(z)), int(np.argmax(z))

    def is_at_an_end(place: int) -> bool:
        return bool(min(y[place] - y.min(), y.max() - y[place]) <= edge)

    if is_at_an_end(highest) or is_at_an_end(lowest):
        return not is_at_an_end(highest)
    middle, share = (highest + lowest) // 2, (y[(highest + lowest) // 2] - y[highest]) / (y[lowest] - y[highest])
    return bool(z[middle] < z[highest] + share * (z[lowest] - z[highest]))


def _unit(text: bytes, scale: float, is_simpack: bool) -> float | None:
    """Millimetres of a unit of the points. Files of Simpack say their own; all others are in mm."""
    if not is_simpack:
        return scale
    if scale == 1:
        return None
    given = _LENGTHS.search(text)
    return _METRE * scale / float(given[1] if given else 1)
