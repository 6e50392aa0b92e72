"""Tests that the examples of the guides run unchanged."""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import textwrap
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import zmq
import zmq.auth

import contactd
from contactd import Client, ContactWarning, Unauthenticated
from support.contact_hertz import write_case
from support.daemons import BIN, eventually

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"


def run_examples(guide: str, client: Any) -> dict[str, Any]:
    """Runs them in sequence; returns the names that they define."""
    names = {"client": client}
    examples = re.findall(r"^```python\n(.*?)^```", (DOCS / guide).read_text(), re.MULTILINE | re.DOTALL)
    assert len(examples) >= 4
    for example in examples:
        exec(compile(example, f"docs/{guide}: {example.splitlines()[0]}", "exec"), names)
    return names


@pytest.mark.timeout(300)
@pytest.mark.parametrize("page", ["README.md", "client/python/README.md"])
def test_the_first_calls_of_a_readme(shared_daemon, page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # where an example draws
    write_case(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.delenv("CONTACTD_ENDPOINT", raising=False)
    text = (ROOT / page).read_text()
    names: dict[str, Any] = {}
    for example in re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        exec(compile(example.replace("tcp://127.0.0.1:5555", shared_daemon.endpoint), page, "exec"), names)
    contactd.default_client().close()
    assert "tcp://127.0.0.1:5555" in text
    assert names["solution"].converged
    if page == "README.md":  # tests/docs/test_five_programs.py runs the rest
        assert names["table"].evidence.errors.zz.largest < 1e-3
        assert 0 < -names["solution"].forces.track.Fx < 0.3 * 80e3
        return
    assert 0 < -names["solution"].Fx < 0.4 * names["solution"].Fn


@pytest.mark.slow  # the page's examples build tables by finite elements
def test_the_guide_to_tables(shared, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # where an example writes files
    assert run_examples("ic-tables.md", shared)["evidence"].warnings[0].startswith("L_over_h is 40")


@pytest.mark.timeout(300)
def test_the_guide_to_python(shared, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_case(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.delenv("CONTACTD_ENDPOINT", raising=False)
    names = run_examples("python.md", shared)
    contactd.default_client().close()
    plt = sys.modules["matplotlib.pyplot"]
    plt.close("all")
    assert {path.name for path in tmp_path.iterdir()} == {
        "x.inp", "x.out", "hertz.png", "wheel.png", "wear.png", "contact.png", "creep.png", "wheel.h5", "solution.h5",
    }  # fmt: skip
    assert names["ended"] == 0
    assert names["punch"].min() > 0
    assert names["full"][-1].Fx < -0.29 * 80e3
    assert [len(run) > 5 for run in names["history"].stages["pcg"]] == [True, True], "two load cases"


def test_the_guide_to_sessions(shared):
    names = run_examples("sessions.md", shared)
    assert names["contact"].Fx < -5000
    assert names["answers"][0].Fy > 0 > names["answers"][1].Fy
    assert abs(names["error"]) < 1e-9
    assert names["ball"].step == names["again"].step + 1, "one step, however often it was tried"
    assert not shared.sessions()


@pytest.mark.parametrize("installed", [True, False], ids=["in process", "daemon"])
def test_the_guide_to_embedding(monkeypatch, installed):
    if not installed:
        monkeypatch.setitem(sys.modules, "contactd_local", None)
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    (example,) = re.findall(r"^```python\n(.*?)^```", (DOCS / "embedding.md").read_text(), re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {}
    exec(compile(example, "docs/embedding.md", "exec"), names)
    assert names["solution"].converged
    assert -0.3 * 50e3 < names["solution"].Fx < -5000


def test_the_guide_to_wheels_on_rails(shared_daemon):
    names = run_page("wheel-rail.md", shared_daemon)
    assert names["solution"].forces.track.Fz == pytest.approx(80e3, rel=1e-5)
    assert names["geometry"].places
    assert names["wheelset"].right.forces.track.Fz == pytest.approx(85e3, rel=1e-5)
    assert names["wheelset"].converged


def test_the_guide_to_profiles(shared_daemon):
    names = run_page("profiles.md", shared_daemon)
    assert names["conicity"].integrated == pytest.approx(0.0093, abs=1e-4)
    assert names["contacts"][0].radius_difference == pytest.approx(0, abs=1e-6)


def run_page(page: str, daemon: Any) -> dict[str, Any]:
    """Returns the names that the examples of a page define, with clients of this daemon."""
    names: dict[str, Any] = {}
    for example in re.findall(r"^```python\n(.*?)^```", (DOCS / page).read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(example.replace("tcp://127.0.0.1:5555", daemon.endpoint), f"docs/{page}", "exec"), names)
    return names


def test_the_guide_to_roughness(shared, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    noise = np.cumsum(np.random.default_rng(1).standard_normal(3000)) * 0.1
    rows = "".join(f"{i / 1e3:.3f};{r:.4f}\n".replace(".", ",") for i, r in enumerate(noise))
    (tmp_path / "rail.csv").write_text("x (m);r (um)\n" + rows)
    names = run_examples("roughness.md", shared)
    assert names["effective_levels"].at(20) < names["measured"].at(20) - 5
    assert names["wide"].band_levels(20) == pytest.approx(-6.8, abs=0.1)
    assert names["run"].areas == pytest.approx(1, abs=0.2)


def test_the_guide_to_contact_problems(shared):
    names = run_examples("contact.md", shared)
    assert abs(names["force"] / names["expected"] - 1).max() < 0.02
    assert names["pulled"].approach == pytest.approx(0.02, rel=1e-6)
    assert names["free"].motion.eta < 0


@pytest.mark.timeout(300)
def test_the_guide_to_temperature(shared):
    (example,) = re.findall(r"^```python\n(.*?)^```", (DOCS / "temperature.md").read_text(), re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {"client": shared}
    exec(compile(example, "docs/temperature.md", "exec"), names)
    assert names["warm"].temperature.largest == pytest.approx(152, abs=3)
    heat = names["met"].temperature
    assert heat.heat_upper + heat.heat_lower == pytest.approx(names["sliding"].frictional_power)
    # Full slip is 0.0333: the upper surface is slower by this fraction, and travels less.
    assert heat.heat_upper / heat.heat_lower == pytest.approx(((1 - 0.0333 / 2) / (1 + 0.0333 / 2)) ** 0.5, rel=1e-3)
    assert names["constant"][-1] == pytest.approx(0.3, rel=1e-4)
    assert max(names["fallen"]) > names["fallen"][-1] + 0.01


def test_the_guide_to_damage(shared):
    examples = re.findall(r"^```python\n(.*?)^```", (DOCS / "damage.md").read_text(), re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {"client": shared}
    with warnings.catch_warnings():  # examples must not cause warnings for users who copy them
        warnings.simplefilter("error", ContactWarning)
        exec(compile("\n".join(examples), "docs/damage.md", "exec"), names)
    assert names["step"].distance == 20
    assert names["wear"].T_gamma == pytest.approx(28.3, abs=0.3)
    assert [law.name for law in names["wear"].laws] == ["energy", "usfd"]


@pytest.mark.timeout(300)
def test_the_guide_to_viscoelastic_bodies(shared):
    (example,) = re.findall(r"^```python\n(.*?)^```", (DOCS / "viscoelastic.md").read_text(), re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {"client": shared}
    exec(compile(example, "docs/viscoelastic.md", "exec"), names)
    forces = [solution.rolling_resistance.force / solution.Fn for solution in names["curve"]]
    assert names["stiff"].rolling_resistance is None
    assert names["soft"].pmax < names["rolling"].pmax < names["stiff"].pmax
    assert 0.3 < names["lengths"][int(np.argmax(forces))] / names["a"] < 3
    assert max(forces) > 10 * max(forces[0], forces[-1])


def test_the_guide_to_keys(daemons, tmp_path, monkeypatch):
    """Runs its commands with temporary folders, its configuration, its clients, and the command that revokes a key."""
    etc, home = tmp_path / "etc", tmp_path / ".config" / "contactd"

    def here(text):
        return text.replace("/etc/contactd", str(etc)).replace("~/.config/contactd", str(home))

    page = (DOCS / "security.md").read_text()
    commands = [shlex.split(here(line)) for line in re.findall(r"^ +\$ (.*)", page, re.MULTILINE)]
    assert [" ".join(command[:2]) for command in commands] == [
        "install -d", "contactd keygen", "contactd keygen", "install -m", "contactd --ping"
    ]  # fmt: skip

    def run(command):
        program = [BIN / "contactd", *command[1:]] if command[0] == "contactd" else command
        folder = home if home.exists() else tmp_path
        ended = subprocess.run(program, cwd=folder, check=True, capture_output=True, text=True, timeout=30)
        return ended.stdout

    *steps, ask = commands
    for command in steps:
        run(command)
    shutil.copy(etc / "keys" / "server.key", home)
    config = json.loads(here(re.search(r'^ +(\{"endpoint".*?\}\}\}) *$', page, re.MULTILINE | re.DOTALL)[1]))
    assert config["endpoint"] == "tcp://0.0.0.0:5555"
    daemon = daemons.start(**{**config, "endpoint": "tcp://127.0.0.1:*"})
    assert run([daemon.endpoint if word == "tcp://host:5555" else word for word in ask]) == "serving\n"

    monkeypatch.chdir(home)
    names = {"Client": Client, "zmq": zmq}
    for example in re.findall(r"^ +```python\n(.*?)^ +```", page, re.MULTILINE | re.DOTALL):
        exec(textwrap.dedent(example).replace("tcp://host:5555", daemon.endpoint), names)
    with names["client"] as client, names["socket"] as socket:
        assert (client.health(), names["answer"]["result"]["state"]) == ("serving", "serving")
        (etc / "keys" / "allowed" / "alice.key").unlink()
        daemon.process.send_signal(signal.SIGHUP)
        eventually(lambda: "0 keys are allowed" in daemon.log)
        with pytest.raises(Unauthenticated, match="no longer allowed"):
            client.health()
        socket.send_json({"contactd": 1, "id": "2", "method": "server.health"})
        assert socket.recv_json()["status"]["details"]["reason"] == "KEY_REVOKED"
