"""Tests all rows of a study in one HDF5 file."""

import json
from pathlib import Path

import h5py
import numpy as np
import pytest

TABLES = Path(__file__).parents[4] / "client" / "python" / "examples" / "creep_tables"


def test_arrays_lie_over_what_varies(ctl):
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {friction.mu: [0.1, 0.4], approach: {from: 0.005, to: 0.02, count: 3}}\n"
                            "together: {grid.nx: [20, 10], grid.ny: [20, 12]}\nanswers: [forces.Fn, converged, area]\n")  # fmt: skip
    rows = ctl("study", "study.yaml", "--hdf5", "all.h5", "--json").json["rows"]
    with h5py.File(ctl.folder / "all.h5") as file:
        assert file["forces.Fn"].shape == (2, 3, 2)
        assert file["forces.Fn"][...].ravel().tolist() == [row["answers"]["forces.Fn"] for row in rows]
        assert [dimension[0].name for dimension in file["forces.Fn"].dims] == ["/friction.mu", "/approach", "/grid.nx"]
        assert file["approach"][...].tolist() == pytest.approx([0.005, 0.0125, 0.02])
        assert file["grid.ny"][...].tolist() == [20, 12]
        assert file["grid.ny"].dims[0][0].name == "/grid.nx"
        assert np.all(file["converged"][...] == 1)
        assert json.loads(file["area"][1, 2, 0]) == rows[-2]["answers"]["area"]
        assert json.loads(file.attrs["problem"])["bodies"]["upper"] == {"G": 200, "nu": 0.42}
        assert file.attrs["method"] == "contact.solve"


def test_a_row_that_failed_has_no_numbers(ctl):
    ctl.write("study.yaml", 'problem: contact.yaml\nvary: {bodies.upper.nu: [0.3, 0.7], friction: [{"mu": 0.1, "rigid_shift": [0.01, 0]}, {}]}\n'
                            "answers: [forces.Fn, converged]\n")  # fmt: skip
    assert ctl("study", "study.yaml", "--hdf5", "all.h5").code == 4
    with h5py.File(ctl.folder / "all.h5") as file:
        assert file["code"][...].tolist() == [[0, 4], [4, 4]]
        assert np.isnan(file["forces.Fn"][...]).tolist() == [[False, True], [True, True]]
        assert file["converged"][...].tolist() == [[1, -1], [-1, -1]]
        assert [json.loads(text) for text in file["friction"]] == [{"mu": 0.1, "rigid_shift": [0.01, 0]}, {}]
    assert not list(ctl.folder.glob("*.part"))


def test_without_h5py_it_is_told_before_anything_is_solved(lonely):
    hiding = lonely.write_module("h5py")
    lonely.write("study.yaml", "problem: contact.yaml\nvary: {approach: [0.01]}\n")
    lonely.environment["PYTHONPATH"] = f"{hiding}:{lonely.environment['PYTHONPATH']}"
    ended = lonely.alone("study", "study.yaml", "--hdf5", "all.h5")
    assert ended.code == 2
    assert 'Writing HDF5 files needs h5py: pip install "contactd[hdf5]"' in ended.err


def test_the_creep_tables_of_the_examples_are_hertzian_and_similar(ctl):
    """Runs a part of them by the array's script; friction forces depend on creepages only with friction."""
    some = (TABLES / "study.yaml").read_text().splitlines()
    vary = ["  friction.mu: [0.1, 0.4]", "  friction.rolling.xi: [5e-4, 2e-3]", "  friction.rolling.eta: [-1e-3, -4e-3]",
            "  friction.rolling.phi: [2e-4, 8e-4]", "answers: [forces.Fx, forces.Fy, pmax, converged]"]  # fmt: skip
    ctl.write("some.yaml", "\n".join([*some[: some.index("vary:") + 1], *vary]) + "\n")
    ctl.environment["PATH"] = f"{ctl.folder}:{ctl.environment['PATH']}"
    program = ctl.folder / "contactctl"
    program.write_text('#!/bin/sh\nexec "$CONTACTCTL_PYTHON" -m contactctl "$@"\n')
    program.chmod(0o755)
    ctl.environment["CONTACTCTL_PYTHON"], ctl.command = ctl.command[0], ["bash", str(TABLES / "array.slurm")]
    for index in "01":
        ended = ctl.alone("some.yaml", SLURM_ARRAY_TASK_ID=index, SLURM_ARRAY_TASK_COUNT="2")
        assert ended.code == 0, ended.err
        assert "80 rows: 80 done" in ended.out
    assert ctl("--local", "study", "some.yaml", "--hdf5", "some.h5").code == 0
    with h5py.File(ctl.folder / "some.h5") as file:
        fx, fy, pmax = (file[name][...] for name in ("forces.Fx", "forces.Fy", "pmax"))
        a, b = (file[f"gap.semi_axes.{name}"][...] for name in "ab")
    assert a * b == pytest.approx(np.full(10, 36.0), rel=1e-4)
    assert pmax[0, 0, 0, 0] == pytest.approx(1.5 * 50e3 / (np.pi * a * b), rel=0.01)
    for force in (fx, fy):
        assert force[1, 1, 1, 1] == pytest.approx(4 * force[0, 0, 0, 0], rel=1e-4)
        assert np.all(np.abs(force[0]) < 0.1 * 50e3)
