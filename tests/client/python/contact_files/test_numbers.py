"""Tests numbers as the CONTACT program prints them."""

from __future__ import annotations

import pytest

from contactd.contact_files.prints.numbers import fixed, fortran_g, general


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "   0.000    "), (0.28, "  0.2800    "), (-0.28, " -0.2800    "), (6.304, "   6.304    "), (1849.2, "   1849.    "),
        (9999.4, "   9999.    "), (9999.6, "  0.1000E+05"), (82000.0, "  0.8200E+05"), (0.099999, "  0.1000    "),
        (0.09994, "  0.9994E-01"), (1e-6, "  0.1000E-05"), (-1.5e-12, " -0.1500E-11"),
    ],
)  # fmt: skip
def test_a_number_has_four_digits_with_an_exponent_where_fortran_has_one(value: float, text: str) -> None:
    assert fortran_g(value) == text


def test_other_widths_and_digits_are_as_asked_for() -> None:
    assert fortran_g(-0.406, 11, 3) == " -0.406    "
    assert fortran_g(12345.678, 14, 6) == "   12345.7    "
    assert fortran_g(1234567.8, 14, 6) == "  0.123457E+07"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "       0.000"), (1e-21, "       0.000"), (9997.0, "       9997."), (10000.0, "   1.000E+04"), (9999.6, "      10000."),
        (0.1219, "      0.1219"), (-0.09994, "  -9.994E-02"), (0.01, "   1.000E-02"), (-2370.4, "      -2370."),
    ],
)  # fmt: skip
def test_the_general_format_has_an_exponent_for_large_and_small_numbers(value: float, text: str) -> None:
    assert general(value) == text


def test_an_approach_has_six_digits_where_it_needs_no_exponent() -> None:
    assert general(0.406012, 6, 4) == "    0.406012"
    assert general(0.0765171, 6, 4) == "   7.652E-02"


def test_what_has_no_room_is_stars() -> None:
    assert fixed(460.0, 12, 4) == "    460.0000"
    assert fixed(123456789.0, 8, 3) == "********"
