"""Reads whole regular files of limited size, and writes whole files."""

from __future__ import annotations

import errno
import hashlib
import math
import os
import secrets
import stat
import zipfile
from pathlib import Path
from typing import IO, Any

import numpy as np

__all__ = ["MOST_BYTES", "arrays_of", "check_npy", "digest_of", "read_whole", "write_whole"]

MOST_BYTES = 1 << 34  #: Largest size of tables and solutions.
_KINDS = ((stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"), (stat.S_ISSOCK, "a socket"),
          (stat.S_ISFIFO, "a named pipe"))  # fmt: skip
_OPEN_FILES = ("/dev/fd", "/proc/self/fd")  #: Folder in which a shell puts the output of <(COMMAND).
_PIECE = 1 << 20
#: Available flags against waiting for a pipe, terminals, inheritance, and converted line ends.
_OPENED = sum(getattr(os, name, 0) for name in ("O_NONBLOCK", "O_NOCTTY", "O_CLOEXEC", "O_NOINHERIT", "O_BINARY"))


def read_whole(path: str | os.PathLike[str], most: int) -> bytes:
    """Returns the content of a file of at most `most` bytes.

    Raises OSError with the reason as `strerror`, also for a file that is not regular: a device may have no end, and
    reading a named pipe may wait forever.
    """
    name = os.fspath(path)
    try:
        # Opening a named pipe could also wait.
        opened = os.open(name, os.O_RDONLY | _OPENED)
    except ValueError:  # The name contains a null character.
        raise OSError(errno.EINVAL, "this is not the name of a file", name) from None
    try:
        status = os.fstat(opened)
        if stat.S_ISDIR(status.st_mode):
            raise OSError(errno.EISDIR, os.strerror(errno.EISDIR), name)
        for is_kind, kind in _KINDS:
            if is_kind(status.st_mode) and not (kind == "a named pipe" and str(Path(name).absolute().parent) in _OPEN_FILES):
                raise OSError(errno.EINVAL, f"it is {kind}; it must be a file", name)
        if stat.S_ISFIFO(status.st_mode):  # Others remain non-blocking, because files of /proc may wait, too.
            os.set_blocking(opened, True)
    except BaseException:
        os.close(opened)
        raise
    size = status.st_size
    try:
        with open(opened, "rb") as file:
            pieces: list[bytes] = []
            requested = max(_PIECE, size + 1)
            while size <= most and (piece := _piece(file, requested, name)):
                pieces.append(piece)
                size, requested = sum(map(len, pieces)), _PIECE
        if size > most:
            raise OSError(errno.EFBIG, f"it has {size} bytes or more, but at most {most} are read", name)
        return b"".join(pieces)
    except MemoryError:
        raise OSError(errno.ENOMEM, f"it has {size} bytes or more, which do not fit into memory", name) from None


def _piece(file: IO[bytes], count: int, name: str) -> bytes:
    """Returns the next bytes. A read error names the file, like an error of opening."""
    try:
        return file.read(count)
    except OSError as error:
        error.filename = name
        raise


def digest_of(path: str | os.PathLike[str], most: int = 1 << 29) -> str:
    """Returns the digest of the content of a file; empty if it cannot be read completely."""
    try:
        return hashlib.sha256(read_whole(path, most)).hexdigest()
    except OSError:
        return ""


def check_npy(file: IO[bytes], size: int, kinds: str = "fiub") -> None:
    """Raises ValueError if a numpy file (.npy) with `size` bytes does not contain the array of its header, or an array
    of another kind than `kinds` (numpy.dtype.kind), before memory is allocated. Does not restore the position in the
    file.
    """
    npy: Any = np.lib.format
    version = npy.read_magic(file)
    if version not in ((1, 0), (2, 0)):
        raise ValueError(f"it has the version {version[0]}.{version[1]}, which arrays of numbers do not use")
    read = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
    try:
        shape, _, dtype = read(file)
    except Exception:  # numpy and Python's parser may raise any exception.
        raise ValueError("its header is not one of numpy") from None
    if dtype.kind not in kinds:
        raise ValueError(f"its type is {dtype}; it must be a type of real numbers")
    if any(extent < 0 for extent in shape):
        raise ValueError(f"its header has the invalid shape {list(shape)}")
    promised, there = math.prod(shape) * dtype.itemsize, size - file.tell()
    if promised != there:
        raise ValueError(f"its header announces {promised} bytes of shape {list(shape)}, but {there} follow")


def arrays_of(archive: IO[bytes]) -> dict[str, np.ndarray[Any, Any]]:
    """Returns the arrays of a numpy archive (.npz) of numbers and texts. Nothing in it is unpickled.

    Raises the exceptions of zipfile and numpy for a damaged archive. Raises ValueError, before memory is allocated, if
    a member does not match its header, or if all members are far larger than the file: numbers cannot be compressed a
    hundredfold.
    """
    size = archive.seek(0, os.SEEK_END)
    with zipfile.ZipFile(archive) as opened:
        members = opened.infolist()
        if sum(member.file_size for member in members) > 1_000_000 + 100 * size:
            raise ValueError("it would need more than a hundred times its size")
        for member in members:
            with opened.open(member) as file:
                check_npy(file, member.file_size, "fiubU")
    archive.seek(0)
    loaded = np.load(archive, allow_pickle=False)
    return {member: loaded[member] for member in loaded.files}


def write_whole(path: str | os.PathLike[str], write: Any) -> None:
    """Writes a file under another name first, so that it is never incomplete; if several programs write it at once, the
    last one wins. `write` receives the open file, which it may also read and seek. Links keep their target, and special
    files such as /dev/stdout are written directly.
    """
    place = Path(path)
    if place.exists() and not place.is_file():
        with place.open("wb") as file:
            write(file)
        return
    place = Path(os.path.realpath(place))
    part = Path(f"{place}.{secrets.token_hex(4)}.part")  # a name for this call only: others may write the same file
    try:
        with open(os.open(part, os.O_RDWR | os.O_CREAT | os.O_EXCL | _OPENED, 0o666), "w+b") as file:
            write(file)
        part.replace(place)
    except OSError as error:
        if error.filename in (None, str(part)):
            error.filename = os.fspath(path)
        raise
    finally:
        part.unlink(missing_ok=True)
