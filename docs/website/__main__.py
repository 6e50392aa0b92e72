"""Builds the documentation site from the pages, docstrings, headers and schemas of the repository. Warnings are errors.

    ./dev docs           (python3 docs/website --bin build/development/bin)
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from headers import FOLDER, ROOT, read_headers
from reference import SCHEMAS

from contactd import LocalDaemon


def write_schemas(folder: Path, bin_folder: Path) -> None:
    """Writes the messages' schemas and the OpenRPC document of the daemon as files next to the pages."""
    shutil.copytree(SCHEMAS, folder / "schema", ignore=lambda _, names: [name for name in names if not name.endswith(".json")])
    with LocalDaemon(bin_folder / "contactd") as daemon, daemon.client() as client:
        (folder / "openrpc.json").write_text(json.dumps(client.describe(), indent=1) + "\n")


def build(bin_folder: Path, output: Path) -> int:
    """Runs Sphinx and returns its status. The output of earlier builds is removed, so that deleted pages disappear."""
    work = output.with_name(output.name + "-work")
    for folder in (output, work):
        shutil.rmtree(folder, ignore_errors=True)
    read_headers(work)
    write_schemas(work / "beside", bin_folder)
    # Notebooks solve in process.
    paths = [str(bin_folder.parent / "lib/python"), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, "CONTACTD_SITE_WORK": str(work), "PYTHONPATH": os.pathsep.join(paths)}
    environment["PYTHONWARNINGS"] = "ignore"  # come from libraries about each other; Sphinx's own are about the pages
    sphinx = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html"]
    return subprocess.run([*sphinx, "-c", FOLDER, "-d", work / "doctrees", ROOT, output], env=environment).returncode


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, required=True, help="folder with contactd")
    parser.add_argument("--output", type=Path, default=ROOT / "build" / "docs", help="default: %(default)s")
    options = parser.parse_args()
    status = build(options.bin.resolve(), options.output.resolve())
    if status == 0:
        print(f"the site: {options.output / 'index.html'}")
    return status


if __name__ == "__main__":
    sys.exit(main())
