"""Writes the bill of materials: the libraries inside every file, with their versions, as CycloneDX 1.5 (JSON)."""

from __future__ import annotations

import io
import json
import re
import subprocess
import tarfile
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

__all__ = ["bill_of", "libraries_in"]

REQUIREMENTS = Path(__file__).parents[1] / "ducc0" / "requirements.txt"
#: Contents of the binaries of Debian packages in addition to their dependencies: headers of Debian, and ducc0's FFT.
_NUMERICS, _MESSAGES = ("ducc0", "libeigen3-dev"), ("nlohmann-json3-dev",)
INSIDE_PACKAGES = {
    "contactd": (*_NUMERICS, *_MESSAGES, "cppzmq-dev", "libcli11-dev", "libspdlog-dev"),
    "python3-contactd-local": (*_NUMERICS, *_MESSAGES),
    "libcontactd1": (*_MESSAGES, "cppzmq-dev"),
    "libcontactd-local1": (*_NUMERICS, *_MESSAGES, "cppzmq-dev"),
    "libcontactd-cntc0": _NUMERICS,
}
#: Contents of the wheels on PyPI on which ours depend. Versions are those of the wheel that pip chooses.
_BROUGHT = {"pyzmq": ("zeromq", "libsodium")}


def libraries_in(path: Path) -> Iterator[tuple[str, str]]:
    """Returns name and version of a file's contents or dependencies, as the file states them. Raises ValueError for a
    line of its sources without both."""
    for line in _lines_in(path):
        if found := re.fullmatch(r"([a-z0-9][a-z0-9.+-]*?)_(\S+?)\.orig\.tar\.\w+", line):  # an author's archive, from Debian
            yield found[1], found[2]
        elif found := re.fullmatch(r"([a-z0-9][a-z0-9.+-]*)-(\d[\w.]*?)(?:\.tar\.gz|, in \S+\.tar\.gz, .*)", line):  # one from PyPI, or in one
            yield found[1], found[2]
        elif found := re.fullmatch(r"([a-z0-9][a-z0-9.+-]*) (\S+)", line):  # a source package of Debian
            yield found[1], found[2]
        elif path.suffix != ".whl":  # their metadata have different lines
            raise ValueError(f"{path.name} lists {line!r}; a name and a version must be read from it")


def _sources_in(archive: Path | io.BytesIO) -> list[str]:
    with zipfile.ZipFile(archive) as opened:
        names = [name for name in opened.namelist() if name.lower().endswith("sources.txt")]
        return [line for name in names for line in opened.read(name).decode().splitlines()]


def _lines_in(path: Path) -> list[str]:
    if path.suffix == ".whl":
        with zipfile.ZipFile(path) as archive:
            (metadata,) = (name for name in archive.namelist() if name.endswith(".dist-info/METADATA"))
            lines = archive.read(metadata).decode().splitlines()
        asked = [f"{found[1]} {found[2]}" for line in lines if (found := re.match(r"Requires-Dist: ([\w-]+)([<>=][^;]+)$", line))]
        return [*asked, *(line[2:] for line in lines if line.startswith("- "))]
    if path.suffix in (".fmu", ".zip"):
        return _sources_in(path)
    if path.suffix == ".ssp":  # FMUs have a separate list
        with zipfile.ZipFile(path) as archive:
            return [line for name in archive.namelist() if name.endswith(".fmu") for line in _sources_in(io.BytesIO(archive.read(name)))]
    if path.name.endswith(".tar.gz"):
        with tarfile.open(path) as archive:
            files = [archive.extractfile(member) for member in archive if member.name.lower().endswith("/sources.txt") and ".egg-info/" not in member.name]
            return [line for file in files if file for line in file.read().decode().splitlines()]
    if path.suffix == ".deb":
        name, asked = (subprocess.run(["dpkg-deb", "-f", path, field], capture_output=True, text=True, check=True).stdout for field in ("Package", "Depends"))
        depends = re.findall(r"([a-z0-9][\w.+-]*)(?: \([<>=]+ ([^)]+)\))?", asked)
        linked = [f"{package} {_installed(package) or version or 'any'}" for package, version in depends]
        return [*linked, *(f"{package} {_installed(package) or 'any'}" for package in INSIDE_PACKAGES.get(name.strip(), ()))]
    return []


def _installed(package: str) -> str:
    """Returns the version installed on the build machine, with which the files were linked; None if it is not installed."""
    if package == "ducc0":
        found = re.search(r"ducc0==([\d.]+)", REQUIREMENTS.read_text())
        return found[1] if found else ""
    asked = subprocess.run(["dpkg-query", "-W", "-f", "${Version}\n", package], capture_output=True, text=True, check=False).stdout
    return asked.split("\n")[0]


def bill_of(folder: Path, version: str, timestamp: str) -> str:
    """Returns the bill of materials of a folder as text."""
    components: list[dict[str, Any]] = []
    dependencies: list[dict[str, Any]] = []
    known: dict[str, dict[str, Any]] = {}
    for path in sorted(path for path in folder.iterdir() if path.is_file()):
        libraries = sorted(set(libraries_in(path)))
        components.append({"type": "file", "bom-ref": path.name, "name": path.name, "version": version})
        for name, of in libraries:
            known.setdefault(f"{name}@{of}", {"type": "library", "bom-ref": f"{name}@{of}", "name": name, "version": of})
        dependencies.append({"ref": path.name, "dependsOn": [f"{name}@{of}" for name, of in libraries]})
    for one in [one for one in known.values() if one["name"] in _BROUGHT]:
        brought = [f"{name}@any" for name in _BROUGHT[one["name"]]]
        known |= {ref: {"type": "library", "bom-ref": ref, "name": ref.removesuffix("@any"), "version": "any"} for ref in brought}
        dependencies.append({"ref": one["bom-ref"], "dependsOn": brought})
    listed = {one["ref"] for one in dependencies}
    subject = {"type": "application", "bom-ref": "contactd", "name": "contactd", "version": version, "licenses": [{"license": {"id": "BSD-3-Clause"}}]}
    bill = {
        "bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
        "metadata": {"timestamp": timestamp, "component": subject},
        "components": [*components, *(known[name] for name in sorted(known))],
        "dependencies": [*dependencies, *({"ref": name} for name in sorted(known.keys() - listed))],
    }  # fmt: skip
    return json.dumps(bill, indent=1) + "\n"
