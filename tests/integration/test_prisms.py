"""Tables of prisms through a daemon: built once for any elements along x, kept, and refused by a sentence."""

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactColumns,
    FemIcs,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    RigidBody,
    save_table,
)

STEEL = Material(G=82000, nu=0.28)
EDGE = {"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}
GRID = Grid.centred(21, 20, 10.5, 10)
SELF = 0.2019960  # zz of the half-space under an element of 0.5 x 0.5 mm, for G = 1


def fem(section, accuracy=1e-2):
    return FemIcs(body="prism", section=section, accuracy=accuracy)


def test_a_table_by_finite_elements_states_its_error_and_serves_any_length_of_elements(shared):
    table = shared.get_ic(STEEL, GRID, fem(EDGE))
    assert table.array.shape == (3, 3, 20, 20, 21)
    assert table.frames.shape == (20, 3)
    assert table.frames[19] == pytest.approx([-1.25, 0, 0])
    error = table.evidence.section.error
    assert 0 < error <= 1e-2
    assert table["zz"][19, 19, 0] * STEEL.G == pytest.approx(0.220063, abs=(error + 1e-4) * SELF)
    assert table["yy"][19, 19, 4] * STEEL.G == pytest.approx(0.042699, abs=(error + 1e-4) * SELF)
    longer = shared.get_ic(Material(G=1, nu=0.28), Grid.centred(40, 20, 80, 20), fem({**EDGE, "size": 2}))
    assert longer.origin == "memory"
    assert longer.key == table.key
    assert np.array_equal(longer.frames, 2 * table.frames * [1, 1, 0.5])


def test_a_table_is_kept_by_the_daemon_alone(shared, tmp_path):
    table = shared.get_ic(STEEL, GRID, AnalyticIcs(body="prism", section=EDGE))
    with pytest.raises(ValueError, match="get_ic"):
        save_table(tmp_path / "table.npz", table)


@pytest.mark.parametrize(("distance", "change", "more"), [(3, 0.003, 0.09), (0.5, -0.22, 0.43), (0, -0.45, 0.5)])
def test_near_an_edge_pressures_fall_below_those_of_a_half_space_that_is_cut_off(shared, distance, change, more):
    grid = Grid(12, 20, 0.25, 0.25, -1.5, distance - 5)  # beside a cut the largest pressure grows with finer elements
    edge = {"edge_block": {"width": 100, "height": 50}}

    def solve(ics):
        sphere = {"grid": grid, "upper": RigidBody(), "gap": Paraboloid(50, 50), "Fn": 5000}
        return shared.solve(**sphere, lower=STEEL, lower_ics=ics)

    block, half_space = solve(fem(edge)), solve(AnalyticIcs())
    assert block.converged
    assert block.Fn == pytest.approx(5000)
    assert block.pmax / half_space.pmax - 1 == pytest.approx(change, abs=0.03)
    assert block.approach / half_space.approach - 1 == pytest.approx(more, abs=0.02)


def test_a_curved_section_wants_to_know_its_columns(shared):
    groove = {"groove": {"radius": 10, "depth": 10, "width": 120, "height": 70}}
    ics = AnalyticIcs(body="prism", section=groove)
    grid = Grid.centred(15, 21, 7.5, 10.5)
    problem = {"grid": grid, "upper": RigidBody(), "lower": STEEL, "lower_ics": ics, "Fn": 1000}
    frames = shared.get_ic(STEEL, grid, ics).frames
    gap = np.abs(grid.x) ** 2 / 100 + np.zeros(grid.shape) + 0.02 * (1 - np.cos(frames[:, 2]))[:, None]
    with pytest.raises(InvalidArgument, match=r"^columns: are missing.*curved|columns are missing.*curved"):
        shared.solve(**problem, gap=gap)
    solution = shared.solve(**problem, gap=gap, columns=ContactColumns(frames))
    assert solution.converged
    assert solution.resultant.Fz == pytest.approx(1000, rel=1e-6)
    turned = frames * [1, 1, 1.01]
    with pytest.raises(InvalidArgument, match=r"columns.frames\[\d+\]"):
        shared.solve(**problem, gap=gap, columns=ContactColumns(turned))


def test_what_only_half_spaces_have_is_refused_of_prisms(shared):
    ics = AnalyticIcs(body="prism", section=EDGE)
    with pytest.raises(InvalidArgument, match="a section: take model full"):
        shared.solve(grid=GRID, gap=Paraboloid(50, 50), upper=STEEL, Fn=1000, lower_ics=ics, model="hertz")


def test_half_spaces_that_are_turned_are_the_half_space_on_a_plane(shared):
    table = shared.get_ic(STEEL, GRID, AnalyticIcs(body="prism", section=EDGE))
    flat = shared.get_ic(STEEL, GRID, AnalyticIcs())
    assert table.origin in ("closed_form", "memory")
    assert table["zz"][3, 1] == pytest.approx(flat["zz"][2], rel=1e-10)
    assert table["xz"][3, 1] == pytest.approx(flat["xz"][2], rel=1e-10)


@pytest.mark.parametrize(
    ("section", "says"),
    [
        ({}, "exactly one"),
        ({**EDGE, "disc": {"radius": 10, "core": 1}}, "exactly one"),
        ({"edge_block": {"width": 5, "height": 50}}, "ics.section"),
        ({"disc": {"radius": 10, "core": 0}}, "held"),
    ],
)
def test_a_section_that_is_none_is_refused(shared, section, says):
    with pytest.raises(InvalidArgument, match=says):
        shared.get_ic(STEEL, GRID, fem(section))


@pytest.mark.parametrize(
    ("corners", "says"),
    [
        ([(30, 0), (0, -20), (30, -20), (0, 0)], r"cross"),
        ([(5, 0), (5, -20), (0, -20), (0, 0)], r"corner"),
        ([(0, -20), (30, -20), (30, 0), (0, 0)], r"clockwise"),
    ],
)
def test_an_outline_that_is_none_is_refused_with_the_place_however_often(shared, corners, says):
    parts = [{"line": {"to": {"y": y, "z": z}}, "held": z == -20} for y, z in corners]
    section = {"outline": {"outside": {"start": {"y": 0, "z": 0}, "parts": parts}}}
    sphere = {"grid": GRID, "upper": RigidBody(), "gap": Paraboloid(50, 50), "Fn": 5000}
    for _ in range(3):  # a table that was refused is not put into quarantine
        with pytest.raises(InvalidArgument, match=says) as caught:
            shared.solve(**sphere, lower=STEEL, lower_ics=fem(section))
        assert "(y, z) = (" in caught.value.message
        assert "ics.section" in caught.value.violations[0].field


def test_a_prism_is_not_exported(shared):
    with pytest.raises(InvalidArgument, match="prism"):
        shared.export_ic(STEEL, GRID, fem(EDGE))
