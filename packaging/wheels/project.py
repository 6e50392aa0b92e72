"""Projects of which setuptools makes wheels, in copies: nothing is written beside the sources."""

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
_EPOCH = "315532800"  #: The same bytes for the same content: all files are of 1980, where time begins for zip.


@contextmanager
def copied(project: Path) -> Iterator[Path]:
    """Until the end of the block; with the licence of contactd."""
    with tempfile.TemporaryDirectory() as scratch:
        there = Path(scratch) / "project"
        shutil.copytree(project, there, ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
        shutil.copy(ROOT / "LICENSE", there)
        yield there


def say(project: Path, version: str, sources: Sequence[str], licenses: Mapping[str, str]) -> None:
    """What a binary wheel says of what is inside: behind its page, and as texts."""
    (project / "VERSION").write_text(version)
    with (project / "README.md").open("a") as readme:
        readme.writelines(["\n", *(f"- {source}\n" for source in sources)])
    (project / "licenses").mkdir()
    shutil.move(project / "LICENSE", project / "licenses" / "contactd.txt")
    for name, text in licenses.items():
        (project / "licenses" / name.replace("+", "x")).write_text(text)  # setuptools takes a plus for a pattern


def wheel(project: Path, folder: Path, system: str = f"linux-{platform.machine()}") -> Path:
    """Of a project as it stands there, in `folder`. Raises CalledProcessError, after what setuptools says, where it fails.
    What is not of Python alone is for `system`, by distutils' name."""
    folder.mkdir(parents=True, exist_ok=True)
    build = "import sys; from setuptools.build_meta import build_wheel; print(build_wheel(sys.argv[1]))"
    built = subprocess.run(
        [sys.executable, "-c", build, folder.resolve()],
        cwd=project, env={**os.environ, "SOURCE_DATE_EPOCH": _EPOCH, "_PYTHON_HOST_PLATFORM": system}, stdout=subprocess.PIPE, text=True, check=True,
    )  # fmt: skip
    return folder / built.stdout.splitlines()[-1]
