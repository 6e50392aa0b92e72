"""Tests the processing of EN 15610 and third octaves against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from contactd import ContactWarning, InvalidArgument
from contactd.roughness import ISO_3095_2013, Record, lines_of, rolled, spectrum_of, without_spikes

X = np.arange(5000.0)


def sine(amplitude: float, length: float) -> Record:
    """A sine with an amplitude in um."""
    return Record(1.0, 1e-3 * amplitude * np.sin(2 * np.pi * X / length))


def test_a_sine_has_its_mean_square_in_one_band():
    found = spectrum_of(sine(3, 10))
    assert found.at(10) == pytest.approx(10 * math.log10(4.5), abs=1e-9)
    assert (np.delete(found.levels, list(found.wavelengths).index(10)) < -70).all()


def test_bands_reach_from_a_quarter_of_the_segment_to_twice_the_spacing():
    found = spectrum_of(sine(1, 20))
    np.testing.assert_allclose(found.wavelengths[[0, -1]], [250, 2.5])
    assert set(found.wavelengths[found.wavelengths >= 3.15]) <= set(ISO_3095_2013.wavelengths)
    np.testing.assert_allclose(spectrum_of(sine(1, 20), segment=1300).wavelengths[0], 315)


def test_a_line_at_the_edge_of_bands_is_shared():
    lines = lines_of(sine(2, 1000 / 111))
    _, shares = lines.bands()
    inside = shares.sum(axis=0)[(lines.wavelengths < 200) & (lines.wavelengths > 3)]
    np.testing.assert_allclose(inside, 1, atol=1e-12)
    part = 100 * 10**0.05 - 111.5
    assert lines.third_octaves().at(10) == pytest.approx(10 * math.log10(2 * (5 + part) / 6), abs=1e-6)


def test_noise_keeps_its_mean_square():
    noise = np.random.default_rng(2).standard_normal(200_000) * 1e-3
    lines = lines_of(Record(1.0, noise))
    assert lines.squares.sum() == pytest.approx(noise.var(), rel=0.01)


def test_means_and_trends_have_no_effect():
    plain = sine(3, 10)
    tilted = plain.with_heights(plain.heights + 5 + 1e-3 * X)
    np.testing.assert_allclose(spectrum_of(tilted).at(10), spectrum_of(plain).at(10), atol=1e-6)
    assert spectrum_of(tilted).at(250) < -60


def test_lines_are_averaged_by_mean_squares():
    both = Record(1.0, np.concatenate([sine(1, 10).heights, sine(3, 10).heights]), np.array([0.0, 5.0]))
    assert spectrum_of(both).at(10) == pytest.approx(10 * math.log10((0.5 + 4.5) / 2), abs=1e-9)


def test_short_records_are_refused_and_coarse_ones_warned_of():
    with pytest.raises(InvalidArgument, match="900 mm long: it is shorter than a segment of 1000 mm"):
        spectrum_of(Record(1.0, sine(1, 10).heights[:, :900]))
    with pytest.warns(ContactWarning, match="at most 1 mm apart"):
        spectrum_of(Record(2.0, sine(1, 10).heights))
    for call in (without_spikes, rolled):
        with pytest.raises(InvalidArgument, match="spacing = 2 mm: EN 15610"):
            call(Record(2.0, sine(1, 10).heights))


def test_dirt_is_removed_and_broad_ridges_stay():
    clean = sine(5, 200)
    dirty = np.array(clean.heights)
    dirty[0, [700, 1900]] += 0.04
    np.testing.assert_allclose(without_spikes(clean.with_heights(dirty)).heights, clean.heights, atol=3e-4)
    ridge = np.zeros(1000)
    ridge[480:521] = 0.2 * (1 - np.abs(np.arange(-20, 21)) / 20)
    np.testing.assert_array_equal(without_spikes(Record(1.0, ridge)).heights[0], ridge)


def test_a_circle_rests_on_the_rims_of_a_pit():
    pit = np.zeros(2001)
    pit[995:1006] = -0.05
    path = rolled(Record(1.0, pit)).heights[0]
    assert path[1000] == pytest.approx(math.sqrt(375**2 - 36) - 375, rel=1e-12)
    assert (path[:994] == 0).all()
    crest = -1e-6 * np.arange(-50, 50) ** 2
    np.testing.assert_allclose(rolled(Record(1.0, crest)).heights[0], crest, atol=1e-15)
    assert (path >= pit).all()
