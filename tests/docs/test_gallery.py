"""Tests that the gallery has every picture of the pages once, with a page that shows it and a command that exists."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
ROWS = re.findall(
    r"^\| \[!\[([^\]]+)\]\(([^)]+)\)\]\(([^)]+)\) \| ([^|]+) \| (.+) \|$",
    (DOCS / "gallery.md").read_text(),
    re.MULTILINE,
)


def test_every_picture_is_there_once():
    pictures = {str(path.relative_to(DOCS)) for ending in ("png", "gif") for path in DOCS.rglob(f"*.{ending}")}
    shown = [picture for _, picture, *_ in ROWS]
    assert len(pictures) > 50
    assert sorted(shown) == sorted(pictures)


@pytest.mark.parametrize(("words", "picture", "page"), [row[:3] for row in ROWS], ids=[row[1] for row in ROWS])
def test_a_picture_leads_to_a_page_that_shows_it_in_the_same_words(words, picture, page):
    folder = (DOCS / page).parent
    shown = re.findall(r"!\[([^\]]*)\]\(([^)]+)\)", (DOCS / page).read_text())
    assert words in [text for text, source in shown if (folder / source).resolve() == (DOCS / picture).resolve()]


def test_commands_are_those_of_dev_and_contactctl_and_examples():
    usage = (ROOT / "dev").read_text().partition("\n}")[0]
    program = "\n".join(
        path.read_text() for path in (ROOT / "client" / "python" / "contactctl" / "commands").glob("*.py")
    )
    for *_, drawn in ROWS:
        (command, *_) = re.findall("`([^`]+)`", drawn)
        first, _, rest = command.partition(" ")
        if first == "./dev":
            assert f"./dev {' '.join(word for word in rest.split() if not word.startswith('-'))}" in usage, command
        elif first == "contactctl":
            name, *options = rest.split()
            assert re.search(rf"\bdef {name}\(|\"{name}\"", program), command
            assert all(f'"{option}"' in program for option in options if option.startswith("--")), command
        elif command.startswith("python3 client"):
            assert (ROOT / rest.split()[0]).exists(), command
        else:
            assert command == "python -m contactd.demo" or re.match(r"[\w.]+\(.*\)$", command), command
