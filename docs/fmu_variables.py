"""Writes the tables of variables of docs/fmu.md from the list in client/fmu; the text above them is kept.

./dev docs           (python3 docs/fmu_variables.py build/development/bin/contactd-fmu-description)
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

PAGE = Path(__file__).with_name("fmu.md")
MARK = "<!-- The rest is written by ./dev docs from client/fmu/variables: edit it there. -->\n"
ROLES = {"parameter": "Parameters", "tunable": "Parameters that may change", "input": "Inputs", "output": "Outputs"}
Json = Mapping[str, Any]


def tables(described: Json) -> str:
    parts = []
    for kind in described["kinds"]:
        parts.append(f"## Variables of {kind['name']}\n")
        for role, title in ROLES.items():
            rows = [variable for variable in kind["variables"] if variable["role"] == role]
            started = role != "output"
            parts.append(f"**{title}**\n")
            parts.append(
                "| name | unit | start | description |\n|---|---|---|---|"
                if started
                else "| name | unit | description |\n|---|---|---|"
            )
            parts += ["| " + " | ".join(_cells(row, started)) + " |" for row in rows]
            parts.append("")
    return "\n".join(parts)


def _cells(variable: Json, started: bool) -> list[str]:
    words = variable.get("enumeration", {}).get("words", [])
    start = words[variable["start"]] if words else variable["start"]
    unit = variable["unit"] or {"integer": "integer", "boolean": "boolean", "text": "text"}.get(variable["type"], "")
    if words:
        unit = ", ".join(words)
    start = str(start).lower() if isinstance(start, bool) else str(start)
    middle = [unit, f"`{start}`" if start else ""] if started else [unit]
    return [f"`{variable['name']}`", *middle, variable["says"]]


def main() -> None:
    described = json.loads(subprocess.run([sys.argv[1]], capture_output=True, check=True).stdout)
    above = PAGE.read_text().partition(MARK)[0]
    PAGE.write_text(above + MARK + "\n" + tables(described))


if __name__ == "__main__":
    main()
