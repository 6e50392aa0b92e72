"""Plastic slip of a layer that yields, from the flow of a step."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from contactd.contact_files.answers.elements import layer_of
from contactd.values.generated.friction import InterfacialLayer
from contactd.values.generated.grid import Grid

GRID = Grid(3, 1, 0.5, 1.0)
LAYER = InterfacialLayer(1e-5, 120.0, 9000.0)
FLOW = np.array([[0.1, 0.2, 0.4]])


def layered(tangential: int, chi: float = 0.0, yield_stress: Any = None) -> Any:
    solution: Any = SimpleNamespace(flow_x=FLOW, flow_y=-FLOW, yield_stress=yield_stress, element_division=None)
    return layer_of(solution, LAYER, GRID, tangential, chi, 0.25)


@pytest.mark.parametrize(
    ("tangential", "chi", "slip"),
    [
        (3, 0.0, [0.35, 0.3, 0.2]), (3, math.pi, [0.05, 0.15, 0.35]),  # particles come from the leading edge
        (2, 0.0, [0.025, 0.05, 0.1]), (1, 0.0, [0.1, 0.2, 0.4]),
    ],
)  # fmt: skip
def test_plastic_slip_is_a_length_that_steady_rolling_accumulates(tangential: int, chi: float, slip: list[float]) -> None:
    stress, x, y = layered(tangential, chi)
    assert x[0] == pytest.approx(slip)
    assert y[0] == pytest.approx([-value for value in slip])
    assert stress.tolist() == [[120.0, 120.0, 120.0]]


def test_the_yield_stress_is_that_of_the_solution_and_no_layer_has_none() -> None:
    hardened = np.array([[130.0, 125.0, 121.0]])
    assert layered(3, yield_stress=hardened)[0] is hardened
    solution: Any = SimpleNamespace(flow_x=None, flow_y=None, yield_stress=None, element_division=None)
    assert layer_of(solution, LAYER, GRID, 3, 0.0, 0.5) is None
    assert layer_of(solution, None, GRID, 3, 0.0, 0.5) is None


def test_plastic_slip_goes_on_from_the_step_before_where_there_is_contact() -> None:
    before = np.array([[1.0, 2.0, 3.0]]), np.array([[0.0, 0.0, 5.0]])
    solution: Any = SimpleNamespace(flow_x=FLOW, flow_y=-FLOW, yield_stress=None, element_division=np.array([[3, 3, 0]]))
    _, x, y = layer_of(solution, LAYER, GRID, 1, 0.0, 0.25, before)
    assert x[0] == pytest.approx([1.1, 2.2, 0.0])
    assert y[0] == pytest.approx([-0.1, -0.2, 0.0])
    # Half an element ahead, particles have the mean of two elements, and those that enter have none.
    _, x, _ = layer_of(solution, LAYER, GRID, 2, 0.0, 0.25, before)
    assert x[0] == pytest.approx([1.5 + 0.025, 2.5 + 0.05, 0.0])


def test_particles_keep_their_yield_stress_behind_the_contact_of_steady_rolling() -> None:
    stress = np.array([[120.0, 130.0, 125.0, 120.0]])
    none = np.zeros((1, 4))
    solution: Any = SimpleNamespace(
        flow_x=none, flow_y=none, yield_stress=stress, element_division=np.array([[0, 3, 3, 0]])
    )
    grid = Grid(4, 1, 0.5, 1.0)
    assert layer_of(solution, LAYER, grid, 3, 0.0, 0.5)[0].tolist() == [[130.0, 130.0, 125.0, 120.0]]
    assert layer_of(solution, LAYER, grid, 3, math.pi, 0.5)[0].tolist() == [[120.0, 130.0, 125.0, 125.0]]
