"""Records of roughness: heights of a running surface along parallel lines, in mm."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from ..calls.answer_warnings import ContactWarning
from ..errors import invalid
from ..values.arrays import Array

__all__ = ["Record", "factor_of", "map_of", "record_of"]

#: Factors to mm.
_UNITS = {"m": 1e3, "cm": 10.0, "mm": 1.0, "um": 1e-3, "micron": 1e-3, "microns": 1e-3, "nm": 1e-6}
_FINEST, _COARSEST = 1e-4, 10.0  #: Bounds of the spacing (mm).
_STEEPEST, _SMOOTHEST = 0.1, 1e-6  #: Bounds of the rms slope; running surfaces lie between 1e-5 and 0.05.
_JITTER = 0.05  #: Largest deviation from uniform places, relative to the spacing.
_SPIKE = 5e-3  #: Smallest height of a spike (mm).
_THIRD_OCTAVE = 10**0.1


@dataclass(frozen=True, eq=False)
class Record:
    """Heights of a running surface along lines in the rolling direction.

    Heights are positive towards the other body: a crest is positive, a pit negative.

    Attributes:
        spacing: Distance of the samples along x (mm), > 0.
        heights: Heights (mm), shape [lines, samples]; a single line may have shape [samples].
        y: Lateral positions of the lines (mm), increasing, shape [lines].
        start: x of the first sample (mm).
    """

    spacing: float
    heights: Array
    y: Array = (0.0,)  # type: ignore[assignment]
    start: float = 0.0

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid field."""
        if np.ma.is_masked(self.heights):
            raise invalid("heights", "= masked values: every height must be known. Interpolate the gaps or cut the record.")
        heights = np.atleast_2d(np.array(self.heights, dtype=float))
        y = np.atleast_1d(np.array(self.y, dtype=float))
        if heights.ndim != 2 or heights.shape[1] < 3:
            raise invalid("heights", f"= an array of shape {list(heights.shape)}: a record has lines of at least 3 samples, shape [lines, samples]. Give the whole record.")
        if not np.isfinite(heights).all():
            line, sample = np.argwhere(~np.isfinite(heights))[0]
            count = int(np.count_nonzero(~np.isfinite(heights)))
            raise invalid("heights", f"= {heights[line, sample]} at sample {sample + 1} of line {line + 1}: {count} heights are not finite. Interpolate the gaps or cut the record.")
        if not (np.isfinite(self.spacing) and self.spacing > 0):
            raise invalid("spacing", f"= {self.spacing} mm: the distance of the samples must be positive. Give it in mm.")
        if y.shape != heights.shape[:1]:
            raise invalid("y", f"= {len(y)} positions: the record has {len(heights)} lines. Give the lateral position of each line (mm).")
        if not (np.isfinite(y).all() and (np.diff(y) > 0).all()):
            raise invalid("y", f"= {y[:5].tolist()}: lateral positions must increase. Order the lines by y (mm).")
        for name, value in (("heights", heights), ("y", y)):
            value.setflags(write=False)
            object.__setattr__(self, name, value)

    @property
    def x(self) -> Array:
        """Places of the samples (mm), shape [samples]."""
        return np.asarray(self.start + self.spacing * np.arange(self.heights.shape[1]))

    @property
    def length(self) -> float:
        """The length of the record (mm): the number of samples times their distance."""
        return float(self.spacing * self.heights.shape[1])

    def with_heights(self, heights: npt.ArrayLike, start: float | None = None) -> Record:
        """Returns the record with other heights (mm)."""
        return replace(self, heights=np.asarray(heights), start=self.start if start is None else start)


def factor_of(field: str, unit: str | None) -> float:
    """Returns the factor from a unit to mm. Raises InvalidArgument if the unit is missing, a level, or unknown."""
    if unit is None:
        raise invalid(field, "= None: the unit is neither in the file nor given. Give one of " + ", ".join(_UNITS) + ".")
    word = unit.strip().replace("µ", "u").replace("μ", "u")
    if word.lower().startswith("db"):
        raise invalid(field, f"= {unit}: levels are not heights. Give the heights along the track, from which contactd computes levels.")
    if word not in _UNITS:
        raise invalid(field, f"= {unit}: the unit is not supported. Give one of " + ", ".join(_UNITS) + ".")
    return _UNITS[word]


