"""Measures one computation of contactd-ic, with its CPU time and the errors of its table, or of another program."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from contactd import load_table

from ..section import ComputationFailed, Measure
from . import block_system, full_model
from .cases import GRIDS, STEEL, Spec

Array = npt.NDArray[np.float64]
_AXES = {"x": 0, "y": 1, "z": 2}
_NOT_CONVERGED = 3  # exit status of contactd-ic


def measure_with(programs: Path) -> Measure:
    """Returns the result of a request for a table, of a `solve` of a system, of a `mesh`, or of the comparison with a
    `whole_block`."""
    builder = Builder(programs / "contactd-ic")

    def measure(spec: Spec) -> dict[str, Any]:
        if "solve" in spec:
            return block_system.solve(programs, spec["solve"])
        if "mesh" in spec:
            return block_system.faces_to_draw(block_system.mesh(programs, spec["mesh"]))
        if "whole_block" in spec:
            quarter = block_system.mesh(programs, spec["whole_block"])
            table = builder.table({name: spec[name] for name in ("material", "grid", "ics")})
            return full_model.compare(quarter, table, spec["material"]["nu"])
        return builder.measure(spec)

    return measure


class Builder:
    """Measures requests with a contactd-ic, one after the other, each on one thread."""

    def __init__(self, program: Path) -> None:
        self._program = program
        self._environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        self._closed_forms: dict[str, Array] = {}

    def measure(self, spec: Spec) -> dict[str, Any]:
        """Returns evidence, costs, and errors by extent. A solve that did not converge has the result {"failure": text}."""
        last, array, usage = self._build(spec)
        if array is None:
            return {"failure": last["error"]["message"]}
        evidence = last["evidence"]
        reference = self._closed_form(spec["ics"].get("load_shape", "constant"))
        extents = sorted({n for n in GRIDS if n <= array.shape[-1]})
        return {
            "elements": evidence["elements"],
            "dofs": evidence["dofs"],
            "solver": evidence.get("solver", ""),
            "iterations": {case["load"]: case["iterations"] for case in evidence["load_cases"]},
            "seconds": evidence["seconds"],
            "cpu_seconds": usage.ru_utime + usage.ru_stime,
            "memory_mib": usage.ru_maxrss / 1024,
            "mesh": evidence.get("mesh"),
            "errors": {str(n): errors(array, reference, n) for n in extents},
        }

    def table(self, spec: Spec) -> Array:
        """Returns the table of contactd-ic for dx = 1 and G = 1, shape [3, 3, ny, nx]."""
        array = self._build(spec)[1]
        if array is None:
            raise ComputationFailed("contactd-ic did not converge")
        return array

    def _closed_form(self, load_shape: str) -> Array:
        """Returns the closed form, which contactd-ic writes in the same form as other tables."""
        if load_shape not in self._closed_forms:
            n = GRIDS[-1]
            grid, material = {"nx": n, "ny": n, "dx": 1, "dy": 1}, {"G": 1, "nu": STEEL["nu"]}
            spec = {"material": material, "grid": grid, "ics": {"source": "analytic", "load_shape": load_shape}}
            self._closed_forms[load_shape] = self.table(spec)
        return self._closed_forms[load_shape]

    def _build(self, spec: Spec) -> tuple[dict[str, Any], Array | None, Any]:
        """Returns the last line of contactd-ic, the table for dx = 1 and G = 1 unless a solve failed, and the resource
        usage."""
        with tempfile.TemporaryDirectory(prefix="contactd-paper-") as folder:
            path, noise = Path(folder, "table.h5"), Path(folder, "noise.txt")
            command = [str(self._program), "-", "--output", str(path), "--exit-with-stdin"]
            text, exit_code, usage = self._run(command, json.dumps(spec), noise)
            last = _last_object(text.splitlines())
            if exit_code == 0 and "evidence" in last:
                return last, np.asarray(load_table(path).array), usage
            if exit_code == _NOT_CONVERGED and "error" in last:
                return last, None, usage
            error = last.get("error", {})
            message = f"{error.get('field', '')} {error.get('message', '')}".strip() or noise.read_text().strip()
            raise ComputationFailed(f"contactd-ic ended with status {exit_code}: {message or 'no word of why'}")

    def _run(self, command: list[str], line: str, noise: Path) -> tuple[str, int, Any]:
        """Returns standard output, exit status and resource usage."""
        with noise.open("wb") as stderr:
            process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=stderr, text=True, env=self._environment
            )
        with process:
            assert process.stdin is not None and process.stdout is not None
            # Standard input stays open until the end, so that a build does not survive this process.
            process.stdin.write(line + "\n")
            process.stdin.flush()
            text = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        return text, process.returncode, usage


def _last_object(lines: list[str]) -> dict[str, Any]:
    for line in reversed(lines):
        try:
            value = json.loads(line)
        except ValueError:
            continue
        if isinstance(value, dict):
            return value
    return {}


def errors(array: Array, reference: Array, extent: int) -> dict[str, Any]:
    """Returns errors over extent x extent offsets. Those of xx, yy and zz are relative: signed at the origin, and the
    largest. The others are multiplied by 2 pi rho, which relates them to a point load's displacement (dx = dy = 1, G =
    1)."""
    part, exact = array[:, :, :extent, :extent], reference[:, :, :extent, :extent]
    y, x = np.mgrid[0:extent, 0:extent]
    rho = np.hypot(x, y)

    def relative(name: str) -> dict[str, float]:
        i = _AXES[name[0]]
        error = part[i, i] / exact[i, i] - 1
        return {"origin": float(error[0, 0]), "largest": float(np.abs(error).max())}

    def scaled(*names: str) -> float:
        axes = [(_AXES[name[0]], _AXES[name[1]]) for name in names]
        return max(float((np.abs(part[axis] - exact[axis]) * 2 * np.pi * rho).max()) for axis in axes)

    result: dict[str, Any] = {name: relative(name) for name in ("xx", "yy", "zz")}
    return {**result, "scaled_xy": scaled("xy", "yx"), "scaled_xz": scaled("xz", "zx", "yz", "zy")}
