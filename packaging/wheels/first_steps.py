"""Takes a stranger's first steps and prints the duration of each: first_steps.py WHEELS PAGE CONTACT_HERTZ.

The steps are: a virtual environment in the current folder, the installation from the folder of wheels, and the programs
of the page's section "Five programs", each in a process of its own.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from pathlib import Path

INSTALLED = "contactd[local,pictures]"
WRITE_CASE = "import pathlib, runpy, sys; runpy.run_path(sys.argv[1])['write_case'](pathlib.Path())"


def programs(page: Path) -> dict[str, str]:
    """Returns the programs of the section by the first sentence above each."""
    (section,) = re.findall(r"^## Five programs\n(.*?)^## ", page.read_text(), re.MULTILINE | re.DOTALL)
    found = re.findall(r"^(\w[^\n]*?)[.:,(][^`]*?^```python\n(.*?)^```", section, re.MULTILINE | re.DOTALL)
    return {name.strip(): program for name, program in found}


def main(wheels: str, page: str, hertz: str) -> None:
    python = Path("first/bin/python")
    pip = [python, "-m", "pip", "install", "--quiet", "--find-links", wheels, INSTALLED]
    steps: dict[str, list[str | Path]] = {
        "a virtual environment": [sys.executable, "-m", "venv", "first"],
        f'pip install "{INSTALLED}"': pip,
    }
    for name, program in programs(Path(page)).items():
        steps[name] = [python, "-c", program]
    began = last = time.monotonic()
    for name, command in steps.items():
        if command[0] is python and "contact_files" in str(command[-1]):
            subprocess.run([python, "-c", WRITE_CASE, hertz], check=True)
            last = time.monotonic()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env={**os.environ, "MPLBACKEND": "Agg"})
        print(f"first steps: {time.monotonic() - last:6.1f} s  {name}")
        last = time.monotonic()
    print(f"first steps: {last - began:6.1f} s  in total")


main(*sys.argv[1:])
