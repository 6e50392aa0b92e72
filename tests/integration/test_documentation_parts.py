"""Tests parts of pages: indented lines of Python, parts of programs, and commands."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import textwrap
from pathlib import Path
from typing import Any

import numpy as np

import contactd
from contactd import Friction, Grid, Material, Paraboloid
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from support.daemons import BIN

ROOT = Path(__file__).parents[2]


def section(page: str, heading: str) -> str:
    found = re.search(rf"^#+ {re.escape(heading)}\n(.*?)(?=^#+ |\Z)", (ROOT / page).read_text(), re.MULTILINE | re.DOTALL)
    assert found, heading
    return found[1]


def indented(text: str) -> list[str]:
    """Blocks of indented lines."""
    return [textwrap.dedent(block) for block in re.findall(r"(?:^    .*\n|^\n(?=    ))+", text, re.MULTILINE)]


def run(command: str, **replaced: str) -> subprocess.CompletedProcess[str]:
    """Returns a command line of a page, with our programs and local replacements of words."""
    words = [replaced.get(word, word) for word in shlex.split(command)]
    program = BIN / Path(words[0]).name
    return subprocess.run([program, *words[1:]], capture_output=True, text=True, timeout=50)


def test_bodies_of_layers_are_asked_for_as_the_page_says(shared):
    python, *_ = indented(section("docs/layers.md", "Inputs"))
    assert "LayeredBody" in python
    names: dict[str, Any] = {name: getattr(contactd, name) for name in contactd.__all__}
    names |= {"client": shared, "grid": Grid.centred(32, 32, 8, 8)}
    exec(python.replace("friction=...", "friction=Friction(0.3, rigid_shift=(0.001, 0))"), names)
    assert names["rubber"].nu == 0.5


def test_a_sphere_near_an_edge_is_solved_as_the_page_on_sections_says(shared):
    found = re.search(r"```python\n(.*?)```", section("docs/sections.md", "Contact on curved strips"), re.DOTALL)
    assert found
    names: dict[str, Any] = {"client": shared}
    exec(found[1], names)
    assert names["solution"].converged
    assert abs(names["solution"].Fn - 5000) < 1e-6


def test_the_wire_form_of_a_body_of_layers_is_taken(shared):
    _, wire, *_ = indented(section("docs/layers.md", "Inputs"))
    lower = json.loads("{" + wire + "}")["lower"]
    params = {
        "grid": {"nx": 16, "ny": 16, "dx": 0.5, "dy": 0.5},
        "bodies": {"upper": {"rigid": True}, "lower": lower},
        "gap": {"paraboloid": {"Rx": 50, "Ry": 50}},
        "Fn": 2,
    }
    assert shared.call("contact.solve", params)["converged"]


def test_the_client_without_a_service_as_the_readme_shows_it(monkeypatch):
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    (code,) = indented(section("client/python/README.md", "Without a service"))
    problem = contactd.ContactProblem(
        grid=Grid.centred(16, 16, 2.4, 2.4), upper=Material(G=200, nu=0.42), gap=Paraboloid(50, 50), approach=0.02,
        friction=Friction(mu=0.4, rigid_shift=(0.008, 0)),
    )  # fmt: skip
    names: dict[str, Any] = {"contactd": contactd, "problem": problem}
    exec(code, names)
    assert names["solution"].converged


def test_the_forces_on_a_wheelset_as_its_page_takes_them(shared):
    (code,) = re.findall(r"^```python\n(.*?)^```", (ROOT / "docs" / "wheelset.md").read_text(), re.MULTILINE | re.DOTALL)
    state = WheelRailState(position=WheelsetPosition(y=2, z=0.3), velocity=WheelsetVelocity(x=2e4, pitch=-2e4 / 460))
    names: dict[str, Any] = {"client": shared, "setup": WheelRailSetup(), "state": state, "force": np.zeros(3), "moment": np.zeros(3)}
    exec(code, names)
    assert names["force"][2] < 0, "the rail carries the wheel"
    assert abs(names["force"]).max() > 1000


def test_a_configuration_is_checked_and_a_daemon_asked_as_the_page_on_operations_says(shared_daemon, tmp_path):
    config = tmp_path / "contactd.json"
    check, ping = [line for line in "".join(indented(section("docs/operations.md", "Configure"))).splitlines() if line]
    config.write_text(json.dumps({"endpoint": f"ipc://{tmp_path}/socket", "store": {"folder": str(tmp_path / "store")}}))
    checked = run(check, **{"/etc/contactd/contactd.json": str(config)})
    assert checked.returncode == 0, checked.stdout
    assert "ok: " in checked.stdout
    assert run(ping, **{"tcp://127.0.0.1:5555": shared_daemon.endpoint}).stdout == "serving\n"


def test_a_builder_is_run_by_hand_as_the_guide_to_changes_says(tmp_path):
    (block,) = [block for block in indented(section("docs/developing/debugging.md", "A table that is not built")) if "contactd-ic" in block]
    spec = re.search(r"echo '(.*?)' >", block, re.DOTALL)
    assert spec
    (tmp_path / "spec.json").write_text(spec[1])
    command = next(line for line in block.splitlines() if "contactd-ic" in line).removeprefix("./dev shell ")
    words = {"build/spec.json": str(tmp_path / "spec.json"), "build/table.h5": str(tmp_path / "table.h5")}
    built = run(command, **words)
    assert built.returncode == 0, built.stdout + built.stderr
    assert (tmp_path / "table.h5").stat().st_size > 10_000
    assert "evidence" in json.loads(built.stdout.splitlines()[-1])


def test_the_fit_of_the_page_on_friction_finds_a_layer(capsys):
    page = (ROOT / "docs" / "friction.md").read_text()
    (code,) = [code for code in re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL) if "contactd.fit(" in code]
    names: dict[str, Any] = {}
    exec(compile(code, "docs/friction.md", "exec"), names)
    found = names["found"]
    assert found.converged
    assert found.rms < 0.004
    assert found["friction.layer.flexibility"].standard_error is not None


def test_the_simplified_models_of_their_page_are_near_the_full_theory(capsys):
    page = (ROOT / "docs" / "simplified-models.md").read_text()
    side_by_side, near = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    exec(compile(near, "docs/simplified-models.md", "exec"), {})
    assert capsys.readouterr().out == "True True\n"
    exec(compile(side_by_side, "docs/simplified-models.md", "exec"), {})
    names = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert {"full", "fastsim", "kpec+fastsim", "hertz"} <= set(names)
