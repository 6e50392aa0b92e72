"""Stores finished computations on disk, one JSON object per line, so that they are not repeated."""

from __future__ import annotations

import fcntl
import json
import os
from pathlib import Path
from typing import Any

Spec = dict[str, Any]


class StoreInUse(Exception):
    """Raised when another run is writing to the store."""


class ResultStore:
    """Stores results by request and version of contactd. The unfinished line of an interrupted run is skipped.

    `program` distinguishes builds of the same version, for the warning of is_of_another_build.
    """

    def __init__(self, path: Path, version: str, program: str = "", fresh: bool = False) -> None:
        self._version, self._program = version, program
        self._programs: dict[str, str] = {}
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file = path.open("a+b")
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._file.close()
            raise StoreInUse(f"{path} is in use by another run; wait for it, or stop it") from None
        if fresh:
            self._file.truncate(0)
        self._results = self._read()

    def _read(self) -> dict[str, dict[str, Any]]:
        self._file.seek(0)
        content = self._file.read()
        if content and not content.endswith(b"\n"):
            self._file.write(b"\n")
        results = {}
        for line in content.splitlines():
            try:
                entry = json.loads(line)
                key = self._key(entry["spec"], entry["version"])
                results[key] = entry["result"]
                self._programs[key] = entry.get("program", "")
            except (ValueError, KeyError, TypeError):
                continue
        return results

    @staticmethod
    def _key(spec: Spec, version: str) -> str:
        return json.dumps([version, spec], sort_keys=True)

    def get(self, spec: Spec) -> dict[str, Any] | None:
        return self._results.get(self._key(spec, self._version))

    def is_of_another_build(self, spec: Spec) -> bool:
        """Returns whether the result exists, but from another program of the same version."""
        key = self._key(spec, self._version)
        return key in self._results and self._programs[key] != self._program

    def put(self, spec: Spec, result: dict[str, Any]) -> None:
        """Writes the result to disk before it returns."""
        entry = {"version": self._version, "program": self._program, "spec": spec, "result": result}
        line = json.dumps(entry, sort_keys=True)
        self._file.write(line.encode() + b"\n")
        self._file.flush()
        os.fsync(self._file.fileno())
        key = self._key(spec, self._version)
        self._results[key], self._programs[key] = result, self._program

    def close(self) -> None:
        self._file.close()

    def __enter__(self) -> ResultStore:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()
