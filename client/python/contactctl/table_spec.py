"""Selects a table: by a file with parameters of ic.get, options for the most common ones, and --set for all others."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import click
import typer

from .files import read_object
from .paths import changed, get

__all__ = ["DX", "DY", "NU", "NX", "NY", "Accuracy", "E", "G", "Set", "Spec", "as_given", "offsets_of", "table_params"]

Spec = Annotated[str | None, typer.Argument(metavar="[FILE]", help="JSON or YAML with material, grid and ics; - reads standard input.")]
Set = Annotated[list[str] | None, typer.Option("--set", metavar="PATH=VALUE", help="Change a field, such as ics.order=3. Repeatable.")]
G = Annotated[float | None, typer.Option("--G", help="Shear modulus (N/mm^2).")]
E = Annotated[float | None, typer.Option("--E", help="Young's modulus (N/mm^2), instead of G.")]
NU = Annotated[float | None, typer.Option("--nu", help="Poisson's ratio.")]
NX = Annotated[int | None, typer.Option("--nx", help="Number of offsets along x.")]
NY = Annotated[int | None, typer.Option("--ny", help="Number of offsets along y. Default: nx.")]
DX = Annotated[float | None, typer.Option("--dx", help="Element size along x (mm).")]
DY = Annotated[float | None, typer.Option("--dy", help="Element size along y (mm). Default: dx.")]
Accuracy = Annotated[float | None, typer.Option("--accuracy", help="Largest relative error of finite elements. Default: 1e-3.")]


def as_given(**options: Any) -> dict[str, Any]:
    """Returns the given options."""
    return {name: value for name, value in options.items() if value is not None}


def table_params(file: str | None, given: dict[str, Any], sets: Sequence[str] | None) -> dict[str, Any]:
    """Returns the parameters of ic.get. Raises click.UsageError."""
    params = read_object(file) if file is not None else {}
    if file is None and not given and not sets:
        raise click.UsageError("Give a table: a FILE, or at least --G, --nu, --nx and --dx.")
    material, grid, ics = (_part(params, name) for name in ("material", "grid", "ics"))
    material |= _modulus(given, material)
    grid |= {name: given[name] for name in ("nx", "ny", "dx", "dy") if name in given}
    for other, same in (("ny", "nx"), ("dy", "dx")):
        if same in grid:
            grid.setdefault(other, grid[same])
    if "accuracy" in given:
        ics["accuracy"] = given["accuracy"]
    ics.setdefault("source", "fem")
    parts = {"material": material, "grid": grid, "ics": ics}
    return changed({**params, **{name: part for name, part in parts.items() if part}}, sets or ())


def _part(params: dict[str, Any], name: str) -> dict[str, Any]:
    found = params.get(name) or {}
    if not isinstance(found, dict):
        raise click.UsageError(f"{name} is {found!r:.60}; it must be an object, fields with their values.")
    return dict(found)


def _modulus(given: dict[str, Any], material: dict[str, Any]) -> dict[str, Any]:
    found = {name: given[name] for name in ("G", "nu") if name in given}
    if "E" not in given:
        return found
    nu = found.get("nu", material.get("nu"))
    if "G" in given or not isinstance(nu, (int, float)) or not nu > -1:
        raise click.UsageError("--E requires --nu above -1, and replaces --G.")
    return {**found, "G": given["E"] / (2 * (1 + nu))}


def offsets_of(params: dict[str, Any]) -> int:
    """Returns the number of offsets; 0 for invalid values, which the daemon refuses."""
    nx, ny = get(params, "grid.nx"), get(params, "grid.ny")
    return nx * ny if isinstance(nx, int) and isinstance(ny, int) and nx > 0 and ny > 0 else 0
