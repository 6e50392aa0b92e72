"""Reads a wear study from a file."""

from __future__ import annotations

import math
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from contactd import InvalidArgument
from contactd.refusals import did_you_mean
from contactd.wear import WearStudy, WeightedState, read_states
from contactd.wear.dynamics import Dynamics

from ..files import named_file, read_object
from ..paths import copied, put_into_words
from ..progress import Bar

__all__ = ["FIELDS", "read_dynamics", "read_study", "states_of"]

FIELDS = {
    "setup", "states", "wears", "law", "rail_law", "passages_per_km", "symmetric", "fatigue", "until", "step", "smoothing", "energy",
    "spacing", "dynamics",
}  # fmt: skip
_NAMED = ("rail_law", "passages_per_km", "symmetric", "fatigue", "smoothing", "energy", "spacing")


def read_study(file: str, states: Sequence[WeightedState] | None = None) -> WearStudy:
    """Returns the study in a JSON or YAML file, with its states or others. Raises click.UsageError naming the file and
    the error.
    """
    given = read_object(file)
    if unknown := given.keys() - FIELDS:
        meant = did_you_mean(min(unknown), FIELDS)
        raise click.UsageError(f"{file}: a study of wear has no {', '.join(sorted(unknown))}; it has {', '.join(sorted(FIELDS))}.{meant}")
    if "dynamics" in given:
        _dynamics_object(file, given)
    if missing := [name for name in (*(() if "dynamics" in given else ("states",)), "wears", "law", "until") if name not in given]:
        raise click.UsageError(f"{file}: {', '.join(missing)} {'is' if len(missing) == 1 else 'are'} missing.")
    step = _object(file, given, "step")
    if unknown := step.keys() - {"depth", "distance"}:
        meant = did_you_mean(min(unknown), ("depth", "distance"))
        raise click.UsageError(f"{file}: step has no {', '.join(sorted(unknown))}; it has depth and distance.{meant}")
    for name in ("law", "rail_law"):
        law = _object(file, given, name) if name in given else None
        if law is not None and not (law.get("source") and law.get("name")):
            raise click.UsageError(f"{file}: {name} has no name or no source; give its name, and the source of its coefficients.")
    named = {name: given[name] for name in _NAMED if name in given}
    if "fatigue" in named:
        _object(file, given, "fatigue")
    if not isinstance(named.get("symmetric", False), bool):
        raise click.UsageError(f"{file}: symmetric is {named['symmetric']!r}; it must be true or false.")
    path = given.get("states")
    if states is None and not isinstance(path, str):
        raise click.UsageError(f"{file}: states must be the name of a file: CSV, HDF5 or Parquet.")
    for name in ("until", "spacing", "passages_per_km"):
        _number(file, name, given.get(name))
    for name in ("depth", "distance"):
        _number(file, f"step.{name}", step.get(name))
    states = states or states_of(named_file(str(path), file))
    setup = copied({"setup": _object(file, given, "setup")})
    put_into_words(setup)
    try:
        return WearStudy(setup["setup"], states, given["wears"], given["law"], given["until"], **step, **named)
    except InvalidArgument as error:
        raise click.UsageError(f"{file}: {error}") from None


def states_of(place: Path) -> Sequence[WeightedState]:
    """Returns the states in a file. Raises click.UsageError naming it."""
    try:
        with Bar("states") as bar:
            return read_states(place, lambda share: bar.show(share, f"reading {place.name}"))
    except InvalidArgument as error:
        raise click.UsageError(f"{place}: {error}") from None
    except OSError as error:
        raise click.UsageError(f"{place}: {error.strerror or error}") from None


def read_dynamics(file: str, folder: Path, allow_program: bool) -> Dynamics | None:
    """Returns the source of states of a study, whose stages are in a folder; None if a file has them. The study may be
    from an untrusted source: raises click.UsageError if the command line does not allow its program.
    """
    given = read_object(file)
    if "dynamics" not in given:
        return None
    dynamics = _dynamics_object(file, given)
    program = dynamics["program"]
    if not allow_program:
        raise click.UsageError(f"{file}: dynamics.program = {program!r:.300}: a study does not run a program by itself. Check it, and give --allow-program.")
    others = {name: dynamics[name] for name in ("depth", "conicity", "distance") if name in dynamics}
    try:
        words = shlex.split(program) if isinstance(program, str) else [str(word) for word in program]
        return Dynamics(words, folder, **others)
    except InvalidArgument as error:
        raise click.UsageError(f"{file}: {error.message}") from None
    except ValueError as error:  # an unpaired quotation mark
        raise click.UsageError(f"{file}: dynamics.program is {program!r}, which is not a command: {error}.") from None


def _dynamics_object(file: str, given: dict[str, Any]) -> dict[str, Any]:
    if "states" in given:
        raise click.UsageError(f"{file}: states and dynamics are given, but dynamics computes the states; remove one of them.")
    dynamics = _object(file, given, "dynamics")
    if unknown := dynamics.keys() - {"program", "depth", "conicity", "distance"}:
        meant = did_you_mean(min(unknown), ("program", "depth", "conicity", "distance"))
        raise click.UsageError(f"{file}: dynamics has no {', '.join(sorted(unknown))}; it has program, depth, conicity and distance.{meant}")
    if not dynamics.get("program") or not isinstance(dynamics["program"], (str, list)):
        raise click.UsageError(f"{file}: dynamics.program is missing; give a command, which is called with the name of a folder.")
    for name in ("depth", "conicity", "distance"):
        _number(file, f"dynamics.{name}", dynamics.get(name))
    return dynamics


def _object(file: str, given: dict[str, Any], name: str) -> dict[str, Any]:
    value = given.get(name, {})
    if not isinstance(value, dict):
        raise click.UsageError(f"{file}: {name} is {value!r}; it must be an object, fields with their values.")
    return value


def _number(file: str, name: str, value: Any) -> None:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    if value is not None and not is_number:
        raise click.UsageError(f"{file}: {name} is {value!r}; it must be a number.")
