"""Tests fit: parameters of friction from a file with a measured curve."""

from __future__ import annotations

import csv
import json
import signal
import sys

import numpy as np
import pytest

from contactctl.codes import Code

CASE = """\
grid: {nx: 15, ny: 15, dx: 0.75, dy: 0.65}
bodies: {upper: {G: 82000, nu: 0.28}}
ics: {source: analytic}
gap: {paraboloid: {Rx: 460, Ry: 300}}
Fn: 30000
friction: {mu: 0.3, rolling: {dq: 0.75}}
"""
CREEPAGE = np.linspace(5e-4, 1e-2, 8)
MU = ("--parameter", "friction.mu=0.1:0.6")
LAYER = ("--parameter", "friction.layer.flexibility=1e-6:1e-3")


@pytest.fixture(scope="module")
def measured(shared_daemon):
    """Uses coefficients with mu 0.35 and a layer of 2e-5."""
    problem = {
        "grid": {"nx": 15, "ny": 15, "dx": 0.75, "dy": 0.65}, "bodies": {"upper": {"G": 82000, "nu": 0.28}}, "ics": {"source": "analytic"},
        "gap": {"paraboloid": {"Rx": 460, "Ry": 300}}, "Fn": 30000, "fields": [],
    }  # fmt: skip
    with shared_daemon.client() as client:
        found = []
        for x in CREEPAGE:
            friction = {"mu": 0.35, "layer": {"flexibility": 2e-5}, "rolling": {"dq": 0.75, "xi": float(x)}}
            forces = client.call("contact.solve", {**problem, "friction": friction})["forces"]
            found.append(-forces["Fx"] / forces["Fn"])
    return np.array(found)


@pytest.fixture
def files(ctl, measured):
    """Writes a case, and the curve with points and commas."""
    ctl.write("case.yaml", CASE)
    ctl.write("curve.csv", "creepage, coefficient\n" + "".join(f"{x!r}, {y!r}\n" for x, y in zip(CREEPAGE.tolist(), measured.tolist())))
    return ctl


def values(told):
    return {one["path"]: one["value"] for one in told["parameters"]}


def test_people_see_values_with_their_errors(files):
    shown = files("fit", "curve.csv", "--case", "case.yaml", *MU, *LAYER)
    assert shown.code == 0, shown.err
    for text in ("curve.csv: 8 points", "friction.layer.flexibility", "95 % interval", "rms residual", "correlation of", "converged"):
        assert text in shown.out
    assert "2e-05" in shown.out


def test_scripts_get_all_numbers(files):
    told = files("fit", "curve.csv", "--case", "case.yaml", *MU, *LAYER, "--json").json
    assert values(told) == pytest.approx({"friction.mu": 0.35, "friction.layer.flexibility": 2e-5}, rel=1e-4)
    assert told["converged"] is True
    assert np.shape(told["correlation"]) == (2, 2)
    assert len(told["residuals"]) == 8
    assert told["params"]["friction"]["layer"]["flexibility"] == values(told)["friction.layer.flexibility"]


@pytest.mark.parametrize("heading", ["Schlupf (%) Kraftschluss", "# creepage [%], coefficient", "creepage in per cent"])
def test_a_heading_that_states_per_cent_asks_for_the_option(files, heading):
    files.write("rig.txt", heading + "\n" + "".join(f"{x:.6f} 0.2\n" for x in CREEPAGE))
    refused = files("fit", "rig.txt", "--case", "case.yaml", *MU)
    assert refused.code == Code.USAGE
    assert "states percent. Give --percent, or --no-percent" in refused.err


@pytest.mark.parametrize("between", [";", " ; ", "  ", "\t"])
def test_a_curve_is_read_as_numbers_are_everywhere(files, measured, between):
    lines = [f"{100 * x:.8f}{between}{y:.8f}".replace(".", ",") for x, y in zip(CREEPAGE, measured)]
    files.write("german.txt", "Schlupf (%) Kraftschluss\n" + "\n".join(lines) + "\n")
    told = files("fit", "german.txt", "--case", "case.yaml", *MU, *LAYER, "--percent", "--json").json
    assert values(told) == pytest.approx({"friction.mu": 0.35, "friction.layer.flexibility": 2e-5}, rel=1e-3)


def test_columns_are_chosen(files, measured):
    rows = [f"{i} {30000 * y!r} {x!r} 20" for i, (x, y) in enumerate(zip(CREEPAGE.tolist(), measured.tolist()))]
    files.write("rig.txt", "\n".join(rows) + "\n")
    told = files("fit", "rig.txt", "--case", "case.yaml", *MU, *LAYER, "--columns", "3,2,4", "--quantity", "force", "--json").json
    assert values(told)["friction.mu"] == pytest.approx(0.35, rel=1e-4)
    assert told["quantity"] == "force"


