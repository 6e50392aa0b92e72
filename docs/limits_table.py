"""Writes the table of docs/limits.md from the costs of methods that the daemon reports; the text above it is kept.

    ./dev docs           (python3 docs/limits_table.py build/development/bin/contactd)
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

PAGE = Path(__file__).with_name("limits.md")
MARK = "<!-- The rest is written by ./dev docs from `x-largest` in proto/schema: edit it there. -->\n"


def costs(program: str | Path) -> list[dict[str, Any]]:
    """Returns large requests of each method, and their expected costs, under the default limits."""
    printed = subprocess.run([program, "--print-costs"], capture_output=True, check=True, timeout=60).stdout
    return json.loads(printed)


def table(examples: list[dict[str, Any]]) -> str:
    rows = [
        f"| `{example['method']}` | {example['arguments']} | {example['bytes'] / 2**20:.0f} MiB | {_time(example)} |"
        for example in examples
        if example["bytes"] is not None
    ]
    little = ", ".join(f"`{example['method']}`" for example in examples if example["bytes"] is None)
    head = "| method | arguments | memory | time of a processor |\n|---|---|---|---|\n"
    return f"{head}{chr(10).join(rows)}\n\nAll other methods need little memory in addition to their messages:\n{_wrapped(little)}.\n"


def _time(example: dict[str, Any]) -> str:
    seconds = example["seconds"]
    return "less than a second" if seconds < 1 else f"{seconds:.0f} s"


def _wrapped(text: str) -> str:
    import textwrap

    return textwrap.fill(text, 110)


def main() -> None:
    above = PAGE.read_text().partition(MARK)[0]
    PAGE.write_text(above + MARK + "\n" + table(costs(sys.argv[1])))


if __name__ == "__main__":
    main()
