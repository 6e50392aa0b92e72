"""docs/contact-files.md lists everything that cases are refused for."""

from __future__ import annotations

import ast
import re
from pathlib import Path

from contactd.contact_files.problems import features

ROOT = Path(__file__).parents[4]
PAGE = (ROOT / "docs" / "contact-files.md").read_text(encoding="utf-8").split("### What is refused")[1]
LISTED = {row.split(" | ")[-1].rstrip(" |") for row in re.findall(r"^\| .*$", PAGE, flags=re.MULTILINE)[1:]}


def _raised() -> set[str]:
    """The names of features that are found missing while a case is made ready; of formatted ones none."""
    names = set()
    for source in (ROOT / "client" / "python" / "contactd" / "contact_files").rglob("*.py"):
        for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Missing":
                names |= {argument.value for argument in node.args if isinstance(argument, ast.Constant)}
    return names


def _features() -> set[str]:
    return {features.TOO_MANY_ELEMENTS, *(feature.name for feature in (*features._BOTH, *features._BASIC, *features._ON_RAILS))}


def test_the_page_lists_every_feature_that_is_refused() -> None:
    of_nobody = "influence coefficients from a file (C = 9) in this call"  # the commands read them
    for name in (_features() | _raised()) - {of_nobody}:
        assert any(row.startswith(name) for row in LISTED), f"the page does not list: {name}"


def test_the_page_lists_nothing_that_is_computed() -> None:
    known = _features() | _raised()
    for row in LISTED - {"what contactd does not have", "---"}:
        assert any(row.startswith(name) for name in known), f"nothing refuses: {row}"
