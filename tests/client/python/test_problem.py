"""Tests the wire format of the dataclasses of requests."""

import copy
import dataclasses
import pickle

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactProblem,
    Estimate,
    FemIcs,
    Friction,
    Grid,
    InvalidArgument,
    Layer,
    LineContact,
    Material,
    Paraboloid,
    RigidBody,
    SemiAxes,
    SolverSettings,
    TableIcs,
)
from contactd.values.contact_params import problem_params, table_params

STEEL = Material(G=82000, nu=0.28)
GRID = Grid(3, 2, 0.5, 1.0)
PROBLEM = ContactProblem(grid=GRID, upper=STEEL, gap=Paraboloid(Rx=50), approach=0.02)


def test_a_grid_is_centred_on_the_origin():
    np.testing.assert_allclose(GRID.x, [-0.5, 0, 0.5])
    np.testing.assert_allclose(GRID.y, [-0.5, 0.5])
    assert GRID.shape == (2, 3)


def test_a_grid_starts_at_its_corner():
    grid = Grid(2, 2, 1.0, 1.0, x0=10, y0=0)
    np.testing.assert_allclose(grid.x, [10.5, 11.5])
    np.testing.assert_allclose(grid.y, [0.5, 1.5])


def test_a_centred_grid_divides_its_rectangle():
    assert Grid.centred(40, 20, 2.4, 2.4) == Grid(40, 20, 2.4 / 40, 2.4 / 20)


@pytest.mark.parametrize(("nx", "ny"), [(0, 20), (20, 0), (-1, 20)])
def test_a_rectangle_is_divided_into_one_element_at_least(nx, ny):
    with pytest.raises(ValueError, match=f"nx and ny are {nx} and {ny}; .* at least one"):
        Grid.centred(nx, ny, 2.4, 2.4)


def test_a_table_request_holds_only_what_was_given():
    assert table_params(STEEL, GRID, FemIcs(preset="paper-test3", L_over_h=1280)) == {
        "material": {"G": 82000, "nu": 0.28},
        "grid": {"nx": 3, "ny": 2, "dx": 0.5, "dy": 1.0},
        "ics": {"source": "fem", "preset": "paper-test3", "L_over_h": 1280},
    }


def test_a_line_contact_says_its_datum():
    ics = AnalyticIcs(line_contact=LineContact(datum=100))
    params = table_params(Material(1, 0.3), Grid(3, 1, 1, 1), ics)
    assert params["ics"] == {"source": "analytic", "line_contact": {"datum": 100}}
    with pytest.raises(TypeError, match="line_contact is 100; it must be of type LineContact"):
        AnalyticIcs(line_contact=100)


def test_an_accuracy_is_asked_for_without_a_mesh():
    ics = FemIcs(accuracy=1e-3, body="block", L_over_h=20, load_shape="bilinear", any_nu=True)
    assert table_params(STEEL, GRID, ics)["ics"] == {
        "source": "fem", "accuracy": 1e-3, "body": "block", "L_over_h": 20, "load_shape": "bilinear", "any_nu": True
    }  # fmt: skip
    assert table_params(STEEL, GRID, FemIcs())["ics"] == {"source": "fem"}


def test_a_table_request_does_not_say_where_the_grid_lies():
    grid = Grid(3, 2, 0.5, 1.0, x0=7, y0=8)
    assert table_params(STEEL, grid, AnalyticIcs()) == table_params(STEEL, GRID, AnalyticIcs())


def test_the_smallest_problem_leaves_everything_optional_out():
    assert problem_params(PROBLEM) == {
        "grid": {"nx": 3, "ny": 2, "dx": 0.5, "dy": 1.0},
        "bodies": {"upper": {"G": 82000, "nu": 0.28}},
        "ics": {"source": "analytic"},
        "gap": {"paraboloid": {"Rx": 50}},
        "approach": 0.02,
    }


def test_a_full_problem_says_everything():
    gap, pressure = np.ones((2, 3)), np.zeros((2, 3))
    problem = PROBLEM.replace(
        lower=Material(1, 0),
        gap=gap,
        friction=Friction(0.4, (0.1, 0)),
        normal=SolverSettings(tolerance=1e-8),
        tangential=SolverSettings(max_iterations=9),
        outer=SolverSettings(tolerance=1e-4),
        initial=Estimate(pressure=pressure),
        previous=Estimate(traction_x=pressure),
        model="full",
    )
    params = problem_params(problem)
    assert params["bodies"]["lower"] == {"G": 1, "nu": 0}
    assert params["gap"]["array"] is gap
    assert params["friction"] == {"mu": 0.4, "rigid_shift": [0.1, 0]}
    assert params["settings"] == {
        "normal": {"tolerance": 1e-8}, "tangential": {"max_iterations": 9}, "outer": {"tolerance": 1e-4}
    }  # fmt: skip
    assert params["initial"].keys() == {"pressure"}
    assert params["previous"].keys() == {"traction_x"}
    assert params["model"] == "full"


