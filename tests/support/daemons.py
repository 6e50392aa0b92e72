"""Starts real daemons on private endpoints, and checks that they leave nothing behind."""

from __future__ import annotations

import os
import re
import shutil
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from contactd import Client, LocalDaemon
from contactd.transport.messages import Reply, Request

from . import schemas
from .raw import RawClient
from .slowness import SLOWER

BIN = Path(os.environ.get("CONTACTD_BIN", Path(__file__).parents[2] / "build" / "development" / "bin"))


class CheckedClient(Client):
    """A client that validates every result and every progress message against its schema."""

    def _exchange(self, request: Request) -> Reply:
        schemas.check(f"{request.method}.params", request.envelope["params"])
        reply = super()._exchange(request)
        schemas.check(f"{request.method}.result", reply.result)
        return reply


class TestDaemon(LocalDaemon):
    """A daemon in a folder of the test's."""

    __test__ = False

    @property
    def store(self) -> Path:
        return self.folder / "store"

    def client(self, **options: Any) -> Client:
        return CheckedClient(self.endpoint, **{"timeout": 50 * SLOWER, **options})

    @property
    def http(self) -> str:
        """Returns its HTTP address, if its configuration has `http.address`."""
        found = re.search(r"http://[0-9.]+:\d+", self.log)
        assert found, f"no HTTP in the log:\n{self.log}"
        return found.group()

    def raw(self, kind: int | None = None) -> RawClient:
        return RawClient(self.endpoint) if kind is None else RawClient(self.endpoint, kind)

    def tables(self) -> list[Path]:
        """Returns the files of the store that are tables."""
        return sorted(self.store.glob("*.h5"))

    def builders(self) -> list[int]:
        """Returns the processes that build for this daemon's store, including launchers."""
        return processes_with(str(self.store) + "/")

    def kill(self) -> None:
        """Sends SIGKILL, and waits for the end."""
        self.process.kill()
        self.process.wait()


class Daemons:
    """Starts daemons. At the end, all must have ended, and the folder must contain only tables and logs."""

    def __init__(self) -> None:
        # The path is short because those of Unix sockets are limited.
        self.folder = Path(tempfile.mkdtemp(prefix="contactd-test-"))
        self._started: list[TestDaemon] = []

    def start(self, name: str = "daemon", *, program: Path = BIN / "contactd", **config: Mapping[str, Any]) -> TestDaemon:
        """Starts a daemon in the folder `name`; a repeated name uses the same store."""
        # The end does not wait for work that a test leaves running, unless the test requests it.
        config = {"shutdown": {"drain_seconds": 0}, **config}
        daemon = TestDaemon(program, folder=self.folder / name, config=config)
        self._started.append(daemon)
        return daemon

    def stop_all(self) -> None:
        for daemon in self._started:
            daemon.stop()

    def finish(self) -> None:
        try:
            ended = [daemon.stop() for daemon in self._started]
            assert all(status in (0, -9) for status in ended), f"exit statuses {ended}"
            eventually(lambda: not processes_with(str(self.folder)), "processes left behind")
            left = [path for path in self.folder.rglob("*") if path.is_file() or path.is_socket()]
            expected = {"contactd.json", "contactd.log"} | ({"socket"} if -9 in ended else set())
            suffixes = {".h5"} | ({".lock", ".tmp"} if -9 in ended else set())  # removed when a daemon starts there again
            strange = [
                p for p in left if p.name not in expected and p.suffix not in suffixes and p.parent.name != "quarantine"
            ]
            assert not strange, f"files left behind: {strange}"
        finally:
            shutil.rmtree(self.folder, ignore_errors=True)


def processes_with(text: str) -> list[int]:
    """Returns the living processes whose command line contains `text`."""
    found = []
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit() or int(entry.name) == os.getpid():
            continue
        try:
            if text.encode() in (entry / "cmdline").read_bytes():
                found.append(int(entry.name))
        except OSError:
            continue  # it ended meanwhile
    return found


def resident(daemon, field: str = "VmRSS") -> int:
    """Returns a value in bytes; VmHWM is the peak memory."""
    text = Path(f"/proc/{daemon.process.pid}/status").read_text()
    return int(next(line.split()[1] for line in text.splitlines() if line.startswith(field + ":"))) << 10


def eventually(condition: Callable[[], object], failure: str = "it did not come about", seconds: float = 20) -> None:
    """Waits until `condition` holds."""
    deadline = time.monotonic() + seconds * SLOWER
    while not condition():
        assert time.monotonic() < deadline, failure
        time.sleep(0.02)
