"""Tests the SSP archive of a wheelset: four FMUs that FMPy and libcosim run as a system."""

from __future__ import annotations

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import contactd
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from support.fmus import PACKAGES, archive
from support.slowness import SLOWER

ROOT = Path(__file__).parents[2]
STEP = 2.5e-4  # s

pytestmark = pytest.mark.skipif(PACKAGES is None, reason="this build has no FMUs: ./dev could not reach PyPI")


@pytest.fixture(scope="module")
def adapter() -> ModuleType:
    spec = importlib.util.spec_from_file_location("ssp_adapter", ROOT / "adapters" / "ssp" / "__main__.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where its dataclass looks for its module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def written(adapter: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    assert PACKAGES
    folder = tmp_path_factory.mktemp("ssp")
    found: Path = adapter.write_ssp(archive("contactd_wheel", 2), PACKAGES / "fmpy" / "c-code", folder / "wheelset.ssp")
    return found


def simulated(path: Path, seconds: float, **changed: float) -> Any:
    """Simulates with FMPy, which takes the parameters of all components in one set, some of them changed."""
    from fmpy.ssp.simulation import simulate_ssp
    from fmpy.ssp.ssd import Parameter, ParameterSet, find_components, read_ssd

    parameters = ParameterSet(name="wheelset")
    for component in find_components(read_ssd(str(path)).system):
        for binding in component.parameterBindings:
            for one in binding.parameterValues[0].parameters:
                parameters.parameters.append(Parameter(name=f"{component.name}.{one.name}", type=one.type, value=one.value))
    for name, value in changed.items():
        parameters.parameters.append(Parameter(name=name.replace("__", "."), type="Real", value=value))
    return simulate_ssp(str(path), stop_time=seconds, step_size=STEP, parameter_set=parameters)


def test_it_is_what_the_schemas_of_ssp_say(written):
    from fmpy.ssp.ssd import find_components, read_ssd

    described = read_ssd(str(written))  # validates against the schemas
    assert [component.name for component in find_components(described.system)] == ["body", "track", "left", "right"]
    assert len(described.system.connections) == 16


def test_it_has_the_same_bytes_twice(written, adapter, tmp_path):
    again = adapter.write_ssp(archive("contactd_wheel", 2), PACKAGES / "fmpy" / "c-code", tmp_path / "again.ssp")
    assert again.read_bytes() == written.read_bytes()


def test_the_wheelset_swings_as_its_equivalent_conicity_says(written):
    """The wheelset starts 3 mm from the middle at 10 m/s, and nearly follows Klingel's wave. Conicity refers to rigid
    profiles; elastic patches make the wave a little longer."""
    run = simulated(written, 0.8)
    y, time = run["body.y"], run["time"]
    (crossings,) = np.nonzero(np.diff(np.sign(y)))
    assert len(crossings) == 2
    instants = time[crossings] - STEP * y[crossings] / (y[crossings + 1] - y[crossings])
    amplitude = abs(y[crossings[0] : crossings[1]]).max()
    assert 2.8 < amplitude < 3
    with contactd.local() as client:
        (klingel,) = client.equivalent_conicity(WheelRailSetup(), [amplitude])
    assert 1 < 2 * np.diff(instants)[0] * 10e3 / klingel.wavelength < 1.1


def test_its_forces_are_those_of_wheels_that_are_asked_for_one_by_one(written):
    run = simulated(written, 0.05)
    before, now = run[-2], run[-1]
    with contactd.local() as client:
        for side in ("left", "right"):
            state = WheelRailState(
                position=WheelsetPosition(y=before[f"{side}.position.y"], yaw=before[f"{side}.position.yaw"]),
                velocity=WheelsetVelocity(
                    x=10e3, y=before[f"{side}.velocity.y"], yaw=before[f"{side}.velocity.yaw"], pitch=-10e3 / 460
                ),
                Fz=50e3,
            )  # fmt: skip
            solution = client.wheel_rail(WheelRailSetup(side=side, model="fastsim", dx=1, dy=1), state, fields=[])
            assert now[f"{side}.Fy"] == pytest.approx(solution.forces.wheelset.Fy, rel=1e-4)
            assert now[f"{side}.pmax"] == pytest.approx(max(patch.solution.pmax for patch in solution.patches), rel=1e-5)


def test_the_program_of_its_page_runs(written):
    page = (ROOT / "docs" / "plugged-in.md").read_text()
    (program,) = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    names: dict[str, Any] = {}
    exec(compile(program.replace("build/fmu/wheelset.ssp", str(written)), "docs/plugged-in.md", "exec"), names)
    assert names["run"]["body.y"].min() < -2.5


def test_it_follows_a_bump_of_the_track(written):
    run = simulated(written, 0.5, body__y_start=0.0, track__height=4.0)
    assert run["track.y"].max() == pytest.approx(4, rel=1e-3)
    on_straight = run["body.y"][run["time"] < 0.02]
    assert abs(on_straight).max() < 0.3
    assert 1 < run["body.y"].max() < 6


def test_a_body_without_mass_is_refused(written):
    from fmpy.fmi1 import FMICallException

    with pytest.raises(FMICallException):
        simulated(written, 1e-3, body__mass=0.0)


def test_libcosim_runs_it_as_fmpy_does(written):
    script = Path(__file__).with_name("run_ssp_by_libcosim.py")
    ended = subprocess.run(
        [sys.executable, script, str(PACKAGES), written, str(STEP), "0.1"], capture_output=True, text=True, timeout=50 * SLOWER
    )  # fmt: skip
    assert ended.returncode == 0, ended.stdout[-2000:] + ended.stderr
    told = json.loads(re.search("^values (.+)$", ended.stdout, re.MULTILINE)[1])
    run = simulated(written, 0.1)
    # FMPy passes values on after a step, libcosim also before the first one, so the difference is at most two steps.
    assert told["body.y"] == pytest.approx(run["body.y"][-1], abs=2.2 * STEP * abs(run["body.y_rate"][-1]))
    assert told["right.pmax"] == pytest.approx(run["right.pmax"][-1], rel=5e-3)
