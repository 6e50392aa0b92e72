"""Tests errors of a table, and the handling of a failing builder."""

import json
import stat

import numpy as np
import pytest

from paper.fem.cases import spec_of
from paper.fem.measure import Builder, errors
from paper.section import ComputationFailed


def tables():
    reference = np.ones((3, 3, 20, 20))
    return reference.copy(), reference


def test_errors_are_signed_at_the_origin_and_largest_anywhere():
    array, reference = tables()
    array[2, 2, 0, 0], array[2, 2, 9, 3], array[2, 2, 15, 0] = 0.99, 1.03, 1.5
    found = errors(array, reference, 10)
    assert found["zz"]["origin"] == pytest.approx(-0.01)
    assert found["zz"]["largest"] == pytest.approx(0.03)
    assert errors(array, reference, 20)["zz"]["largest"] == pytest.approx(0.5)


def test_other_components_are_compared_with_a_point_load():
    array, reference = tables()
    array[0, 1, 4, 3] += 0.01  # 5 elements from the load
    assert errors(array, reference, 10)["scaled_xy"] == pytest.approx(0.01 * 2 * np.pi * 5)


@pytest.fixture
def builder(tmp_path):
    """builder(status, answer) returns a builder whose contactd-ic ends in this way."""

    def make(status, answer):
        program = tmp_path / "contactd-ic"
        program.write_text(f"#!/bin/sh\nread line\necho '{json.dumps(answer)}'\nexit {status}\n")
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        return Builder(program)

    return make


def test_a_solve_that_does_not_converge_is_a_result(builder):
    answer = {"error": {"field": "", "message": "The load case z did not converge."}}
    assert builder(3, answer).measure(spec_of(10)) == {"failure": "The load case z did not converge."}


def test_any_other_failure_is_named(builder):
    answer = {"error": {"field": "ics.f", "message": "is 0; it must be at least 1"}}
    with pytest.raises(ComputationFailed, match="status 2: ics.f is 0"):
        builder(2, answer).measure(spec_of(10))
