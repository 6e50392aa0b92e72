"""Watches a loaded daemon from a separate process: the latency of health, and the memory.

    python3 -m load.watch ENDPOINT PID    until standard input ends, then one line of JSON
"""

from __future__ import annotations

import json
import os
import select
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import zmq

from load.process import resident_bytes

PAUSE = 0.005  # seconds between an answer and the next request
TIMEOUT_MS = 60_000
EVERY = 10  # health requests per request for the kept bytes
KEPT = ("contactd_cache_bytes", "contactd_session_bytes")


@dataclass
class Watched:
    latencies_ms: list[float] = field(default_factory=list)
    #: Each contains the time that threads of the daemon and of the watch waited for a processor.
    waited_ms: list[float] = field(default_factory=list)
    before: int = 0  # resident bytes
    most: int = 0
    kept: int = 0  # largest number of bytes that the daemon reported in its caches and sessions

    def own_ms(self) -> list[float]:
        """Holds the latencies without the waits for a processor."""
        return [max(0.0, latency - waited) for latency, waited in zip(self.latencies_ms, self.waited_ms, strict=True)]


def answer(socket: zmq.Socket[bytes], method: str) -> dict[str, Any]:
    socket.send(json.dumps({"contactd": 1, "id": "watch", "method": method}).encode())
    if not socket.poll(TIMEOUT_MS):
        raise TimeoutError(f"no answer to {method} within {TIMEOUT_MS / 1000:g} s")
    result: dict[str, Any] = json.loads(socket.recv_multipart()[0])["result"]
    return result


def kept_bytes(metrics: dict[str, Any]) -> int:
    return int(sum(sample["value"] for family in metrics["metrics"] if family["name"] in KEPT for sample in family["samples"]))


def waited_for_processor(*pids: int) -> float:
    """Sums the waiting times of all threads of some processes since their start (ms), because one may wait for another
    without a processor."""
    waited = 0
    for task in (task for pid in pids for task in Path(f"/proc/{pid}/task").iterdir()):
        with suppress(FileNotFoundError, ProcessLookupError):  # it has ended
            waited += int((task / "schedstat").read_text().split()[1])
    return waited / 1e6


def watch(endpoint: str, pid: int) -> Watched:
    seen = Watched(before=resident_bytes(pid))
    with zmq.Context() as context, context.socket(zmq.DEALER) as socket:
        socket.linger = 0
        socket.connect(endpoint)
        while not select.select([sys.stdin], [], [], PAUSE)[0]:
            before = waited_for_processor(pid, os.getpid())
            start = time.monotonic()
            answer(socket, "server.health")
            seen.latencies_ms.append(1000 * (time.monotonic() - start))
            seen.waited_ms.append(waited_for_processor(pid, os.getpid()) - before)
            if len(seen.latencies_ms) % EVERY == 0:
                seen.kept = max(seen.kept, kept_bytes(answer(socket, "server.metrics")))
            seen.most = max(seen.most, resident_bytes(pid))
    return seen


@contextmanager
def watching(endpoint: str, pid: int) -> Iterator[Watched]:
    """Results are available after the block."""
    seen = Watched()
    command = [sys.executable, "-m", "load.watch", endpoint, str(pid)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment) as process:
        yield seen
        printed, _ = process.communicate()
    found: dict[str, Any] = json.loads(printed) if process.returncode == 0 else {}
    if not found:
        raise RuntimeError(f"the watch has ended with status {process.returncode}")
    for name, value in found.items():
        setattr(seen, name, value)


if __name__ == "__main__":
    print(json.dumps(asdict(watch(sys.argv[1], int(sys.argv[2])))))
