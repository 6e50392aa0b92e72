"""conform: checks against standards, for an engineer and for CI."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import click
import typer

from ..codes import Code, Ended
from ..common import Command, Group, connected, setting
from ..conformity.benchmark import own_benchmark
from ..conformity.benchmark_files import read_benchmark
from ..conformity.conicities import Row, compared, curves_of
from ..conformity.contact_filters import RANGES, compared_filters
from ..conformity.limits import nadal_limit
from ..conformity.pictures import draw_conicities, draw_filters, draw_run
from ..conformity.run_files import read_run
from ..conformity.run_quantities import Assessment, RunLimits, assessed
from ..files import writable, write_text
from ..output import emit, facts, listing, number
from ..progress import Bar
from ..saving import check_picture
from ..writing.csv_files import csv_text
from ..writing.drawing import save_picture

__all__ = ["add_to"]

_CONICITY_COLUMNS = ("combination", "wheels", "amplitude", "conicity", "reference", "low", "high", "inside")
_RUN_COLUMNS = ("quantity", "place", "mean")
_FILTER_COLUMNS = ("load", "diameter", "wavelength", "directive", "computed", "difference")
Plot = Annotated[str | None, typer.Option("--plot", metavar="FILE", help="Write a picture: .png, .svg or .pdf.")]
Table = Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write all values to a CSV file.")]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Checks against standards.", rich_markup_mode=None)
    family.command(cls=Command)(en15302)
    family.command(cls=Command)(en14363)
    family.command(cls=Command)(cnossos)
    app.add_typer(family, name="conform")


def en15302(
    folders: Annotated[list[Path] | None, typer.Argument(metavar="[FOLDER]...", help="Folders with RUIC519A.dat and other profiles, and with ben_E1.dat and other values.")] = None,
    own: Annotated[bool, typer.Option("--own", help="Check six combinations at seven amplitudes, without any files.")] = False,
    plot: Plot = None, table: Table = None,
) -> None:  # fmt: skip
    """Check equivalent conicities against the benchmark of EN 15302:2008.

    Exit code 9: a conicity lies outside its tolerance.
    """
    if own == bool(folders):
        raise click.UsageError("Give the folders with the profiles and values of the benchmark, or --own.")
    _check_outputs(plot, table, _CONICITY_COLUMNS)
    benchmark = own_benchmark() if own else read_benchmark(folders or ())
    with connected(local_unless_named=True) as client, Bar("conicities") as bar:
        rows = compared(client, benchmark, bar.show)
        curves = curves_of(client, benchmark, bar.show) if plot is not None else {}
    cells = [[row.combination, row.wheels, row.amplitude, row.conicity, row.reference, row.low, row.high, row.is_inside] for row in rows]
    if table is not None:
        write_text(table, csv_text([_CONICITY_COLUMNS, *cells]))
    if plot is not None:
        save_picture(Path(plot), draw_conicities(rows, curves), dpi=130)
    given = {"inside": sum(row.is_inside for row in rows), "total": len(rows), "rows": [dict(zip(_CONICITY_COLUMNS, one)) for one in cells]}
    emit(setting().json, given, *_shown_conicities(rows))
    if outside := [f"{row.combination} at {number(row.amplitude)} mm" for row in rows if not row.is_inside]:
        raise Ended(Code.OUTSIDE, f"{len(outside)} of {len(rows)} conicities lie outside their tolerances: {_first(outside)}.")


def en14363(
    file: Annotated[Path, typer.Argument(help="Table with the columns distance, or time and speed, and Yr, Yl, Qr, Ql.")],
    flange_angle: Annotated[float, typer.Option("--flange-angle", min=30, max=85, help="Angle of the flange (degrees), for Nadal's limit.")] = 70,
    mu: Annotated[float, typer.Option("--mu", min=0, max=2, help="Friction coefficient, for Nadal's limit.")] = 0.36,
    ratio_limit: Annotated[float | None, typer.Option("--ratio-limit", min=0.01, max=10, help="Limit of Y/Q instead of Nadal's, such as 0.8.")] = None,
    axle_load: Annotated[float | None, typer.Option("--axle-load", min=1, max=1e6, help="Static vertical force of a wheelset (N). Default: its mean over the run.")] = None,
    track_factor: Annotated[float, typer.Option("--track-factor", min=0.1, max=2, help="Factor of Prud'homme's limit: 0.85 for freight wagons.")] = 1.0,
    outwards: Annotated[bool, typer.Option("--outwards", help="Y is positive towards the field side of both wheels. Default: to the right.")] = False,
    plot: Plot = None, table: Table = None,
) -> None:  # fmt: skip
    """Check Y/Q and the sums of lateral forces of a run, as means over 2 m (EN 14363).

    Exit code 9: a quantity exceeds its limit.
    """
    _check_outputs(plot, table, _RUN_COLUMNS)
    limit = nadal_limit(math.radians(flange_angle), mu) if ratio_limit is None else ratio_limit
    if not limit > 0:
        raise click.UsageError(f"--mu {mu:g}: Nadal's limit for a flange of {flange_angle:g} degrees is {limit:.3g}; give a smaller friction coefficient.")
    with Bar("run") as bar:
        run = read_run(file, is_outwards=outwards, on_progress=lambda share: bar.show(share, f"reading {file.name}"))
    try:
        found = assessed(run, RunLimits(limit, axle_load, track_factor))
    except ValueError as error:
        raise click.UsageError(f"{file}: {error}.") from None
    if table is not None:
        write_text(table, csv_text([_RUN_COLUMNS, *([one.name, float(x), float(y)] for one in found for x, y in zip(one.places, one.means))]))
    if plot is not None:
        save_picture(Path(plot), draw_run(found), dpi=130)
    emit(setting().json, {"quantities": [_as_json(one) for one in found]}, *_shown_run(found))
    if outside := [one.name for one in found if not one.is_inside]:
        raise Ended(Code.OUTSIDE, f"{len(outside)} of {len(found)} quantities exceed their limits: {_first(outside)}.")


def cnossos(
    solve: Annotated[bool, typer.Option("--solve", help="Compute the contacts by solves. Default: Hertz in closed form.")] = False,
    rail_radius: Annotated[float, typer.Option("--rail-radius", min=20, max=1e4, help="Radius of the rail head (mm).")] = 300,
    exponent: Annotated[float, typer.Option("--exponent", min=2, max=8, help="Exponent of the isotropic surface.")] = 3,
    plot: Plot = None, table: Table = None,
) -> None:  # fmt: skip
    """Compare contact filters with table G-2 of Directive 2002/49/EC (CNOSSOS-EU), as amended by (EU) 2021/1226.

    Exit code 9: a column differs by more than 2.5 dB down to 10 mm, or by more than 2.8 dB down to 3.15 mm.
    """
    _check_outputs(plot, table, _FILTER_COLUMNS)
    with Bar("filters") as bar:
        if solve:
            with connected(local_unless_named=True) as client:
                found = compared_filters(client, rail_radius, exponent, bar.show)
        else:
            found = compared_filters(None, rail_radius, exponent, bar.show)
    cells = [
        [one.load, one.diameter, float(wave), float(given), float(computed), float(computed - given)]
        for one in found
        for wave, given, computed in zip(one.given.wavelengths, one.given.levels, one.computed.levels)
    ]
    if table is not None:
        write_text(table, csv_text([_FILTER_COLUMNS, *cells]))
    if plot is not None:
        save_picture(Path(plot), draw_filters(found), dpi=130)
    columns = ["column", *(f"to {shortest:g} mm (dB)" for shortest, _ in RANGES), "inside"]
    shown = [[one.name, *(f"{one.largest(shortest)[0]:.2f} at {one.largest(shortest)[1]:g} mm" for shortest, _ in RANGES), one.is_inside] for one in found]
    given = {"columns": [{"load": one.load, "diameter": one.diameter, "inside": one.is_inside} for one in found], "rows": [dict(zip(_FILTER_COLUMNS, row)) for row in cells]}
    emit(setting().json, given, listing("Largest differences from table G-2, 2002/49/EC", columns, shown))
    if outside := [one.name for one in found if not one.is_inside]:
        raise Ended(Code.OUTSIDE, f"{len(outside)} of {len(found)} columns lie outside their tolerances: {_first(outside)}.")


def _check_outputs(plot: str | None, table: Path | None, columns: Sequence[str]) -> None:
    if plot is not None:
        check_picture("--plot", plot)
    if table is not None:
        writable("--csv", table, columns)


def _first(names: Sequence[str]) -> str:
    return ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")


def _shown_conicities(rows: Sequence[Row]) -> list[Any]:
    columns = ["combination", "amplitude (mm)", "conicity", "reference", "low", "high", "inside"]
    cells = [
        [row.combination, row.amplitude, _digits(row.conicity), row.reference, _digits(row.low), _digits(row.high), row.is_inside] for row in rows
    ]
    summary: list[tuple[str, Any]] = []
    for name in dict.fromkeys(row.combination for row in rows):
        own = [row for row in rows if row.combination == name]
        apart = [abs(row.conicity - row.reference) for row in own if row.conicity is not None]
        largest = f", largest difference {max(apart):.4f}" if apart else ""
        summary.append((f"{name}: {own[0].wheels}", f"{sum(row.is_inside for row in own)} of {len(own)} inside{largest}"))
    title = f"{sum(row.is_inside for row in rows)} of {len(rows)} conicities inside"
    return [listing("Equivalent conicity, EN 15302:2008", columns, cells), "", facts(title, summary)]


def _shown_run(found: Sequence[Assessment]) -> list[Any]:
    columns = ["quantity", "extreme", "at (m)", "99.85 %", "limit", "inside"]
    cells = [
        [f"{one.name}{' (N)' if one.is_force else ''}", *map(_digits, (one.extreme, one.place / 1e3, one.percentile, one.limit)), one.is_inside]
        for one in found
    ]
    return [listing("Means over 2 m, EN 14363", columns, cells)]


def _as_json(one: Assessment) -> dict[str, Any]:
    return {
        "name": one.name, "extreme": one.extreme, "place": one.place, "percentile": one.percentile, "limit": one.limit,
        "inside": one.is_inside, "places": one.places, "means": one.means,
    }  # fmt: skip


def _digits(value: float | None) -> float | None:
    """Rounds to the digits that are relevant for a comparison."""
    return None if value is None else float(f"{value:.4g}")
