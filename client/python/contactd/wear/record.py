"""Stores the steps of an evolution in one HDF5 file, which is always complete."""

from __future__ import annotations

import io
import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from .._version import __version__
from ..errors import invalid
from ..files.whole import write_whole
from .steps import StepFatigue, WornStep
from .study import WearStudy

__all__ = ["read_record", "write_record"]

_NUMBERS = ("distance", "area", "removed", "T_gamma", "T_gamma_with_spin", "pmax", "mean_pressure", "smoothing", "stage")
_FATIGUE = ("dang_van", "limits", "contacts")


def write_record(path: str | os.PathLike[str], study: WearStudy, steps: Sequence[WornStep]) -> None:
    """Writes all steps: a dataset for each field with a row per step, `steps/N` with the depths of step N, and the
    study. The existing file is replaced only when the new one is complete. Needs h5py.
    """
    import h5py

    content = io.BytesIO()
    with h5py.File(content, "w") as file:  # Without tracking of the order, which would store the time of day.
        file.attrs.update(contactd=__version__, study=_described(study), wears=study.wears, unit=study.unit)
        file.attrs["sources"] = json.dumps([f"{one['name']}: {one['source']}" for one in study.sourced()])
        _write(file, steps)
        if steps and steps[0].rail is not None:
            _write(file.create_group("rail"), [step.of("rail") for step in steps])

    def write(into: Any) -> None:
        into.write(content.getvalue())
        into.flush()
        os.fsync(into.fileno())

    write_whole(path, write)


def _write(group: Any, steps: Sequence[WornStep]) -> None:
    if len({step.points.shape for step in steps}) == 1:
        group.create_dataset("points", data=np.stack([step.points for step in steps]))
    for name in _NUMBERS:
        group.create_dataset(name, data=np.array([getattr(step, name) for step in steps]))
    for step in steps:
        one = group.create_group(f"steps/{step.number:06d}")
        for name in ("edges", "depths", "points"):
            one.create_dataset(name, data=getattr(step, name))
        one.attrs.update(groups=json.dumps(step.groups), warnings=json.dumps(step.warnings), ended_by=step.ended_by)
        if step.fatigue is not None:
            tired = one.create_group("fatigue")
            for name in _FATIGUE:
                tired.create_dataset(name, data=getattr(step.fatigue, name))
            for name, values in step.fatigue.damages.items():
                tired.create_dataset(f"damages/{name.replace('/', ' ')}", data=values)


def read_record(path: str | os.PathLike[str], study: WearStudy | None = None) -> list[WornStep]:
    """Returns the steps of a file by write_record; none if there is no file. Raises InvalidArgument if they belong to
    another study than `study`, apart from its end.
    """
    import h5py

    if not Path(path).exists():
        return []
    with h5py.File(path, "r") as file:
        if study is not None and (described := _described(study)) != file.attrs["study"]:
            names = _differences(json.loads(described), json.loads(file.attrs["study"]))
            raise invalid("study", f"differs in {', '.join(names)} from the one whose steps are in {os.fspath(path)}; give another file")
        steps = _read(file)
        return [one.beside(rail) for one, rail in zip(steps, _read(file["rail"]))] if "rail" in file else steps


def _read(file: Any) -> list[WornStep]:
    numbers = {name: file[name][()] for name in _NUMBERS}
    steps = []
    for i, name in enumerate(sorted(file["steps"])):
        group = file["steps"][name]
        tired = group.get("fatigue")
        steps.append(
            WornStep(
                number=int(name), points=group["points"][()] if "points" in group else file["points"][i], edges=group["edges"][()],
                depths=group["depths"][()], groups=json.loads(group.attrs["groups"]), warnings=tuple(json.loads(group.attrs["warnings"])),
                ended_by=str(group.attrs.get("ended_by", "")),
                fatigue=None if tired is None else _read_fatigue(tired),
                **_numbers_at(numbers, i),
            )
        )  # fmt: skip
    return steps


def _numbers_at(numbers: dict[str, Any], index: int) -> dict[str, Any]:
    return {name: int(values[index]) if name == "stage" else float(values[index]) for name, values in numbers.items()}


def _read_fatigue(group: Any) -> StepFatigue:
    damages = {name: values[()] for name, values in group["damages"].items()} if "damages" in group else {}
    return StepFatigue(damages, **{name: group[name][()] for name in _FATIGUE})


def _described(study: WearStudy) -> str:
    """Returns the study without its end."""
    return json.dumps(study.described(), sort_keys=True, default=lambda value: np.asarray(value).tolist())


def _differences(one: dict[str, Any], other: dict[str, Any]) -> list[str]:
    return [name for name in one if one[name] != other.get(name)] or ["its form"]
