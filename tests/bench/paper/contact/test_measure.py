"""Tests the problems sent to the daemon, and the handling of its failures."""

import numpy as np
import pytest

from contactd import AnalyticIcs, FemIcs, InternalError, TableIcs
from paper.contact.measure import Solver
from paper.contact.problem import ics_of, spec_of


class Table:
    def __init__(self, value, n):
        self.array = np.full((3, 3, n, n), value)


class FakeClient:
    """Records its problems. Closed-form tables are filled with 1, others with 2."""

    def __init__(self, error=None):
        self.problems, self._error = [], error

    def get_ic(self, material, grid, ics):
        return Table(1.0 if isinstance(ics, AnalyticIcs) else 2.0, grid.nx)

    def solve(self, problem):
        self.problems.append(problem)
        raise self._error or InternalError("The load case z did not converge.")


MESH = {"preset": "paper-test3", "L_over_h": 100}


def asked(spec):
    client = FakeClient()
    Solver(client).measure(spec)
    return client.problems[0]


def test_a_plain_request_names_its_coefficients():
    assert asked(spec_of(4, MESH)).ics == FemIcs("paper-test3", L_over_h=100)
    assert asked(spec_of(4, {})).ics == AnalyticIcs()
    assert ics_of({"load_shape": "bilinear"}) == AnalyticIcs(load_shape="bilinear")


def test_halves_of_the_problem_get_their_own_tables():
    ics = asked(spec_of(4, MESH, tangential={})).ics
    assert isinstance(ics, TableIcs)
    assert (ics["zz"] == 4).all()  # of two bodies
    assert all((ics[name] == 2).all() for name in ("xx", "yy", "xy", "yx"))
    assert all((ics[name] == 0).all() for name in ("xz", "zx", "yz", "zy"))


def test_lateral_displacements_can_be_left_out():
    ics = asked(spec_of(4, MESH, no_xy=True)).ics
    assert (ics["xx"] == 4).all() and (ics["xy"] == 0).all() and (ics["yx"] == 0).all()


def test_a_table_that_does_not_converge_is_a_result():
    assert "did not converge" in Solver(FakeClient()).measure(spec_of(4, MESH))["failure"]


def test_any_other_failure_ends_the_run():
    with pytest.raises(InternalError, match="killed"):
        Solver(FakeClient(InternalError("The builder was killed."))).measure(spec_of(4, MESH))
