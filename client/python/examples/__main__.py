"""Lists the examples, or copies them: python -m contactd.examples [FOLDER].

Each example begins with a description, and how to run it.
"""

from __future__ import annotations

import ast
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).parent


def main() -> int:
    """Copies all examples to a new folder, or prints their names and first sentences."""
    if len(sys.argv) > 2 or sys.argv[1:] in (["-h"], ["--help"]):
        print(__doc__)
        return 0 if len(sys.argv) == 2 else 2
    if len(sys.argv) == 2:
        try:
            shutil.copytree(HERE, sys.argv[1], ignore=shutil.ignore_patterns("__pycache__", "__main__.py"))
        except FileExistsError:
            print(f"{sys.argv[1]} exists; name a new folder.", file=sys.stderr)
            return 2
        for folder in (path.parent for path in HERE.glob("*/__main__.py")):
            shutil.copy(folder / "__main__.py", Path(sys.argv[1]) / folder.name)
    for path in sorted([*HERE.glob("*.py"), *HERE.glob("*/__main__.py")]):
        name = path.parent.name if path.name == "__main__.py" else path.name
        if path.parent == HERE and path.name == "__main__.py":
            continue
        says = (ast.get_docstring(ast.parse(path.read_text())) or "").split("\n\n")[0].replace("\n", " ")
        print(f"{name:24}  {says}")
    print(f"\nThey are in {sys.argv[1] if len(sys.argv) == 2 else HERE}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
