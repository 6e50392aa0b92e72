"""Tests that a folder contains at most twenty files; docs/architecture.md names exceptions."""

import re
import subprocess
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[2]
MOST = 20


def named() -> set[str]:
    """Returns the folders that the page names as exceptions."""
    page = (ROOT / "docs/architecture.md").read_text()
    paragraph = next(text for text in page.split("\n\n") if "more than twenty files" in text)
    return {name for name in re.findall(r"`([^`]+)`", paragraph) if not name.endswith(".py")}


def large() -> set[str]:
    files = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    counts = Counter(str(Path(file).parent) for file in files)
    return {folder for folder, count in counts.items() if count > MOST}


def test_folders_with_more_than_twenty_files_are_named():
    assert not large() - named()


def test_folders_are_named_only_where_they_are_large():
    assert not named() - large()