def test_a_force_takes_the_place_of_the_approach():
    params = problem_params(PROBLEM.replace(Fn=9.2))
    assert params["Fn"] == 9.2
    assert "approach" not in params
    assert "Fn" not in problem_params(PROBLEM.replace(Fn=9.2).replace(approach=0.1))


@pytest.mark.parametrize(
    ("load", "problem"), [({}, "lacks approach or Fn"), ({"approach": 0.02, "Fn": 1.0}, "has both approach and Fn")]
)
def test_either_the_approach_or_the_force_is_given(load, problem):
    with pytest.raises(TypeError, match=rf"^ContactProblem\(\) {problem}; give either approach or Fn"):
        ContactProblem(grid=GRID, upper=STEEL, gap=Paraboloid(Rx=50), **load)


@pytest.mark.parametrize(
    ("field", "value", "kind"),
    [
        ("grid", (20, 20, 0.1, 0.1), "Grid"),
        ("upper", {"G": 200, "nu": 0.42}, "Material or RigidBody"),
        ("lower", "steel", "Material or RigidBody"),
        ("ics", "fem", "AnalyticIcs or FemIcs or TableIcs"),
        ("lower_ics", "fem", "AnalyticIcs or FemIcs or TableIcs"),
        ("friction", 0.3, "Friction"),
        ("normal", 1e-8, "SolverSettings"),
        ("previous", 3, "a solution or an Estimate"),
    ],
)
def test_a_part_of_another_type_is_named_with_the_right_one(field, value, kind):
    good = {"grid": Grid(4, 4, 1, 1), "upper": Material(1, 0.3), "gap": Paraboloid(Rx=1), "approach": 0.1}
    with pytest.raises(TypeError, match=f"^{field} is .*; it must be .*{kind}"):
        ContactProblem(**{**good, field: value})


def test_a_table_request_takes_material_before_grid():
    with pytest.raises(TypeError, match="^material is Grid.*; it must be of type Material"):
        table_params(Grid(4, 4, 1, 1), Material(1, 0.3), AnalyticIcs())


def test_a_gap_is_required():
    with pytest.raises(TypeError, match="lacks gap"):
        ContactProblem(grid=GRID, upper=STEEL, approach=0.02)


def test_a_gap_may_be_given_by_semi_axes():
    assert problem_params(PROBLEM.replace(gap=SemiAxes(1, 2)))["gap"] == {"semi_axes": {"a": 1, "b": 2}}


def test_a_body_may_be_rigid():
    bodies = problem_params(PROBLEM.replace(upper=RigidBody(), lower=STEEL))["bodies"]
    assert bodies == {"upper": {"rigid": True}, "lower": {"G": 82000, "nu": 0.28}}


def test_a_body_may_have_coefficients_of_its_own():
    table = TableIcs(np.ones((3, 3, 4, 5)), 0.5, 1.0)
    problem = PROBLEM.replace(upper_ics=FemIcs(body="block"), lower=Material(1, 0), lower_ics=table)
    bodies = problem_params(problem)["bodies"]
    assert bodies["upper"] == {"G": 82000, "nu": 0.28, "ics": {"source": "fem", "body": "block"}}
    assert bodies["lower"]["ics"].keys() == {"source", "table", "dx", "dy"}
    assert bodies["lower"]["ics"]["table"].shape == (3, 3, 2, 3)  # only as large as the grid requires


def test_coefficients_of_the_lower_body_alone_name_its_material():
    bodies = problem_params(PROBLEM.replace(lower_ics=FemIcs()))["bodies"]
    assert bodies["lower"] == {"G": 82000, "nu": 0.28, "ics": {"source": "fem"}}
    assert "ics" not in bodies["upper"]


def test_a_rigid_slip_goes_out_as_two_arrays():
    slip = (np.ones((2, 3)), np.zeros((2, 3)))
    friction = problem_params(PROBLEM.replace(friction=Friction(0.4, rigid_slip=slip)))["friction"]
    assert friction["mu"] == 0.4
    assert friction["rigid_slip"]["x"] is slip[0]
    assert friction["rigid_slip"]["y"] is slip[1]


