"""Steps of an evolution in one HDF5 file, which is always whole."""

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
from ..values.wheel_rail.params import state_params
from .steps import WornStep
from .study import WearStudy

__all__ = ["read_record", "write_record"]

_NUMBERS = ("distance", "area", "removed", "T_gamma", "T_gamma_with_spin", "pmax", "mean_pressure", "smoothing")


def write_record(path: str | os.PathLike[str], study: WearStudy, steps: Sequence[WornStep]) -> None:
    """Writes all steps: a dataset a field with a row a step, `steps/N` with the depths of step N, and what was asked for. The
    file that was there stays until the new one is whole. Needs h5py."""
    import h5py

    content = io.BytesIO()
    with h5py.File(content, "w", track_order=True) as file:
        file.attrs.update(contactd=__version__, study=_described(study), wears=study.wears, unit="km" if study.wears == "wheel" else "passages")
        file.create_dataset("points", data=np.stack([step.points for step in steps]))
        for name in _NUMBERS:
            file.create_dataset(name, data=np.array([getattr(step, name) for step in steps]))
        for step in steps:
            group = file.create_group(f"steps/{step.number:06d}")
            group.create_dataset("edges", data=step.edges)
            group.create_dataset("depths", data=step.depths)
            group.attrs.update(groups=json.dumps(step.groups), warnings=json.dumps(step.warnings))

    def write(into: Any) -> None:
        into.write(content.getvalue())
        into.flush()
        os.fsync(into.fileno())

    write_whole(path, write)


def read_record(path: str | os.PathLike[str], study: WearStudy | None = None) -> list[WornStep]:
    """The steps of a file that write_record wrote; none where there is no file. Raises InvalidArgument where they are of
    another study than `study`, but for how far that goes."""
    import h5py

    if not Path(path).exists():
        return []
    with h5py.File(path, "r") as file:
        if study is not None and (described := _described(study)) != file.attrs["study"]:
            names = _differences(json.loads(described), json.loads(file.attrs["study"]))
            raise invalid("study", f"differs in {', '.join(names)} from the one whose steps {os.fspath(path)} has; name another file")
        numbers = {name: file[name][()] for name in _NUMBERS}
        points = file["points"][()]
        steps = []
        for i, name in enumerate(sorted(file["steps"])):
            group = file["steps"][name]
            steps.append(
                WornStep(
                    number=int(name), points=points[i], edges=group["edges"][()], depths=group["depths"][()],
                    groups=json.loads(group.attrs["groups"]), warnings=tuple(json.loads(group.attrs["warnings"])),
                    **{field: float(values[i]) for field, values in numbers.items()},
                )
            )
    return steps


def _described(study: WearStudy) -> str:
    """What was asked for, but for where it ends."""
    states = [
        {"state": state_params(one.state, "state"), "weight": one.weight, "group": one.group, "mu": one.mu} for one in study.states
    ]
    described = {
        "setup": study.setup_params(), "states": states, "wears": study.wears, "law": study.law_params(), "depth": study.depth,
        "distance": study.distance, "smoothing": study.smoothing, "energy": study.energy, "spacing": study.spacing,
    }  # fmt: skip
    return json.dumps(described, sort_keys=True, default=lambda value: np.asarray(value).tolist())


def _differences(one: dict[str, Any], other: dict[str, Any]) -> list[str]:
    return [name for name in one if one[name] != other.get(name)] or ["its form"]
