"""./dev generate: writes what follows from proto/schema; with --check only says what differs.

    python3 -m generate [--check]      in proto
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from .c_paths import c_files
from .cpp import INCLUDE, SOURCES, cpp_files
from .declarations import ROOT, Declarations
from .fmu import fmu_files
from .python import generated_modules, python_files


def differing() -> dict[Path, str | None]:
    """The files whose text in the tree is another one than the generated; None where there should be no file."""
    declarations = Declarations()
    generated = {
        **cpp_files(declarations),
        **c_files(declarations),
        **fmu_files(declarations),
        **python_files(declarations),
    }
    wrong: dict[Path, str | None] = {
        path: text for path, text in generated.items() if not path.exists() or path.read_text() != text
    }
    written = [*(INCLUDE / "fields").glob("*"), *SOURCES.glob("*"), *generated_modules()]
    wrong.update((path, None) for path in written if path not in generated)
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