@pytest.mark.parametrize("slip", [np.ones((2, 3)), (np.ones((2, 3)),), 0.001])
def test_a_rigid_slip_is_a_pair(slip):
    with pytest.raises(TypeError, match="^rigid_slip is .*; it must be a pair of arrays"):
        problem_params(PROBLEM.replace(friction=Friction(0.4, rigid_slip=slip)))


def test_quick_models_do_not_use_a_table():
    table = TableIcs(np.ones((3, 3, 2, 3)), 0.5, 1.0)
    params = problem_params(PROBLEM.replace(model="fastsim", ics=table))
    assert params["bodies"] == {"upper": {"G": 82000, "nu": 0.28}}
    assert "ics" not in params


def test_a_gap_may_be_nested_lists():
    params = problem_params(PROBLEM.replace(gap=[[0, 1, 2], [3, 4, 5]]))
    assert params["gap"]["array"].shape == (2, 3)


def test_values_cannot_be_changed_by_accident():
    with pytest.raises(AttributeError):
        STEEL.G = 1


# --- materials -------------------------------------------------------------------------------------------------------


def test_a_material_is_given_by_its_shear_modulus_or_by_youngs():
    assert Material(E=210000, nu=0.28) == Material(G=210000 / 2.56, nu=0.28)
    assert Material(82000, 0.28).E == 2 * 82000 * 1.28
    assert Material(E=1, nu=0.5).G == pytest.approx(1 / 3)
    assert Layer(2, E=3, nu=0.5) == Layer(2, G=1, nu=0.5)
    assert Layer(2, 1, 0.5).E == 3


def test_a_material_of_youngs_modulus_goes_out_as_one_of_the_shear_modulus():
    params = problem_params(PROBLEM.replace(upper=Material(E=256, nu=0.28)))
    assert params["bodies"]["upper"] == {"G": 100, "nu": 0.28}


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"nu": 0.3}, TypeError, "lacks G or E; give either G, the shear modulus, or E"),
        ({"G": 1, "E": 1, "nu": 0.3}, TypeError, "has both G and E; give either G, the shear modulus, or E"),
        ({"E": 1}, TypeError, "lacks nu"),
        ({"E": 0, "nu": 0.3}, InvalidArgument, "^E is 0; it must be a positive"),
        ({"E": -1.0, "nu": 0.3}, InvalidArgument, r"^E is -1\.0; it must be a positive"),
        ({"E": float("inf"), "nu": 0.3}, InvalidArgument, "^E is inf; it must be a positive"),
        ({"E": float("nan"), "nu": 0.3}, InvalidArgument, "^E is nan; it must be a positive"),
        ({"E": "1", "nu": 0.3}, TypeError, "^E is '1'; it must be a number"),
        ({"E": 1, "nu": -1}, InvalidArgument, r"^nu is -1; it must lie in \[0, 0.5\]"),
        ({"E": 1, "nu": "x"}, TypeError, "^nu is 'x'; it must be a number"),
    ],
)
def test_a_material_that_is_none_is_refused_by_name(arguments, error, message):
    with pytest.raises(error, match=message):
        Material(**arguments)


def test_a_material_stays_a_plain_value():
    steel = Material(E=210000, nu=0.28)
    assert repr(steel) == f"Material(G={steel.G}, nu=0.28)"
    assert pickle.loads(pickle.dumps(steel)) == copy.copy(steel) == steel
    assert hash(steel) == hash(Material(steel.G, 0.28))
    assert dataclasses.replace(steel, nu=0.3) == Material(steel.G, 0.3)
    assert [field.name for field in dataclasses.fields(steel)] == ["G", "nu"]
    with pytest.raises(dataclasses.FrozenInstanceError):
        steel.G = 1


def test_derivatives_are_asked_for_where_they_are_wanted():
    assert "derivatives" not in problem_params(PROBLEM)
    assert problem_params(PROBLEM.replace(derivatives=True))["derivatives"] is True
    with pytest.raises(TypeError, match="derivatives is 1; it must be of type bool"):
        PROBLEM.replace(derivatives=1)


@pytest.mark.parametrize("section", [[1], "rail_60e1", 3])
def test_a_section_that_is_no_mapping_is_refused_by_its_name(section):
    problem = ContactProblem(
        grid=Grid(2, 2, 1, 1), upper=Material(1, 0), gap=Paraboloid(50), approach=0.1, ics=AnalyticIcs("longitudinally_uniform", section=section)
    )
    with pytest.raises(TypeError, match=r"ics\.section is .*; it must be of type Mapping"):
        problem_params(problem)
