"""Makes the wheels: python3 packaging/wheels client FOLDER, local MODULE STATIC DUCC0 FOLDER, or daemon BIN DUCC0
FOLDER.

MODULE is the contactd_local of the preset wheel. STATIC is the folder made by static_libraries.sh, and DUCC0 the one
made by packaging/ducc0/fetch.sh. BIN contains the programs. The wheel is written to FOLDER. ./dev wheel does all of
this.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from daemon_wheel import daemon_wheel
from local_wheel import local_wheel
from project import ROOT, copied, wheel


def main() -> None:
    parser = argparse.ArgumentParser(prog="wheels", description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    kinds = parser.add_subparsers(dest="kind", required=True)
    client, local, daemon = (kinds.add_parser(kind) for kind in ("client", "local", "daemon"))
    local.add_argument("module", type=Path)
    local.add_argument("static", type=Path)
    daemon.add_argument("bin", type=Path)
    for kind in (local, daemon):
        kind.add_argument("ducc0", type=Path)
    for kind in (client, local, daemon):
        kind.add_argument("folder", type=Path)
    options = parser.parse_args()

    source = (ROOT / "client" / "python" / "contactd" / "_version.py").read_text()
    version = re.search(r'__version__ = "(.+)"', source)[1]
    if options.kind == "client":
        with copied(ROOT / "client" / "python") as project:
            made = wheel(project, options.folder)
    elif options.kind == "local":
        made = local_wheel(options.module, [options.static, options.ducc0], version, options.folder)
    else:
        made = daemon_wheel(options.bin, options.ducc0, version, options.folder)
    print(made)


if __name__ == "__main__":
    main()
