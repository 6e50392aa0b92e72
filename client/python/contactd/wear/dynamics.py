"""Runs the loop of vehicle dynamics and wear: a simulation on the current profiles yields states, wear steps change
the profiles, and the simulation is repeated.
"""

from __future__ import annotations

import csv
import io
import math
import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import InvalidArgument, invalid
from ..files.marks import can_be_written_over, written_by
from ..files.number_text import number_in
from ..files.profile_text import format_profile
from ..files.whole import write_whole
from .evolution import evolve, place_of
from .measures import conicities
from .placed import WheelRailClient
from .states import WeightedState, read_states
from .steps import WornStep
from .study import WearStudy

__all__ = ["Dynamics", "evolve_with", "states_of_stage", "write_states"]

Array = npt.NDArray[np.float64]
#: Maps the profiles (y, z) of worn bodies, by "wheel" and "rail", and the distance to states.
StatesOf = Callable[[Mapping[str, Array], float], Sequence[WeightedState]]

_LONGEST_NUMBER = 40  #: characters
_LINES = 5  #: Number of the last characters of a program's output.


@dataclass(frozen=True)
class Dynamics:
    """Describes the source of states, and the criteria for new ones.

    Attributes:
        states: A function of the profiles of worn bodies, (y, z) by "wheel" and "rail", and the distance. Or a program
            with its arguments, called with a folder as last argument. The folder contains wheel.prw and rail.prr of
            worn bodies, and distance.txt with the km or passages. The program writes states.csv there, which
            read_states reads.
        folder: Contains a folder for each stage, stage-000 and so on, with its profiles and states. A stage with states
            is not run again.
        depth: Depth after which new states are requested (mm): the sum of the largest depths of the steps.
        conicity: Change of the equivalent conicity at 3 mm after which new states are requested; None: no limit.
        distance: Distance after which new states are requested (km or passages); None: no limit.
    """

    states: StatesOf | Sequence[str]
    folder: Path
    depth: float = 0.1
    conicity: float | None = 0.02
    distance: float | None = None

    def __post_init__(self) -> None:
        """Raises InvalidArgument naming an invalid limit."""
        for name in ("depth", "conicity", "distance"):
            value = getattr(self, name)
            if not (value is None and name != "depth") and not (math.isfinite(value) and value > 0):
                raise invalid(f"dynamics.{name}", f"is {value}; it must be positive")


def evolve_with(
    client: WheelRailClient, study: WearStudy, dynamics: Dynamics, steps: Sequence[WornStep] | None = None, **options: Any
) -> Iterator[WornStep]:
    """Evolves like evolve, with its options, but takes the states from dynamics, stage by stage. The states of the
    study must be those of the first stage (`states_of_stage`); nothing else depends on them. Raises InvalidArgument
    ("dynamics") if a program fails.
    """
    place, done = place_of(client, study), list(steps or ())
    if not done:
        done += _first(evolve(client, study, None, **options))
        yield done[0]
    while done[-1].distance < study.until:
        stage = done[-1].stage
        start = max((step for step in done if step.stage < stage), key=lambda step: step.number, default=done[0])
        conicity = _conicity(client, study, place, start) if dynamics.conicity is not None else 0.0
        if done[-1].number > start.number and _is_due(client, study, place, dynamics, done, start, conicity):
            stage, start = stage + 1, done[-1]
            conicity = _conicity(client, study, place, start) if dynamics.conicity is not None else 0.0
        points: dict[str, Array] = {part: start.of(part).points for part in study.parts}
        of_stage = replace(study, states=states_of_stage(dynamics, stage, points, start.distance))
        for step in evolve(client, of_stage, done, **options):
            made = replace(step, stage=stage)
            done.append(made)
            yield made
            if _is_due(client, study, place, dynamics, done, start, conicity):
                break


