"""Collects the licences of the contents of a wheel: the copyright file of each Debian package, and the texts it names."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable
from pathlib import Path

__all__ = ["Origins"]

_COMMON = Path("/usr/share/common-licenses")


class Origins:
    """Finds the packages that contain files, with their licences and their sources."""

    def __init__(self, files: Iterable[Path]) -> None:
        owners = subprocess.run(["dpkg-query", "-S", *map(str, files)], capture_output=True, text=True, check=True).stdout
        #: Binary packages, sorted.
        self.packages = sorted({line.split(":")[0] for line in owners.splitlines()})

    def sources(self) -> list[str]:
        """Returns the source packages with their versions in Debian: the source code in the sense of the GPL."""
        asked = ["dpkg-query", "-W", "-f", "${source:Package} ${source:Version}\n", *self.packages]
        return sorted(set(subprocess.run(asked, capture_output=True, text=True, check=True).stdout.splitlines()))

    def texts(self) -> dict[str, str]:
        """Returns name -> text: for each package its copyright, and the common licences to which these refer."""
        found = {package: _copyright(package) for package in self.packages}
        common = re.findall(rf"{_COMMON}/([A-Za-z0-9.+-]*[A-Za-z0-9])", "\n".join(found.values()))
        for name in sorted({name for name in common if (_COMMON / name).is_file()}):
            found[f"common-{name}"] = (_COMMON / name).read_text()
        return {f"{name}.txt": text for name, text in found.items()}


def _copyright(package: str) -> str:
    return Path("/usr/share/doc", package, "copyright").read_text(errors="replace")
