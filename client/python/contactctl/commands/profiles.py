"""profiles: lists standard profiles, shows one, and writes its files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, cast

import click
import typer
from rich.console import RenderableType

from contactd import Client, __version__
from contactd.files.profile_text import format_profile
from contactd.refusals import did_you_mean
from contactd.standard_profiles import OMITTED, STANDARDS
from contactd.wheel_rail import ProfileEvidence, Rail60E1, StandardName, StandardProfile, Track, WheelRailSetup

from ..common import Command, Group, connected, setting
from ..files import writable, writable_folder, write_text
from ..output import emit, facts, listing, plain_json
from ..saving import check_picture
from ..writing.profile_picture import save_profile_picture

__all__ = ["add_to"]

Name = Annotated[str, typer.Argument(help="Name of a standard profile, such as 54E1, in upper or lower case.")]
Inclination = Annotated[float, typer.Option("--inclination", help="Slope of a rail, such as 0.025 for 1/40. Default: 0, upright.")]
_INCLINATIONS = {"1/40": 1 / 40, "1/20": 1 / 20}
_AMPLITUDES = range(1, 8)  #: mm


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="Standard profiles by name.", rich_markup_mode=None)
    family.command("list", cls=Command)(list_profiles)
    family.command(cls=Command)(show)
    family.command(cls=Command)(write)
    app.add_typer(family, name="profiles")


def list_profiles() -> None:
    """List all standard profiles with their standards, sources and differences."""
    columns = ["name", "of", "standard", "shape", "second source", "difference (mm)"]
    rows = [[name, of.of, _edition(name), of.shape, of.second, of.difference] for name, of in STANDARDS.items()]
    given = {"profiles": [{"name": name, **plain_json(of)} for name, of in STANDARDS.items()], "omitted": dict(OMITTED)}
    emit(setting().json, given, listing(None, columns, rows), "", listing("Left out", ["name", "reason"], OMITTED.items()))


def show(
    name: Name, inclination: Inclination = 0,
    output: Annotated[str | None, typer.Option("--output", "-o", metavar="FILE", help="Write a picture: .png, .svg or .pdf.")] = None,
) -> None:  # fmt: skip
    """Show the sources of a profile, its extent, and its equivalent conicity with S1002 or UIC60."""
    known = _known(name)
    if output is not None:
        check_picture("--output", output)
    with connected(local_unless_named=True) as client:
        points, evidence = _placed(client, known, inclination)
        conicities = {slope: _conicities(client, known, value) for slope, value in _INCLINATIONS.items()}
    if output is not None:
        save_profile_picture(Path(output), f"{known}, {_edition(known)}", points, evidence)
    given = {"name": known, **plain_json(STANDARDS[known]), "points": points, "conicities": conicities}
    emit(setting().json, given, facts(known, _rows(known, points)), "", _listed(known, conicities))


def write(
    name: Name,
    target: Annotated[Path, typer.Argument(metavar="[FOLDER]", help="Folder of the files.")] = Path(),
    inclination: Inclination = 0,
) -> None:
    """Write its files in mm: Simpack (.prr, .prw) with z downwards, and MiniProf (.ban, .whl) with z upwards."""
    known = _known(name)
    of = STANDARDS[known].of
    writable_folder("the folder", target).mkdir(parents=True, exist_ok=True)
    files = [writable("the file", target / f"{known}{ending}") for ending in ((".prw", ".whl") if of == "wheel" else (".prr", ".ban"))]
    with connected(local_unless_named=True) as client:
        points, _ = _placed(client, known, inclination)
    slope = f", inclined by {inclination:g}" if inclination else ""
    for file in files:
        upwards = "upwards" if file.suffix in (".ban", ".whl") else "downwards"
        remark = f"{of} {known} of {_edition(known)}{slope}, made by contactctl {__version__}: y to the field side, z {upwards}, mm"
        write_text(file, format_profile(points, of, file.suffix, [remark]))
    given = {"name": known, "files": [str(file) for file in files], "points": len(points)}
    emit(setting().json, given, *(f"{file}: {len(points)} points of a {of}" for file in files))


def _known(name: str) -> StandardName:
    known = name.upper()
    if known in STANDARDS:
        return cast(StandardName, known)
    if known in OMITTED:
        raise click.UsageError(f"{known} is left out: {OMITTED[known]}.")
    raise click.UsageError(f"There is no standard profile {name!r}.{did_you_mean(name, STANDARDS)} See contactctl profiles list.")


def _edition(name: StandardName) -> str:
    of = STANDARDS[name]
    return of.standard if of.year is None else f"{of.standard}:{of.year}"


def _placed(client: Client, name: StandardName, inclination: float) -> tuple[Any, ProfileEvidence]:
    """Returns the points of a profile and the results of processing them."""
    profile = StandardProfile(name, inclination or None)
    track = Track(rail_origin=(750.0, 0.0))  # needs no gauge face
    if STANDARDS[name].of == "wheel":
        placed = client.placed_profiles(WheelRailSetup(wheel=profile, track=track)).right
        return placed.wheel, placed.wheel_evidence
    placed = client.placed_profiles(WheelRailSetup(rail=profile, track=track)).right
    return placed.rail, placed.rail_evidence


def _conicities(client: Client, name: StandardName, inclination: float) -> Any:
    """Returns the equivalent conicities of a rail under S1002, or of a wheel on UIC60."""
    if STANDARDS[name].of == "wheel":
        setup = WheelRailSetup(wheel=StandardProfile(name), rail=Rail60E1(inclination))
    else:
        setup = WheelRailSetup(rail=StandardProfile(name, inclination))
    return client.equivalent_conicity(setup, _AMPLITUDES)


def _rows(name: StandardName, points: Any) -> list[tuple[str, Any]]:
    of = STANDARDS[name]
    (left, right), (top, low) = ((float(values.min()), float(values.max())) for values in points.T)
    return [
        ("profile of", f"a {of.of}"),
        ("standard", _edition(name)),
        ("shape", of.shape),
        ("source", of.first),
        ("second source", of.second),
        ("largest difference (mm)", of.difference),
        ("points", len(points)),
        ("y (mm)", f"{left:.3f} to {right:.3f}"),
        ("z (mm)", f"{top:.3f} to {low:.3f}"),
    ]


def _listed(name: StandardName, conicities: dict[str, Any]) -> RenderableType:
    other = "on UIC60" if STANDARDS[name].of == "wheel" else "under S1002"
    values = zip(_AMPLITUDES, *conicities.values(), strict=True)
    rows = [[amplitude, *(found.integrated for found in of_slopes)] for amplitude, *of_slopes in values]
    return listing(f"Equivalent conicity {other}, gauge 1435 mm", ["amplitude (mm)", *(f"rails at {slope}" for slope in conicities)], rows)
