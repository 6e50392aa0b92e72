"""Writes an FMU, a zip of files, with reproducible bytes."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Mapping
from pathlib import Path

__all__ = ["write_fmu"]

_EPOCH = (1980, 1, 1, 0, 0, 0)


def write_fmu(path: Path, files: Mapping[str, bytes]) -> Path:
    """Writes `files` (name -> content) and atomically replaces an existing archive. Returns `path`."""
    half = path.with_suffix(".half")
    with zipfile.ZipFile(half, "w", zipfile.ZIP_DEFLATED, compresslevel=6) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, _EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if name.endswith(".so") else 0o100644) << 16
            archive.writestr(entry, data)
    os.replace(half, path)
    return path