def record_of(
    x: npt.ArrayLike | float,
    heights: npt.ArrayLike,
    *,
    x_unit: str | None,
    height_unit: str | None,
    y: npt.ArrayLike | None = None,
    upside_down: bool = False,
) -> Record:
    """Returns the record of measured heights, checked for mistakes of units and of sampling.

    `x` contains the places of the samples, or is their distance; both units must be stated. `heights` has shape
    [samples] or [lines, samples]; `y` contains the positions of several lines (mm). Heights are positive towards the
    other body; `upside_down` reverses their sign. If x decreases, the samples are reversed. The mean and trends are
    kept.

    Raises InvalidArgument for unsupported units, gaps, places that are not uniform, constant heights, and slopes that
    no running surface has. Warns (ContactWarning) if slopes are very small, or if narrow spikes point downwards.
    """
    place, scale = factor_of("x_unit", x_unit), factor_of("height_unit", height_unit)
    if np.ma.is_masked(heights):
        raise invalid("heights", "= masked values: every height must be known. Interpolate the gaps or cut the record.")
    values = np.atleast_2d(np.asarray(heights, dtype=float)) * (-scale if upside_down else scale)
    places = np.asarray(x, dtype=float) * place
    if places.ndim == 0:
        start, spacing = 0.0, float(places)
    else:
        if places.shape != values.shape[1:]:
            raise invalid("x", f"= {places.size} places: the lines have {values.shape[-1]} heights. Give one place for each height.")
        if len(places) > 1 and places[-1] < places[0]:
            places, values = places[::-1], values[:, ::-1]
        start, spacing = _uniform(places)
    if not _FINEST <= spacing <= _COARSEST:
        raise invalid("x", f"= places {spacing:g} mm apart: the distance must lie between {_FINEST:g} and {_COARSEST:g} mm. Check x_unit = {x_unit}.")
    if y is None and len(values) > 1:
        raise invalid("y", f"= None: the record has {len(values)} lines. Give the lateral position of each line (mm).")
    found = Record(spacing, values, np.zeros(1) if y is None else np.asarray(y, dtype=float), start)
    _check_slopes(found, x_unit, height_unit)
    return found


def map_of(surface: Any, *, unit: str | None = None) -> Record:
    """Returns the heights of a measured map: any object with `positions_and_heights()`, as topographies of the package
    SurfaceTopography have.

    The first axis of a map is x. Positions and heights have the unit of `surface.unit`, or `unit` if it has none. Raises
    InvalidArgument as record_of does.
    """
    stated = getattr(surface, "unit", None)
    if unit is not None and stated is not None and factor_of("unit", unit) != factor_of("unit", stated):
        raise invalid("unit", f"= {unit}: the map states {stated}. Omit unit, or correct that of the map.")
    unit = stated if unit is None else unit
    positions = surface.positions_and_heights()
    if len(positions) == 2:
        return record_of(positions[0], positions[1], x_unit=unit, height_unit=unit)
    x, y, heights = positions
    factor = factor_of("unit", unit)
    return record_of(np.asarray(x)[:, 0], np.transpose(heights), x_unit=unit, height_unit=unit, y=factor * np.asarray(y)[0])


def _uniform(places: Array) -> tuple[float, float]:
    """Returns the first of uniform places and their distance."""
    if not np.isfinite(places).all():
        raise invalid("x", f"= {places[~np.isfinite(places)][0]} at sample {int(np.argmin(np.isfinite(places))) + 1}: every place must be finite. Remove or correct this row.")
    steps = np.diff(places)
    if len(steps) < 2 or not (steps > 0).all():
        row = int(np.argmin(steps > 0)) + 2 if len(steps) else 1
        raise invalid("x", f"= {places[min(row, len(places)) - 1]:g} mm at sample {row}: places must increase or decrease throughout. Remove repeated samples.")
    spacing = float((places[-1] - places[0]) / len(steps))
    off = np.abs(places - places[0] - spacing * np.arange(len(places)))
    if off.max() > _JITTER * spacing:
        if places[0] > 0 and np.allclose(places[1:] / places[:-1], _THIRD_OCTAVE, rtol=0.05):
            raise invalid("x", f"= {places[0]:g} to {places[-1]:g} mm in third octaves: these are wavelengths of a spectrum. Give the heights along the track.")
        raise invalid("x", f"= {places[int(off.argmax())]:g} mm at sample {int(off.argmax()) + 1}: samples are not uniform. Resample the record at equal distances.")
    return float(places[0]), spacing


def _check_slopes(record: Record, x_unit: str | None, height_unit: str | None) -> None:
    slopes = np.diff(record.heights, axis=1) / record.spacing
    slope = float(np.sqrt(np.mean((slopes - slopes.mean(axis=1, keepdims=True)) ** 2)))
    largest = float(np.abs(record.heights).max())
    if np.ptp(record.heights) == 0 or slope * record.length < 1e-12 * largest:
        raise invalid("heights", f"= {record.heights[0, 0]:g} mm throughout, or a straight line: the record has no roughness. Check the column of the heights.")
    if slope > _STEEPEST:
        raise invalid("height_unit", f"= {height_unit}: the rms slope is {slope:.2g} with x in {x_unit}, but no running surface exceeds {_STEEPEST}. Check both units.")
    if slope < _SMOOTHEST:
        _warn(f"height_unit = {height_unit}: the rms slope is only {slope:.1g} with x in {x_unit}. Check both units.")
    if record.heights.shape[1] > 7:
        # Dirt makes narrow spikes, which point upwards.
        beside = np.median(np.lib.stride_tricks.sliding_window_view(record.heights, 7, axis=1), axis=2)
        excess = record.heights[:, 3:-3] - beside
        least = max(_SPIKE, 10 * float(np.median(np.abs(excess))))
        if (down := np.count_nonzero(excess < -least)) >= 3 and not (excess > least).any():
            _warn(f"heights: {down} narrow spikes point downwards and none upwards. Set upside_down if heights are positive into the surface.")


def _warn(sentence: str) -> None:
    warnings.warn(ContactWarning(sentence), stacklevel=4)
