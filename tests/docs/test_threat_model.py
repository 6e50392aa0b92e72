"""The threat model of docs/security.md has a row for each method."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_each_method_has_a_row():
    page = (ROOT / "docs/security.md").read_text()
    rows = page.partition("## Threat model")[2].partition("\n## ")[0]
    named = set(re.findall(r"`([a-z]+\.[a-z_*]+)`", "".join(line.split("|")[1] for line in rows.splitlines() if line.startswith("|"))))
    methods = {path.name.removesuffix(".params.json") for path in (ROOT / "proto/schema").glob("*.params.json")}
    families = {name.removesuffix("*") for name in named if name.endswith("*")}
    unnamed = {method for method in methods if method not in named and not any(method.startswith(f) for f in families)}
    assert not unnamed, f"without a row in the threat model: {sorted(unnamed)}"
    stale = {name for name in named if not name.endswith("*")} - methods
    assert not stale, f"rows of no method: {sorted(stale)}"
