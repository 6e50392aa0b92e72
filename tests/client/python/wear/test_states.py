"""Tests states from files, and refusals of studies."""

from __future__ import annotations

import sys
import warnings
from dataclasses import replace

import numpy as np
import pytest

from contactd import ContactWarning, EnergyWear, InvalidArgument, WearLaw
from contactd.wear import WearStudy, WeightedState, read_states
from contactd.wear.states import mirrored, states_of_columns
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


def test_positions_in_metres_are_warned_of_once_for_the_whole_table(tmp_path):
    with pytest.warns(ContactWarning) as caught:
        read_states(write(tmp_path, TEXT.replace("1.5,", "0.0015,").replace("-2,", "-0.002,")))
    (warning,) = caught
    assert "position.y is at most 0.002 mm" in str(warning.message)
    assert "not in m. If it is in m, it is up to 2 mm." in str(warning.message)


@pytest.mark.parametrize("y", ["0, 0", "1e-4, -2e-4", "0.003, -2"])
def test_positions_in_millimetres_that_are_small_are_warned_of_nothing(y):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        states_of_columns({"position.y": y.split(","), "Fz": [1, 1], "weight": [1, 1]})


@pytest.mark.parametrize("between", [";", "\t", " ; "])
def test_files_of_spreadsheets_have_decimal_commas(tmp_path, between):
    lines = TEXT.replace("#", "%").replace("2, 3", "2; 3").splitlines()
    text = "\r\n".join(line.replace(", ", between).replace("straight,", f"straight{between}").replace(".", "," if i > 1 else ".") for i, line in enumerate(lines))
    assert read_states(write(tmp_path, text)) == read_states(write(tmp_path, TEXT))


def test_a_sign_of_comments_in_quotation_marks_is_one_of_a_name(tmp_path):
    (one,) = read_states(write(tmp_path, 'Fz, weight, group  # of the network\n1, 1, "5 % of all"  # curves\n'))
    assert one.group == "5 % of all"


def test_files_that_are_not_what_their_names_say_are_refused(tmp_path):
    pytest.importorskip("h5py")
    for name in ("states.csv", "states.h5"):
        (tmp_path / name).write_bytes(b"\x89\xff\x00 no text")
        with pytest.raises(InvalidArgument, match="not text in UTF-8|not a readable HDF5"):
            read_states(tmp_path / name)
        with pytest.raises(FileNotFoundError):
            read_states(tmp_path / "nothing" / name)


def test_what_is_no_column_of_hdf5_is_not_passed_over(tmp_path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "states.h5", "w") as file:
        file["position/y"], file["Fz"], file["weight"] = [1.0, 2.0], [8e4, 9e4], [1.0, 1.0]
    with pytest.raises(InvalidArgument, match="have position, which is not a column"):
        read_states(tmp_path / "states.h5")


def test_columns_have_a_row_a_state():
    with pytest.raises(InvalidArgument, match="columns of different lengths: Fz 1, weight 2"):
        states_of_columns({"Fz": [1.0], "weight": [1.0, 2.0]})


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
    with pytest.raises(InvalidArgument, match="requires pyarrow"):
        read_states(tmp_path / "states.parquet")