def states_of_stage(dynamics: Dynamics, stage: int, points: Mapping[str, Array], distance: float) -> list[WeightedState]:
    """Returns the states of a stage: those of its folder, or new ones, which are then stored. Raises InvalidArgument
    ("dynamics").
    """
    folder = dynamics.folder / f"stage-{stage:03d}"
    path = folder / "states.csv"
    if path.is_file():
        return read_states(path)
    folder.mkdir(parents=True, exist_ok=True)
    for part in ("wheel", "rail"):
        if part in points:
            ending = ".prw" if part == "wheel" else ".prr"
            _write(folder / f"{part}{ending}", format_profile(points[part], part, ending, [f"{written_by()}: after {distance!r}"]))
    _write(folder / "distance.txt", f"{distance!r}\n")
    if callable(dynamics.states):
        write_states(path, dynamics.states(points, distance))
        return read_states(path)
    program = [*dynamics.states, str(folder)]
    try:
        ended = subprocess.run(program, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
    except OSError as error:
        raise invalid("dynamics", f"cannot be started: {' '.join(program)}: {error.strerror}") from None
    if ended.returncode != 0:
        last = " ".join(ended.stderr.splitlines()[-_LINES:])
        path.unlink(missing_ok=True)
        raise invalid("dynamics", f"ended with {ended.returncode}: {' '.join(program)}: {last or 'no output'}")
    if not path.is_file():
        raise invalid("dynamics", f"wrote no states: {' '.join(program)} must leave {path}")
    try:
        return read_states(path)
    except InvalidArgument as error:  # The program can be corrected and called again.
        kept = path.replace(folder / "states.refused.csv")
        raise invalid("dynamics", f"wrote states that cannot be read, which are in {kept}: {error.message}") from None


def write_states(path: Path, states: Sequence[WeightedState]) -> None:
    """Writes a CSV file for read_states, with the columns in which a state differs from the default."""
    if not states:
        raise invalid("states", "are empty; give at least one state")
    rows = [_flat(one.state) for one in states]
    if any(row["position.z"] is not None for row in rows):
        for row in rows:
            if row["Fz"] is not None:  # The height is computed, starting from 0.
                row["position.z"] = row["position.z"] or 0.0
    plain = _flat(type(states[0].state)())
    names = [name for name in rows[0] if any(row[name] != plain[name] for row in rows)]
    if mixed := next((name for name in names if len({row[name] is None for row in rows}) > 1), None):
        raise invalid("states", f"have {mixed} in some states only; a file has a column for all of them")
    written = io.StringIO()
    table = csv.writer(written, lineterminator="\n", quoting=csv.QUOTE_NONNUMERIC)  # for any group name
    table.writerow([*names, "weight", "group", "mu"])
    for one, row in zip(states, rows):
        numbers = [float(row[name]) for name in names]
        table.writerow([*numbers, float(one.weight), " ".join(one.group.splitlines()), "" if one.mu is None else float(one.mu)])
    write_whole(path, lambda into: into.write(written.getvalue().encode()))


def _write(path: Path, text: str) -> None:
    """Writes a file. Raises InvalidArgument if a file of another kind exists."""
    is_number = path.name == "distance.txt" and path.is_file() and number_in(path.read_text(errors="replace")[:_LONGEST_NUMBER].strip()) is not None
    if path.is_symlink() or not (is_number or can_be_written_over(path)):
        raise invalid("dynamics", f"would overwrite {path}, which contactd did not write; move it")
    write_whole(path, lambda into: into.write(text.encode()))


def _flat(value: Any, path: str = "") -> dict[str, Any]:
    """Returns the numbers of a state by their paths; unset ones are None."""
    found: dict[str, Any] = {}
    for field in fields(value):
        part = getattr(value, field.name)
        if hasattr(part, "__dataclass_fields__"):
            found.update(_flat(part, f"{path}{field.name}."))
        elif part is None or (isinstance(part, (int, float)) and not isinstance(part, bool)):
            found[f"{path}{field.name}"] = part
    return found


def _first(steps: Iterator[WornStep]) -> list[WornStep]:
    """Returns the new profiles, which need no solve."""
    return [next(steps)]


def _conicity(client: WheelRailClient, study: WearStudy, place: Any, step: WornStep) -> float:
    return conicities(client, study, place, step, (3.0,))[0]


def _is_due(
    client: WheelRailClient, study: WearStudy, place: Any, dynamics: Dynamics, done: Sequence[WornStep], start: WornStep, conicity: float
) -> bool:
    last = done[-1]
    behind = [step for step in done if step.number > start.number]
    depth = sum(max(float(step.of(part).depths.max()) for part in study.parts) for step in behind)
    if depth >= dynamics.depth or (dynamics.distance is not None and last.distance - start.distance >= dynamics.distance):
        return True
    if dynamics.conicity is None:
        return False
    return abs(_conicity(client, study, place, last) - conicity) >= dynamics.conicity
