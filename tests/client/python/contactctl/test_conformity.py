"""Formulas and files behind conform, without a daemon: limits, sliding means, reference profiles, tables of runs."""

from __future__ import annotations

import math

import click
import numpy as np
import pytest

from contactctl.conformity.benchmark import COMBINATIONS, bounds, own_benchmark
from contactctl.conformity.benchmark_files import read_benchmark
from contactctl.conformity.limits import nadal_limit, prudhomme_limit
from contactctl.conformity.reference_profiles import RAIL, WHEELS, points_of
from contactctl.conformity.run_files import read_run
from contactctl.conformity.run_quantities import Run, RunLimits, WheelsetForces, assessed
from contactctl.conformity.sliding_means import sliding_means

NADAL = {
    60: (1.391, 1.138, 0.942, 0.787, 0.660),
    65: (1.683, 1.361, 1.122, 0.939, 0.794),
    70: (2.077, 1.644, 1.342, 1.118, 0.947),
}  #: For friction coefficients 0.1 to 0.5, three decimal places.


@pytest.mark.parametrize("degrees", NADAL)
def test_nadals_limit_is_the_tangent_of_the_difference_of_angles(degrees):
    angle = math.radians(degrees)
    for mu, printed in zip((0.1, 0.2, 0.3, 0.4, 0.5), NADAL[degrees]):
        assert nadal_limit(angle, mu) == pytest.approx(math.tan(angle - math.atan(mu)), rel=1e-12)
        assert nadal_limit(angle, mu) == pytest.approx(printed, abs=5.1e-4)


def test_prudhommes_limit_grows_by_a_third_of_the_load():
    assert prudhomme_limit(0) == 10e3
    assert prudhomme_limit(120e3) == pytest.approx(50e3)
    assert prudhomme_limit(120e3, 0.85) == pytest.approx(42.5e3)


def test_means_of_a_straight_line_are_its_values_at_any_spacing():
    distance = np.cumsum(np.random.default_rng(3).uniform(20, 300, 200))
    places, means = sliding_means(distance, 3 + 0.01 * distance, 2000, 500)
    assert np.allclose(means, 3 + 0.01 * places, rtol=1e-12)
    assert np.allclose(np.diff(places), 500)
    assert places[0] == pytest.approx(distance[0] + 1000)


def test_means_of_a_wave_are_smaller_by_the_transform_of_the_window():
    distance = np.arange(0, 100e3 + 1, 10.0)
    places, means = sliding_means(distance, np.sin(2 * math.pi * distance / 8000), 2000, 500)
    assert np.allclose(means, math.sin(math.pi / 4) / (math.pi / 4) * np.sin(2 * math.pi * places / 8000), atol=2e-5)


def test_a_run_of_one_window_has_one_mean_and_a_shorter_one_none():
    places, means = sliding_means(np.array([0.0, 2000.0]), np.array([1.0, 3.0]), 2000, 500)
    assert (list(places), list(means)) == ([1000], [2])
    with pytest.raises(ValueError, match="shorter than a window"):
        sliding_means(np.array([0.0, 1999.0]), np.array([1.0, 3.0]), 2000, 500)


def wave(distance):
    return 10e3 + 30e3 * np.sin(2 * math.pi * distance / 8000)


def test_quantities_of_a_synthetic_run_have_their_closed_forms():
    distance = np.arange(0, 100e3 + 1, 10.0)
    ones = np.ones(len(distance))
    run = Run(distance, [WheelsetForces("", wave(distance), -4e3 * ones, 60e3 * ones, 55e3 * ones)])
    total, right, left = assessed(run, RunLimits(0.5))
    largest = 10e3 + 30e3 * math.sin(math.pi / 4) / (math.pi / 4)
    assert total.extreme == pytest.approx(largest - 4e3, rel=1e-4)
    assert total.percentile == pytest.approx(total.extreme, rel=1e-2)
    assert total.limit == pytest.approx(10e3 + 115e3 / 3)
    assert right.extreme == pytest.approx(largest / 60e3, rel=1e-4)
    assert (right.place - 2000) % 8000 == pytest.approx(0, abs=1e-6)
    assert left.extreme == pytest.approx(4 / 55)
    assert [one.is_inside for one in (total, right, left)] == [True, False, True]


def test_a_force_to_the_left_counts_by_its_size():
    distance = np.array([0.0, 4000.0])
    run = Run(distance, [WheelsetForces("2", *(np.full(2, value) for value in (-30e3, -40e3, 50e3, 50e3)))])
    total, right, left = assessed(run, RunLimits(1.2, axle_load=120e3, track_factor=0.85))
    assert (total.name, total.extreme, total.limit, total.is_inside) == ("sum of Y of wheelset 2", 70e3, 42.5e3, False)
    assert (right.extreme, left.extreme) == (-0.6, 0.8)


def test_tables_of_runs_have_units_and_several_wheelsets(tmp_path):
    file = tmp_path / "run.csv"
    file.write_text("time [s];speed (km/h);Yr1 (kN);Yl1;Qr1 (kN);Ql1 (kN);Yr2;Yl2;Qr2;Ql2;remark\n"
                    "0;36;1;-2000;50;51;1;2;3;4;a\n0,5;36;2;-2500;52;53;5;6;7;8;b\n")  # fmt: skip
    run = read_run(file, is_outwards=False)
    assert list(run.distance) == pytest.approx([0, 5000])
    assert [wheelset.name for wheelset in run.wheelsets] == ["1", "2"]
    assert list(run.wheelsets[0].Yr) == [1000, 2000]
    assert list(run.wheelsets[0].Yl) == [-2000, -2500]
    assert list(read_run(file, is_outwards=True).wheelsets[0].Yl) == [2000, 2500]


