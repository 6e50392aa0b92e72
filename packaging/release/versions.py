"""Checks or sets the version, which CMakeLists.txt defines: python3 packaging/release/versions.py [VERSION].

Without a version, it lists the places with another version, and fails if there are any. With one, it writes the version
to all places.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

__all__ = ["differing", "version", "write"]

ROOT = Path(__file__).parents[2]
#: File: patterns whose first group is the version. The first file defines the version.
PLACES = {
    "CMakeLists.txt": [r"project\(contactd VERSION (\S+) "],
    "client/python/contactd/_version.py": [r'__version__ = "([^"]+)"'],
    "client/python/pyproject.toml": [r'^version = "([^"]+)"', r"contactd-local==([^\"]+)\"", r"contactd-daemon==([^\"]+)\""],
    "CITATION.cff": [r"^version: (\S+)"],
    "docs/cite.md": [r"version = \{([^}]+)\}"],
    "packaging/conda/recipe.yaml": [r"^  version: (\S+)"],
    "packaging/spack/package.py": [r'^    version\("([^"]+)"\)'],
    "packaging/debian/changelog": [r"\Acontactd \(([^)-]+)"],
}
#: Returns the three numbers of a version.
HEADER = "client/c/include/contactd.h"
NUMBERS = [rf"#define CONTACTD_VERSION_{part} (\d+)" for part in ("MAJOR", "MINOR", "PATCH")]


def version() -> str:
    """Returns the version in CMakeLists.txt."""
    found = re.search(PLACES["CMakeLists.txt"][0], (ROOT / "CMakeLists.txt").read_text())
    assert found
    return found[1]


def differing() -> list[str]:
    """Returns the places whose version differs from CMakeLists.txt or is missing."""
    expected, wrong = version(), []
    for file, patterns in PLACES.items():
        text = (ROOT / file).read_text()
        for pattern in patterns:
            found = re.search(pattern, text, re.MULTILINE)
            if found is None or found[1] != expected:
                wrong.append(f"{file} has {found[1] if found else 'none'}")
    text = (ROOT / HEADER).read_text()
    numbers = [found[1] if (found := re.search(pattern, text)) else "" for pattern in NUMBERS]
    return wrong if ".".join(numbers) == expected else [*wrong, f"{HEADER} has {'.'.join(numbers)}"]


def write(new: str) -> None:
    """Writes the version to all places."""
    if not re.fullmatch(r"\d+\.\d+\.\d+", new):
        raise ValueError(f"{new} is not a version; it must be three numbers separated by dots")

    def put(text: str, pattern: str, value: str) -> str:
        return re.sub(pattern, lambda found: found[0].replace(found[1], value), text, count=1, flags=re.MULTILINE)

    for file, patterns in PLACES.items():
        text = (ROOT / file).read_text()
        for pattern in patterns:
            text = put(text, pattern, new)
        (ROOT / file).write_text(text)
    text = (ROOT / HEADER).read_text()
    for pattern, number in zip(NUMBERS, new.split(".")):
        text = re.sub(pattern, lambda found, number=number: found[0][: found.start(1) - found.start()] + number, text)
    (ROOT / HEADER).write_text(text)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        write(sys.argv[1])
    for sentence in differing():
        print(f"{sentence}; it must be {version()}", file=sys.stderr)
    sys.exit(1 if differing() else 0)
