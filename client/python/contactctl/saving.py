"""Writes answers to files: JSON, HDF5 or a picture, by extension."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, get_args

import click

from contactd import ContactSolution, MissingExtra
from contactd.values.generated.result import Field
from contactd.wheel_rail import WheelRailSolution

from .files import writable, write_text
from .output import plain_json
from .writing.drawing import save_picture

__all__ = ["ARRAYS", "check_outputs", "check_picture", "is_picture", "need", "save"]

#: Possible arrays over the grid in an answer.
ARRAYS: tuple[str, ...] = get_args(Field)
_PICTURES = (".png", ".svg", ".pdf")


def check_outputs(paths: Iterable[str]) -> list[Path]:
    """Checks before a solve that each file can be written. Raises click.UsageError."""
    checked = []
    for name in paths:
        path = Path(name)
        if path.suffix not in (".json", ".h5", *_PICTURES):
            raise click.UsageError(f"--output {path}: the name must end in .json, .h5, .png, .svg or .pdf.")
        checked.append(writable("--output", name))
        if path.suffix == ".h5":
            need("h5py", "HDF5 files", "hdf5")
        elif path.suffix in _PICTURES:
            _need_matplotlib()
    return checked


def check_picture(option: str, name: str) -> Path:
    """Checks before a solve that a picture can be written. Raises click.UsageError."""
    if Path(name).suffix not in _PICTURES:
        raise click.UsageError(f"{option} {name}: the name must end in {', '.join(_PICTURES)}.")
    path = writable(option, name)
    _need_matplotlib()
    return path


def is_picture(path: Path) -> bool:
    """Returns whether the file is a picture."""
    return path.suffix in _PICTURES


def _need_matplotlib() -> None:
    need("matplotlib", "pictures", "pictures")


def need(module: str, what: str, extra: str) -> None:
    """Raises click.UsageError if the module of an extra is not installed."""
    try:
        __import__(module)
    except ImportError:
        raise click.UsageError(str(MissingExtra(f"Writing {what}", module, extra, f"python3-{module}"))) from None


def save(path: Path, answer: dict[str, Any], read: Callable[[], ContactSolution | WheelRailSolution]) -> None:
    """Saves `answer` as on the wire; `read` converts it to the Python solution."""
    if path.suffix == ".json":
        write_text(path, json.dumps(plain_json(answer), allow_nan=False) + "\n")
    elif path.suffix == ".h5":
        read().save(path)
    else:
        from matplotlib.figure import Figure

        solution = read()
        if isinstance(solution, WheelRailSolution):
            figure = solution.plot()
        else:
            figure = Figure(figsize=(6.8, 5.4), layout="constrained")
            solution.plot(figure.subplots())
        save_picture(path, figure, dpi=150, bbox_inches="tight")
