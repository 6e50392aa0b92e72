"""A copy of parts of the repository that is edited by hand, and compiled in parts."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

__all__ = ["EditedTree"]

ROOT = Path(__file__).parents[2]
INCLUDE = ["core/include", "core/types/generated/include", "core/types", "core/src", "core", "cases/include", "cases", "", "proto/include"]
INCLUDE += ["proto/src", "client/fmu", "client/cpp/include", "client/cpp/src", "server/src"]


class EditedTree:
    """Holds the copy and the files that were edited; `folders` are the copied parts."""

    def __init__(self, root: Path, folders: list[str]) -> None:
        self.root = root
        self.edited: set[Path] = set()
        for folder in folders:
            shutil.copytree(ROOT / folder, root / folder)
        shutil.copy(ROOT / ".clang-format", root)

    def replace(self, path: str, *changes: tuple[str, str]) -> None:
        """Replaces texts that each occur once."""
        text = (self.root / path).read_text()
        for old, new in changes:
            assert text.count(old) == 1, f"{path}: {old!r}"
            text = text.replace(old, new)
        self.write(path, text)

    def write(self, path: str, text: str) -> None:
        (self.root / path).write_text(text)
        self.edited.add(self.root / path)

    @contextmanager
    def schema(self, name: str) -> Iterator[Any]:
        """Gives the schema for changes. Its layout, and thus rows that ./dev generate completes, remain."""
        path = self.root / "proto" / "schema" / f"{name}.json"
        document = json.loads(path.read_text())
        yield document
        path.write_text(json.dumps(document))
        self.edited.add(path)

    def generate(self) -> None:
        subprocess.run([sys.executable, "-B", "-m", "generate"], cwd=self.root / "proto", check=True)

    def python(self, program: str) -> None:
        """Runs a program with the copy of the Python client."""
        ran = subprocess.run([sys.executable, "-B", "-c", program], cwd=self.root / "client" / "python", capture_output=True, text=True)
        assert ran.returncode == 0, ran.stderr

    def compile(self, source: str, *options: str) -> None:
        """Compiles a source of the copy to an object file beside it, or checks it with -fsyntax-only."""
        compiler = ["ccache", "c++"] if shutil.which("ccache") else ["c++"]
        environment = {**os.environ, "CCACHE_BASEDIR": str(self.root), "CCACHE_NOHASHDIR": "1"}
        include = [f"-I{self.root / folder}" for folder in INCLUDE] + ["-isystem", "/usr/include/eigen3"]
        command = [*compiler, "-std=c++20", "-O0", "-Wall", "-Wextra", '-DCONTACTD_VERSION="0"', *include, *options, "-c", source]
        made = subprocess.run([*command, "-o", f"{source}.o"], cwd=self.root, env=environment, capture_output=True, text=True)
        assert made.returncode == 0, made.stderr[-3000:]

    def run(self, *sources: str) -> list[str]:
        """Compiles and links the sources, and returns the lines that the program prints. Functions that are not called may be
        missing."""
        for source in sources:
            self.compile(source)
        objects = [f"{source}.o" for source in sources]
        subprocess.run(["c++", "-static", "-Wl,--unresolved-symbols=ignore-all", *objects, "-o", "probe"], cwd=self.root, check=True)
        return subprocess.run([self.root / "probe"], capture_output=True, text=True, check=True).stdout.splitlines()
