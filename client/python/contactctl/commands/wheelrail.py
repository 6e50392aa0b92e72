"""Implements wheelrail, which solves a wheel on a rail, from a file or from a few numbers."""

from __future__ import annotations

import math
from typing import Annotated, Any

import typer
from rich.console import RenderableType

from contactd import Client, StatusError
from contactd.calls.answer_warnings import collected
from contactd.values.answers import read
from contactd.values.generated.wheel_rail.rigid_wheelset import PlacedProfiles
from contactd.values.generated.wheel_rail.setup import Side as WheelSide
from contactd.values.generated.wheel_rail.state import RailDeviation, WheelsetPosition
from contactd.values.wheel_rail.origins import RADIUS, Origin, remember
from contactd.values.wheel_rail.solution import WheelRailSolution, read_wheel_rail

from ..asking import ask
from ..codes import Code, Ended
from ..common import Command, Group, connected, setting
from ..files import read_object, with_arrays
from ..output import above_rounding, emit, facts, listing
from ..paths import changed, get
from ..saving import check_outputs, is_picture, save
from .solve import Fields, Outputs, Set, requested_fields

__all__ = ["add_to"]

File = Annotated[str | None, typer.Argument(metavar="[FILE]", help="JSON or YAML with setup and state of wheelrail.solve. Default: S1002 on 60E1.")]
Y = Annotated[float | None, typer.Option("--y", help="Lateral shift of the wheelset to the right (mm).")]
Yaw = Annotated[float | None, typer.Option("--yaw", help="Yaw angle of the wheelset (rad).")]
Roll = Annotated[float | None, typer.Option("--roll", help="Roll angle of the wheelset (rad).")]
Fz = Annotated[float | None, typer.Option("--Fz", help="Vertical force of this wheel on the rail (N).")]
Speed = Annotated[float | None, typer.Option("--speed", help="Forward speed (mm/s). The wheelset rolls, unless the file has a pitch rate.")]
Side = Annotated[str | None, typer.Option("--side", help="Side of the wheel: right or left.")]
Mu = Annotated[float | None, typer.Option("--mu", help="Friction coefficient. Default without a file: 0.3.")]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    family = typer.Typer(cls=Group, help="A wheel on a rail.", rich_markup_mode=None)
    family.command(cls=Command)(solve)
    family.command(cls=Command)(geometry)
    app.add_typer(family, name="wheelrail")


def solve(
    file: File = None, y: Y = None, yaw: Yaw = None, roll: Roll = None, Fz: Fz = None, speed: Speed = None,
    side: Side = None, mu: Mu = None, sets: Set = None, output: Outputs = None, fields: Fields = None,
) -> None:  # fmt: skip
    """Solve patches and forces on the rail. Exit code 5: it did not converge."""
    outputs = check_outputs(output or ())
    params = _params(file, {"y": y, "yaw": yaw, "roll": roll}, Fz, speed, side, mu, sets)
    requested_fields(params, fields, outputs)
    with connected(local_unless_named=True) as client:
        answer = ask(client, "wheelrail.solve", params, "solving")
        profiles = _profiles(client, params) if any(is_picture(path) for path in outputs) else None
    for path in outputs:
        save(path, answer, lambda: _solution(params, answer, profiles))
    emit(setting().json, answer, *_shown(answer))
    if not answer["converged"]:
        raise Ended(Code.NOT_CONVERGED, "a solver or a search missed its tolerance; see evidence.")


def _profiles(client: Client, params: dict[str, Any]) -> PlacedProfiles | None:
    """Returns the profiles of the side for a picture; None if the set-up has none."""
    try:
        with collected():  # The solution has their warnings.
            both = client.placed_profiles(params.get("setup", {}))
    except StatusError:
        return None
    return both.left if get(params, "setup.side") == "left" else both.right


def _solution(params: dict[str, Any], answer: dict[str, Any], profiles: PlacedProfiles | None) -> WheelRailSolution:
    """Returns the Python solution with its set-up and state."""
    solution = read_wheel_rail(params.get("fields"), params.get("gap", False), answer)
    radius = get(params, "setup.wheelset.nominal_radius")
    position = read(WheelsetPosition, get(params, "state.position") or {}, "state.position")
    rail = read(RailDeviation, get(params, "state.rail") or {}, "state.rail")
    side: WheelSide = "left" if get(params, "setup.side") == "left" else "right"
    remember(solution, Origin(side, RADIUS if radius is None else float(radius), position, rail, lambda: profiles))
    return solution


