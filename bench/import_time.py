"""Measures the time of `import contactd` and of the libraries that it requires: seconds, the minimum of alternating
runs.

    ./dev shell python3 bench/import_time.py [RUNS]
"""

from __future__ import annotations

import subprocess
import sys
import time

STATEMENTS = ("pass", "import numpy", "import numpy, zmq", "import contactd")


def seconds(statement: str) -> float:
    start = time.perf_counter()
    subprocess.run([sys.executable, "-c", statement], check=True)
    return time.perf_counter() - start


def main() -> None:
    runs = int(sys.argv[1]) if sys.argv[1:] else 20
    found: dict[str, list[float]] = {statement: [] for statement in STATEMENTS}
    for _ in range(runs):
        for statement, times in found.items():
            times.append(seconds(statement))
    for statement, times in found.items():
        print(f"{statement:20} {min(times):6.3f} s   over the interpreter {min(times) - min(found['pass']):6.3f} s")


if __name__ == "__main__":
    main()
