"""Tests commands that solve without an endpoint, which need no daemon."""

from __future__ import annotations

import pytest
from click.testing import CliRunner
from typer.main import get_command

from contactctl.app import app
from contactctl.common import Setting, is_local

from .test_contact import END, FIRST

NOWHERE = {"CONTACTD_ENDPOINT": ""}
HISTORY = """\
open: {grid: {nx: 15, ny: 15, dx: 0.16, dy: 0.16}, bodies: {upper: {G: 200, nu: 0.42}}, ics: {source: analytic},
       gap: {paraboloid: {Rx: 50, Ry: 50}}, friction: {mu: 0.4, rigid_shift: [0.001, 0]}}
steps: [{approach: 0.02}]
"""
WEAR = """\
setup: {dx: 0.8, dy: 0.8}
states: states.csv
wears: wheel
law: {name: mild, source: a test, body: lower, range: [0, 10], energy: {coefficient: 0.000675}}
until: 5
"""
STATES = "position.y, velocity.x, velocity.pitch, Fz, weight\n4, 20000, -43.478, 75000, 1\n"
PROFILE = "".join(f"{y} {y * y / 600}\n" for y in range(-36, 37))
COMMANDS = [
    "solve contact.yaml",
    "wheelrail solve --y 3 --Fz 60e3 --set setup.dx=0.8 --set setup.dy=0.8",
    "wheelrail geometry --y 3 --Fz 60e3",
    "compare contact.yaml --models full,hertz --repeats 1",
    "fit curve.txt --case rolling.yaml -p friction.mu=0.1:0.6 --starts 1",
    "session history.yaml",
    "study study.yaml",
    "wear wear.yaml",
    "contact run case.inp",
    "contact check case.inp",
    "profile show head.txt",
    "roughness rail.csv --case normal.yaml --across alike",
    "conform en15302 --own",
    "conform cnossos --solve",
    "profiles write S1002",
]


@pytest.fixture
def files(lonely):
    lonely.write("history.yaml", HISTORY)
    lonely.write("study.yaml", "problem: contact.yaml\nvary: {approach: [0.01, 0.02]}\n")
    lonely.write("wear.yaml", WEAR)
    lonely.write("states.csv", STATES)
    lonely.write("case.inp", FIRST + END)
    lonely.write("head.txt", PROFILE)
    lonely.write("curve.txt", "0.0005 0.1\n0.001 0.18\n0.002 0.27\n0.004 0.3\n")
    lonely.write("rail.csv", "x (mm);r (um)\n" + "".join(f"{x};{x % 7}\n" for x in range(1200)))
    lonely.write("normal.yaml", "grid: {nx: 40, ny: 40, dx: 0.36, dy: 0.27}\nbodies: {upper: {G: 82000, nu: 0.28}}\nics: {source: analytic}\ngap: {paraboloid: {Rx: 460, Ry: 300}}\nFn: 50000\n")
    rolling = "grid: {nx: 11, ny: 11, dx: 1.1, dy: 1.1}\nbodies: {upper: {G: 82000, nu: 0.28}}\nics: {source: analytic}\n"
    lonely.write("rolling.yaml", rolling + "gap: {paraboloid: {Rx: 460, Ry: 300}}\nFn: 30000\nmodel: fastsim\nfriction: {mu: 0.3, rolling: {xi: 1e-3}}\n")
    return lonely


@pytest.mark.parametrize("words", COMMANDS, ids=lambda words: " ".join(words.split()[:2]))
def test_commands_that_solve_need_no_daemon(files, words):
    if (module := {"wear": "h5py", "fit": "scipy"}.get(words.split()[0])) is not None:
        pytest.importorskip(module)
    ended = files(*words.split(), **NOWHERE)
    assert ended.code == 0, ended.err
    assert "daemon" not in ended.err


def test_answers_are_those_of_a_daemon(ctl):
    with_daemon, without = (ctl("solve", "contact.yaml", "--json", **there) for there in ({}, NOWHERE))
    assert without.code == 0, without.err
    for name in ("forces", "approach", "pmax", "pressure"):
        assert without.json[name] == with_daemon.json[name]


def test_an_endpoint_is_asked_where_one_is_named(files):
    for named in (("-e", files.endpoint), ()):  # otherwise that of the environment
        ended = files("solve", "contact.yaml", *named)
        assert ended.code == 3 and "No daemon answers at" in ended.err


def test_where_nothing_solves_it_says_what_to_install(files):
    hidden = {"PYTHONPATH": f"{files.write_module('contactd_local')}:{files.environment['PYTHONPATH']}", "PATH": "/nowhere"}
    ended = files.alone("solve", "contact.yaml", **NOWHERE, **hidden)
    assert ended.code == 3 and 'pip install "contactd[local]"' in ended.err and "with --endpoint" in ended.err
    assert "LocalDaemon" not in ended.err


def test_keys_need_a_daemon_that_has_them(files):
    ended = files("solve", "contact.yaml", "--server-key", "a.key", **NOWHERE)
    assert ended.code == 2 and "give its address with --endpoint" in ended.err


def test_workers_of_a_cluster_have_the_same_rule(monkeypatch):
    monkeypatch.delenv("CONTACTD_ENDPOINT", raising=False)
    assert is_local(Setting()) and not is_local(Setting(endpoint="ipc:///there"))
    monkeypatch.setenv("CONTACTD_ENDPOINT", "ipc:///there")
    assert not is_local(Setting()) and is_local(Setting(local=True))


def test_help_says_so():
    shown = " ".join(CliRunner().invoke(get_command(app), ["solve", "--help"]).output.split())
    assert "Without either, commands that solve need no daemon" in shown
