"""Tests the requests of Client.subsurface and the reading of its answers."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    Client,
    ContactProblem,
    Estimate,
    FemIcs,
    Grid,
    InvalidArgument,
    LargestStress,
    Material,
    Paraboloid,
    ProtocolError,
    RigidBody,
    StressBlock,
    TableIcs,
)
from contactd.values.contact_params import subsurface_params
from support import answers
from support.fake_server import FakeServer

GRID = Grid(3, 2, 0.5, 1.0)
PROBLEM = ContactProblem(GRID, Material(1, 0.1), Paraboloid(1, 1), 0.1, lower=Material(2, 0.2))
PRESSURE = np.ones((2, 3))
SOLUTION = Estimate(PRESSURE, -0.1 * PRESSURE)
INFO = {**answers.INFO, "limits": {**answers.INFO["limits"], "max_frames": 8}}
POINTS = [[0, 0, 0], [0, 0, -1]]


def params(problem=PROBLEM, solution=SOLUTION, body="lower", points=None, block=None, nu=None):
    if points is None and block is None:
        points = POINTS
    return subsurface_params(problem, solution, body, points, block, nu)[0]


def test_grid_material_and_tractions_come_from_problem_and_solution():
    sent = params()
    assert sent["grid"] == {"nx": 3, "ny": 2, "dx": 0.5, "dy": 1.0}
    assert (sent["body"], sent["nu"]) == ("lower", 0.2)
    assert sent["pressure"] is PRESSURE
    np.testing.assert_array_equal(sent["traction_x"], -0.1 * PRESSURE)
    assert "traction_y" not in sent


def test_each_body_has_its_poissons_ratio():
    assert params(body="upper")["nu"] == 0.1
    assert params(PROBLEM.replace(lower=None))["nu"] == 0.1
    assert params(nu=0.5)["nu"] == 0.5


def test_a_rigid_body_has_no_stresses():
    problem = PROBLEM.replace(lower=RigidBody())
    with pytest.raises(InvalidArgument, match="body is 'lower', which is rigid"):
        params(problem)
    assert params(problem, body="upper")["nu"] == 0.1


def test_a_table_may_be_of_any_body():
    table = np.ones((3, 3, 2, 3))
    problem = ContactProblem(GRID, gap=Paraboloid(1, 1), approach=0.1, ics=TableIcs(table, 0.5, 1.0))
    for nu in (None, 0.3):
        with pytest.raises(InvalidArgument, match="ics is a table, .* half-space"):
            params(problem, nu=nu)
    assert params(problem.replace(ics=AnalyticIcs(), upper=Material(1, 0.3)))["nu"] == 0.3


def test_the_daemon_hears_of_coefficients_that_may_be_of_a_block():
    assert "ics" not in params()
    assert params(PROBLEM.replace(ics=FemIcs(body="block")))["ics"] == {"source": "fem", "body": "block"}
    assert "ics" not in params(PROBLEM.replace(ics=FemIcs(body="block"), model="hertz"))


def test_poissons_ratio_may_be_another():
    assert params(nu=0.3)["nu"] == 0.3


def test_there_are_two_bodies():
    with pytest.raises(InvalidArgument, match="body is 'both'"):
        params(body="both")


def test_an_estimate_without_pressure_is_no_solution():
    with pytest.raises(InvalidArgument, match="pressure is missing"):
        params(solution=Estimate())


def test_a_block_may_be_made_of_numbers_and_lists():
    block = StressBlock(x=0, y=[1, 2], z=-np.arange(3))
    assert block.shape == (3, 2, 1)
    sent, shape = subsurface_params(PROBLEM, SOLUTION, "lower", None, block, None)
    assert shape == (3, 2, 1)
    assert {name: list(axis) for name, axis in sent["block"].items()} == {"x": [0], "y": [1, 2], "z": [0, -1, -2]}
    assert "points" not in sent


@pytest.mark.parametrize("points", [[], [0, 0, 0], [[0, 0]], np.zeros((2, 3, 1))])
def test_points_that_are_no_triples_are_refused(points):
    with pytest.raises(InvalidArgument, match="points has shape") as caught:
        params(points=points)
    assert caught.value.reason == "ARRAY_INVALID"


def test_a_block_is_a_stress_block():
    with pytest.raises(TypeError, match=r"block is \(0, 0, -1\); it must be of type StressBlock"):
        params(block=(0, 0, -1))


def test_an_axis_of_a_block_is_one_axis():
    with pytest.raises(InvalidArgument, match=r"block\.y has shape \[1, 2\]"):
        params(block=StressBlock(0, [[0, 1]], 0))


@pytest.mark.parametrize("where", [{}, {"points": POINTS, "block": StressBlock(0, 0, 0)}])
def test_either_points_or_a_block_are_asked_for(tmp_path, where):
    with Client(f"ipc://{tmp_path}/nobody") as client, pytest.raises(TypeError, match="points or block"):
        client.subsurface(PROBLEM, SOLUTION, **where)


def ask(tmp_path, answer, **where):
    def script(request):
        return [request.result(INFO) if request.method == "server.info" else request.result(*answer)]

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        return client.subsurface(PROBLEM, SOLUTION, **where)


def test_stresses_are_arrays_of_the_shape_asked_for(tmp_path):
    stress = ask(tmp_path, answers.stresses(2, 1, 2), block=StressBlock([0, 1], 0, [0, -1]))
    for n, name in enumerate(["xx", "yy", "zz", "xy", "xz", "yz", "von_mises"]):
        np.testing.assert_array_equal(getattr(stress, name), np.full((2, 1, 2), n))
    assert stress.largest == LargestStress(von_mises=6, x=0, y=0, z=-1, depth=1)


def test_stresses_cannot_be_changed(tmp_path):
    stress = ask(tmp_path, answers.stresses(2), points=POINTS)
    with pytest.raises(ValueError, match="read-only"):
        stress.zz[0] = 1
    with pytest.raises(dataclasses.FrozenInstanceError):
        stress.zz = PRESSURE


def test_stresses_of_another_shape_break_the_protocol(tmp_path):
    with pytest.raises(ProtocolError, match="xx has shape"):
        ask(tmp_path, answers.stresses(3), points=POINTS)


def test_an_answer_without_stresses_breaks_the_protocol(tmp_path):
    with pytest.raises(ProtocolError, match="lacks xx"):
        ask(tmp_path, [{"shape": [2]}], points=POINTS)
