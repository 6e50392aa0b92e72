"""The binary wheels of contactd: python3 packaging/wheels local MODULE STATIC FOLDER, or daemon BIN FOLDER.

MODULE is the contactd_local of the preset wheel, STATIC what static_libraries.sh has made, BIN has the programs; the wheel
comes into FOLDER. ./dev wheel does all of it.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from daemon_wheel import daemon_wheel
from local_wheel import local_wheel

ROOT = Path(__file__).parents[2]


def main() -> None:
    parser = argparse.ArgumentParser(prog="wheels", description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    kinds = parser.add_subparsers(dest="kind", required=True)
    local = kinds.add_parser("local")
    local.add_argument("module", type=Path)
    local.add_argument("static", type=Path)
    daemon = kinds.add_parser("daemon")
    daemon.add_argument("bin", type=Path)
    for kind in (local, daemon):
        kind.add_argument("folder", type=Path)
    options = parser.parse_args()

    said = (ROOT / "client" / "python" / "contactd" / "_version.py").read_text()
    version = re.search(r'__version__ = "(.+)"', said)[1]
    license_text = (ROOT / "LICENSE").read_text()
    if options.kind == "local":
        wheel = local_wheel(options.module, options.static, version, license_text)
    else:
        wheel = daemon_wheel(options.bin, version, license_text)
    options.folder.mkdir(parents=True, exist_ok=True)
    print(wheel.write(options.folder))


if __name__ == "__main__":
    main()
