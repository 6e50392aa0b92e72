"""Tests the requests of Client.temperature and the reading of its answers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from contactd import (
    Client,
    ContactProblem,
    ContactWarning,
    Friction,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    ProtocolError,
    Rolling,
    Shift,
    ThermalBodies,
    ThermalBody,
)
from contactd.values.contact_params import problem_params
from contactd.values.solution import ContactSolution
from contactd.values.temperature_params import temperature_params
from support import answers
from support.fake_server import FakeServer

GRID = Grid(3, 2, 0.5, 1.0)
ONES = np.ones((2, 3))
BODIES = ThermalBodies(lower=ThermalBody(bulk_temperature=20, conductivity=40))
INFO = {**answers.INFO, "limits": {**answers.INFO["limits"], "max_frames": 16}}


def solution(**changes):
    found = object.__new__(ContactSolution)
    values = {"grid": GRID, "motion": Rolling(xi=1e-3, velocity=2e4, chi=0.0), "pressure": ONES, "traction_x": -0.3 * ONES,
              "traction_y": 0 * ONES, "slip_x": 1e-3 * ONES, "slip_y": 0 * ONES, **changes}  # fmt: skip
    for name, value in values.items():
        object.__setattr__(found, name, value)
    return found


def test_tractions_slip_and_motion_come_from_the_solution():
    sent = temperature_params(solution(), BODIES, None)
    assert sent["grid"] == {"nx": 3, "ny": 2, "dx": 0.5, "dy": 1.0}
    assert (sent["velocity"], sent["chi"]) == (2e4, 0)
    assert sent["temperature"] == {"lower": {"bulk_temperature": 20, "conductivity": 40}}
    np.testing.assert_array_equal(sent["traction_x"], -0.3 * ONES)
    assert "temperature" not in temperature_params(solution(), None, None)
    assert temperature_params(solution(), None, 5e3)["velocity"] == 5e3
    assert "upper_speed" not in sent


def test_the_speed_of_a_rail_goes_along_and_follows_another_velocity():
    of_rail = solution(upper_speed=1.8e4)
    assert temperature_params(of_rail, None, None)["upper_speed"] == 1.8e4
    assert temperature_params(of_rail, None, 5e3)["upper_speed"] == pytest.approx(4.5e3)


@pytest.mark.parametrize("motion", [Shift(rigid_shift=(1e-3, 0)), Rolling(kind="transient"), None])
def test_only_steady_rolling_has_temperatures(motion):
    with pytest.raises(InvalidArgument, match="does not roll steadily"):
        temperature_params(solution(motion=motion), None, None)


def test_arrays_that_were_not_asked_for_are_missed():
    with pytest.raises(TypeError, match="slip_x"):
        temperature_params(solution(slip_x=None), None, None)
    with pytest.raises(TypeError, match="ThermalBodies"):
        temperature_params(solution(), {"lower": {}}, None)


def test_the_flow_of_a_layer_goes_along():
    flow = np.full(GRID.shape, 0.01)
    params = temperature_params(solution(plastic_power=1.0, flow_x=flow, flow_y=flow), None, None)
    assert np.array_equal(params["flow_x"], flow) and "flow_x" not in temperature_params(solution(), None, None)
    with pytest.raises(TypeError, match="flow_x"):
        temperature_params(solution(plastic_power=1.0), None, None)


def test_a_problem_says_what_its_bodies_have_to_do_with_heat():
    rolling = Friction(0.3, rolling=Rolling(xi=1e-3, velocity=2e4))
    problem = ContactProblem(GRID, Material(1, 0.1), Paraboloid(1, 1), 0.1, friction=rolling, temperature=ThermalBodies())
    assert problem_params(problem)["temperature"] == {}
    assert problem_params(problem.replace(temperature=BODIES))["temperature"]["lower"]["conductivity"] == 40


def ask(tmp_path, shape):
    result = {
        "upper_temperature": answers.array(1, shape),
        "lower_temperature": answers.array(2, shape),
        "temperature": {
            "largest": 2, "x": 0, "y": 0.5, "largest_upper": 2, "largest_lower": 5, "rise": 1, "heat_upper": 3,
            "heat_lower": 4, "peclet": 100,
        },
        "warnings": ["Warm."],
    }

    def script(request):
        frames = [np.full(shape, float(n)).tobytes() for n in (1, 2)]
        return [request.result(INFO) if request.method == "server.info" else request.result(result, *frames)]

    with FakeServer(tmp_path, script) as server, Client(server.endpoint, timeout=5) as client:
        return client.temperature(solution(), BODIES)


def test_temperatures_are_arrays_over_the_grid(tmp_path):
    with pytest.warns(ContactWarning, match="Warm"):
        found = ask(tmp_path, (2, 3))
    assert found.upper_temperature.tolist() == [[1] * 3] * 2
    assert found.lower_temperature.tolist() == [[2] * 3] * 2
    assert (found.temperature.largest, found.temperature.heat_lower, found.grid) == (2, 4, GRID)
    assert "largest temperature 2" in repr(found)
    assert replace(found, grid=None).grid is None


def test_temperatures_of_another_shape_break_the_protocol(tmp_path):
    with pytest.raises(ProtocolError, match="upper_temperature"):
        ask(tmp_path, (3, 2))
