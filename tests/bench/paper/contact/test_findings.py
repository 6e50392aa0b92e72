"""What verdicts of section 4 are made of: rows in, True where the paper agrees."""

import pytest

from paper.contact.cases import COMPARED_GRIDS
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
