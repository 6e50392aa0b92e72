"""What is generated from proto/schema is what stands in the tree."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def generate(*arguments: str, folder: Path = ROOT) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-B", "-m", "generate", *arguments]
    return subprocess.run(command, cwd=folder / "proto", capture_output=True, text=True)


def test_the_tree_has_what_its_schemas_say() -> None:
    checked = generate("--check")
    assert checked.returncode == 0, f"run ./dev generate\n{checked.stdout}{checked.stderr}"