def geometry(
    file: File = None, y: Y = None, yaw: Yaw = None, roll: Roll = None, Fz: Fz = None, speed: Speed = None,
    side: Side = None, mu: Mu = None, sets: Set = None,
) -> None:  # fmt: skip
    """Compute contact points, angles, radii and creepages without a solve."""
    params = _params(file, {"y": y, "yaw": yaw, "roll": roll}, Fz, speed, side, mu, sets)
    if "state" in params:
        params["states"] = [params.pop("state")]
    with connected(local_unless_named=True) as client:
        answer = ask(client, "wheelrail.geometry", params, "searching")
    shown = [part for found in answer.get("geometries", ()) for part in _shown_geometry(found)]
    if "conicities" in answer:
        columns = ["amplitude (mm)", "integrated", "harmonic", "wavelength (mm)"]
        rows = [[found.get(name) for name in ("amplitude", "integrated", "harmonic", "wavelength")] for found in answer["conicities"]]
        shown.append(listing("Equivalent conicity", columns, rows))
    emit(setting().json, answer, *shown)


def _params(
    file: str | None, position: dict[str, float | None], force: float | None, speed: float | None,
    side: str | None, mu: float | None, sets: list[str] | None,
) -> dict[str, Any]:  # fmt: skip
    """Returns `setup` and `state`; options replace values in the file."""
    params = read_object(file) if file is not None else {"setup": {}, "state": {}}
    given: list[tuple[str, Any]] = [(f"state.position.{name}", value) for name, value in position.items()]
    given += [("state.Fz", force), ("state.velocity.x", speed), ("setup.side", side), ("setup.friction.mu", mu)]
    params = changed(params, [f"{path}={value}" for path, value in given if value is not None])
    if speed is not None:
        radius = get(params, "setup.wheelset.nominal_radius")
        is_usable = isinstance(radius, (int, float)) and radius != 0  # The daemon refuses other values.
        params["state"]["velocity"].setdefault("pitch", -speed / (radius if is_usable else RADIUS))
    # Files in options are relative to the current folder.
    return with_arrays(changed(params, sets), "--set") if sets else params


def _shown(answer: dict[str, Any]) -> list[RenderableType]:
    track = answer["forces"]["track"]
    largest = max(abs(float(track[name])) for name in ("Fx", "Fy", "Fz"))
    rows: list[tuple[str, Any]] = [
        ("height z (mm)", float(answer["z"])),
        ("pitch rate (rad/s)", float(answer["pitch_rate"])),
        ("clearance (mm)", answer.get("clearance")),
        *((f"{name} (N)", above_rounding(float(track[name]), largest)) for name in ("Fx", "Fy", "Fz")),
        ("converged", bool(answer["converged"])),
    ]
    shown: list[RenderableType] = [facts("Forces on the rail, in track coordinates", rows)]
    columns = ["patch", "y (mm)", "angle (deg)", "Fn (N)", "Fx (N)", "Fy (N)", "pmax (N/mm^2)", "contact (mm^2)"]
    lines = []
    for index, patch in enumerate(answer["patches"], 1):
        place, found = patch["place"]["reference"], patch["solution"]
        forces = (above_rounding(float(found["forces"][name]), largest) for name in ("Fn", "Fx", "Fy"))
        lines.append((index, place["y"], math.degrees(place["angle"]), *forces, float(found["pmax"]), float(found["area"]["contact"])))
    shown += ["", listing("Patches, in contact coordinates", columns, lines) if lines else "Wheel and rail do not touch."]
    return shown


def _shown_geometry(found: dict[str, Any]) -> list[RenderableType]:
    rows = [("height z (mm)", float(found["z"])), ("clearance (mm)", found.get("clearance"))]
    columns = ["place", "y (mm)", "z (mm)", "angle (deg)", "approach (mm)", "xi", "eta", "phi (rad/mm)"]
    lines = []
    for index, place in enumerate(found["places"], 1):
        at, creep = place["reference"], place["creepages"]
        creepages = (float(creep[name]) for name in ("xi", "eta", "phi"))
        lines.append((index, at["y"], at["z"], math.degrees(at["angle"]), float(place["approach"]), *creepages))
    return [facts("Wheelset", rows), listing("Places", columns, lines) if lines else "Wheel and rail do not touch.", ""]
