"""Implements fit, which fits parameters of friction to a measured creep curve."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Annotated, Any

import click
import numpy as np
import typer

import contactd
from contactd import Fit, FitFailed, MissingExtra
from contactd.files.heading_units import heading_of
from contactd.files.marks import written_by
from contactd.files.number_text import number_in, rows_of
from contactd.files.whole import read_whole

from ..asking import reports_of_rounds
from ..codes import Code, Ended, code_of
from ..common import Command, connected, setting
from ..files import COMMENT, read_object, writable, write_text
from ..output import emit, facts, listing, number, plain_json, warn
from ..paths import changed
from ..progress import Bar
from ..saving import check_picture
from ..writing.csv_files import csv_text
from ..writing.drawing import save_picture
from .solve import Set

__all__ = ["add_to"]

_MOST_BYTES = 1 << 24  #: Largest size of a file with a curve.
_COLUMNS = ("creepage", "measured", "computed", "residual")
_PERCENT = re.compile(r"[\[(]\s*%\s*[\])]|\bper ?cent\b", re.IGNORECASE)
_BETWEEN = 61  #: Number of creepages of the drawn curve.


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(fit)


def fit(
    measured: Annotated[Path, typer.Argument(help="The curve, one line per point: creepage, value and optionally its standard uncertainty.")],
    case: Annotated[str, typer.Option("--case", metavar="FILE", help="The contact problem: JSON or YAML with the parameters of contact.solve.")],
    parameter: Annotated[list[str], typer.Option("--parameter", "-p", metavar="PATH=LOW:HIGH", help="A fitted field and its bounds, such as friction.mu=0.1:0.6. Repeatable.")],
    start: Annotated[list[str] | None, typer.Option("--start", metavar="PATH=VALUE", help="Start of a parameter. Default: the value in the case, or the best of several.")] = None,
    starts: Annotated[int | None, typer.Option("--starts", min=1, max=10000, help="Number of starts that are tried. Default: 16.")] = None,
    sets: Set = None,
    by: Annotated[str, typer.Option("--by", metavar="CREEPAGE", help="Varied creepage: xi, eta or phi, or a path such as friction.rigid_shift[0].")] = "xi",
    quantity: Annotated[str, typer.Option("--quantity", help="Measured quantity: traction coefficient, or force (N).")] = "coefficient",
    force: Annotated[str | None, typer.Option("--force", help="Fx or Fy. Default: that of the creepage.")] = None,
    columns: Annotated[str | None, typer.Option("--columns", metavar="N,N[,N]", help="Columns of creepage, value and uncertainty. Default: the first ones.")] = None,
    percent: Annotated[bool | None, typer.Option("--percent/--no-percent", help="Creepages are in percent, not ratios.")] = None,
    confidence: Annotated[float, typer.Option("--confidence", help="Confidence level of intervals and of the band.")] = 0.95,
    evaluations: Annotated[int, typer.Option("--max-evaluations", min=1, max=100000, help="Largest number of curves in the search, without those for derivatives.")] = 100,
    plot: Annotated[str | None, typer.Option("--plot", metavar="FILE", help="Write a picture: .png, .svg or .pdf.")] = None,
    table: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write points, computed values and residuals to a CSV file.")] = None,
    output: Annotated[str | None, typer.Option("--output", "-o", metavar="FILE", help="Write the case with the fitted values: .json, .yaml or .yml.")] = None,
) -> None:  # fmt: skip
    """Fit parameters of friction to a measured creep curve by least squares.

    Exit code 5: the search did not converge.
    """
    _check_outputs(plot, table, output)
    points = _points(measured, columns, percent)
    bounds = dict(_bounds(text) for text in parameter)
    if len(bounds) < len(parameter):
        raise click.UsageError("--parameter: a field is given twice.")
    begin = dict(_start(text) for text in start or ())
    params = changed(read_object(case), sets or ())
    between = _between(points[0]) if plot else None
    with connected(local_unless_named=True) as client, Bar("fitting") as bar:
        try:
            with reports_of_rounds(client, params, bar) as report:
                found = contactd.fit(
                    client, params, points[0], points[1], bounds, uncertainty=points[2] if len(points) > 2 else None, start=begin,
                    starts=starts, by=by, quantity=quantity, force=force, confidence=confidence, curve=between,
                    max_evaluations=evaluations, on_progress=report,
                )  # fmt: skip
        except FitFailed as error:
            raise Ended(Code.NOT_CONVERGED if error.__cause__ is None else code_of(error.__cause__), str(error)) from None
        except contactd.StatusError:
            raise
        except ValueError as error:
            raise click.UsageError(str(error)) from None
    _write(found, plot, table, output)
    emit(setting().json, _as_json(found), *_shown(found, measured))
    warn(found.warnings)
    if not found.converged:
        raise Ended(Code.NOT_CONVERGED, f"the search did not converge: {found.reason}.")


def _check_outputs(plot: str | None, table: Path | None, output: str | None) -> None:
    try:
        import scipy  # noqa: F401
    except ImportError:
        raise click.UsageError(str(MissingExtra("A fit", "scipy", "fit", "python3-scipy"))) from None
    if plot is not None:
        check_picture("--plot", plot)
    if table is not None:
        writable("--csv", table, _COLUMNS)
    if output is not None:
        if Path(output).suffix not in (".json", ".yaml", ".yml"):
            raise click.UsageError(f"--output {output}: the name must end in .json, .yaml or .yml.")
        writable("--output", output)


def _points(file: Path, columns: str | None, percent: bool | None) -> list[np.ndarray[Any, Any]]:
    """Returns creepages, values and, if the file has a third column, uncertainties."""
    try:
        text = read_whole(file, _MOST_BYTES).decode("utf-8-sig")
        rows = np.array(rows_of(text))
    except OSError as error:
        raise click.UsageError(f"{file} cannot be read: {error.strerror or error}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{file} is not text in UTF-8.") from None
    except ValueError as error:
        raise click.UsageError(f"{file} contains no curve: {error}.") from None
    if percent is None and (line := next(filter(_PERCENT.search, heading_of(text)), None)) is not None:
        raise click.UsageError(f"{file}: its heading, {line.strip()[:60]!r}, states percent. Give --percent, or --no-percent if creepages are ratios.")
    chosen = list(range(min(3, rows.shape[1]))) if columns is None else _columns(columns, rows.shape[1], file)
    if len(chosen) < 2:
        raise click.UsageError(f"{file} has one column; a curve requires creepages and values.")
    found = [rows[:, index] for index in chosen]
    if percent:
        found[0] = found[0] / 100
    return found


def _columns(text: str, count: int, file: Path) -> list[int]:
    try:
        found = [int(word) - 1 for word in text.split(",")]
    except ValueError:
        found = []
    if len(found) not in (2, 3) or len(set(found)) < len(found) or not all(0 <= index < count for index in found):
        raise click.UsageError(f"--columns {text}: it must be two or three different columns, 1 to {count} in {file}, such as 1,2.")
    return found


def _bounds(text: str) -> tuple[str, tuple[float, float]]:
    path, _, rest = text.partition("=")
    low, _, high = rest.partition(":")
    found = number_in(low.strip()), number_in(high.strip())
    if found[0] is None or found[1] is None:
        raise click.UsageError(f"--parameter {text}: it must be PATH=LOW:HIGH, such as friction.layer.flexibility=1e-6:1e-3.")
    return path.strip(), (found[0], found[1])


def _start(text: str) -> tuple[str, float]:
    path, _, value = text.partition("=")
    found = number_in(value.strip())
    if found is None:
        raise click.UsageError(f"--start {text}: it must be PATH=VALUE, such as friction.mu=0.3.")
    return path.strip(), found


def _between(creepage: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Returns the creepages of the drawn curve: from zero, and dense where there are measured ones."""
    ends = np.unique([0.0, *creepage])
    found: np.ndarray[Any, Any] = np.interp(np.linspace(0, len(ends) - 1, _BETWEEN), np.arange(len(ends)), ends)
    return found


