"""roughness: spectra of records before and after the contact filter, as users call it."""

from __future__ import annotations

import csv
import math

import numpy as np
import pytest

X = np.arange(3000)
NORMAL = "grid: {nx: 40, ny: 40, dx: 0.36, dy: 0.27}\nbodies: {upper: {G: 82000, nu: 0.28}}\nics: {source: analytic}\ngap: {paraboloid: {Rx: 460, Ry: 300}}\nFn: 50000\n"


def table(*lines: np.ndarray, heading: str = "x (m);r (um)") -> str:
    rows = (";".join([f"{x / 1e3:.3f}", *(f"{line[x]:.4f}" for line in lines)]) for x in X)
    return heading + "\n" + "\n".join(rows).replace(".", ",") + "\n"


SINE = 4 * np.sin(2 * np.pi * X / 20)
NOISE = np.cumsum(np.random.default_rng(3).standard_normal(len(X))) * 0.05


@pytest.fixture
def there(ctl):
    ctl.write("rail.csv", table(SINE))
    ctl.write("noise.csv", table(NOISE))
    ctl.write("lines.csv", table(SINE, SINE, SINE, heading="x (m);a (um);b (um);c (um)"))
    ctl.write("bare.csv", table(SINE, heading="x;r"))
    ctl.write("normal.yaml", NORMAL)
    ctl.write("wheel.yaml", "setup: {dx: 0.25, dy: 0.25, friction: null}\nstate: {Fz: 50000}\n")
    return ctl


def bands(ended):
    assert (ended.code, ended.err) == (0, ""), ended.err
    return {row["wavelength"]: row for row in ended.json["bands"]}


def test_a_sine_is_filtered_like_roughness_alike_across(there):
    found = bands(there("roughness", "rail.csv", "--load", 50e3, "--across", "alike", "--raw", "--json"))[20]
    assert found["level"] == pytest.approx(10 * math.log10(8), abs=0.01)
    assert found["filter"] == pytest.approx(20 * math.log10(0.5438), abs=0.06)
    assert found["filtered"] == pytest.approx(found["level"] + found["filter"], abs=1e-9)
    assert found["limit"] == -6.2


def test_computed_contacts_are_close_to_hertz(there):
    hertz, computed = (bands(there("roughness", "noise.csv", *words, "--json")) for words in (("--load", 50e3), ("--case", "normal.yaml")))
    for wave in (100, 40, 25, 20):
        assert computed[wave]["filter"] == pytest.approx(hertz[wave]["filter"], abs=0.1)


def test_a_wheel_on_its_rail_is_solved(there):
    told = there("roughness", "noise.csv", "--wheel", "wheel.yaml", "--json").json
    assert told["semi_axes"] == pytest.approx([4.23, 10.27], abs=0.03)
    assert told["across"] == "isotropic"
    assert told["chi"] > 0


def test_measured_lines_need_no_assumption(there):
    lines = bands(there("roughness", "lines.csv", "--y", "-10,0,10", "--load", 50e3, "--raw", "--json"))[20]
    alike = bands(there("roughness", "rail.csv", "--across", "alike", "--load", 50e3, "--raw", "--json"))[20]
    assert lines["filter"] == pytest.approx(alike["filter"], abs=0.05)


def test_people_see_the_assumption_and_the_processing(there):
    pytest.importorskip("matplotlib")
    shown = there("roughness", "rail.csv", "--load", 50e3, "--csv", "levels.csv", "--plot", "levels.png")
    assert (shown.code, shown.err) == (0, "")
    for words in ("EN 15610: spikes, circle of 0.375 m", "isotropic, exponent 3", "5.709 along, 4.294 across", "chi"):
        assert words in shown.out
    rows = list(csv.DictReader((there.folder / "levels.csv").read_text().splitlines()))
    assert len(rows) == 21
    assert (there.folder / "levels.png").read_bytes()[1:4] == b"PNG"
    assert "filter" in there("roughness", "rail.csv").out


def test_steep_roughness_is_warned_of(there):
    there.write("steep.csv", table(20 * SINE))
    ended = there("roughness", "steep.csv", "--load", 50e3)
    assert ended.code == 0
    assert "the filter to first order errs by 1 dB and more above 0.3" in ended.err


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--load", 50), "--load 50: the load is very small for a wheel. Give it in N; is it in kN?"),
        (("--load", 50e3, "--radii", "0.46,0.3"), "--radii 0.46,0.3: the radii are very small for a wheel and a rail."),
    ],
)
def test_loads_in_kilonewtons_and_radii_in_metres_are_warned_of(there, words, sentence):
    ended = there("roughness", "noise.csv", *words)
    assert ended.code == 0
    assert sentence in ended.err


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("bare.csv",), "x_unit = None: the unit is neither in the file nor given"),
        (("bare.csv", "--x-unit", "m"), "height_unit = None"),
        (("rail.csv", "--height-unit", "mm"), "height_unit = mm: rail.csv states um"),
        (("rail.csv", "--segment", 5000), "shorter than a segment of 5000 mm"),
        (("lines.csv",), "the record has 3 lines"),
        (("rail.csv", "--across", "measured"), "the record has one line"),
        (("rail.csv", "--across", "round"), "must be isotropic, alike or measured"),
        (("rail.csv", "--load", 5e4, "--radii", 460), "must be two radii in mm"),
        (("rail.csv", "--load", 5e4, "--case", "normal.yaml"), "Give one of"),
        (("rail.csv", "--columns", "1,5"), "rail.csv has columns 0 to 1"),
        (("rail.csv", "--y", "a"), "must be numbers separated by commas"),
        (("nowhere.csv",), "nowhere.csv"),
        (("rail.csv", "--plot", "levels.doc"), "must end in .png"),
    ],
)
def test_invalid_calls_end_with_an_error(there, words, sentence):
    ended = there("roughness", *words)
    assert ended.code not in (0, None)
    assert ended.out == ""
    assert sentence in ended.err
