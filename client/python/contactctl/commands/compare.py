"""Implements compare, which solves one case with all contact models that support it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import click
import typer

from contactd import Client, ComparedModel, ModelComparison
from contactd.refusals import did_you_mean
from contactd.values.wheel_rail.comparison import FULL, combinations
from contactd.wheel_rail import WheelRailSolution

from ..asking import reports_of_rounds
from ..cases.converting import case_params
from ..cases.reading import read_cases
from ..codes import Code, Ended
from ..common import Command, connected, setting
from ..files import read_object, writable, write_text
from ..output import above_rounding, emit, listing, span, warn
from ..paths import changed
from ..progress import Bar
from ..saving import check_picture
from ..writing.csv_files import csv_text
from ..writing.drawing import save_picture
from .solve import Set

__all__ = ["add_to"]

_FIRST_COLUMNS = ("name", "model", "normal_model")
_ERRORS = ("Fn", "Fx", "Fy", "Mz", "pmax", "area", "patch", "approach", "creepage")


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(compare)


def compare(
    file: Annotated[str, typer.Argument(help="JSON or YAML of contact.solve or wheelrail.solve, or an input file of CONTACT (.inp); - reads standard input.")],
    sets: Set = None,
    models: Annotated[str | None, typer.Option("--models", metavar="NAMES", help="Models, such as fastsim,kpec+fastsim. Default: all.")] = None,
    case: Annotated[int | None, typer.Option("--case", metavar="N", help="The N-th case of an input file of CONTACT.")] = None,
    repeats: Annotated[int, typer.Option("--repeats", min=1, max=1000, help="Number of repetitions to time short requests.")] = 3,
    plot: Annotated[str | None, typer.Option("--plot", metavar="FILE", help="Write a picture: .png, .svg or .pdf.")] = None,
    table: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write all numbers to a CSV file.")] = None,
) -> None:  # fmt: skip
    """Compare all contact models for a case: forces, errors against the full theory, and computing times.

    Exit code 5: a model did not converge.
    """
    _check_outputs(plot, table)
    names = None if models is None else [name.strip() for name in models.split(",")]
    if unknown := [name for name in names or () if name not in combinations()]:
        raise click.UsageError(f"--models {models}: {unknown[0]!r} is not one of {', '.join(combinations())}.{did_you_mean(unknown[0], combinations())}")
    is_contact_file = file.endswith(".inp")
    if case is not None and not is_contact_file:
        raise click.UsageError(f"--case {case}: only input files of CONTACT (.inp) have several cases.")
    params = {} if is_contact_file else changed(read_object(file), sets or ())
    with connected(local_unless_named=True) as client, Bar("comparing") as bar:
        if is_contact_file:
            params = changed(_case_of(Path(file), case, client), sets or ())
        with reports_of_rounds(client, params, bar) as report:
            found = client.compare(params, models=names, repeats=repeats, on_progress=report)
    rows = [_row(one) for one in found.models]
    if table is not None:
        _write_table(table, rows)
    if plot is not None:
        _draw(Path(plot), found)
    emit(setting().json, {"models": rows, "request_seconds": found.request_seconds}, *_shown(found, rows))
    warn(_left_out(found))
    if bad := [one.name for one in found.computed if one.solution is not None and not one.solution.converged]:
        raise Ended(Code.NOT_CONVERGED, f"not converged: {', '.join(bad)}.")


def _left_out(found: ModelComparison) -> list[str]:
    """Returns sentences about options of `simplified`, with the models that do not have them."""
    names = {option for one in found.models for option in one.left_out}
    sentences = []
    for option in sorted(names):
        without = [one.name for one in found.computed if option in one.left_out and one.model not in (FULL, "hertz")]
        if without:
            sentences.append(f"simplified.{option} is not an option of {', '.join(without)} and was ignored there")
    return sentences


def _check_outputs(plot: str | None, table: Path | None) -> None:
    if plot is not None:
        check_picture("--plot", plot)
    if table is not None:
        writable("--csv", table, _FIRST_COLUMNS)


def _case_of(file: Path, number: int | None, client: Client) -> dict[str, Any]:
    found = read_cases(file, client)
    cases = found.content.cases
    if number is None and len(cases) != 1:
        raise click.UsageError(f"{file} has {len(cases)} cases: choose one with --case.")
    if not 1 <= (number or 1) <= len(cases):
        raise click.UsageError(f"--case {number}: {file} has {len(cases)} cases.")
    (converted,) = found.runner(client, file.name).converted([cases[(number or 1) - 1]])
    return case_params(converted)


def _row(one: ComparedModel) -> dict[str, Any]:
    """Returns all results of a model; missing ones are None."""
    row: dict[str, Any] = {"name": one.name, "model": one.model, "normal_model": one.normal_model}
    found = one.solution
    if found is None:
        return {**row, "refusal": one.refusal}
    if isinstance(found, WheelRailSolution):
        track = found.forces.track
        patches = [patch.solution for patch in found.patches]
        row |= {"z": found.z, "Fx": track.Fx, "Fy": track.Fy, "Fz": track.Fz, "patches": len(patches)}
        row["contacts"] = [
            {"y": patch.place.reference.y, "Fn": one.Fn, "Fx": one.Fx, "Fy": one.Fy, "Mz": one.Mz, "pmax": one.pmax, "area": one.area.contact}
            for patch, one in zip(found.patches, patches)
        ]
        row |= {"pmax": max((patch.pmax for patch in patches), default=0.0), "area": sum(patch.area.contact for patch in patches)}
    else:
        forces = {name: getattr(found, name) for name in ("Fn", "Fx", "Fy", "Mz")}
        row |= {**forces, "approach": found.approach, "pmax": found.pmax, "area": found.area.contact}
        row |= {"elements": found.elements.contact, "adhesion": found.elements.adhesion, "motion": found.motion}
    row |= {"seconds": one.seconds, "converged": found.converged, "left_out": list(one.left_out)}
    if one.errors is not None:
        row["errors"] = {name: getattr(one.errors, name) for name in _ERRORS}
        row["errors"]["force"] = one.errors.force
    return row


def _write_table(path: Path, rows: list[dict[str, Any]]) -> None:
    flat = []
    for row in rows:
        errors = {f"error of {name}": value for name, value in row.get("errors", {}).items()}
        flat.append({**{name: value for name, value in row.items() if name not in ("errors", "motion", "left_out", "contacts")}, **errors})
    columns = [*dict.fromkeys(name for row in flat for name in row if name != "refusal"), "refusal"]
    write_text(path, csv_text([columns, *([row.get(name, "") for name in columns] for row in flat)]))


def _shown(found: ModelComparison, rows: list[dict[str, Any]]) -> list[Any]:
    computed = [row for row in rows if "converged" in row]
    on_rail = any("Fz" in row for row in computed)
    forces = (
        {"Fx (N)": "Fx", "Fy (N)": "Fy", "Fz (N)": "Fz", "z (mm)": "z", "patches": "patches"} if on_rail
        else {"Fn (N)": "Fn", "Fx (N)": "Fx", "Fy (N)": "Fy", "Mz (N mm)": "Mz", "approach (mm)": "approach"}
    )  # fmt: skip
    columns = {**forces, "pmax (N/mm^2)": "pmax", "contact (mm^2)": "area"}
    largest = max((abs(row[name]) for row in computed for name in ("Fn", "Fz") if name in row), default=0.0)
    errors = [row.get("errors", {}) for row in computed]
    off = {"error (% of mu Fn)": "force"} if any(one.get("force") is not None for one in errors) else {"error of pmax (%)": "pmax"}
    if any(one.get("creepage") is not None for one in errors):
        off["error of creepage (%)"] = "creepage"
    lines = []
    for row, error in zip(computed, errors):
        cells = [above_rounding(row[name], largest) if name[0] == "F" else row[name] for name in columns.values()]
        apart = [None if row["name"] == FULL or error.get(name) is None else 100 * error[name] for name in off.values()]
        numbers = [*(_digits(cell) for cell in cells), *(_digits(cell, 3) for cell in apart), _digits(1e3 * row["seconds"], 3)]
        lines.append([row["name"], *numbers, bool(row["converged"])])
    shown: list[Any] = [listing(None, ["model", *columns, *off, "time (ms)", "converged"], lines)]
    if refused := [[row["name"], row["refusal"]] for row in rows if "converged" not in row]:
        shown += ["", listing("Not computed", ["model", "why"], refused)]
    return [*shown, "", f"A request without computation takes {span(found.request_seconds)} here."]


def _digits(value: Any, count: int = 5) -> Any:
    """Rounds to the digits that are relevant for a comparison."""
    return float(f"{value:.{count}g}") if isinstance(value, float) else value


def _draw(path: Path, found: ModelComparison) -> None:
    figure = found.plot()
    save_picture(path, figure, dpi=130)