def _write(found: Fit, plot: str | None, table: Path | None, output: str | None) -> None:
    if plot is not None:
        _draw(Path(plot), found)
    if table is not None:
        columns = [found.creepage, found.measured, found.computed, found.residuals]
        write_text(table, csv_text([_COLUMNS, *zip(*(map(float, column) for column in columns))]))
    if output is not None:
        write_text(output, _case_text(Path(output), plain_json(found.params)))


def _case_text(path: Path, params: Any) -> str:
    if path.suffix == ".json":
        return json.dumps({COMMENT: f"{written_by().capitalize()}.", **params}, allow_nan=False) + "\n"
    import yaml

    return f"# {written_by().capitalize()}.\n{yaml.safe_dump(params, sort_keys=False, default_flow_style=None, width=120)}"


def _draw(path: Path, found: Fit) -> None:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 4.8), layout="constrained")
    found.plot(figure.subplots())
    save_picture(path, figure, dpi=150)


def _as_json(found: Fit) -> dict[str, Any]:
    members: dict[str, Any] = plain_json(found)
    return {**members, "correlation": plain_json(found.correlation)}


def _shown(found: Fit, measured: Path) -> list[Any]:
    percent = f"{100 * found.confidence:g} %"
    rows = []
    for one in found.parameters:
        low, high = one.interval or (None, None)
        interval = None if low is None or high is None else f"{_short(low)} to {_short(high)}"
        bound = f"at its {'lower' if one.at_bound == 'low' else 'upper'} bound" if one.at_bound else None
        error = None if one.standard_error is None else float(f"{one.standard_error:.2g}")
        rows.append([one.path, one.value, error, interval or bound, f"{one.low:g} to {one.high:g}"])
    title = f"{measured.name}: {len(found.measured)} points, {found.evaluations} curves, {found.solves} solves"
    shown: list[Any] = [listing(title, ["parameter", "value", "standard error", f"{percent} interval", "bounds"], rows)]
    pairs = [
        (f"correlation of {one.path} and {other.path}", float(f"{found.correlation[i, j]:.4f}"))
        for i, one in enumerate(found.parameters)
        for j, other in enumerate(found.parameters)
        if j > i and math.isfinite(found.correlation[i, j])
    ]
    unit = " (N)" if found.quantity == "force" else ""
    worst = int(np.argmax(np.abs(found.residuals)))
    largest = f"{_short(float(found.residuals[worst]))} at creepage {_short(float(found.creepage[worst]))}"
    ends: list[tuple[str, Any]] = [(f"rms residual{unit}", float(f"{found.rms:.4g}")), (f"largest residual{unit}", largest), *pairs]
    return [*shown, "", facts("", [*ends, ("converged", found.converged)])]


def _short(value: float) -> str:
    return number(float(f"{value:.4g}"))
