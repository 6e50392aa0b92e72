"""Makes contactd-daemon: daemon and builder with the modules that they load, their libraries, and the loader."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from elf import is_elf, links, own_folders
from licenses import Origins
from project import ROOT, copied, say, wheel

__all__ = ["daemon_wheel"]

HERE = Path(__file__).parent
PACKAGE = ROOT / "client" / "python" / "daemon" / "contactd_daemon"
PROGRAMS = ("contactd", "contactd-ic")


def daemon_wheel(bin: Path, ducc0: Path, version: str, folder: Path) -> Path:
    """Makes the wheel in `folder`. `bin` contains the programs, and beside them the modules (*.so) that they load on
    demand. `ducc0` is the folder made by packaging/ducc0/fetch.sh.

    Raises ValueError for a binary that looks for libraries in folders of its own.
    """
    modules = sorted(file for file in bin.glob("*.so") if is_elf(file))
    libraries: dict[str, Path] = {}
    for file in [*(bin / name for name in PROGRAMS), *modules]:
        if folders := own_folders(file):
            raise ValueError(f"{file} looks for its libraries in {folders}, of this machine")
        libraries |= links(file)
    loader = next(name for name in libraries if name.startswith("ld-linux"))
    origins = Origins(libraries.values())
    with copied(HERE / "daemon") as project:
        sources = [*origins.sources(), *(ducc0 / "sources.txt").read_text().splitlines()]
        say(project, version, sources, origins.texts() | {"ducc0.txt": (ducc0 / "licenses" / "ducc0").read_text()})
        package = project / "contactd_daemon"
        for name in ("bin", "lib", "programs"):
            (package / name).mkdir(parents=True)
        shutil.copy(PACKAGE / "__init__.py", package)
        for name in PROGRAMS:
            start = package / "bin" / name
            start.write_text((HERE / "start.sh").read_text().replace("LOADER", loader).replace("NAME", name))
            start.chmod(0o755)
            _strip(bin / name, package / "programs")
        for module in modules:
            _strip(module, package / "bin")
        for name, file in libraries.items():
            shutil.copy(file, package / ("bin" if name == loader else "lib") / name)
        return wheel(project, folder)


def _strip(file: Path, folder: Path) -> None:
    subprocess.run(["strip", "-o", folder / file.name, file], check=True)
