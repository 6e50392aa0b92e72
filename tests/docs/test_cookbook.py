"""Tests that each recipe of the cookbook, and the first lines of the front page, run separately and have the
documented answers."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib  # imported here, because collecting tests/packaging hides a package with the same name
import pytest

from support.daemons import BIN

matplotlib.use("Agg")

ROOT = Path(__file__).parents[2]
COOKBOOK = (ROOT / "docs" / "cookbook.md").read_text()
SECTIONS = [section.partition("\n") for section in re.split("^## ", COOKBOOK, flags=re.MULTILINE)[1:]]
RECIPES = {
    title: "".join(re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)) for title, _, text in SECTIONS
}

Names = dict[str, Any]
HOLDS: dict[str, Callable[[Names], bool]] = {
    "A wheel on its rail under a load": lambda n: (
        abs(n["solution"].forces.track.Fz / 80e3 - 1) < 1e-5 and Path("wheel.png").exists()
    ),
    "A wheelset with a load on each wheel": lambda n: (
        abs(n["both"].right.forces.track.Fz / 85e3 - 1) < 1e-5 and n["both"].converged
    ),
    "Own profiles": lambda n: abs(n["solution"].patches[0].place.radii.rail_across - 300) < 0.01,
    "Equivalent conicity": lambda n: abs(n["found"].integrated - 0.155) < 0.002,
    "A creep curve": lambda n: -n["curve"][-1].Fx == pytest.approx(0.3 * 80e3, rel=1e-3) and Path("creep.png").exists(),
    "The creepage for a prescribed force": lambda n: (
        n["solution"].Fx == pytest.approx(-8000, rel=1e-5) and n["solution"].motion.xi > 0
    ),
    "FASTSIM beside the full theory": lambda n: (
        max(one.errors.force for one in n["found"].computed if one.name == "fastsim") < 0.06
    ),
    "Falling friction": lambda n: 0.2 < -n["solution"].Fx / 80e3 < 0.4,
    "Steps of a simulation": lambda n: n["tried"].step == 3 and n["tried"].Fx < n["step"].Fx * 0.8 < 0,
    "A table by finite elements, read from a store": lambda n: (
        n["table"].origin == "disk" and n["table"].evidence.errors.zz.largest < 0.01
    ),
    "A ball on a coating": lambda n: n["coated"].approach < 0.9 * n["solid"].approach,
    "A surface of your own": lambda n: n["solution"].Fn == pytest.approx(100, rel=1e-6),
    "Wear of a wheel": lambda n: n["wear"].T_gamma > 0 and 0 < n["depth"] < 1e-4,
    # By Johnson, 0.62 of the largest pressure for nu = 0.3 at a depth of 0.48 a, in terms of the largest von Mises
    # stress.
    "Stresses below the surface": lambda n: (
        n["stress"].largest.von_mises / n["solution"].pmax == pytest.approx(0.63, abs=0.015)
    ),
    "An input file of CONTACT": lambda n: (
        n["case"].forces.Fn == pytest.approx(80e3) and n["case"].forces.Fx < 0
    ),
}


@pytest.fixture
def a_place_to_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)  # where recipes write
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")  # finds the builder of tables
    monkeypatch.delenv("CONTACTD_ENDPOINT", raising=False)


def test_every_recipe_is_run():
    assert RECIPES.keys() == HOLDS.keys()
    assert len(RECIPES) == len(SECTIONS) == COOKBOOK.count("```python"), "one program each"


@pytest.mark.timeout(120)
@pytest.mark.usefixtures("a_place_to_work")
@pytest.mark.filterwarnings("error::contactd.ContactWarning")
@pytest.mark.parametrize("title", HOLDS)
def test_a_recipe(title):
    names: Names = {}
    exec(compile(RECIPES[title], f"docs/cookbook.md: {title}", "exec"), names)
    assert HOLDS[title](names)


@pytest.mark.usefixtures("a_place_to_work")
def test_the_front_page_solves_without_a_daemon():
    (code,) = re.findall(r"^```python\n(.*?)^```", (ROOT / "docs" / "index.md").read_text(), re.MULTILINE | re.DOTALL)
    assert len(code.strip().splitlines()) <= 12
    names: Names = {}
    exec(compile(code, "docs/index.md", "exec"), names)
    assert names["solution"].converged
    assert Path("contact.png").exists()
