"""Measures the gain of two workers over one in a study: shares of the creep tables of the examples, in processes of
contactctl that solve in process. It reports processor time of the processes and wall-clock time of alternating runs.

    python3 bench/study_shares.py [--rows 10000] [--rounds 3]     (the packages contactd, contactctl and contactd_local on PYTHONPATH)

By wall-clock time, the gain of two workers depends on other busy processes. Processor time shows how much they slow
each other down. `gain` is the resulting gain on an idle machine with two cores: twice one worker's time over that of
both.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

STUDY = Path(__file__).resolve().parent.parent / "client" / "python" / "examples" / "creep_tables" / "study.yaml"
COMMAND = [sys.executable, "-m", "contactctl", "--local", "study", "--workers", "1"]


def part_of(rows: int) -> str:
    """Returns the study with enough values of friction and creepage for at least `rows` rows."""
    ellipses, creepages = 10, 100  # numbers of ellipses with spin, and of values of xi
    count = max(1, round(rows / ellipses / creepages))
    lines = []
    for line in STUDY.read_text().splitlines():
        if line.startswith("  friction.mu:"):
            line = f"  friction.mu: {{from: 0.1, to: 0.5, count: {count}}}"
        elif line.startswith("  friction.rolling.eta:"):
            line = "  friction.rolling.eta: [1e-3]"
        lines.append(line)
    return "\n".join(lines) + "\n"


def timed(study: Path, workers: int) -> tuple[float, float]:
    """Returns wall-clock seconds and processor seconds."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    tasks = [
        subprocess.Popen([*COMMAND, study, "--share", f"{index}/{workers}", "--rows", f"{study}.{workers}"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        for index in range(workers)
    ]
    for task in tasks:
        _, err = task.communicate()
        if task.returncode not in (0, 5):
            raise SystemExit(err.decode())
    seconds, after = time.perf_counter() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    for index in range(workers):
        os.unlink(f"{study}.{workers}.{index}-of-{workers}")
    return seconds, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, default=10000, help="minimum number of rows (default %(default)s)")
    parser.add_argument("--rounds", type=int, default=3, help="default %(default)s")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="study-shares-") as folder:
        study = Path(folder) / "study.yaml"
        study.write_text(part_of(options.rows))
        found = [(timed(study, 1), timed(study, 2)) for _ in range(options.rounds)]
    for (one, one_used), (two, two_used) in found:
        print(f"one worker {one:6.1f} s, {one_used:6.1f} s of processors; two {two:6.1f} s, {two_used:6.1f} s: "
              f"{one / two:.2f} by the clock, gain {2 * one_used / two_used:.2f} by processor time")  # fmt: skip
    print(f"medians: {median(one[0] / two[0] for one, two in found):.2f} by the clock, "
          f"gain {median(2 * one[1] / two[1] for one, two in found):.2f} by processor time")  # fmt: skip


if __name__ == "__main__":
    main()
