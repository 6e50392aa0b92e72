"""Writes the files that follow from proto/schema (./dev generate); --check only lists those that differ.

    python3 -m generate [--check]      in proto
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import array_rows, c_paths, cpp, fmu, grid_arrays, python
from .declarations import ROOT, Declarations


def differing() -> dict[Path, str | None]:
    """Returns the generated text of each file that differs from the tree, or None for a file that should not exist."""
    schemas = array_rows.schema_files()
    declarations = Declarations(texts=schemas)
    generated = {
        **schemas,
        **cpp.cpp_files(declarations),
        **c_paths.c_files(declarations),
        **fmu.fmu_files(declarations),
        **python.python_files(declarations),
        **grid_arrays.grid_array_files(declarations),
    }
    wrong: dict[Path, str | None] = {
        path: text for path, text in generated.items() if not path.exists() or path.read_text() != text
    }
    found = (path for part in (cpp, c_paths, fmu, python) for path in part.GENERATED.rglob("*") if path.is_file())
    wrong.update((path, None) for path in found if path not in generated and path.suffix != ".pyc")
    return wrong


def main() -> int:
    parser = argparse.ArgumentParser(prog="./dev generate", description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail where a file differs")
    check = parser.parse_args().check
    wrong = differing()
    for path, text in wrong.items():
        print(("differs: " if check else "wrote ") + str(path.relative_to(ROOT)))
        if check:
            continue
        if text is None:
            path.unlink()
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    return 1 if check and wrong else 0


if __name__ == "__main__":
    sys.exit(main())