def test_a_mirrored_state_turns_what_lies_across_the_track():
    made = WheelRailState(
        position=WheelsetPosition(y=1, z=2, roll=3e-3, yaw=4e-3), velocity=WheelsetVelocity(x=5, y=6, pitch=7, yaw=8), rail=RailDeviation(y=9, z=1)
    )
    image = mirrored(WeightedState(made, 0.5, "curve")).state
    assert image.position == WheelsetPosition(y=-1, z=2, roll=-3e-3, yaw=-4e-3)
    assert image.velocity == WheelsetVelocity(x=5, y=-6, pitch=7, yaw=-8)
    assert image.rail == RailDeviation(y=-9, z=1)


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("position.y, Fz\n1, 2\n", "neither weight nor distance"),
        ("weight, distance\n1, 2\n", "both weight and distance"),
        ("position.q, weight\n1, 2\n", r"a column position\.q; a state has no q there"),
        ("position, weight\n1, 2\n", "not a number of a state"),
        ("Fz, weight\nmany, 2\n", r"states\[0\]\.Fz is 'many'"),
        ("Fz, weight\n1, 2\n3, -1\n", r"states\[1\]\.weight is -1"),
        ("Fz, weight\n1, 0\n2, 0\n", "states all have a weight of 0; give at least one of them a positive weight"),
        ("Fz, distance\n1, 0\n", "states all have a distance of 0"),
        ("Fz, weight\n1\n", "line 2 has 1 columns, but the first has 2"),
        ("Fz, weight, Fz\n1, 1, 2\n", "line 1 names Fz twice"),
        ("Fz, weight,\n1, 1,\n", "line 1 has no name for column 3"),
        ("", "are empty"),
    ],
)
def test_what_is_wrong_with_a_file_is_named(tmp_path, text, match):
    with pytest.raises(InvalidArgument, match=match):
        read_states(write(tmp_path, text))


@pytest.mark.parametrize(
    ("changed", "match"),
    [
        ({"wears": "axle"}, "must be wheel, rail or both"),
        ({"wears": "both"}, "rail_law is missing"),
        ({"wears": "both", "rail_law": replace(RAIL, name="energy")}, "which the wheel's law already has"),
        ({"wears": "both", "rail_law": RAIL}, "passages_per_km is missing"),
        ({"rail_law": RAIL}, "only the wheel wears"),
        ({"fatigue": {"body": "upper"}}, "that of the rail, but the wheel wears"),
        ({"wears": "rail"}, r"law\.body is lower, but the rail wears"),
        ({"depth": 0.0}, "depth is 0"),
        ({"until": float("inf")}, "until is inf"),
        ({"smoothing": "much"}, "auto, exponential_step, or a wavelength"),
        ({"smoothing": True}, "auto, exponential_step, or a wavelength"),
        ({"smoothing": float("inf")}, "auto, exponential_step, or a wavelength"),
        ({"distance": 1e-300}, "distance is 1e-300 km, which results in more than 1000000 steps"),
        ({"spacing": 1e-9}, r"spacing is 1e-09 mm; it must lie in \[0.01, 10\]"),
        ({"spacing": 1000.0}, r"spacing is 1000 mm; it must lie in \[0.01, 10\]"),
        ({"states": [STATE, replace(STATE, weight=-0.5)]}, r"states\[1\]\.weight is -0.5"),
        ({"states": [STATE, replace(STATE, weight=float("inf"))]}, r"states\[1\]\.weight is inf"),
        ({"states": []}, "are empty; give at least one state"),
        ({"states": [WeightedState(WheelRailState(), 0.0)]}, "all have a weight of 0"),
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


def test_who_waits_for_many_states_hears_how_many_are_read(tmp_path):
    heard = []
    rows = "".join(f"{row / 1000}, 8e4, 1\n" for row in range(10_000))
    states = read_states(write(tmp_path, f"position.y, Fz, weight\n{rows}"), heard.append)
    assert [one.state.position.y for one in states] == [row / 1000 for row in range(10_000)]
    assert heard[0] == 0 and heard == sorted(heard) and len(heard) >= 5 and 0.5 < heard[-1] < 1


def test_a_cell_that_is_no_number_is_quoted_in_part(tmp_path):
    for cell in ("x" * 5_000_000, "y" * 100_000):
        with pytest.raises(InvalidArgument) as refused:
            read_states(write(tmp_path, f"Fz, weight\n1, 1\n{cell}, 1\n"))
        assert len(str(refused.value)) < 300
        assert "line 3 has a cell of 5000000 characters" in str(refused.value) or "states[1].Fz" in str(refused.value)
