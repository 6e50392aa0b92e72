"""Measured roughness and its effect on a contact: records, spectra in third octaves, and the contact filter.

::

    from contactd.materials import steel
    from contactd.roughness import ContactFilter, hertz_weights, lines_of, read_record, rolled, without_spikes

    record = read_record("rail.csv", x_unit="m", height_unit="um")  # units are never guessed
    lines = lines_of(rolled(without_spikes(record)))
    contact = ContactFilter(hertz_weights(50e3, 460, 300, steel))
    print(lines.third_octaves().levels)  # dB relative to 1 um
    print(contact.filtered(lines).third_octaves().levels)

Lengths are in mm, also heights; forces are in N. Heights are positive towards the other body. docs/roughness.md has the
theory and its limits.
"""

from __future__ import annotations

from .contacts import contact_weights, wheel_rail_weights
from .directive import DIRECTIVE_2002_49
from .en15610 import rolled, without_spikes
from .filters import ContactFilter, effective
from .reading import read_record
from .records import Record, map_of, record_of
from .rough_contact import RoughRun, chi_of, heights_at, roll_over
from .spectra import ISO_3095_2013, Lines, Spectrum, lines_of, spectrum_of
from .weights import ContactWeights, EllipseWeights, hertz_weights

__all__ = [
    "DIRECTIVE_2002_49",
    "ISO_3095_2013",
    "ContactFilter",
    "ContactWeights",
    "EllipseWeights",
    "Lines",
    "Record",
    "RoughRun",
    "Spectrum",
    "chi_of",
    "contact_weights",
    "effective",
    "heights_at",
    "hertz_weights",
    "lines_of",
    "map_of",
    "read_record",
    "record_of",
    "roll_over",
    "rolled",
    "spectrum_of",
    "wheel_rail_weights",
    "without_spikes",
]
