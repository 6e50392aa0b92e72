"""Tests the five programs of README and of the page on Python: at most five lines each, in process and with a
daemon."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest

import contactd
from contactd.values.hertz import Load, compliance_of, ellipse_of_curvatures
from integration.conftest import shared_daemon  # noqa: F401
from support.contact_hertz import MU, write_case

matplotlib.use("Agg")

ROOT = Path(__file__).parents[2]
Names = dict[str, Any]


def programs(page: str, section: str) -> list[str]:
    text = (ROOT / page).read_text()
    (part,) = re.findall(rf"^## {section}\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    return re.findall(r"^```python\n(.*?)^```", part, re.MULTILINE | re.DOTALL)


PROGRAMS = programs("docs/python.md", "Five programs")


def hertz(n: Names) -> None:
    found = ellipse_of_curvatures(0.01, 0.01, Load(100, True, compliance_of((0.28, 0.28), (82000, 82000))))
    assert n["solution"].pmax == pytest.approx(1.5 * 100 / (pi * found.aa * found.bb), rel=0.01)
    assert n["solution"].approach == pytest.approx(found.approach, rel=2e-3)
    assert n["solution"].converged


def creep_curve(n: Names) -> None:
    shares = n["curve"].Fx / n["curve"].Fn
    assert shares.shape == (21,)
    assert (shares[0], shares[-1]) == pytest.approx((0, -0.3), abs=1e-3)
    assert (np.diff(shares) < 0).all()


def wheel(n: Names) -> None:
    assert n["solution"].forces.track.Fz == pytest.approx(80e3, rel=1e-5)
    assert n["solution"].state.velocity.pitch == pytest.approx(-20e3 / 460)


def wear(n: Names) -> None:
    found = n["wear"]
    assert (found.body, found.law) == ("wheel", "energy")
    moved = np.linalg.norm(n["worn"] - found.points, axis=1).max()
    assert moved == pytest.approx(10_000 * found.depth_per_km, rel=0.03)
    assert 1e-4 < found.depth_per_km < 0.1


def contact_file(n: Names) -> None:
    assert n["cases"][0].forces.Fx == pytest.approx(-MU * 80e3, rel=1e-4)
    assert n["cases"].compare("x.out").agrees


HOLDS: list[tuple[str, Callable[[Names], None], set[str]]] = [
    ("hertz", hertz, {"hertz.png"}),
    ("creep curve", creep_curve, {"creep.png"}),
    ("wheel", wheel, {"wheel.png"}),
    ("wear", wear, {"wear.png"}),
    ("contact file", contact_file, set()),
]


def statements(program: str) -> list[str]:
    """Those beside the imports."""
    return [ast.unparse(one) for one in ast.parse(program).body if not isinstance(one, ast.Import | ast.ImportFrom)]


def test_both_pages_show_the_same_programs():
    (together,) = programs("README.md", "Five lines of Python")
    assert statements(together) == [line for program in PROGRAMS for line in statements(program)]
    assert len(PROGRAMS) == len(HOLDS) == 5


@pytest.mark.parametrize("program", PROGRAMS, ids=[name for name, _, _ in HOLDS])
def test_a_program_has_at_most_five_lines_beside_its_imports(program):
    lines = [line for line in program.splitlines() if line.strip() and not line.startswith(("import ", "from "))]
    assert 0 < len(lines) <= 5
    ast.parse(program, feature_version=(3, 10))


@pytest.mark.parametrize("where", ["in process", "daemon"])
@pytest.mark.parametrize("number", range(5), ids=[name for name, _, _ in HOLDS])
@pytest.mark.filterwarnings("error::contactd.ContactWarning")
def test_a_program_runs(number, where, shared_daemon, tmp_path, monkeypatch):  # noqa: F811
    monkeypatch.chdir(tmp_path)
    write_case(tmp_path)
    monkeypatch.setenv("CONTACTD_ENDPOINT", shared_daemon.endpoint if where == "daemon" else "")
    contactd.default_client().close()
    names: Names = {}
    try:
        exec(compile(PROGRAMS[number], "docs/python.md", "exec"), names)
        assert contactd.default_client().endpoint == (shared_daemon.endpoint if where == "daemon" else "local")
        HOLDS[number][1](names)
    finally:
        contactd.default_client().close()
        matplotlib.pyplot.close("all")
    assert {path.name for path in tmp_path.iterdir()} == {"x.inp", "x.out", *HOLDS[number][2]}
