"""Tests units in headings of files with heights and pressures."""

from __future__ import annotations

import time

import pytest

from contactd.files.heading_units import unit_factor
from contactd.files.number_text import rows_of


@pytest.mark.parametrize(
    ("heading", "factor"),
    [
        ("# Channel: Topography\n# Width: 3.00 mm\n# Height: 2.00 mm\n# Value units: m", 1e3),
        ("# Value units: µm", 1e-3),
        ("Z-Unit: um", 1e-3),
        ("z_unit = nm", 1e-6),
        ("x unit: mm\nz unit: nm", 1e-6),
        ("# X Units: um, Z Units: nm", 1e-6),
        ("# Height [nm]", 1e-6),
        ("x [mm]; y [mm]; z [µm]", 1e-3),
        ("heights in micrometres", 1e-3),
        ("% unit: inches", 25.4),
        ("! units are mm", 1),
        ("# pressures (MPa)", 1),
        ("data are in Pa", 1e-6),
        ("# Value units: none", 1),
        ("made by a unit test, values in rows", 1),
        ("# heights in rows from below", 1),
        ("", 1),
    ],
)
def test_values_are_in_mm_whatever_unit_their_heading_states(heading, factor):
    assert unit_factor(f"{heading}\n1e-4 2e-4\n") == factor
    assert unit_factor(f"\n{heading}\n-1;2\n# Value units: m\n") == factor


@pytest.mark.parametrize(
    ("heading", "sentence"),
    [
        ("# Value units: K", "states the unit 'K'"),
        ("# Height [V]", "states the unit 'V'"),
        ("# units: m\n# z units: mm", "two units of the values, m and mm"),
        ("# Zscale = 1e-6", "states a scale of the heights"),
        ("z scale: 0.5", "states a scale of the heights"),
    ],
)
def test_what_cannot_be_converted_is_refused(heading, sentence):
    with pytest.raises(ValueError, match=sentence):
        unit_factor(f"{heading}\n1 2\n")


@pytest.mark.parametrize("text", ["units: " * 300_000, "z " * 1_000_000, " " * 2_000_000, "\n" * 1_000_000, "[" * 2_000_000])
def test_long_headings_take_no_longer_than_the_numbers_below_them(text):
    begun = time.process_time()
    try:
        unit_factor(text + "\n1 2\n")
    except ValueError:
        pass
    own = time.process_time() - begun
    begun = time.process_time()
    try:
        rows_of(text + "\n1 2\n")
    except ValueError:
        pass
    assert own < 10 * (time.process_time() - begun) + 1
