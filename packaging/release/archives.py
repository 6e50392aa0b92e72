"""Makes archives with reproducible bytes: sorted, with one time, and without names of users."""

from __future__ import annotations

import gzip
import io
import os
import tarfile
import time
import zipfile
from collections.abc import Mapping
from pathlib import Path

__all__ = ["epoch", "files_of", "write_tar", "write_zip"]


def epoch() -> int:
    """Returns the time of all files: SOURCE_DATE_EPOCH."""
    return int(os.environ["SOURCE_DATE_EPOCH"])


def files_of(folder: Path, within: str = "") -> dict[str, bytes]:
    """Returns name -> content of all files of a folder, below `within`."""
    return {f"{within}{path.relative_to(folder).as_posix()}": path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def write_tar(path: Path, files: Mapping[str, bytes], links: Mapping[str, str] | None = None) -> Path:
    """Writes a .tar.gz in which programs and libraries (.so) are executable. `links` are symbolic links with their
    targets."""
    links = links or {}
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name in sorted([*files, *links]):
            entry = tarfile.TarInfo(name)
            entry.mtime = epoch()
            if name in links:
                entry.type, entry.linkname, entry.mode = tarfile.SYMTYPE, links[name], 0o777
                archive.addfile(entry)
                continue
            entry.size = len(files[name])
            entry.mode = 0o755 if files[name][:4] == b"\x7fELF" or files[name][:2] == b"#!" else 0o644
            archive.addfile(entry, io.BytesIO(files[name]))
    with path.open("wb") as file, gzip.GzipFile("", "wb", 9, file, mtime=epoch()) as compressed:
        compressed.write(packed.getvalue())
    return path


def write_zip(path: Path, files: Mapping[str, bytes]) -> Path:
    """Writes a .zip."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, time.gmtime(max(epoch(), 315532800))[:6])
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o100644 << 16
            archive.writestr(entry, files[name])
    return path
