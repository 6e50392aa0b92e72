"""Compares contact filters of Hertzian contacts with those of Directive 2002/49/EC."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from contactd import Client, ContactProblem, Grid, Paraboloid
from contactd.materials import steel
from contactd.roughness import DIRECTIVE_2002_49, ContactFilter, Spectrum, contact_weights, hertz_weights
from contactd.roughness.filters import Weights

__all__ = ["RANGES", "FilterColumn", "compared_filters"]

#: Shortest wavelengths (mm) and tolerances (dB). The directive has none: they are the agreement that is expected of an
#: isotropic surface on a rail head of 300 mm, although the contact sizes of the directive are not published.
RANGES = ((10.0, 2.5), (3.15, 2.8))
_ELEMENTS = 48  #: Number of elements across a computed contact.


@dataclass(frozen=True, eq=False)
class FilterColumn:
    """A column of the table and the computed filter.

    Attributes:
        load: Wheel load (kN).
        diameter: Wheel diameter (mm).
        given: Filter of the directive.
        computed: Filter of the contact.
    """

    load: float
    diameter: float
    given: Spectrum
    computed: Spectrum

    @property
    def name(self) -> str:
        """The load and the diameter."""
        return f"{self.load:g} kN, {self.diameter:g} mm"

    def largest(self, shortest: float) -> tuple[float, float]:
        """Returns the largest difference (dB) down to a wavelength (mm), and its wavelength."""
        waves = self.given.wavelengths
        apart = np.where(waves >= shortest, np.abs(self.computed.levels - self.given.levels), 0)
        return float(apart.max()), float(waves[apart.argmax()])

    @property
    def is_inside(self) -> bool:
        """Whether all differences are within their tolerances."""
        return all(self.largest(shortest)[0] <= tolerance for shortest, tolerance in RANGES)


def compared_filters(
    client: Client | None, rail_radius: float, exponent: float, on_progress: Callable[[float, str], None]
) -> list[FilterColumn]:
    """Computes the filter of each column: that of Hertz in closed form, or of contacts that a client computes."""
    found = []
    for done, ((load, diameter), given) in enumerate(DIRECTIVE_2002_49.items()):
        on_progress(done / len(DIRECTIVE_2002_49), f"{load} kN, {diameter} mm")
        contact = ContactFilter(_weights(client, 1e3 * load, diameter / 2, rail_radius), exponent=exponent)
        found.append(FilterColumn(load, diameter, given, Spectrum(given.wavelengths, contact.band_levels(given.wavelengths))))
    return found


def _weights(client: Client | None, force: float, radius: float, rail_radius: float) -> Weights:
    ellipse = hertz_weights(force, radius, rail_radius, steel)
    if client is None:
        return ellipse
    side = round(1.25 * _ELEMENTS)
    grid = Grid.centred(side, side, 2.5 * ellipse.a, 2.5 * ellipse.b)
    return contact_weights(client, ContactProblem(grid, steel, Paraboloid(radius, rail_radius), Fn=force))