def test_reading_a_long_run_reports_its_progress(tmp_path):
    file = tmp_path / "run.csv"
    file.write_text("distance,Yr,Yl,Qr,Ql\n" + "".join(f"{x},1,1,1,1\n" for x in range(50_000)))
    seen = []
    read_run(file, is_outwards=False, on_progress=seen.append)
    assert seen == sorted(seen)
    assert len(seen) >= 6 and 0 == seen[0] < seen[1] < 0.5 <= seen[-1] < 1


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("distance,Yr,Yl,Qr\n0,1,1,1\n9,1,1,1\n", "no column Ql"),
        ("distance,a\n0,1\n9,1\n", "no forces"),
        ("Yr,Yl,Qr,Ql\n1,1,1,1\n1,1,1,1\n", "no column time"),
        ("distance (in),Yr,Yl,Qr,Ql\n0,1,1,1,1\n9,1,1,1,1\n", "the unit of 'distance (in)' is not supported"),
        ("distance,Yr,Yl,Qr,Ql\n0,1,1,1,1\n0,1,1,1,1\n", "does not increase at row 2"),
        ("distance,Yr,Yl,Qr,Ql\n0,1,1,1,1\n", "at least two"),
        ("distance,Yr,Yl,Qr,Ql\n0,1,1,1,1\n9,1,1,1,0\n", "Ql is 0 N in row 2"),
        ("distance,Yr,Yl,Qr,Ql\n0,1,1,1,1\n9,x,1,1,1\n", "line 3 has 'x' in column Yr"),
        ("distance,Yr,Yl,Qr,Ql\n0,1,1,1,1\n9,1e308,1,1,1\n", "line 3 has 1e+308 in column Yr, which is too large"),
        ("distance,Yr,Yl,Qr,Ql\n0,1,1,1,1\n1e999,1,1,1,1\n", "line 3 has inf in column distance, which is too large"),
        ("distance,Yr,Yl,Qr,Ql\n0,1,1,1,1\n1e11,1,1,1,1\n", "100000 km long; it may have up to 5000 km"),
    ],
)
def test_invalid_tables_of_runs_are_refused(tmp_path, text, sentence):
    (tmp_path / "run.csv").write_text(text)
    with pytest.raises(click.UsageError) as refused:
        read_run(tmp_path / "run.csv", is_outwards=False)
    assert sentence in refused.value.message


def test_tolerances_are_half_the_value_and_at_most_a_twentieth():
    assert bounds(0.025) == pytest.approx((0.0125, 0.0375))
    assert bounds(0.3) == pytest.approx((0.25, 0.35))
    assert bounds(0) == (0, 0.01)


@pytest.mark.parametrize("name", [*WHEELS, "rail"])
def test_reference_profiles_are_continuous_and_have_few_kinks(name):
    points = points_of(RAIL if name == "rail" else WHEELS[name], 0.05)
    steps = np.diff(points, axis=0)
    assert np.all(steps[:, 0] > 0)
    assert np.max(np.hypot(*steps.T)) <= 0.05 + 1e-9
    turns = np.abs(np.diff(np.arctan2(steps[:, 1], steps[:, 0])))
    # Kinks at the chamfer and, for H and I, at the tread.
    assert np.count_nonzero(turns > 0.02) == {"rail": 0, "H": 3}.get(name, 2)


def test_reference_wheels_meet_their_flange_and_tread():
    for outline in WHEELS.values():
        points = points_of(outline)
        assert np.interp(0, *points.T) == 0
        assert np.max(points[:, 1]) == pytest.approx(28, abs=2e-3)
        assert points[0, 0] == pytest.approx(-70, abs=1e-2)
        assert points[-1, 0] == 65


def test_a_folder_with_the_own_profiles_is_read_as_they_are(tmp_path):
    own = own_benchmark()
    for letter, outline in WHEELS.items():
        np.savetxt(tmp_path / f"RUIC519{letter}.dat", points_of(outline) * (1, -1))
    np.savetxt(tmp_path / "SUIC519A.dat", points_of(RAIL) * (1, -1), delimiter="\t")
    for name, values in own.values.items():
        (tmp_path / f"ben_{name}.dat").write_text("".join(f"{a} {c} {bounds(c)[1]} {bounds(c)[0]}\n" for a, c in values))
    found = read_benchmark([tmp_path])
    assert found.values == own.values
    assert found.wheels.keys() == own.wheels.keys()
    assert all(profile.mirror_z for profile in (*found.wheels.values(), found.rail))
    assert COMBINATIONS["E5"].title == "A/A, radii 460 and 459"
    (tmp_path / "RUIC519H.dat").unlink()
    with pytest.raises(click.UsageError, match=r"RUIC519H\.dat is missing"):
        read_benchmark([tmp_path])
    (tmp_path / "RUIC519H.dat").write_text("1\n2\n")
    with pytest.raises(click.UsageError, match="has one column"):
        read_benchmark([tmp_path])
