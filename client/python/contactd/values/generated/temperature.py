"""Temperatures of both surfaces: answers of `Client.temperature`.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..arrays import Array
from ..dictionaries import Saved
from ..representation import Shown
from ..temperature_methods import SurfaceTemperaturesMethods
from .grid import Grid
from .result import ContactTemperature

__all__ = ["SurfaceTemperatures"]


@dataclass(frozen=True, eq=False, repr=False)
class SurfaceTemperatures(SurfaceTemperaturesMethods, Saved, Shown):
    """Temperatures of both surfaces, in contact and behind it: read-only arrays of shape [ny, nx] (degrees Celsius).

    Attributes:
        upper_temperature: Temperature of the upper body's surface, in contact and behind it, shape [ny, nx] (degrees
            Celsius).
        lower_temperature: Temperature of the lower body's surface, as upper_temperature.
        temperature: The largest temperature, and the heat.
        warnings: Warnings about the temperatures.
        grid: The grid of the problem, which the client adds.
    """

    upper_temperature: Array
    lower_temperature: Array
    temperature: ContactTemperature
    warnings: tuple[str, ...] = ()
    grid: Grid | None = None
