"""Answers to files: JSON, HDF5 or a picture, by the ending of the name."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import click

from .files import write_text
from .output import plain_json

__all__ = ["ARRAYS", "check_outputs", "save"]

#: Arrays over the grid that an answer may have.
ARRAYS = ("element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y")
_PICTURES = (".png", ".svg", ".pdf")


def check_outputs(paths: Iterable[str]) -> list[Path]:
    """Before anything is solved: whether each can be written. Raises click.UsageError."""
    checked = [Path(path) for path in paths]
    for path in checked:
        if path.suffix not in (".json", ".h5", *_PICTURES):
            raise click.UsageError(f"--output {path}: the name must end in .json, .h5, .png, .svg or .pdf.")
        if not path.absolute().parent.is_dir():
            raise click.UsageError(f"--output {path}: there is no folder {path.parent}.")
        if path.suffix == ".h5":
            _need("h5py", "HDF5 files", "python3-h5py")
        elif path.suffix in _PICTURES:
            _need("matplotlib", "pictures", "python3-matplotlib")
    return checked


def _need(module: str, what: str, package: str) -> None:
    try:
        __import__(module)
    except ImportError:
        advice = f"Writing {what} needs {module}: pip install {module}, or on Debian {package}."
        raise click.UsageError(advice) from None


def save(path: Path, asked: dict[str, Any], answer: dict[str, Any], draw: Callable[[Any], None]) -> None:
    """`asked` and `answer` are those of the wire; `draw` fills a figure of matplotlib."""
    if path.suffix == ".json":
        write_text(path, json.dumps(plain_json(answer), allow_nan=False) + "\n")
    elif path.suffix == ".h5":
        _write_hdf5(path, asked, answer)
    else:
        from matplotlib.figure import Figure

        figure = Figure(layout="constrained")
        draw(figure)
        figure.savefig(path, dpi=150, bbox_inches="tight")


def _write_hdf5(path: Path, asked: dict[str, Any], answer: dict[str, Any]) -> None:
    """Objects are groups, arrays datasets, all else attributes; the request is JSON in the attribute `asked`."""
    import h5py

    part = Path(f"{path}.part")
    try:
        with h5py.File(part, "w") as file:
            file.attrs["asked"] = json.dumps(plain_json(asked))
            _fill(file, answer)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def _fill(group: Any, members: dict[str, Any]) -> None:
    for name, value in members.items():
        if value is None:
            continue
        if isinstance(value, dict):
            _fill(group.create_group(name), value)
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            for index, member in enumerate(value):
                _fill(group.create_group(f"{name}/{index}"), member)
        elif hasattr(value, "shape"):
            group.create_dataset(name, data=value)
        else:
            group.attrs[name] = json.dumps(value) if isinstance(value, list) else value
