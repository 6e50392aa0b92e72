"""Implements roughness, which computes spectra of a measured record before and after the contact filter."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal, cast, get_args

import click
import numpy as np
import typer

from contactd import Client, InvalidArgument
from contactd.files.number_text import number_in
from contactd.materials import steel
from contactd.pictures.canvas import plain
from contactd.pictures.roughness import draw_levels
from contactd.roughness import (
    ISO_3095_2013,
    ContactFilter,
    Lines,
    Record,
    Spectrum,
    chi_of,
    contact_weights,
    effective,
    hertz_weights,
    lines_of,
    read_record,
    rolled,
    wheel_rail_weights,
    without_spikes,
)
from contactd.roughness.filters import Weights
from contactd.values.wheel_rail.solution import read_wheel_rail

from ..asking import ask
from ..common import Command, connected, setting
from ..files import read_object, writable, write_text
from ..output import emit, facts, listing, warn
from ..saving import check_picture
from ..writing.csv_files import csv_text
from ..writing.drawing import save_picture

__all__ = ["add_to"]

_COLUMNS = ("wavelength", "level", "filter", "filtered", "limit")
_LEAST_LOAD, _LEAST_RADIUS = 200.0, 5.0  #: N, mm: smaller values are probably in kN and m
Across = Literal["isotropic", "alike", "measured"]


def add_to(app: typer.Typer) -> None:
    """Adds the command."""
    app.command(cls=Command)(roughness)


def roughness(
    file: Annotated[Path, typer.Argument(help="The record: text or CSV with x and the heights of one or more lines, .npy, or .npz.")],
    x_unit: Annotated[str | None, typer.Option("--x-unit", help="Unit of x: m, cm, mm or um. Default: that in the heading.")] = None,
    height_unit: Annotated[str | None, typer.Option("--height-unit", help="Unit of the heights: um, mm, nm, cm or m. Default: that in the heading.")] = None,
    spacing: Annotated[float | None, typer.Option("--spacing", help="Distance of the samples in the unit of x, if the file has no column x.")] = None,
    columns: Annotated[str | None, typer.Option("--columns", metavar="N,N,...", help="Columns of x and the lines, counted from 1. Default: all.")] = None,
    y: Annotated[str | None, typer.Option("--y", metavar="Y,Y,...", help="Lateral positions of several lines (mm), increasing.")] = None,
    upside_down: Annotated[bool, typer.Option("--upside-down", help="Heights are positive into the surface.")] = False,
    raw: Annotated[bool, typer.Option("--raw", help="Omit the processing of EN 15610: spikes and the circle of 0.375 m.")] = False,
    segment: Annotated[float, typer.Option("--segment", min=1, max=1e6, help="Length of a segment of the spectrum (mm).")] = 1000,
    load: Annotated[float | None, typer.Option("--load", min=1, max=1e7, help="Filter of Hertz's contact of steel under this wheel load (N).")] = None,
    radii: Annotated[str, typer.Option("--radii", metavar="RX,RY", help="With --load: combined radii of curvature along and across (mm).")] = "460,300",
    case: Annotated[str | None, typer.Option("--case", metavar="FILE", help="Filter of a contact: JSON or YAML with the parameters of contact.solve.")] = None,
    wheel: Annotated[str | None, typer.Option("--wheel", metavar="FILE", help="Filter of a wheel on its rail: JSON or YAML with setup and state of wheelrail.solve.")] = None,
    across: Annotated[str | None, typer.Option("--across", help="Roughness across: isotropic, alike, or measured by several lines. Default: measured, or isotropic for one line.")] = None,
    exponent: Annotated[float, typer.Option("--exponent", min=2, max=8, help="Exponent of an isotropic surface: its spectrum is ~ K^-exponent.")] = 3,
    plot: Annotated[str | None, typer.Option("--plot", metavar="FILE", help="Write a picture: .png, .svg or .pdf.")] = None,
    table: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write the levels to a CSV file.")] = None,
) -> None:  # fmt: skip
    """Compute the spectrum of a measured roughness, and that after the contact filter.

    Levels are those of third octaves in dB relative to 1 um.
    """
    if plot is not None:
        check_picture("--plot", plot)
    if table is not None:
        writable("--csv", table, _COLUMNS)
    if sum(one is not None for one in (load, case, wheel)) > 1:
        raise click.UsageError("Give one of --load, --case and --wheel.")
    lines_used = None if columns is None else [int(number) - 1 for number in _numbers("--columns", columns)]
    places = None if y is None else _numbers("--y", y)
    try:
        record = read_record(file, x_unit=x_unit, height_unit=height_unit, spacing=spacing, columns=lines_used, y=places, upside_down=upside_down)
        clean = record if raw else without_spikes(record)
        used = clean if raw else rolled(clean)
        lines = lines_of(used, segment=segment)
    except InvalidArgument as error:
        raise click.UsageError(f"{file}: {error.message}") from None
    chosen = _across(across, len(record.y))
    found = _contact(load, _two("--radii", radii), case, wheel)
    filtered, chi = None, None
    if found is not None:
        filtered = _filtered(found[0], used, lines, chosen, exponent, segment)
        chi = chi_of(clean, *found, across="alike" if chosen == "alike" else "isotropic")
    weights = None if found is None else found[0]
    spectrum = lines.third_octaves()
    rows = _rows(spectrum, filtered)
    if table is not None:
        write_text(table, csv_text([_COLUMNS, *([number if np.isfinite(number) else "" for number in row] for row in rows)]))
    if plot is not None:
        _draw(Path(plot), file.name, spectrum, filtered)
    about: list[tuple[str, Any]] = [
        ("record", f"{record.length / 1e3:g} m, {record.heights.shape[1]} samples {record.spacing:g} mm apart, {len(record.y)} lines"),
        ("processing", "none" if raw else "EN 15610: spikes, circle of 0.375 m"),
        ("segments", lines.segments),
        ("semi-axes (mm)", None if weights is None else "{:.4g} along, {:.4g} across".format(*weights.semi_axes)),
        ("roughness across", None if weights is None else chosen + (f", exponent {exponent:g}" if chosen == "isotropic" else "")),
        ("chi", None if chi is None else float(f"{chi:.2g}")),
    ]
    heads = ["wavelength (mm)", "level (dB)", "filter (dB)", "filtered (dB)", "limit (dB)"]
    cells = [[row[0], *(float(f"{number:.2f}") if np.isfinite(number) else None for number in row[1:])] for row in rows]
    emit(setting().json, _as_json(record, lines, rows, chi, chosen, weights), facts(file.name, about), "", listing("Third octaves, dB re 1 um", heads, cells))


def _numbers(option: str, text: str) -> list[float]:
    found = [number_in(word.strip()) for word in text.split(",")]
    if None in found:
        raise click.UsageError(f"{option} {text}: it must be numbers separated by commas.")
    return [float(number or 0) for number in found]


def _two(option: str, text: str) -> tuple[float, float]:
    found = _numbers(option, text)
    if len(found) != 2:
        raise click.UsageError(f"{option} {text}: it must be two radii in mm, such as 460,300.")
    return found[0], found[1]


def _across(given: str | None, lines: int) -> Across:
    if given not in (None, *get_args(Across)):
        raise click.UsageError(f"--across {given}: it must be isotropic, alike or measured.")
    if given == "measured" and lines == 1:
        raise click.UsageError("--across measured: the record has one line. Choose isotropic or alike.")
    return cast(Across, given or ("measured" if lines > 1 else "isotropic"))


def _contact(load: float | None, radii: tuple[float, float], case: str | None, wheel: str | None) -> tuple[Weights, float] | None:
    """Returns the weights of the contact, and its force (N); None without a contact."""
    if load is not None:
        if load < _LEAST_LOAD:
            warn([f"--load {load:g}: the load is very small for a wheel. Give it in N; is it in kN?"])
        if min(radii) < _LEAST_RADIUS:
            warn([f"--radii {radii[0]:g},{radii[1]:g}: the radii are very small for a wheel and a rail. Give them in mm; are they in m?"])
        return hertz_weights(load, *radii, steel), load
    if (given := case or wheel) is None:
        return None
    with connected(local_unless_named=True) as client:
        return (_of_case if case is not None else _of_wheel)(client, read_object(given))


def _of_case(client: Client, params: dict[str, Any]) -> tuple[Weights, float]:
    answer = ask(client, "contact.solve", {**params, "fields": []}, "solving")
    return contact_weights(client, params), float(answer["forces"]["Fn"])


def _of_wheel(client: Client, params: dict[str, Any]) -> tuple[Weights, float]:
    answer = ask(client, "wheelrail.solve", {**params, "fields": ["pressure"]}, "solving")
    solution = read_wheel_rail(["pressure"], False, answer)
    return wheel_rail_weights(client, params.get("setup", {}), solution), solution.forces.track.Fz


def _filtered(weights: Weights, record: Record, lines: Lines, across: Across, exponent: float, segment: float) -> tuple[Spectrum, Spectrum]:
    """Returns the filter, and the filtered spectrum."""
    if across == "measured":
        found = lines_of(effective(weights, record), segment=segment).third_octaves()
        return Spectrum(found.wavelengths, found.levels - lines.third_octaves().levels), found
    contact = ContactFilter(weights, across, exponent)
    return contact.third_octaves(lines), contact.filtered(lines).third_octaves()


def _rows(spectrum: Spectrum, filtered: tuple[Spectrum, Spectrum] | None) -> list[list[float]]:
    limits = dict(zip(map(float, ISO_3095_2013.wavelengths), map(float, ISO_3095_2013.levels)))
    rows = []
    for i, wave in enumerate(map(float, spectrum.wavelengths)):
        gain, after = (np.nan, np.nan) if filtered is None else (float(part.levels[i]) for part in filtered)
        rows.append([wave, float(spectrum.levels[i]), gain, after, limits.get(wave, np.nan)])
    return rows


def _as_json(record: Record, lines: Lines, rows: list[list[float]], chi: float | None, across: str, weights: Weights | None) -> dict[str, Any]:
    bands = [{name: number for name, number in zip(_COLUMNS, row) if np.isfinite(number)} for row in rows]
    found = {"length": record.length, "spacing": record.spacing, "segments": lines.segments, "bands": bands}
    return found if weights is None else {**found, "across": across, "semi_axes": list(weights.semi_axes), "chi": chi}


def _draw(path: Path, name: str, spectrum: Spectrum, filtered: tuple[Spectrum, Spectrum] | None) -> None:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.8, 4.6), layout="constrained")
    axes = figure.subplots()
    draw_levels(axes, {"measured": spectrum, **({} if filtered is None else {"after the contact filter": filtered[1]})}, ISO_3095_2013)
    axes.set_title(plain(name, 80), fontsize="medium")
    save_picture(path, figure, dpi=150)
