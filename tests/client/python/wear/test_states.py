"""States from files, and what a study refuses."""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
import pytest

from contactd import EnergyWear, InvalidArgument, WearLaw
from contactd.wear import WearStudy, WeightedState, read_states
from contactd.wear.states import mirrored
from contactd.wheel_rail import RailDeviation, WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

LAW = WearLaw("energy", "a test", "lower", (0, 10), energy=EnergyWear(1e-3))
RAIL = WearLaw("of rails", "a test", "upper", (0, 10), energy=EnergyWear(1e-3))
STATE = WeightedState(WheelRailState(position=WheelsetPosition(y=1), Fz=8e4), 1.0)
TEXT = """# From a run of 20 km.
position.y, position.yaw, velocity.x, Fz, weight, group, mu
1.5, -0.001, 30000, 80000, 0.7, straight,
-2, 0.002, 20000, 9e4, 0.3, curve, 0.2
"""


def write(tmp_path, text):
    path = tmp_path / "states.csv"
    path.write_text(text)
    return path


def test_columns_are_paths_of_a_state(tmp_path):
    first, second = read_states(write(tmp_path, TEXT))
    assert (first.state.position.y, first.state.position.yaw, first.state.velocity.x, first.state.Fz) == (1.5, -1e-3, 3e4, 8e4)
    assert (first.weight, first.group, first.mu) == (0.7, "straight", None)
    assert (second.weight, second.group, second.mu) == (0.3, "curve", 0.2)


def test_hdf5_has_a_dataset_a_column(tmp_path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "states.h5", "w") as file:
        file["position.y"], file["Fz"], file["distance"] = np.array([1.0, 2.0]), np.array([8e4, 9e4]), np.array([10.0, 5.0])
        file["group"] = np.array([b"a", b"b"])
    found = read_states(tmp_path / "states.h5")
    assert [(one.state.position.y, one.weight, one.group) for one in found] == [(1, 10, "a"), (2, 5, "b")]


def test_parquet_has_columns_of_the_same_names(tmp_path):
    pyarrow = pytest.importorskip("pyarrow")
    from pyarrow import parquet

    parquet.write_table(pyarrow.table({"position.y": [1.0, 2.0], "weight": [0.5, 0.25], "group": ["a", "b"]}), tmp_path / "s.parquet")
    found = read_states(tmp_path / "s.parquet")
    assert [(one.state.position.y, one.weight, one.group) for one in found] == [(1, 0.5, "a"), (2, 0.25, "b")]


def test_parquet_without_its_library_is_refused_by_its_name(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(InvalidArgument, match="pyarrow, which is missing"):
        read_states(tmp_path / "states.parquet")


def test_a_mirrored_state_turns_what_lies_across_the_track():
    made = WheelRailState(
        position=WheelsetPosition(y=1, z=2, roll=3e-3, yaw=4e-3), velocity=WheelsetVelocity(x=5, y=6, pitch=7, yaw=8), rail=RailDeviation(y=9, z=1)
    )
    turned = mirrored(WeightedState(made, 0.5, "curve")).state
    assert turned.position == WheelsetPosition(y=-1, z=2, roll=-3e-3, yaw=-4e-3)
    assert turned.velocity == WheelsetVelocity(x=5, y=-6, pitch=7, yaw=-8)
    assert turned.rail == RailDeviation(y=-9, z=1)


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("position.y, Fz\n1, 2\n", "neither weight nor distance"),
        ("weight, distance\n1, 2\n", "both weight and distance"),
        ("position.q, weight\n1, 2\n", r"a column position\.q; a state has no q there"),
        ("position, weight\n1, 2\n", "no number of a state"),
        ("Fz, weight\nmany, 2\n", r"states\[0\]\.Fz is 'many'"),
        ("Fz, weight\n1, 2\n3, -1\n", r"states\[1\]\.weight is -1"),
        ("Fz, weight\n1, 0\n", "have no weight together"),
        ("Fz, weight\n1\n", r"states\[0\] has 1 columns"),
        ("", "are empty"),
    ],
)
def test_what_is_wrong_with_a_file_is_named(tmp_path, text, match):
    with pytest.raises(InvalidArgument, match=match):
        read_states(write(tmp_path, text))


@pytest.mark.parametrize(
    ("changed", "match"),
    [
        ({"wears": "axle"}, "must be wheel or rail"),
        ({"wears": "both"}, "rail_law is missing"),
        ({"wears": "both", "rail_law": replace(RAIL, name="energy")}, "as that of the wheel's law"),
        ({"wears": "both", "rail_law": RAIL}, "passages_per_km is missing"),
        ({"rail_law": RAIL}, "only the wheel wears"),
        ({"fatigue": {"body": "upper"}}, "that of the rail, and the wheel wears"),
        ({"wears": "rail"}, r"law\.body is lower, and the rail wears"),
        ({"depth": 0.0}, "depth is 0"),
        ({"until": float("inf")}, "until is inf"),
        ({"smoothing": "much"}, "auto, exponential_step, or a wavelength"),
        ({"states": []}, "are none"),
        ({"states": [WeightedState(WheelRailState(motion="shift", time_step=1), 1.0)]}, "steady rolling"),
    ],
)
def test_a_study_that_makes_no_sense_is_refused(changed, match):
    given = {"setup": WheelRailSetup(), "states": [STATE], "wears": "wheel", "law": LAW, "until": 1.0, **changed}
    with pytest.raises(InvalidArgument, match=match):
        WearStudy(**given)


def test_a_state_may_have_a_friction_of_its_own():
    states = [STATE, WeightedState(STATE.state, 1.0, mu=0.1)]
    first, second = WearStudy(WheelRailSetup(), states, "wheel", LAW, 1.0).params({})
    assert first["setup"]["friction"] == {"mu": 0.3}
    assert second["setup"]["friction"] == {"mu": 0.1}
    assert first["setup"]["wear"]["laws"][0]["source"] == "a test"
