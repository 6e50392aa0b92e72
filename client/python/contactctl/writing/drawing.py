"""Writes pictures to files, marked as written by contactd."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from contactd.files.marks import written_by
from contactd.files.whole import write_whole

__all__ = ["save_animation", "save_picture"]

_NAMES = {".png": "Software", ".svg": "Creator", ".pdf": "Creator"}
_END_OF_GIF = b";"


def save_picture(path: Path, figure: Any, **options: Any) -> None:
    """Writes a matplotlib figure, never incomplete; options are those of savefig."""
    metadata = {_NAMES[path.suffix]: written_by()}
    write_whole(path, lambda file: figure.savefig(file, format=path.suffix[1:], metadata=metadata, **options))


def save_animation(path: Path, content: bytes) -> None:
    """Writes a GIF with the mark as a comment at its end."""
    mark = written_by().encode()
    comment = b"!\xfe" + bytes([len(mark)]) + mark + b"\0"
    write_whole(path, lambda file: file.write(content.removesuffix(_END_OF_GIF) + comment + _END_OF_GIF))
