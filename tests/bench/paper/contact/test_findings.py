"""Tests verdicts of section 4: from rows to True if the paper agrees."""

import pytest

from paper.contact.cases import COMPARED_GRIDS, GRIDS, LARGER_LENGTHS, LENGTHS
from paper.contact.findings_normal import larger_blocks
from paper.contact.findings_tangential import share_of_bound
from paper.contact.problem import FZ, MU


@pytest.mark.parametrize(("share", "agrees"), [(7 / 8, True), (0.8759, True), (0.86, False)])
def test_the_tangential_force_is_compared_with_seven_eighths_of_the_bound(share, agrees):
    def point(curve, n):
        return {"curve": curve, "n": n, "Fz": FZ, "Fx": share * MU * FZ}

    rows = {"fig14": [point("analytic", n) for n in COMPARED_GRIDS], "sources": [point("analytic, no xy", 160)]}
    values, verdicts = share_of_bound(rows)
    assert verdicts == {"share_of_bound": agrees}
    assert values["share"] == f"{share:.4f}"


def blocks(error):
    """Returns the rows of fig10 and larger, with error(L, way) of every quantity."""
    rows = {"fig10": [], "larger": []}
    for n in GRIDS:
        for way in ("", ", fem"):
            for L in (*LENGTHS, *LARGER_LENGTHS):
                errors = {f"error_{quantity}": error(L, way) for quantity in ("Fz", "pmax", "area", "Fx")}
                part = "fig10" if L in LENGTHS else "larger"
                rows[part].append({"curve": f"{n}x{n}{way}", "n": n, "L": L, **errors})
    return rows


def test_as_large_as_possible_is_best_when_every_error_falls_to_the_end():
    verdicts = larger_blocks(blocks(lambda L, way: 1 / L))[1]
    assert verdicts == {"larger_is_better": True, "larger_is_better_fem": True, "pmax_rises_beyond": False}


def test_as_large_as_possible_is_not_best_when_an_error_turns_beyond_the_papers_block():
    values, verdicts = larger_blocks(blocks(lambda L, way: 1 / L - (0 if way else 1e-3)))
    assert verdicts == {"larger_is_better": False, "larger_is_better_fem": True, "pmax_rises_beyond": True}
    assert values["best_pmax"] == "1024, 1024, 1024"
