"""Profiles and coefficients named in cases: files next to the input file, placed as in the CONTACT program."""

from __future__ import annotations

import os
import re
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any

import numpy as np

from ..calls.answer_warnings import collected
from ..errors import InvalidArgument
from ..files.case_text import text_of
from ..files.profile_text import read_profile_text
from ..files.reach import check_within
from ..files.whole import digest_of
from ..values.generated.profile_shapes import KinkRule, Profile, ProfileFile
from ..values.generated.wheel_rail.setup import Track, WheelRailSetup
from ..values.tables import TableIcs
from .case import Case
from .problems.rails import Slices
from .slice_list import SPLINES, placed_slices

if TYPE_CHECKING:
    from ..values.arrays import Array
    from ..values.generated.wheel_rail.rigid_wheelset import ProfileEvidence
    from .asked_client import AskedClient

__all__ = ["ProfileFiles"]

_DRIVE = re.compile(r"[A-Za-z]:")
_LISTS = (".slcs", ".slcw")
_SIMPACK = (".prr", ".prw")
_NAMES = ("RFNAME", "WFNAME", "CFNAME")
_ORIENTED = (*_SIMPACK, ".ban", ".whl")  #: Formats that define the direction of z.
_FACE = 0.05  #: Fraction of a wheel's width at an end.
_METRE = 1000.0  # mm
_OPTIONS = ("MIRRORY", "SCALE", "SMOOTH", "MIRRORZ", "ISMOOTH", "KINKHIGH", "KINKLOW", "KINKWID")


class ProfileFiles:
    """Reads each file once. Names are relative to `folder`, with either path separator. The `client` parses lists of
    slices. Files outside the `allowed` folders are refused; None allows all.
    """

    def __init__(self, folder: str | os.PathLike[str], client: AskedClient, allowed: Iterable[Path] | None = None) -> None:
        self._folder, self._client = Path(folder), client
        self._allowed = None if allowed is None else tuple(allowed)
        self._read: dict[tuple[Any, ...], Profile | tuple[Slices, str]] = {}
        self._lock = Lock()

    def __call__(self, case: Case, which: str) -> Profile | tuple[Slices, str]:
        """Returns the profile of "RAIL" or "WHEEL". Raises OSError if it cannot be read."""
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
        """Returns the influence coefficients of a case (C = 9). Raises OSError if they cannot be read, and
        TableFileError for invalid ones.
        """
        path = self.place(str(case.values["CFNAME"]))
        self._check(path)
        return TableIcs.from_contact_text(path, modulus)

    def digests(self, cases: Iterable[Case]) -> dict[str, str]:
        """Returns a digest of each file named in the cases, including those of slices; empty for a file that cannot be
        read.
        """
        named = {self.place(str(case.values[name])) for case in cases for name in _NAMES if name in case.values}
        lists = [path for path in named if path.suffix.lower() in _LISTS and self._is_allowed(path)]
        slices = {path.parent / name.replace("\\", "/") for path in lists for name in _names_in(path)}
        return {os.fspath(path): digest_of(path) if self._is_allowed(path) else "" for path in named | slices}

    def _check(self, path: Path) -> None:
        if self._allowed is not None:
            check_within(path, self._allowed)

    def _is_allowed(self, path: Path) -> bool:
        try:
            self._check(path)
        except OSError:
            return False
        return True

    def _profile(self, path: Path, options: Mapping[str, Any], which: str) -> ProfileFile:
        self._check(path)
        file = ProfileFile(path, read_profile_text(path))
        reported = self._reading(file, options, which) if path.suffix.lower() in _SIMPACK else _FileReading(options["SCALE"])
        profile = _with_options(file, options, reported)
        if profile.mirror_z is not None or path.suffix.lower() in _ORIENTED or self._placed(profile, which) is not None:
            return profile
        placed = self._placed(_with_options(file, {**options, "MIRRORZ": -1}, reported), which)
        upwards = placed is not None and _runs_upwards(placed[0], which)
        return profile if placed is None else _with_options(file, {**options, "MIRRORZ": 1 if upwards else -1}, reported)

    def _reading(self, file: ProfileFile, options: Mapping[str, Any], which: str) -> _FileReading:
        """Returns the reading by the service, which first reads a Simpack file without options of the case that change
        its interpretation. For a file with a wrong unit, the points have no plausible size; it is then in metres or mm
        according to the scale.
        """
        scale = options["SCALE"]
        if scale == 1 and options["MIRRORY"] != -1:
            return _FileReading(None)
        for unit in (None, _METRE * scale, scale):
            with warnings.catch_warnings():  # The case warns of the file as used.
                warnings.simplefilter("ignore", UserWarning)
                placed = self._placed(replace(file, unit=unit), which)
            if placed is not None and (reading := placed[1].file) is not None:
                in_unit = scale * reading.unit if unit is None else unit
                return _FileReading(None if scale == 1 else in_unit, reading.mirror_y)
        return _FileReading(None if scale == 1 else _METRE * scale)

    def _placed(self, profile: ProfileFile, which: str) -> tuple[Array, ProfileEvidence] | None:
        """Returns the points as read by the service, y and z, with the evidence; None if it cannot read them."""
        track = Track(rail_origin=(750.0, 0.0))  # needs no gauge face, which some rails do not have
        setup = WheelRailSetup(wheel=profile, track=track) if which == "WHEEL" else WheelRailSetup(rail=profile, track=track)
        try:
            with collected():  # The case itself warns of its profiles.
                placed = self._client.placed_profiles(setup).right
        except InvalidArgument:
            return None
        return (placed.wheel, placed.wheel_evidence) if which == "WHEEL" else (placed.rail, placed.rail_evidence)

    def _slices(self, path: Path, options: Mapping[str, Any]) -> tuple[Slices, str]:
        self._check(path)
        read = self._client.read_contact_slices(text_of(path), name=path.name)
        is_wheel = path.suffix.lower() == ".slcw"
        which = "WHEEL" if is_wheel else "RAIL"
        slices = placed_slices(read, path.parent, lambda place: self._profile(place, options, which))
        return [one[:2] if is_wheel else one for one in slices], SPLINES[read.is_approximated]

    def place(self, name: str) -> Path:
        """Returns the path of a file named in another one."""
        path = Path(name.replace("\\", "/"))
        is_absolute = path.is_absolute() or _DRIVE.match(name) is not None
        return path if is_absolute else self._folder / path


