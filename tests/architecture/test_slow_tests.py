"""Tests that a slow test states its reason: `./dev test` skips it, and `--all` has to wait for it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

TESTS = Path(__file__).parents[1]
SLOW_PYTHON = re.compile(r"^(?:@|pytestmark = .*)pytest\.mark\.slow\b.*$", re.MULTILINE)
SLOW_CPP = re.compile(r'^(.*)\nTEST_CASE\("[^\n]*",\s+"[^"]*\[slow\]"', re.MULTILINE)


def slow_tests() -> list[tuple[Path, str, bool]]:
    """Yields the file, its comment, and whether the comment states the reason."""
    found = []
    for path in sorted(TESTS.rglob("*.py")):
        found += [(path, match[0], "  # " in match[0]) for match in SLOW_PYTHON.finditer(path.read_text())]
    for path in sorted(TESTS.rglob("*.cpp")):
        found += [(path, match[0], match[1].startswith("// Slow: ")) for match in SLOW_CPP.finditer(path.read_text())]
    return found


@pytest.mark.parametrize("ending", [".py", ".cpp"])
def test_a_slow_test_says_why(ending: str) -> None:
    tests = [test for test in slow_tests() if test[0].suffix == ending]
    assert len(tests) > 10
    assert [(str(path.relative_to(TESTS)), text) for path, text, said in tests if not said] == []
