"""Tests `./dev paper contact` with a real daemon, for the closed forms."""

from __future__ import annotations

import pytest

from paper.contact.measure import solver
from paper.contact.problem import FX, FZ, spec_of
from support.daemons import BIN


def test_the_cattaneo_problem_is_solved_with_and_without_tables_of_our_own() -> None:
    with solver(BIN) as measure:
        plain = measure(spec_of(20, {}))
        halves = measure(spec_of(20, {}, tangential={}))  # provides the same coefficients
        planar = measure(spec_of(20, {}, no_xy=True))
    assert plain["Fz"] == pytest.approx(FZ, rel=1e-3)
    assert plain["Fx"] == pytest.approx(FX, rel=1e-3)
    assert [halves["Fz"], halves["Fx"]] == pytest.approx([plain["Fz"], plain["Fx"]], rel=1e-6)
    # Without lateral displacements Fx equals Cattaneo's, 0.1 % smaller.
    assert planar["Fx"] < 0.9995 * plain["Fx"]
