"""Tests other importers: libcosim for FMI 2 (libcosimpy), fmuloader for FMI 3."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from support.fmus import PACKAGES, archive
from support.slowness import SLOWER

HERE = Path(__file__).parent
#: Numbers replace enumerations, which libcosim does not support.
CASES = {
    "contactd_contact": (
        {"grid.nx": 15, "grid.ny": 15, "load.Fn": 40e3, "motion.xi": 1e-3, "model_number": 1}, ("Fx", "pmax")
    ),
    "contactd_wheel": (
        {"elements.dx": 1.0, "elements.dy": 1.0, "position.y": 2.0, "side_number": 0}, ("Fy", "patch[1].Fn")
    ),
}  # fmt: skip


def by_another(script, *arguments):
    """Returns the printed values of a separate process, which may crash."""
    ended = subprocess.run(
        [sys.executable, HERE / script, str(PACKAGES), *map(str, arguments)],
        capture_output=True, text=True, timeout=50 * SLOWER,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stdout[-2000:] + ended.stderr
    return json.loads(re.search("^values (.+)$", ended.stdout, re.MULTILINE)[1])


@pytest.mark.parametrize("kind", CASES)
def test_libcosim_steps_as_fmpy_does(instances, kind):
    values, names = CASES[kind]
    fmu = instances(kind, 2)
    typed = [[fmu.variables[name].type, fmu.reference(name), value] for name, value in values.items()]
    told = by_another("run_libcosim.py", archive(kind, 2), json.dumps(typed), json.dumps([*map(fmu.reference, names)]))
    outputs = fmu.start(values).step()
    assert told == [outputs[name] for name in names]
    assert all(value != 0 for value in told)


@pytest.mark.parametrize("kind", CASES)
def test_fmuloader_steps_as_fmpy_does(instances, kind):
    values, names = CASES[kind]
    fmu = instances(kind, 3)
    typed = [[fmu.variables[name].type, fmu.reference(name), value] for name, value in values.items()]
    token, references = fmu.description.guid, json.dumps([*map(fmu.reference, names)])
    told = by_another("run_fmuloader.py", archive(kind, 3), kind, token, json.dumps(typed), references)
    outputs = fmu.start(values).step()
    assert told == [outputs[name] for name in names]
    assert all(value != 0 for value in told)
