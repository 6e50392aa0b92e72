"""Tests the adapters of Project Chrono and MBDyn, which are not among the packages. They are compiled with
replacements of their headers, and their forces are compared with those of the client."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest

import contactd
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from support.daemons import BIN

ROOT = Path(__file__).parents[2]
HERE = Path(__file__).parent
LIBRARIES = BIN.parent / "lib"
WARNINGS = ("-Wall", "-Wextra", "-Werror")
PLACES = [f"-I{folder}" for folder in (HERE / "stand_ins", ROOT / "adapters" / "multibody", ROOT / "client" / "c" / "include")]
LINKED = (f"-L{LIBRARIES}", f"-Wl,-rpath,{LIBRARIES}", "-lcontactd-local", "-lm")

pytestmark = pytest.mark.skipif(not (LIBRARIES / "libcontactd-local.so").exists(), reason="this build has no libcontactd-local")

#: y, z (mm), roll, yaw, pitch (rad), rates of roll and yaw (rad/s): in the middle, across and yawed, and above the rails.
MOTIONS = [
    (0, 0.236, 0, 0, 0, 0, 0), (3, 0.17, -1e-4, 0.002, 1.3, 0.01, 0.02), (-4, 0.15, 2e-4, -0.003, -2.5, 0, -0.01), (0, -1, 0, 0, 0, 0, 0)
]  # fmt: skip
SPEED = 20e3


def turn(axis: int, angle: float) -> np.ndarray:
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = np.cos(angle)
    matrix[j, i] = np.sin(angle)
    matrix[i, j] = -matrix[j, i]
    return matrix


@pytest.fixture(scope="module")
def motions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    lines = []
    for y, z, roll, yaw, pitch, roll_rate, yaw_rate in MOTIONS:
        axes = turn(2, yaw) @ turn(0, roll)
        rotation = axes @ turn(1, pitch)
        omega = axes @ np.array([roll_rate, -SPEED / 460, yaw_rate])
        lines.append([0.5, 1e-3 * y, 1e-3 * z, *rotation.T.ravel(), 1e-3 * SPEED, 0.01, 0, *omega])
    path = tmp_path_factory.mktemp("motions") / "motions.txt"
    path.write_text("\n".join(" ".join(f"{number!r}" for number in map(float, line)) for line in lines) + "\n")
    return path


@pytest.fixture(scope="module")
def expected() -> np.ndarray:
    """Returns the force on the wheelset and the moment about its centre, along the track (N, N m)."""
    found = []
    with contactd.local() as client:
        for y, z, roll, yaw, _, roll_rate, yaw_rate in MOTIONS:
            state = WheelRailState(
                position=WheelsetPosition(x=500, y=y, z=z, roll=roll, yaw=yaw),
                velocity=WheelsetVelocity(x=SPEED, y=10, roll=roll_rate, yaw=yaw_rate, pitch=-SPEED / 460),
            )
            force, moment = np.zeros(3), np.zeros(3)
            for side in ("left", "right"):
                forces = client.wheel_rail(WheelRailSetup(side=side, model="fastsim", dx=1, dy=1), state, fields=[]).forces
                force -= (forces.track.Fx, forces.track.Fy, forces.track.Fz)
                moment -= (forces.wheelset.Mx, forces.wheelset.My, forces.wheelset.Mz)
            found.append([*force, *(1e-3 * turn(2, yaw) @ turn(0, roll) @ moment)])
    return np.array(found)


def numbers(text: str) -> np.ndarray:
    return np.array([[float(word) for word in line.split()] for line in text.splitlines()])


def run(program: Path, *arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=60)


@pytest.fixture(scope="module")
def mbdyn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    built = tmp_path_factory.mktemp("mbdyn") / "wheelset_peer"
    source = ROOT / "adapters" / "mbdyn" / "wheelset_peer.c"
    subprocess.run(["cc", "-std=c99", *WARNINGS, *PLACES, source, *LINKED, "-o", built], check=True)
    return built


@pytest.fixture(scope="module")
def chrono(tmp_path_factory: pytest.TempPathFactory) -> Path:
    built = tmp_path_factory.mktemp("chrono") / "wheelset"
    places = [*PLACES, f"-I{ROOT / 'adapters' / 'chrono'}"]
    subprocess.run(["c++", "-std=c++17", *WARNINGS, *places, HERE / "chrono_wheelset.cpp", *LINKED, "-o", built], check=True)
    return built


def test_the_peer_of_mbdyn_puts_the_forces_of_the_client_on_the_wheelset(mbdyn, motions, expected):
    ended = run(mbdyn, motions, "local", "fastsim", 0.3, 0.001)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert numbers(ended.stdout) == pytest.approx(expected, rel=1e-6, abs=1e-2)
    assert abs(expected[0][2]) > 1e4, "rails carry it"
    assert not expected[-1].any(), "and not above them"


def test_the_load_of_chrono_puts_the_opposite_on_the_track(chrono, motions, expected):
    ended = run(chrono, motions, "local", "fastsim")
    assert (ended.returncode, ended.stderr) == (0, "")
    assert -numbers(ended.stdout) == pytest.approx(expected, rel=1e-6, abs=1e-2)


def test_failures_have_sentences(mbdyn, chrono, motions):
    for ended in (run(mbdyn, motions, "local", "springs", 0.3, 0.001), run(chrono, motions, "local", "springs")):
        assert ended.returncode == 1
        assert "setup.model is" in ended.stderr
    assert "no program listens" in run(mbdyn, motions.with_name("none"), "local", "fastsim", 0.3, 0.001).stderr
    assert "SOCKET WHERE MODEL" in run(mbdyn).stderr
