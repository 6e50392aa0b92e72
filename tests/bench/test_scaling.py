"""Tests ./dev bench --plot: each model from few elements to many, and its cost per element."""

import os
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

import scaling

BENCH = Path(scaling.__file__).parent
NAMES = ["simplified/hertz/n:10", "simplified/hertz/n:100", "conformal/n:10", "conformal/n:100", "conformal/n:1000"]


@pytest.fixture
def program(tmp_path):
    """Replaces bench_scaling: it lists its rows; a row writes its process to the file `row` and takes an hour."""
    file = tmp_path / "bench_scaling"
    lines = "".join(f"echo {name}\n" for name in NAMES)
    file.write_text(
        f'#!/bin/sh\nif [ "$1" = --benchmark_list_tests ]; then\n{lines}exit\nfi\n'
        f"echo $$ > {tmp_path}/new; mv {tmp_path}/new {tmp_path}/row; exec sleep 3600\n"
    )
    file.chmod(file.stat().st_mode | stat.S_IXUSR)
    return file


def is_running(process):
    """Returns whether there is such a process that has not ended, although nobody has waited for it yet."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def row(name, microseconds, elements, **counters):
    return {"name": f"bench_scaling.{name}", "cpu_time": microseconds, "time_unit": "us", "elements": elements, **counters}


def test_rows_run_model_by_model_and_each_is_printed_as_it_ends(program, capsys):
    assert scaling.rows_of(program, lambda _, only, timeout: [only]) == [f"^{name}$" for name in NAMES]
    assert [line.strip().rsplit(":", 1)[0] for line in capsys.readouterr().err.splitlines()] == NAMES


def test_a_model_gets_no_more_elements_after_a_row_that_took_too_long(program, capsys):
    def run(program, only, timeout):
        if only == "^conformal/n:100$":
            raise subprocess.TimeoutExpired(program, timeout)
        return [only]

    assert scaling.rows_of(program, run) == [f"^{name}$" for name in NAMES[:3]]
    assert capsys.readouterr().err.endswith("conformal/n:100: stopped after 60 s\n")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_run_and_its_row(program, number):
    command = [sys.executable, BENCH / "run.py", "--bin", program.parent, "--plot"]
    path = os.pathsep.join(sys.path)
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": path}) as process:
        assert "about three minutes and up to 2 GB of memory" in process.stderr.readline()
        started = program.parent / "row"
        while not started.exists():
            time.sleep(0.01)
        process.send_signal(number)
        assert process.stderr.read().endswith("interrupted; docs/performance.csv and docs/performance.png are unchanged\n")
    assert process.returncode == 130
    assert not is_running(int(started.read_text()))


def test_a_line_has_the_time_of_an_element():
    lines = scaling.table_of([
        row("steady_rolling/n:50", 1000, 2500, A_p=80.0, solver_iterations=11),
        row("simplified/hertz/n:10", 20, 100),
    ])
    assert lines[0] == {
        "model": "steady_rolling",
        "elements": 2500,
        "us": "1000",
        "us_per_element": "0.4",
        "products": "80",
        "iterations": 11,
    }
    assert lines[1] == {
        "model": "simplified/hertz",
        "elements": 100,
        "us": "20",
        "us_per_element": "0.2",
        "products": "",
        "iterations": "",
    }


def test_a_row_that_failed_ends_the_run():
    failed = {"error_occurred": True, "error_message": "the solver did not converge"}
    with pytest.raises(SystemExit, match="steady_rolling/n:50: the solver did not converge"):
        scaling.table_of([row("steady_rolling/n:50", 1000, 2500, **failed)])


def test_the_table_and_the_picture_have_all_models(tmp_path):
    models = list(scaling.SIMPLE | scaling.SOLVERS)
    scaling.write([row(f"{model}/n:{n}", n**2, n**2, A_p=n) for model in models for n in (10, 100)], tmp_path)
    written = (tmp_path / "performance.csv").read_text().splitlines()
    assert [line.split(",")[0] for line in written[1::2]] == models
    assert (tmp_path / "performance.png").read_bytes()[:4] == b"\x89PNG"
