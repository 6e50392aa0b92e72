"""Tests the demo as a user runs it, and as a user stops it."""

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from support.daemons import BIN, eventually, processes_with

CLIENT = Path(__file__).parents[2] / "client" / "python"
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(CLIENT), "PYTHONDONTWRITEBYTECODE": "1"}


def start(folder, *options):
    """Runs the demo in a process, with its daemon in a temporary folder below `folder`."""
    return subprocess.Popen(
        [sys.executable, CLIENT / "examples" / "demo", *options],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env={**ENVIRONMENT, "TMPDIR": str(folder)},
    )  # fmt: skip


@pytest.fixture
def folder(daemons):
    """Provides a short name, and checks afterwards for remaining files."""
    (daemons.folder / "demo").mkdir()
    return daemons.folder / "demo"


def test_missing_programs_are_named(tmp_path):
    demo = start(tmp_path, "--bin", tmp_path)
    _, errors = demo.communicate(timeout=50)
    assert demo.returncode == 2
    assert "contactd cannot be started: No such file" in errors


def test_a_daemon_that_fails_shows_its_log(tmp_path, folder):
    program = tmp_path / "contactd"
    program.write_text("#!/bin/sh\necho the disk is full >&2\nexit 1\n")
    program.chmod(0o755)
    demo = start(folder, "--bin", tmp_path)
    _, errors = demo.communicate(timeout=50)
    assert demo.returncode == 2
    assert "the disk is full" in errors
    assert left_in(folder) == []


@pytest.mark.parametrize(("ending", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_an_interrupted_demo_stops_its_daemon(folder, ending, status):
    demo = start(folder, "--bin", BIN, "--output", folder / "picture.png")
    eventually(lambda: processes_with(f"{folder}/contactd-") and any("contactd-ic" in name for name in names(folder)))
    demo.send_signal(ending)
    _, errors = demo.communicate(timeout=50)
    assert demo.returncode == status
    assert "Traceback" not in errors
    assert processes_with(str(folder)) == []
    assert left_in(folder) == []


def names(folder):
    """Returns command lines of the processes that work in `folder`."""
    found = []
    for process in processes_with(str(folder)):
        try:
            found.append(Path(f"/proc/{process}/cmdline").read_text())
        except OSError:
            continue
    return found


def left_in(folder):
    """Returns names in `folder`, without the session folder that Open MPI leaves in the temporary folder."""
    return [path.name for path in folder.iterdir() if not path.name.startswith("ompi.")]


def drawn(folder: Path, names: str, *options: str, file: str = "picture.png") -> str:
    """Runs a demo that draws pictures with these names and passes, and returns its output."""
    demo = start(folder, *options, "--bin", BIN, "--output", folder / "sub" / file)
    output, errors = demo.communicate(timeout=280)
    assert demo.returncode == 0, output + errors
    assert errors == ""
    assert "FAIL" not in output
    pictures = sorted((folder / "sub").iterdir())
    assert [picture.stem for picture in pictures] == names.split()
    for picture in pictures:
        assert picture.read_bytes().startswith(b"\x89PNG")
        picture.unlink()
    assert left_in(folder) == ["sub"]
    return output


@pytest.mark.slow  # builds the table of the paper's finest block
@pytest.mark.timeout(300)
def test_the_demo_reaches_the_accuracy_of_the_paper_and_draws_a_picture(folder):
    output = drawn(folder, "picture")
    assert re.search(r"elements +1840\n +unknowns +50361", output)


@pytest.mark.timeout(300)
def test_the_demo_of_a_wheelset_agrees_with_the_benchmark_and_draws_a_picture(folder):
    assert drawn(folder, "picture", "wheelrail").count("pass") == 9


@pytest.mark.timeout(300)
def test_the_demo_of_profiles_agrees_with_closed_forms_and_draws_pictures(folder):
    output = drawn(folder, "contact-locus creep-forces equivalent-conicity standard-profiles wheel-rail-patches", "profiles", file="all.png")
    assert output.count("pass") == 4


@pytest.mark.timeout(300)
def test_the_demo_of_cross_sections_agrees_with_a_prototype_and_draws_a_picture(folder):
    assert drawn(folder, "picture", "conformal").count("pass") == 8


def test_a_demo_that_there_is_not_is_refused(folder):
    demo = start(folder, "railway")
    _, errors = demo.communicate(timeout=50)
    assert demo.returncode == 2
    assert "invalid choice: 'railway'" in errors