def _names_in(path: Path) -> Iterator[str]:
    """Returns the profiles in a list of slices, in quotation marks in its lines; none if it cannot be read."""
    try:
        lines = text_of(path).splitlines()
    except OSError:
        return
    for line in lines:
        yield from (name for name in line.split("'")[1:-1:2] if name)


@dataclass(frozen=True)
class _FileReading:
    """The unit of a file's points in mm, None if the file defines it, and whether the file mirrors y."""

    unit: float | None
    mirror_y: bool = False


def _with_options(file: ProfileFile, options: Mapping[str, Any], reported: _FileReading) -> ProfileFile:
    """Adds the options of a case to a file."""
    # MIRRORY = -1 reverts the mirroring in a Simpack file.
    mirrored_back = options["MIRRORY"] == -1 and reported.mirror_y
    smooth = options["SMOOTH"]
    smoothing: dict[str, Any] = {}
    if smooth > 0:
        smoothing = {"smoothing_lambda": smooth} if options["ISMOOTH"] == 0 else {"smoothing_length": smooth}
    if smooth > 0 and options["ISMOOTH"] == 2:
        smoothing["smoothing_order"] = 3
    return replace(
        file, unit=reported.unit, mirror_y=options["MIRRORY"] == 1 or mirrored_back,
        mirror_z=None if options["MIRRORZ"] == 0 else options["MIRRORZ"] == 1,
        kinks=KinkRule(options["KINKHIGH"], options["KINKLOW"], options["KINKWID"]), **smoothing,
    )  # fmt: skip


def _runs_upwards(points: Array, which: str) -> bool:
    """Decides like the CONTACT program if neither a flange nor the ends of a rail show the direction: by the position
    of the smallest z.
    """
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
