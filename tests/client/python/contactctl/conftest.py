"""Runs contactctl like users: as a process, in a folder with files, with a daemon."""

from __future__ import annotations

import io
import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, chdir, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest import mock

import pytest

from contactctl.app import run
from integration.conftest import background, client, daemon, daemons, shared, shared_daemon  # noqa: F401
from support.daemons import BIN
from support.slowness import SLOWER

CONTACT = """\
grid: {nx: 20, ny: 20, dx: 0.12, dy: 0.12}
bodies: {upper: {G: 200, nu: 0.42}}
ics: {source: analytic}
gap: {paraboloid: {Rx: 50, Ry: 50}}
approach: 2e-2
friction: {mu: 0.4, rigid_shift: [0.00817, 0]}
"""
#: A table in a tenth of a second, and one that takes half a minute.
QUICK = {"material": {"G": 82000, "nu": 0.28}, "grid": {"nx": 6, "ny": 6, "dx": 0.8, "dy": 0.8},
         "ics": {"source": "fem", "preset": "paper-test2", "order": 1, "L_over_h": 40}}  # fmt: skip
LONG = {**QUICK, "ics": {"source": "fem", "preset": "paper-test1", "order": 2, "L_over_h": 1000}}
#: A solve that only ends when it is cancelled: rolling a hundred thousand steps takes hours.
ENDLESS = {"grid": {"nx": 160, "ny": 160, "dx": 0.015, "dy": 0.015}, "bodies": {"upper": {"G": 200, "nu": 0.42}},
           "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 50, "Ry": 50}}, "approach": 0.02,
           "friction": {"mu": 0.4, "rolling": {"kind": "transient", "xi": 1e-3, "steps": 100_000}}}  # fmt: skip


@dataclass(frozen=True)
class Ended:
    """How a command ended."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        """Returns standard output, which must be one document in one line."""
        assert self.out.endswith("\n")
        assert self.out.count("\n") == 1
        return json.loads(self.out, parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))


class Ctl:
    """Runs contactctl with the endpoint of a daemon, in a folder of the test."""

    def __init__(self, folder: Path, endpoint: str) -> None:
        self.folder = folder
        self.endpoint = endpoint
        self.command = [sys.executable, "-m", "contactctl"]
        self.environment = {
            **{name: value for name, value in os.environ.items() if not name.startswith("CONTACTD_")},
            "CONTACTD_ENDPOINT": endpoint,
            "PATH": f"{BIN}:{os.environ['PATH']}",
            "PYTHONPATH": os.pathsep.join([path for path in sys.path if path]),
            "TERM": "xterm",
            "COLUMNS": "100",
        }  # fmt: skip

    def __call__(self, *words: object, given: str = "", **environment: str) -> Ended:
        """Runs it in this process until it ends, which saves the start of a process."""
        out, err = io.StringIO(), io.StringIO()
        with ExitStack() as stack:
            there = {name: value for name, value in self.environment.items() if not name.startswith("PYTHON")}
            stack.enter_context(mock.patch.dict(os.environ, {**there, **environment}, clear=True))
            stack.enter_context(chdir(self.folder))
            stack.enter_context(redirect_stdout(out))
            stack.enter_context(redirect_stderr(err))
            stack.enter_context(mock.patch.object(sys, "stdin", io.StringIO(given)))
            code = run([str(word) for word in words])
        return Ended(code, out.getvalue(), err.getvalue())

    def alone(self, *words: object, given: str = "", **environment: str) -> Ended:
        """Runs it in a separate process until it ends."""
        ended = subprocess.run(
            [*self.command, *map(str, words)], cwd=self.folder, env={**self.environment, **environment},
            input=given, capture_output=True, text=True, timeout=50 * SLOWER,
        )  # fmt: skip
        assert "Traceback" not in ended.stderr, ended.stderr
        return Ended(ended.returncode, ended.stdout, ended.stderr)

    def start(self, *words: object, **options: Any) -> subprocess.Popen[str]:
        """Runs it in the background."""
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.Popen(
            [*self.command, *map(str, words)], cwd=self.folder, env=self.environment, text=True,
            start_new_session=True, **streams,
        )  # fmt: skip

    def start_python(self, *lines: str) -> subprocess.Popen[str]:
        """Runs a program in its environment, with a pipe to its input."""
        streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
        return subprocess.Popen([sys.executable, "-c", "\n".join(lines)], env=self.environment, text=True, **streams)

    def write(self, name: str, content: Any) -> str:
        """Writes a file; values that are not text become JSON."""
        (self.folder / name).write_text(content if isinstance(content, str) else json.dumps(content))
        return name

    def write_module(self, name: str) -> Path:
        """Creates a folder with a module that hides one of this name."""
        folder = self.folder / "hiding"
        folder.mkdir(exist_ok=True)
        (folder / f"{name}.py").write_text(f"raise ModuleNotFoundError('hidden', name={name!r})\n")
        return folder


@pytest.fixture(autouse=True)
def _interrupts() -> Iterator[None]:
    """Commands receive Ctrl-C as at a terminal, even if the tests run in the background."""
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


@pytest.fixture
def ctl(shared_daemon: Any, tmp_path: Path) -> Ctl:  # noqa: F811
    """Uses the daemon of the test file."""
    return _with_files(tmp_path, shared_daemon.endpoint)


@pytest.fixture(scope="module")
def shared_ctl(shared_daemon: Any, tmp_path_factory: pytest.TempPathFactory) -> Ctl:  # noqa: F811
    """Uses the daemon of the test file, for data that are created once."""
    return Ctl(tmp_path_factory.mktemp("shared"), shared_daemon.endpoint)


@pytest.fixture
def own(daemon: Any, tmp_path: Path) -> Ctl:  # noqa: F811
    """Uses a separate daemon."""
    return _with_files(tmp_path, daemon.endpoint)


@pytest.fixture
def lonely(tmp_path: Path) -> Ctl:
    """Without a daemon."""
    return _with_files(tmp_path, f"ipc://{tmp_path}/nobody")


def _with_files(folder: Path, endpoint: str) -> Ctl:
    made = Ctl(folder, endpoint)
    made.write("contact.yaml", CONTACT)
    made.write("quick.json", QUICK)
    made.write("long.json", LONG)
    made.write("endless.json", ENDLESS)
    return made