def test_the_case_with_the_values_is_written_and_can_be_solved(files):
    words = ("fit", "curve.csv", "--case", "case.yaml", *MU, *LAYER, "--output", "fitted.yaml", "--csv", "residuals.csv", "--plot", "fit.png")
    ended = files(*words)
    assert ended.code == 0, ended.err
    assert files("solve", "fitted.yaml", "--set", "friction.rolling.xi=1e-3").code == 0
    with (files.folder / "residuals.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 8
    assert float(rows[0]["residual"]) == pytest.approx(float(rows[0]["measured"]) - float(rows[0]["computed"]))
    assert (files.folder / "fit.png").read_bytes().startswith(b"\x89PNG")
    assert files("fit", "curve.csv", "--case", "case.yaml", *MU, "--output", "fitted.json").code == 0
    assert json.loads((files.folder / "fitted.json").read_text())["Fn"] == 30000
    # It has contactd's mark, which is not a field of the case, so it is overwritten.
    assert files("fit", "curve.csv", "--case", "fitted.json", *MU, "--output", "fitted.json").code == 0
    assert files("solve", "fitted.json", "--set", "friction.rolling.xi=1e-3").code == 0


def test_a_parameter_at_its_bound_is_said(files):
    ended = files("fit", "curve.csv", "--case", "case.yaml", "--parameter", "friction.mu=0.1:0.3", *LAYER)
    assert ended.code == 0
    assert "at its upper bound" in ended.out
    assert "warning: friction.mu is at its upper bound, 0.3" in ended.err


def test_a_search_that_is_cut_short_ends_with_its_code(files):
    ended = files("fit", "curve.csv", "--case", "case.yaml", *MU, *LAYER, "--start", "friction.layer.flexibility=9e-4", "--max-evaluations", 1)
    assert ended.code == Code.NOT_CONVERGED
    assert "the search did not converge: the largest number of evaluations was reached." in ended.err
    assert "NO" in ended.out


def test_curves_that_do_not_converge_end_with_their_code(files):
    ended = files("fit", "curve.csv", "--case", "case.yaml", *MU, "--set", "settings.tangential.max_iterations=1")
    assert ended.code == Code.NOT_CONVERGED
    assert "No curve can be computed at the start, friction.mu 0.3: a solve did not converge" in ended.err


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (("--parameter", "friction.mu"), Code.USAGE, "it must be PATH=LOW:HIGH"),
        (("--parameter", "friction.mu=a:b"), Code.USAGE, "it must be PATH=LOW:HIGH"),
        ((*MU, *MU), Code.USAGE, "a field is given twice"),
        (("--parameter", "friction.mu=0.6:0.1"), Code.REFUSED, "the lower one first"),
        ((*MU, "--start", "friction.mu"), Code.USAGE, "it must be PATH=VALUE"),
        ((*MU, "--start", "friction.mu=0.9"), Code.REFUSED, "outside its bounds"),
        ((*MU, "--columns", "1"), Code.USAGE, "two or three different columns, 1 to 2 in curve.csv"),
        ((*MU, "--columns", "1,3"), Code.USAGE, "two or three different columns"),
        ((*MU, "--columns", "2,2"), Code.USAGE, "two or three different columns"),
        ((*MU, "--by", "zeta"), Code.USAGE, '"xi", "eta", "phi", or a path'),
        ((*MU, "--quantity", "stress"), Code.USAGE, '"coefficient" or "force"'),
        ((*MU, "--confidence", "95"), Code.USAGE, "between 0 and 1"),
        ((*MU, "--plot", "fit.gif"), Code.USAGE, ".png, .svg, .pdf"),
        ((*MU, "--output", "fit.txt"), Code.USAGE, ".json, .yaml or .yml"),
        ((*MU, "--set", "grid.nx=0"), Code.REFUSED, "grid.nx"),
        (("--parameter", "friction.layr.flexibility=1e-6:1e-3"), Code.REFUSED, "friction.layr"),
        (("--parameter", "friction.mu[0]=0.1:0.6"), Code.USAGE, "friction.mu[0] cannot be set"),
    ],
)
def test_what_cannot_be_fitted_is_refused(files, words, code, said):
    ended = files("fit", "curve.csv", "--case", "case.yaml", *words)
    assert ended.code == code, ended.err
    assert said in ended.err


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "contains no curve: it has none"),
        ("1\n2\n", "has one column"),
        ("1e-3 0.1\n2e-3\n", "line 2 has 1 numbers, but the first has 2"),
        ("1e-3 0.1\n2e-3 high\n", "line 2 has 'high' instead of a number"),
    ],
)
def test_a_file_that_holds_no_curve_is_refused(files, text, said):
    files.write("wrong.csv", text)
    ended = files("fit", "wrong.csv", "--case", "case.yaml", *MU)
    assert ended.code == Code.USAGE
    assert said in ended.err
    assert files("fit", "missing.csv", "--case", "case.yaml", *MU).code == Code.USAGE
    assert files("fit", "curve.csv", "--case", "missing.yaml", *MU).code == Code.USAGE


def test_without_scipy_it_says_what_to_install(files, monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy", None)
    ended = files("fit", "curve.csv", "--case", "case.yaml", *MU)
    assert ended.code == Code.USAGE
    assert 'pip install "contactd[fit]"' in ended.err


def test_ctrl_c_ends_it_and_its_solves(own):
    """Each curve of this case takes hours."""
    friction = {"mu": 0.4, "rolling": {"kind": "transient", "xi": 1e-3, "steps": 100_000}}
    own.write("hours.json", {**json.loads((own.folder / "endless.json").read_text()), "friction": friction})
    own.write("curve.csv", "1e-3 0.1\n2e-3 0.2\n")
    running = own.start("fit", "curve.csv", "--case", "hours.json", *MU)
    _wait_for_a_solve(own)
    running.send_signal(signal.SIGINT)
    _, said = running.communicate(timeout=30)
    assert running.returncode == Code.INTERRUPTED, said


def _wait_for_a_solve(ctl):
    from contactd import Client
    from support.daemons import eventually

    with Client(ctl.endpoint) as client:
        eventually(lambda: any(metric["name"] == "contactd_workers_busy" and metric["samples"][0]["value"] > 0 for metric in client.metrics()))
