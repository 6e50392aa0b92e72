"""Builds wheels of projects with setuptools, in copies, so that nothing is written to the sources."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

__all__ = ["ROOT", "copied", "say", "wheel"]

ROOT = Path(__file__).parents[2]
_EPOCH = "315532800"  #: For reproducible bytes, all files are of 1980, the earliest date of zip.


@contextmanager
def copied(project: Path) -> Iterator[Path]:
    """Provides a copy of the project with the licence of contactd, until the end of the block."""
    with tempfile.TemporaryDirectory() as scratch:
        there = Path(scratch) / "project"
        shutil.copytree(project, there, ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
        shutil.copy(ROOT / "LICENSE", there)
        yield there


def say(project: Path, version: str, sources: Sequence[str], licenses: Mapping[str, str]) -> None:
    """Adds the notices of a binary wheel's contents to its page and as files."""
    (project / "VERSION").write_text(version)
    with (project / "README.md").open("a") as readme:
        readme.writelines(["\n", *(f"- {source}\n" for source in sources)])
    (project / "licenses").mkdir()
    shutil.move(project / "LICENSE", project / "licenses" / "contactd.txt")
    for name, text in licenses.items():
        (project / "licenses" / name.replace("+", "x")).write_text(text)  # setuptools reads a plus as a pattern


def wheel(project: Path, folder: Path, system: str = f"linux-{platform.machine()}") -> Path:
    """Builds the wheel of a project in `folder`. Raises CalledProcessError, after the messages of setuptools, if that
    fails. A project that is not pure Python is built for `system`, by distutils' name."""
    folder.mkdir(parents=True, exist_ok=True)
    build = "import sys; from setuptools.build_meta import build_wheel; print(build_wheel(sys.argv[1]))"
    built = subprocess.run(
        [sys.executable, "-c", build, folder.resolve()],
        cwd=project, env={**os.environ, "SOURCE_DATE_EPOCH": _EPOCH, "_PYTHON_HOST_PLATFORM": system}, stdout=subprocess.PIPE, text=True, check=True,
    )  # fmt: skip
    return folder / built.stdout.splitlines()[-1]
