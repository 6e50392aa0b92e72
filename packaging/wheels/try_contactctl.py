"""Runs every example of docs/contactctl.md with the installed packages and a private daemon: try_contactctl.py PAGE."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from contactd import LocalDaemon


def commands(page: str) -> Iterator[tuple[str, str]]:
    """Yields each example with the output that the page shows; empty if it shows none."""
    for block in re.findall(r"(?:^    .*\n(?:\n(?=    ))?)+", page, re.MULTILINE):
        for example in re.split(r"^    \$ ", block, flags=re.MULTILINE)[1:]:
            command, _, shown = example.partition("\n")
            yield command, re.sub(r"^    ", "", shown, flags=re.MULTILINE).strip("\n")


def main() -> None:
    page = Path(sys.argv[1]).read_text()
    with LocalDaemon() as daemon, tempfile.TemporaryDirectory(dir=Path.home()) as folder:
        for name, text in re.findall(r"^```(?:yaml\n#|text\n%) (\S+)\n(.*?)^```", page, re.MULTILINE | re.DOTALL):
            Path(folder, name).write_text(text)
        x = (np.arange(40) - 19.5) * 0.06
        np.savetxt(Path(folder, "gap.csv"), (x[:, None] ** 2 + x**2) / 100, delimiter=",")
        head = "".join(f"{y};{y * y / 600:.4f}\n".replace(".", ",") for y in range(-36, 37))
        Path(folder, "head.csv").write_text(f"y;z\n{head}")
        environment = {**os.environ, "CONTACTD_ENDPOINT": daemon.endpoint, "COLUMNS": "100"}
        ran = 0
        for command, shown in commands(page):
            ended = subprocess.run(
                ["bash", "-o", "pipefail", "-c", command],
                cwd=folder, env=environment, capture_output=True, text=True, timeout=300,
            )  # fmt: skip
            assert ended.returncode == 0, f"{command}: {ended.stderr}"
            assert not shown or ended.stdout.strip("\n") == shown, f"{command} shows\n{ended.stdout}"
            ran += 1
    assert ran > 20, "the page has lost its examples"
    print(f"wheel test: {ran} commands of {Path(sys.argv[1]).name} ran")


main()
