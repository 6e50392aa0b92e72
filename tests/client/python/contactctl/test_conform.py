"""conform: the benchmark of EN 15302 and quantities of EN 14363, as a user and CI call them."""

from __future__ import annotations

import csv
import os

import numpy as np
import pytest

from contactctl.conformity.benchmark import own_benchmark
from contactctl.conformity.reference_profiles import RAIL, WHEELS, points_of

#: Folders with the public profiles and values, separated as on PATH. They repeat a standard and are not in the tree.
PUBLIC = os.environ.get("CONTACTD_EN15302", "")
#: Amplitudes at which a contact leaps between two shifts of the reference's table (docs/conformity.md).
LEAPS = {("E3", 2.5), ("E3", 2.6), ("E3", 6.8), ("E4", 1.8)}
RUN = "distance (m),Yr (kN),Yl (kN),Qr (kN),Ql (kN)\n" + "".join(f"{x / 10},{20 + x % 7},-4,60,55\n" for x in range(101))


def test_own_profiles_meet_the_benchmark(ctl):
    pytest.importorskip("matplotlib")
    found = ctl("conform", "en15302", "--own", "--csv", "values.csv", "--plot", "curves.png", "--json")
    assert (found.code, found.err) == (0, "")
    told = found.json
    assert (told["inside"], told["total"]) == (42, 42)
    assert {row["combination"] for row in told["rows"]} == {"E1", "E2", "E3", "E4", "E5", "E9"}
    assert all(row["low"] <= row["conicity"] <= row["high"] for row in told["rows"])
    rows = list(csv.DictReader((ctl.folder / "values.csv").read_text().splitlines()))
    assert [float(row["conicity"]) for row in rows] == [row["conicity"] for row in told["rows"]]
    assert (ctl.folder / "curves.png").read_bytes()[1:4] == b"PNG"


def test_people_see_each_value_with_its_limits(ctl):
    shown = ctl("conform", "en15302", "--own").out
    assert "42 of 42 conicities inside" in shown
    assert "E5: A/A, radii 460 and 459" in shown
    assert len([line for line in shown.splitlines() if line.endswith("yes")]) == 42


def folder_of(ctl, factor=1.0):
    """Files with the own profiles and the values of E1, multiplied."""
    folder = ctl.folder / "benchmark"
    folder.mkdir()
    np.savetxt(folder / "RUIC519A.dat", points_of(WHEELS["A"]) * (1, -1))
    np.savetxt(folder / "SUIC519A.dat", points_of(RAIL) * (1, -1))
    values = own_benchmark().values["E1"]
    (folder / "ben_E1.dat").write_text("".join(f"{amplitude} {factor * conicity}\n" for amplitude, conicity in values))


def test_a_folder_is_checked(ctl):
    folder_of(ctl)
    found = ctl("conform", "en15302", "benchmark")
    assert (found.code, found.err) == (0, "")
    assert "7 of 7 conicities inside" in found.out


def test_values_outside_their_tolerances_end_with_9(ctl):
    folder_of(ctl, 2.0)
    found = ctl("conform", "en15302", "benchmark")
    assert found.code == 9
    assert "7 of 7 conicities lie outside their tolerances: E1 at 1 mm" in found.err
    assert "0 of 7 conicities inside" in found.out


@pytest.mark.skipif(not PUBLIC, reason="CONTACTD_EN15302 names no folders")
def test_the_public_benchmark_is_met_but_where_contacts_leap(ctl):
    found = ctl("conform", "en15302", *PUBLIC.split(os.pathsep), "--json")
    rows = found.json["rows"]
    assert len(rows) == 594
    outside = {(row["combination"], row["amplitude"]) for row in rows if not row["inside"]}
    assert outside <= LEAPS
    assert found.code == (9 if outside else 0)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ((), "or --own"),
        (("benchmark", "--own"), "or --own"),
        (("nowhere",), "nowhere is not a folder"),
        ((".",), "there are no values"),
        (("--own", "--plot", "curves.doc"), "must end in .png"),
    ],
)
def test_invalid_calls_of_the_benchmark_end_with_2(ctl, words, sentence):
    found = ctl("conform", "en15302", *words)
    assert (found.code, found.out) == (2, "")
    assert sentence in found.err


def test_a_run_is_checked(ctl):
    pytest.importorskip("matplotlib")
    ctl.write("run.csv", RUN)
    found = ctl("conform", "en14363", "run.csv", "--axle-load", 115e3, "--plot", "run.png", "--csv", "means.csv")
    assert (found.code, found.err) == (0, "")
    assert "Y/Q, right wheel" in found.out
    assert (ctl.folder / "run.png").read_bytes()[1:4] == b"PNG"
    told = ctl("conform", "en14363", "run.csv", "--axle-load", 115e3, "--json").json["quantities"]
    assert [one["name"] for one in told] == ["sum of Y", "Y/Q, right wheel", "Y/Q, left wheel"]
    assert told[0]["limit"] == pytest.approx(10e3 + 115e3 / 3)
    assert told[1]["limit"] == pytest.approx(1.200, abs=1e-3)
    assert told[2]["extreme"] == pytest.approx(4 / 55)
    assert len((ctl.folder / "means.csv").read_text().splitlines()) == 1 + 3 * 17


def test_a_run_beyond_a_limit_ends_with_9(ctl):
    ctl.write("run.csv", RUN)
    found = ctl("conform", "en14363", "run.csv", "--ratio-limit", 0.3)
    assert found.code == 9
    assert "1 of 3 quantities exceed their limits: Y/Q, right wheel" in found.err
    assert ctl("conform", "en14363", "run.csv", "--flange-angle", 60, "--mu", 0.6, "--axle-load", 1000).code == 9


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("short.csv",), "shorter than a window of 2000 mm"),
        (("run.csv", "--flange-angle", "60", "--mu", "1.9"), "give a smaller friction coefficient"),
        (("nowhere.csv",), "nowhere.csv cannot be read"),
        (("run.csv", "--flange-angle", "90"), "not in the range"),
    ],
)
def test_invalid_runs_end_with_2(ctl, words, sentence):
    ctl.write("run.csv", RUN)
    ctl.write("short.csv", RUN.replace("(m)", "(mm)"))
    found = ctl("conform", "en14363", *words)
    assert (found.code, found.out) == (2, "")
    assert sentence in found.err


def test_contact_filters_meet_the_directive(ctl):
    pytest.importorskip("matplotlib")
    found = ctl("conform", "cnossos", "--csv", "filters.csv", "--plot", "filters.png", "--json")
    assert (found.code, found.err) == (0, "")
    assert [(one["load"], one["diameter"]) for one in found.json["columns"]] == [(50, 360), (50, 680), (50, 920), (25, 920), (100, 920)]
    assert len(found.json["rows"]) == 175
    rows = list(csv.DictReader((ctl.folder / "filters.csv").read_text().splitlines()))
    assert [float(row["computed"]) for row in rows] == [row["computed"] for row in found.json["rows"]]
    assert (ctl.folder / "filters.png").read_bytes()[1:4] == b"PNG"
    solved = ctl("conform", "cnossos", "--solve", "--json").json
    near = [(one["computed"], other["computed"]) for one, other in zip(solved["rows"], found.json["rows"]) if one["wavelength"] >= 16]
    np.testing.assert_allclose(*zip(*near), atol=0.1)


def test_another_rail_head_ends_with_1(ctl):
    found = ctl("conform", "cnossos", "--rail-radius", 800)
    assert found.code == 9
    assert "3 of 5 columns lie outside their tolerances: 50 kN, 920 mm" in found.err
