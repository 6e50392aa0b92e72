"""Implements solve, which solves one contact problem from a file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import click
import typer

from contactd import ContactSolution, Grid
from contactd.refusals import did_you_mean
from contactd.values.answers import read
from contactd.values.step_solution import read_solution

from ..asking import ask
from ..codes import Code, Ended
from ..common import Command, connected, setting
from ..files import read_object
from ..output import above_rounding, emit, facts, number
from ..paths import changed
from ..saving import ARRAYS, check_outputs, save

__all__ = ["Fields", "Outputs", "Set", "add_to", "contact_rows", "requested_fields"]

Set = Annotated[list[str] | None, typer.Option("--set", metavar="PATH=VALUE", help="Change a field, such as friction.mu=0.3. Repeatable.")]
Outputs = Annotated[list[str] | None, typer.Option("--output", "-o", metavar="FILE", help="Write the answer to FILE.json or FILE.h5, or a picture to FILE.png, .svg or .pdf.")]
Fields = Annotated[str | None, typer.Option("--fields", metavar="NAMES", help=f"Arrays of the answer: all, none, or a list of {','.join(ARRAYS)}.")]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(solve)


def solve(
    file: Annotated[str, typer.Argument(help="JSON or YAML with the parameters of contact.solve; - reads standard input.")],
    sets: Set = None,
    output: Outputs = None,
    fields: Fields = None,
) -> None:
    """Solve a contact problem. Exit code 5: it did not converge."""
    outputs = check_outputs(output or ())
    params = changed(read_object(file), sets or ())
    requested_fields(params, fields, outputs)
    with connected(local_unless_named=True) as client:
        answer = ask(client, "contact.solve", params, "solving")
    for path in outputs:
        save(path, answer, lambda: _solution(params, answer))
    emit(setting().json, answer, facts(_title(params), contact_rows(answer)))
    if not answer["converged"]:
        raise Ended(Code.NOT_CONVERGED, "a solver missed its tolerance; see evidence.")


def requested_fields(params: dict[str, Any], fields: str | None, outputs: list[Path]) -> None:
    """Sets the requested arrays in `params`: none for a table, all for pictures."""
    if fields is not None:
        names = [] if fields == "none" else list(ARRAYS) if fields == "all" else fields.split(",")
        if unknown := [name for name in names if name not in ARRAYS]:
            raise click.UsageError(f"--fields {fields}: {unknown[0]!r} is not one of {', '.join(ARRAYS)}, all or none.{did_you_mean(unknown[0], ARRAYS)}")
        params["fields"] = names
    elif not outputs and not setting().json:
        params["fields"] = []
    if any(path.suffix not in (".json", ".h5") for path in outputs):
        params.pop("fields", None)


def _solution(params: dict[str, Any], answer: dict[str, Any]) -> ContactSolution:
    return read_solution(read(Grid, params["grid"], "grid"), params.get("fields"), answer)


def _title(params: dict[str, Any]) -> str:
    grid = params.get("grid", {})
    return f"Contact on {grid.get('nx')} x {grid.get('ny')} elements of {grid.get('dx'):g} x {grid.get('dy'):g} mm"


def contact_rows(answer: dict[str, Any]) -> list[tuple[str, Any]]:
    """Returns names with units, and values, of the answers for one contact."""
    forces, area, elements = answer["forces"], answer["area"], answer["elements"]
    has_friction = "motion" in answer
    rows: list[tuple[str, Any]] = [("Fn (N)", float(forces["Fn"]))]
    if has_friction:
        across = area["contact"] ** 0.5
        arms = (("Fx (N)", "Fx", 1.0), ("Fy (N)", "Fy", 1.0), ("Mz (N mm)", "Mz", across))
        rows += [(title, above_rounding(float(forces[name]), forces["Fn"] * arm)) for title, name, arm in arms]
    division = f"{elements['contact']} elements"
    if has_friction:
        division += f": {elements['adhesion']} in adhesion, {elements['slip']} in slip"
    rows += [
        ("approach (mm)", float(answer["approach"])),
        ("pmax (N/mm^2)", float(answer["pmax"])),
        ("contact (mm^2)", f"{number(float(area['contact']))}, {division}"),
        ("frictional work (N mm)", answer.get("frictional_work")),
        ("frictional power (N mm/s)", answer.get("frictional_power")),
        ("rolling resistance (N)", answer.get("rolling_resistance", {}).get("force")),
    ]
    if has_friction:
        rows.append(("motion", _motion(answer["motion"])))
    evidence = answer["evidence"]
    iterations = [f"{evidence[name]['iterations']} {name}" for name in ("normal", "tangential", "outer", "force") if name in evidence]
    return [*rows, ("iterations", ", ".join(iterations)), ("converged", bool(answer["converged"]))]


def _motion(motion: dict[str, Any]) -> str:
    units = {"rigid_shift": " mm", "rotation": " rad", "phi": " rad/mm", "force": " N"}
    names = ("rigid_shift", "rotation", "xi", "eta", "phi", "force")
    given = []
    for name in names:
        value = motion.get(name)
        values = value if isinstance(value, list) else [value]
        if any(values):
            text = ", ".join(number(None if part is None else float(part)) for part in values)
            given.append(f"{name} {text}{units.get(name, '')}")
    return "; ".join(given) or "none"
