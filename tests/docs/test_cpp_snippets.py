"""Tests that the C++ code of the pages compiles. The code of client/cpp is its example, which is built and run."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
HEADERS = ("contactd/client/client.hpp", "contactd/client/session.hpp", "iostream")
#: Marks code that is a part of a function.
FRAME = "{includes}\nvoid snippet() {{\n{code}\n}}\n"


def snippets():
    pages = sorted([*ROOT.glob("docs/*.md"), *ROOT.glob("client/*/README.md"), ROOT / "README.md"])
    for page in pages:
        for number, code in enumerate(re.findall(r"^```cpp\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)):
            yield pytest.param(code, id=f"{page.relative_to(ROOT)}-{number}")


@pytest.mark.timeout(120)
@pytest.mark.parametrize("code", snippets())
def test_a_snippet_compiles(code, tmp_path):
    source = tmp_path / "snippet.cpp"
    if "int main" in code:
        source.write_text(code)
    else:
        own = [line for line in code.splitlines() if line.startswith("#include")]
        rest = "\n".join(line for line in code.splitlines() if not line.startswith("#include"))
        source.write_text(FRAME.format(includes="\n".join([*(f"#include <{name}>" for name in HEADERS), *own]), code=rest))
    folders = [f"-I{ROOT / folder}" for folder in ("client/cpp/include", "cases/include", "core/include")]
    compiled = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", *folders, source], capture_output=True, text=True)
    assert compiled.returncode == 0, compiled.stderr


def test_there_are_snippets():
    assert len(list(snippets())) >= 3
