"""contactd-daemon: daemon and builder, modules that they open, all libraries of these, and the loader."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

from elf import is_elf, links, own_folders
from licenses import Origins
from wheel_file import Wheel

__all__ = ["daemon_wheel"]

HERE = Path(__file__).parent
PACKAGE = HERE.parents[1] / "client" / "python" / "daemon" / "contactd_daemon"
PROGRAMS = ("contactd", "contactd-ic")
#: It brings its own glibc, so that the machine's may be as old as its kernel lets it be.
TAG = "py3-none-manylinux_2_17_x86_64"


def daemon_wheel(folder: Path, version: str, license_text: str) -> Wheel:
    """`folder` has the programs, and beside them the modules (*.so) that they open when they are wanted.

    Raises ValueError for what looks for libraries in folders of its own.
    """
    modules = sorted(file for file in folder.glob("*.so") if is_elf(file))
    ours = [*(folder / name for name in PROGRAMS), *modules]
    libraries: dict[str, Path] = {}
    for file in ours:
        if folders := own_folders(file):
            raise ValueError(f"{file} looks for its libraries in {folders}, of this machine")
        libraries |= links(file)
    loader = next(name for name in libraries if name.startswith("ld-linux"))
    origins = Origins(libraries.values())
    wheel = Wheel(
        "contactd-daemon", version, "Daemon and builder of contactd, with all libraries that they need",
        "GPL-3.0-or-later", TAG, _readme(origins),
    )  # fmt: skip
    wheel.files["contactd_daemon/__init__.py"] = (PACKAGE / "__init__.py").read_bytes()
    for name in PROGRAMS:
        start = (HERE / "start.sh").read_text().replace("LOADER", loader).replace("NAME", name)
        wheel.files[f"contactd_daemon/bin/{name}"] = start.encode()
        wheel.files[f"contactd_daemon/programs/{name}"] = _stripped(folder / name)
        wheel.programs |= {f"contactd_daemon/bin/{name}", f"contactd_daemon/programs/{name}"}
    for module in modules:
        wheel.files[f"contactd_daemon/bin/{module.name}"] = _stripped(module)
    for name, file in sorted(libraries.items()):
        place = "bin" if name == loader else "lib"
        wheel.files[f"contactd_daemon/{place}/{name}"] = file.read_bytes()
    wheel.programs.add(f"contactd_daemon/bin/{loader}")
    wheel.scripts = {"contactd": "contactd_daemon:_contactd", "contactd-ic": "contactd_daemon:_contactd_ic"}
    wheel.licenses = {"contactd.txt": license_text, **origins.texts()}
    return wheel


def _stripped(file: Path) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        stripped = Path(folder) / file.name
        subprocess.run(["strip", "-o", stripped, file], check=True)
        return stripped.read_bytes()


def _readme(origins: Origins) -> str:
    sources = "\n".join(f"- {source}" for source in origins.sources())
    return (HERE / "daemon.md").read_text() + f"\n{sources}\n"
