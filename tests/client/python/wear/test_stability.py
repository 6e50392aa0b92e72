"""Tests the depth of steps, and their smoothing."""

from __future__ import annotations

import math

import pytest

from contactd.wear.filters import smoothing_length
from contactd.wear.stability import LoadedRows, Stiffness

MODULUS = 115_000.0


def of(*contacts: LoadedRows) -> Stiffness:
    return Stiffness(contacts, MODULUS)


def test_long_rows_are_smoothed_by_the_half_space_formula():
    long = of(LoadedRows(1.0, 450.0, 1e4, 30.0))
    assert long.smoothing(0.02) == pytest.approx(smoothing_length(0.02, 450, MODULUS), rel=0.02)
    assert long.deepest == pytest.approx(1.03 * 450 * 30 / (math.pi * MODULUS), rel=1e-2)


def test_short_rows_ask_for_shallow_steps_and_for_more_smoothing():
    short, long = of(LoadedRows(1.0, 450.0, 3.0, 30.0)), of(LoadedRows(1.0, 450.0, 12.0, 30.0))
    assert short.deepest < 0.6 * long.deepest
    assert short.smoothing(short.deepest) > long.smoothing(short.deepest)


def test_what_was_smoothed_so_is_stable_and_half_of_it_is_not():
    contact = of(LoadedRows(1.0, 450.0, 10.0, 12.0))
    depth = 0.5 * contact.deepest
    length = contact.smoothing(depth)
    assert contact.is_stable(depth, length)
    assert not contact.is_stable(depth, 0.4 * length)
    assert contact.is_stable(1e-5, 0.0)


def test_contacts_count_by_what_they_wear_off():
    one, other = LoadedRows(1.0, 450.0, 10.0, 12.0), LoadedRows(1e-9, 50.0, 2.0, 20.0)
    assert of(one, other).deepest == pytest.approx(of(one).deepest, rel=1e-6)
    assert of(one, one).smoothing(0.005) == pytest.approx(of(one).smoothing(0.005), rel=1e-9)
