"""wear: profiles that wear under a collective of states."""

from __future__ import annotations

import math
import os
import time
from pathlib import Path
from typing import Annotated, Any

import click
import typer

from contactd import InvalidArgument
from contactd.wear import WearStudy, WornStep, evolve, read_record, read_states, write_record

from ..codes import Code, Ended
from ..common import Command, connected, setting
from ..files import read_object, writable, write_text
from ..output import emit, listing, note, span, warn
from ..progress import Bar
from ..saving import need

__all__ = ["add_to"]

_FIELDS = {"setup", "states", "wears", "law", "until", "step", "smoothing", "energy", "spacing"}
_SHOWN = 40  #: steps of a table for people


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(wear)


def wear(
    file: Annotated[str, typer.Argument(help="JSON or YAML: setup, states, wears, law, until, step, smoothing.")],
    output: Annotated[Path | None, typer.Option("--output", "-o", metavar="FILE", help="HDF5 with all steps; else FILE.h5 beside it.")] = None,
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=128, help="Requests at a time.")] = os.cpu_count() or 1,
    profile: Annotated[Path | None, typer.Option("--profile", metavar="FILE", help="Write the last section, too: y and z, a point a line.")] = None,
    fresh: Annotated[bool, typer.Option("--fresh", help="Begin with the new profile, also where there are steps.")] = False,
) -> None:
    """Wear a wheel or a rail under a collective of states, step by step.

    Killed at any moment and started again, it goes on behind the last step.
    """
    need("h5py", "HDF5 files", "python3-h5py")
    study = _study(file)
    if output is None:
        if file == "-":
            raise click.UsageError("A study from standard input needs --output, where its steps are kept.")
        output = Path(f"{file}.h5")
    writable("--output", output)
    if profile is not None:
        writable("--profile", profile)
    steps = _before(output, study, fresh)
    unit = "km" if study.wears == "wheel" else "passages"
    try:
        _evolve(study, steps, output, workers, unit)
    except BaseException:
        if steps:
            note(f"{steps[-1].distance:g} of {study.until:g} {unit} are in {output}; the same command goes on.")
        raise
    if profile is not None:
        write_text(profile, "".join(f"{y:.9g} {z:.9g}\n" for y, z in steps[-1].points))
    _show(steps, unit)


def _before(output: Path, study: WearStudy, fresh: bool) -> list[WornStep]:
    if fresh:
        return []
    try:
        return read_record(output, study)
    except InvalidArgument as error:
        raise Ended(Code.USAGE, f"{error} --fresh begins anew.") from None
    except (OSError, KeyError):
        raise Ended(Code.USAGE, f"{output} holds no steps of wear; --fresh writes over it.") from None


def _evolve(study: WearStudy, steps: list[WornStep], output: Path, workers: int, unit: str) -> None:
    """Adds steps to the list as they end, and writes all to the file each time."""
    before, began = steps[-1].distance if steps else 0.0, time.monotonic()
    with connected(workers=workers if setting().local else None) as client, Bar("wear") as bar:

        def show(share: float, sentence: str) -> None:
            went = share - before / study.until
            left = f"about {span((time.monotonic() - began) / went * (1 - share))} to go" if went > 0 else ""
            bar.show(share, sentence, left)

        for step in evolve(client, study, steps, workers=workers, on_progress=show):
            steps.append(step)
            write_record(output, study, steps)
            bar.show(step.distance / study.until, f"{step.distance:g} of {study.until:g} {unit}")


def _study(file: str) -> WearStudy:
    given = read_object(file)
    if unknown := given.keys() - _FIELDS:
        raise click.UsageError(f"{file}: a study of wear has no {', '.join(sorted(unknown))}; it has {', '.join(sorted(_FIELDS))}.")
    if missing := [name for name in ("states", "wears", "law", "until") if name not in given]:
        raise click.UsageError(f"{file}: {', '.join(missing)} {'is' if len(missing) == 1 else 'are'} missing.")
    step = _object(file, given, "step")
    if unknown := step.keys() - {"depth", "distance"}:
        raise click.UsageError(f"{file}: step has no {', '.join(sorted(unknown))}; it has depth and distance.")
    law = _object(file, given, "law")
    if not law.get("source") or not law.get("name"):
        raise click.UsageError(f"{file}: law has no name or no source; say what it is called, and where its coefficients come from.")
    named = {name: given[name] for name in ("smoothing", "energy", "spacing") if name in given}
    path = given["states"]
    if not isinstance(path, str):
        raise click.UsageError(f"{file}: states is the name of a file: CSV, HDF5 or Parquet.")
    place = Path(path) if file == "-" else Path(file).parent / path
    for name in ("until", "spacing"):
        _number(file, name, given.get(name))
    for name in ("depth", "distance"):
        _number(file, f"step.{name}", step.get(name))
    try:
        return WearStudy(_object(file, given, "setup"), read_states(place), given["wears"], law, given["until"], **step, **named)
    except InvalidArgument as error:
        raise click.UsageError(f"{file}: {error}") from None
    except (OSError, UnicodeDecodeError) as error:
        raise click.UsageError(f"{place}: {getattr(error, 'strerror', None) or 'it is no text'}") from None


def _object(file: str, given: dict[str, Any], name: str) -> dict[str, Any]:
    value = given.get(name, {})
    if not isinstance(value, dict):
        raise click.UsageError(f"{file}: {name} is {value!r}; it must be an object, fields with their values.")
    return value


def _number(file: str, name: str, value: Any) -> None:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
    if value is not None and not is_number:
        raise click.UsageError(f"{file}: {name} is {value!r}; it must be a number.")


def _show(steps: list[WornStep], unit: str) -> None:
    columns = ["step", unit, "largest depth, mm", "area, mm^2", "T gamma, N", "pmax, N/mm^2"]
    rows = [[s.number, s.distance, float(s.depths.max()), s.area, s.T_gamma, s.pmax] for s in steps[1:]]
    more = [f"... {len(rows) - _SHOWN} steps before these are in the file"] if len(rows) > _SHOWN else []
    emit(setting().json, {"steps": [_facts(step, unit) for step in steps]}, *more, listing(None, columns, rows[-_SHOWN:]))
    warn(f"step {step.number}: {sentence}" for step in steps for sentence in step.warnings)


def _facts(step: WornStep, unit: str) -> dict[str, Any]:
    return {
        "number": step.number, unit: step.distance, "area": step.area, "removed": step.removed, "T_gamma": step.T_gamma,
        "T_gamma_with_spin": step.T_gamma_with_spin, "pmax": step.pmax, "smoothing": step.smoothing, "groups": step.groups,
        "warnings": list(step.warnings),
    }  # fmt: skip
