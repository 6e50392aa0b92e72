"""The script that builds the creep-force table of a release."""

import os
import subprocess
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "packaging" / "release" / "creep_table.sh"


def run(folder, *words, size=1000):
    """Runs the script with a contactctl that writes its words, and a table of this size."""
    program = folder / "bin" / "contactctl"
    program.parent.mkdir(exist_ok=True)
    program.write_text(f'#!/bin/sh\necho "$@" >> "{folder}/calls"\ncase "$*" in *--share*) ;; *) truncate -s {size} "{folder}/creep-0.28.creep" ;; esac\n')
    program.chmod(0o755)
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    ended = subprocess.run([SCRIPT, folder, *words], env=environment, capture_output=True, text=True, timeout=30)
    return ended, (folder / "calls").read_text().splitlines()


def test_a_table_is_built_and_then_checked(tmp_path):
    ended, calls = run(tmp_path)
    assert ended.returncode == 0
    table = tmp_path / "creep-0.28.creep"
    assert calls == [f"table build {table} --nu 0.28", f"table check {table} --points 10000 --seed 7"]


def test_a_share_is_checked_as_soon_as_the_table_exists(tmp_path):
    assert len(run(tmp_path, "0/2")[1]) == 1
    run(tmp_path)
    assert run(tmp_path, "0/2")[1][-1].endswith("--seed 7 --share 0/2")


def test_a_table_that_is_too_large_is_refused(tmp_path):
    ended, _ = run(tmp_path, size=20_000_001)
    assert ended.returncode == 1
    assert "Reduce the cells" in ended.stderr
