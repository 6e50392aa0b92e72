"""Random requests that the daemon has work with: grids as large as its limits allow, and a little larger."""

from __future__ import annotations

import json
import math
import struct
import subprocess
from pathlib import Path
from typing import Any

from load.messages import Messages

#: Longer arrays repeat so many numbers; lists are no longer than this.
NUMBERS = 1000
MAX_ARRAY_BYTES = 32 << 20


def templates(program: str | Path) -> dict[str, list[dict[str, Any]]]:
    """Parameters of good requests by their method: the large ones that `contactd --print-costs` knows."""
    printed = subprocess.run([program, "--print-costs"], capture_output=True, check=True, timeout=60).stdout
    found: dict[str, list[dict[str, Any]]] = {}
    for example in json.loads(printed):
        if "params" in example:
            found.setdefault(example["method"], []).append(example["params"])
    return found


def copied(value: Any) -> Any:
    """A deep copy, in a hundredth of copy's time where there are millions of numbers."""
    if isinstance(value, dict):
        return {key: copied(item) for key, item in value.items()}
    if isinstance(value, list):
        return [copied(item) for item in value] if value and isinstance(value[0], dict | list) else value[:]
    return value


class LargeMessages(Messages):
    """`templates` are good parameters by method, `most_elements` what a grid may have."""

    max_bytes = 100 << 20
    timeouts_ms = (1, 50, 200, 1000, 3000)

    def __init__(self, document: dict[str, Any], seed: int, templates: dict[str, list[dict[str, Any]]], most_elements: int) -> None:
        super().__init__(document, seed)
        self._templates = templates
        self._most = most_elements
        # Methods that have work with large grids come as often as all others together.
        self.methods += sorted(templates) * (len(self.methods) // len(templates))

    def _random_grid(self) -> tuple[int, int]:
        choose = self._random
        if choose.random() < 0.3:
            return super()._random_grid()
        elements = math.exp(choose.uniform(math.log(36), math.log(1.1 * self._most)))
        nx = max(1, round(math.sqrt(elements) * math.exp(choose.uniform(-2, 2))))
        return nx, max(1, round(elements / nx))

    def _params(self, method: str) -> Any:
        if method not in self._templates or self._random.random() < 0.3:
            return super()._params(method)
        params = copied(self._random.choice(self._templates[method]))
        if "problems" in params:
            del params["problems"][self._random.randint(1, len(params["problems"])) :]
        for problem in params.get("problems", [params]):
            self._resize(problem)
        if "setup" in params:
            params["setup"]["dx"] = params["setup"]["dy"] = math.exp(self._random.uniform(math.log(0.02), 0))
        return params

    def _resize(self, problem: dict[str, Any]) -> None:
        """The problem on a grid of the message's size, as long and as wide as before."""
        grid = problem.get("grid")
        if grid is None:
            return
        for count, width, new in (("nx", "dx", self._grid[0]), ("ny", "dy", self._grid[1])):
            grid[width] *= grid[count] / new
            grid[count] = new
        rolling = problem.get("friction", {}).get("rolling")
        if rolling is not None:
            rolling["dq"] = grid["dx"]
            rolling["kind"] = self._random.choice(["steady", "transient"])

    def _damage_some(self, envelope: dict[str, Any]) -> None:
        """Leaves the deadline as it is, since large work without one may take hours."""
        timeout = envelope["timeout_ms"]
        if self._random.random() < 0.4:
            super()._damage_some(envelope)
        envelope["timeout_ms"] = timeout

    def _array(self) -> Any:
        nx, ny = self._grid
        if nx * ny <= NUMBERS:
            return super()._array()
        shape = self._random.choice([[ny, nx], [ny, nx], [3, 3, ny, nx], [nx, 3], [nx]])
        count = math.prod(shape)
        if 8 * count > MAX_ARRAY_BYTES:
            shape, count = [nx], nx
        some = struct.pack(f"<{NUMBERS}d", *(self._random.uniform(-1, 1) for _ in range(NUMBERS)))
        self._frames.append((some * (count // NUMBERS + 1))[: 8 * count])
        return {"$array": {"frame": len(self._frames), "dtype": "<f8", "shape": shape}}
