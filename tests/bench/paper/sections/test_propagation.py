"""Tests the contacts in which errors of coefficients are followed."""

import numpy as np
import pytest

from paper.sections.findings_propagation import propagation
from paper.sections.persson import NU, RADIUS, STRIPS
from paper.sections.propagation import HALF_WIDTH, MESHES, closed_form, contact, symmetric

PLACES = (np.arange(STRIPS) - (STRIPS - 1) / 2) / RADIUS


def half_plane(datum):
    """Returns the normal displacement of strips under a strip, up to a constant, of two equal bodies."""
    x = np.arange(STRIPS)[:, None] - np.arange(STRIPS)[None, :]
    outer, inner = x + 0.5, x - 0.5
    return -2 * (1 - NU) / np.pi * (outer * np.log(np.abs(outer)) - inner * np.log(np.abs(inner)) - 1 - np.log(datum))


def test_a_lower_half_becomes_a_symmetric_matrix():
    assert symmetric([1.0, 2.0, 3.0], 2).tolist() == [[1, 2], [2, 3]]


def test_the_contact_on_the_flat_is_that_of_hertz():
    found = contact("flat", PLACES, half_plane(3000))
    assert found["p0"] == pytest.approx(closed_form("flat"), rel=2e-3)
    assert found["extent"] * RADIUS == pytest.approx(HALF_WIDTH, rel=2e-3)
    assert found["p"].sum() == pytest.approx(1)


def test_a_rigid_motion_of_the_flat_bodies_changes_the_approach_alone():
    one, other = (contact("flat", PLACES, half_plane(datum)) for datum in (3000, 6000))
    assert one["p0"] == pytest.approx(other["p0"], rel=1e-9)
    assert other["approach"] - one["approach"] == pytest.approx(2 * (1 - NU) / np.pi * np.log(2))


def rows(curved_ics=1.0, curved_contact=1.0):
    """Creates errors that decrease with the mesh; those of curved bodies are larger by the factor."""

    def row(body, order, edges):
        error = 0.02 / (order * edges)
        ics = error * (curved_ics if body == "curved" else 1)
        p0 = error * (curved_contact if body == "curved" else 1)
        more = {"p0_error": p0, "extent_error": 0.0, "approach_error": -error / 2, "finest_error": 1e-4}
        return {"curve": f"{body}, order {order}", "value": edges, "ic_largest": ics, **more}

    return {"propagation": [row(body, *mesh) for body in ("flat", "curved") for mesh in MESHES]}


@pytest.mark.parametrize(
    ("change", "verdict"), [({"curved_ics": 3}, "propagation_ics"), ({"curved_contact": 3}, "propagation_contact")]
)
def test_errors_that_are_larger_on_curved_bodies_are_told(change, verdict):
    assert all(propagation(rows())[1].values())
    assert propagation(rows(**change))[1][verdict] is False
