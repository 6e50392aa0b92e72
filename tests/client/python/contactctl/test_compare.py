"""Tests compare: one case by all contact models, for users, for scripts, and as a picture."""

from __future__ import annotations

import csv

import pytest

from contactctl.codes import Code
from support.contact_cases import END, FIRST, SECOND

ROLLING = """\
grid: {nx: 24, ny: 24, dx: 0.5, dy: 0.42}
bodies: {upper: {G: 82000, nu: 0.28}}
ics: {source: analytic}
gap: {paraboloid: {Rx: 460, Ry: 300}}
Fn: 30000
friction: {mu: 0.35, rolling: {xi: 1.1e-3, eta: -7e-4, phi: 1e-4, dq: 0.5}}
"""
WHEEL = """\
setup: {dx: 0.7, dy: 0.7}
state: {Fz: 80e3, position: {y: 3, yaw: 0.002}, velocity: {x: 20e3, pitch: -43.478}}
"""


@pytest.fixture
def case(ctl):
    return ctl.write("rolling.yaml", ROLLING)


def test_people_see_a_line_for_each_model(ctl, case):
    shown = ctl("compare", case)
    assert shown.code == 0, shown.err
    lines = {line.split()[0]: line for line in shown.out.splitlines() if line.strip()}
    assert {"full", "fastsim", "fastrip", "polach", "kpec+fastsim", "analyn+full"} <= lines.keys()
    assert "error (% of mu Fn)" in shown.out
    assert "Not computed" in shown.out
    assert "spin" in lines["hertz"]
    assert "A request without computation takes" in shown.out


def test_scripts_get_all_numbers(ctl, case):
    told = ctl("compare", case, "--models", "fastsim,kpec+full", "--repeats", 1, "--json").json
    full, quick, kpec = told["models"]
    assert [one["name"] for one in told["models"]] == ["full", "fastsim", "kpec+full"]
    assert quick["errors"]["Fx"] == pytest.approx((quick["Fx"] - full["Fx"]) / (0.35 * full["Fn"]))
    assert kpec["normal_model"] == "kpec"
    assert kpec["seconds"] > 0
    assert full["converged"] is True


def test_a_table_is_written_with_those_that_refuse(ctl, case):
    assert ctl("compare", case, "--models", "hertz,fastsim", "--csv", "models.csv").code == 0
    with (ctl.folder / "models.csv").open() as file:
        rows = {row["name"]: row for row in csv.DictReader(file)}
    assert float(rows["fastsim"]["error of force"]) > 0
    assert "spin" in rows["hertz"]["refusal"]
    assert rows["hertz"]["Fx"] == ""


def test_a_picture_is_drawn(ctl, case):
    assert ctl("compare", case, "--models", "fastsim,kpec+full", "--plot", "models.png").code == 0
    assert (ctl.folder / "models.png").read_bytes().startswith(b"\x89PNG")
    assert ctl("compare", case, "--plot", "models.gif").code == Code.USAGE
    assert ctl("compare", case, "--plot", "nowhere/models.png").code == Code.USAGE


def test_a_wheel_is_compared(ctl):
    shown = ctl("compare", ctl.write("wheel.yaml", WHEEL), "--models", "fastsim", "--plot", "wheel.png")
    assert shown.code == 0, shown.err
    assert "Fz (N)" in shown.out
    assert (ctl.folder / "wheel.png").exists()
    told = ctl("compare", "wheel.yaml", "--models", "fastsim", "--json", "--csv", "wheel.csv").json
    for one in told["models"]:
        assert one["patches"] == len(one["contacts"]) == 1
        assert one["contacts"][0]["pmax"] == one["pmax"]


def test_without_friction_pressures_are_compared(ctl):
    case = ctl.write("smooth.yaml", ROLLING.partition("friction")[0])
    shown = ctl("compare", case, "--plot", "pressures.png")
    assert shown.code == 0, shown.err
    assert "error of pmax (%)" in shown.out
    assert "fastsim" not in shown.out


def test_a_case_of_an_input_file_is_compared(ctl):
    ctl.write("two.inp", FIRST + SECOND + END)
    told = ctl("compare", "two.inp", "--case", 1, "--models", "fastsim", "--json").json
    assert told["models"][0]["Fn"] == pytest.approx(50000)
    assert ctl("compare", "two.inp").code == Code.USAGE
    assert ctl("compare", "two.inp", "--case", 2, "--models", "fastsim").code == 0
    assert ctl("compare", "two.inp", "--case", 3).code == Code.USAGE


def test_options_that_models_do_not_have_are_said(ctl, case):
    shown = ctl("compare", case, "--models", "fastsim,polach", "--set", "simplified.k_slip=0.5")
    assert shown.code == 0
    assert "warning: simplified.k_slip is not an option of fastsim and was ignored there" in shown.err


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("--models", "fastest"), Code.USAGE, "'fastest' is not one of full, hertz, fastsim"),
        (("--case", "1"), Code.USAGE, "only input files of CONTACT (.inp) have several cases"),
        (("--set", "friction.mu=-1"), Code.REFUSED, "friction.mu"),
        (("--set", "grid.nx=0"), Code.REFUSED, "grid.nx"),
    ],
)
def test_what_cannot_be_compared_is_refused(ctl, case, words, code, said):
    ended = ctl("compare", case, *words)
    assert ended.code == code
    assert said in ended.err


def test_a_model_that_does_not_converge_ends_with_its_code(ctl, case):
    ended = ctl("compare", case, "--models", "fastsim", "--set", "settings.tangential.max_iterations=1")
    assert ended.code == Code.NOT_CONVERGED
    assert "not converged: full." in ended.err
    assert "error of pmax (%)" in ended.out
    (line,) = (line for line in ended.out.splitlines() if line.startswith("fastsim"))
    assert " - " in line
    assert "NO" in ended.out
