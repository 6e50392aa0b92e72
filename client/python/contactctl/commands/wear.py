"""Implements wear, which wears profiles in a set of weighted states."""

from __future__ import annotations

import os
import shutil
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Annotated, Any

import click
import typer

from contactd import Client, InvalidArgument
from contactd.calls.answer_warnings import collected
from contactd.files.marks import written_by
from contactd.wear import WearStudy, WeightedState, WornStep, evolve, read_record, write_record
from contactd.wear.dynamics import Dynamics, evolve_with, states_of_stage
from contactd.wear.evolution import Solve, by_threads, place_of
from contactd.wheel_rail import WheelRailState

from ..codes import Code, Ended
from ..common import Command, connected, setting
from ..files import writable, writable_folder, write_text
from ..output import emit, listing, note, span, warn_of
from ..progress import Bar
from ..saving import need
from ..study.shares import Share, share_of
from ..wearing.along import is_along, wear_along
from ..wearing.by_dask import solving_by_dask
from ..wearing.convergence import settled
from ..wearing.outputs import Measures, check_folders, measured, totals_of, write_pictures, write_profiles
from ..wearing.reading import read_dynamics, read_study
from ..wearing.shares import ShareFiles, work

__all__ = ["add_to"]

_SHOWN = 40  #: Number of steps in a printed table.


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(wear)


def wear(
    file: Annotated[str, typer.Argument(help="JSON or YAML: setup, states, wears, law, until, step, smoothing.")],
    output: Annotated[Path | None, typer.Option("--output", "-o", metavar="FILE", help="HDF5 file with all steps. Default: FILE.h5 next to it.")] = None,
    workers: Annotated[int, typer.Option("--workers", "-w", min=1, max=128, help="Number of requests at a time.")] = os.cpu_count() or 1,
    profile: Annotated[Path | None, typer.Option("--profile", metavar="FILE", help="Write the last section: y and z, one point per line.")] = None,
    profiles: Annotated[Path | None, typer.Option("--profiles", metavar="FOLDER", help="Folder for the last profiles: .prw or .prr, .whl or .ban.")] = None,
    pictures: Annotated[Path | None, typer.Option("--pictures", metavar="FOLDER", help="Folder for pictures of profiles, depths, groups, conicity and more.")] = None,
    share: Annotated[str | None, typer.Option("--share", metavar="INDEX/COUNT", help="Solve a share of the states; 0/4 makes the steps, 1/4 to 3/4 help.")] = None,
    longest_wait: Annotated[float, typer.Option("--longest-wait", metavar="SECONDS", min=1, help="Time that shares wait for each other.")] = 3600,
    dask: Annotated[str | None, typer.Option("--dask", metavar="SCHEDULER", help="Use the workers of a Dask cluster, such as tcp://host:8786.")] = None,
    convergence: Annotated[bool, typer.Option("--convergence", help="Only check convergence: with other states, elements and steps.")] = False,
    allow_program: Annotated[bool, typer.Option("--allow-program", help="Allow the program in dynamics of the study.")] = False,
    fresh: Annotated[bool, typer.Option("--fresh", help="Start again with the new profile.")] = False,
) -> None:
    """Wear a wheel, a rail, or both in a set of weighted states, step by step.

    If it is killed and started again, it continues after the last step.
    """
    need("h5py", "HDF5 files", "hdf5")
    if pictures is not None:
        need("matplotlib", "pictures", "pictures")
    if convergence:
        _tell_convergence(read_study(file), workers)
        return
    part = None if share is None else share_of(share)
    if part is not None and dask is not None:
        raise click.UsageError("--share and --dask divide the states in different ways; use one of them.")
    if output is None:
        if file == "-":
            raise click.UsageError("A study from standard input requires --output, the file for its steps.")
        output = Path(f"{file}.h5")
    writable("--output", output)
    if is_along(file):
        if part is not None or dask is not None or profiles is not None or pictures is not None or profile is not None:
            raise click.UsageError("A study along the track writes a map; it supports no profiles, pictures, shares or Dask.")
        wear_along(file, output)
        return
    dynamics = read_dynamics(file, Path(f"{output}.stages"), allow_program)
    if dynamics is not None and part is not None:
        raise click.UsageError("--share requires states from a file, but dynamics computes new ones.")
    study = read_study(file) if dynamics is None else _study_of(file, dynamics, fresh)
    if profile is not None:
        writable("--profile", profile)
    for option, folder in (("--profiles", profiles), ("--pictures", pictures)):
        if folder is not None:
            writable_folder(option, folder)
    check_folders(profiles, pictures)
    if part is not None and part.index > 0:
        _help(study, output, part, workers, longest_wait)
        return
    steps = _before(output, study, fresh)
    try:
        measures = _evolve(study, steps, output, workers, part, longest_wait, dask, pictures is not None, dynamics)
    except BaseException:
        if len(steps) > 1:
            note(f"{steps[-1].distance:g} of {study.until:g} {study.unit} are in {output}; repeat the command to continue.")
        raise
    if profile is not None:
        write_text(profile, "".join([f"# {written_by()}\n", *(f"{y:.9g} {z:.9g}\n" for y, z in steps[-1].points)]))
    written = [] if profiles is None else write_profiles(profiles, study, steps)
    if pictures is not None:
        if len(steps) < 2:
            raise Ended(Code.USAGE, "There is no wear yet, so there is nothing to draw.")
        written += write_pictures(pictures, study, steps, measures)
    for path in written:
        note(f"wrote {path}")
    _show(steps, study)


def _tell_convergence(study: WearStudy, workers: int) -> None:
    """Shows a table of variants, each compared with the finest."""
    with connected(workers=workers, local_unless_named=True) as client, Bar("convergence") as bar:
        found = list(settled(client, study, workers, bar.show))
    columns = ["what differs", "L1 of depth", "area", "largest depth", "steps", "s"]
    rows = [[one.name, one.difference, one.area, one.largest, one.steps, one.seconds] for one in found]
    emit(setting().json, {"variants": [vars(one) for one in found]}, listing(None, columns, rows))


def _study_of(file: str, dynamics: Dynamics, fresh: bool) -> WearStudy:
    """Returns the study with the states from dynamics on the new profiles."""
    if fresh:
        _forget_stages(dynamics.folder)
    anyone = read_study(file, [WeightedState(WheelRailState(), 1.0)])
    with connected(local_unless_named=True) as client:
        new = next(evolve(client, anyone))
    return read_study(file, states_of_stage(dynamics, 0, {part: new.of(part).points for part in anyone.parts}, 0.0))


def _forget_stages(folder: Path) -> None:
    """Removes the folders of stages. Raises Ended for a folder with other files."""
    if not folder.is_dir():
        return
    for path in folder.iterdir():
        if path.is_symlink() or not (path / "distance.txt").is_file():
            raise Ended(Code.USAGE, f"{path} is not a stage written by contactd; move it, or give another file with --output.")
    shutil.rmtree(folder)


def _help(study: WearStudy, output: Path, share: Share, workers: int, longest_wait: float) -> None:
    """Runs a share other than the first."""
    with connected(workers=workers, local_unless_named=True) as client, Bar("wear") as bar:
        files = ShareFiles(output, study, share, longest_wait)
        work(
            files, output, study, place_of(client, study), share, by_threads(client, workers, study), longest_wait,
            lambda distance: bar.show(distance / study.until, f"{distance:g} of {study.until:g} {study.unit}"),
        )  # fmt: skip


def _before(output: Path, study: WearStudy, fresh: bool) -> list[WornStep]:
    if fresh:
        return []
    try:
        return read_record(output, study)
    except InvalidArgument as error:
        if len(read_record(output)) < 2:  # That study was refused, so nothing is lost.
            return []
        raise Ended(Code.USAGE, f"{error} Use --fresh to start anew.") from None
    except (OSError, KeyError):
        raise Ended(Code.USAGE, f"{output} contains no steps of wear; use --fresh to overwrite it.") from None


def _evolve(
    study: WearStudy, steps: list[WornStep], output: Path, workers: int, share: Share | None, longest_wait: float, dask: str | None, is_measured: bool,
    dynamics: Dynamics | None = None,
) -> Measures:
    """Adds completed steps to the list, and writes all to the file each time."""
    before, began = steps[-1].distance if steps else 0.0, time.monotonic()
    with ExitStack() as stack:
        stack.enter_context(collected())  # `_show` prints the warnings of all steps, including earlier ones.
        client = stack.enter_context(connected(workers=workers, local_unless_named=True))
        bar = stack.enter_context(Bar("wear"))

        def show(part: float, sentence: str) -> None:
            went = part - before / study.until
            left = f"about {span((time.monotonic() - began) / went * (1 - part))} to go" if went > 0 else ""
            bar.show(part, sentence, left)

        solve = _solving(client, study, steps, output, workers, share, longest_wait)
        if dask is not None:
            solve = stack.enter_context(solving_by_dask(dask, setting()))
        options: dict[str, Any] = {"solve": solve, "on_progress": show}
        for step in evolve(client, study, steps, **options) if dynamics is None else evolve_with(client, study, dynamics, steps, **options):
            steps.append(step)
            write_record(output, study, steps)
            bar.show(step.distance / study.until, f"{step.distance:g} of {study.until:g} {study.unit}")
        return measured(client, study, steps) if is_measured else {}


def _solving(
    client: Client, study: WearStudy, steps: list[WornStep], output: Path, workers: int, share: Share | None, longest_wait: float
) -> Solve:
    own = by_threads(client, workers, study)
    if share is None:
        return own
    return ShareFiles(output, study, share, longest_wait).solving(own, lambda: steps[-1].number)


def _show(steps: list[WornStep], study: WearStudy) -> None:
    columns = ["step", study.unit, "largest depth, mm", "area, mm^2", "T gamma, N", "pmax, N/mm^2", "ended by"]
    rows = [[s.number, s.distance, float(s.depths.max()), s.area, s.T_gamma, s.pmax, s.ended_by or None] for s in steps[1:]]
    more = [f"... {len(rows) - _SHOWN} earlier steps are in the file"] if len(rows) > _SHOWN else []
    totals = totals_of(study, steps)
    answer = {"steps": [_facts(step, study.unit) for step in steps], "total": totals}
    emit(setting().json, answer, *more, listing(None, columns, rows[-_SHOWN:]), "", *_sentences(steps, study, totals))
    warn_of("step", ((str(step.number), sentence) for step in steps for sentence in step.all_warnings))


def _sentences(steps: list[WornStep], study: WearStudy, totals: dict[str, dict[str, float]]) -> list[str]:
    """Returns the sentences below the table: the depths after all steps, and the limits of shallow steps."""
    found = [
        f"After {steps[-1].distance:g} {study.unit} the {part} is worn by up to {total['depth']:.4g} mm, at y = {total['y']:.2f} mm; "
        f"the worn area is {total['area']:.4g} mm^2."
        for part, total in totals.items()
    ]
    if bounded := [step.number for step in steps if step.ended_by.startswith("stability")]:
        which = "All steps" if len(bounded) == len(steps) - 1 else f"{len(bounded)} of {len(steps) - 1} steps"
        found.append(f"{which} limited by stability: they are less deep than step.depth = {study.depth:g} mm, at which grooves would grow.")
    return found


def _facts(step: WornStep, unit: str) -> dict[str, Any]:
    return {
        "number": step.number, unit: step.distance, "area": step.area, "removed": step.removed, "T_gamma": step.T_gamma,
        "T_gamma_with_spin": step.T_gamma_with_spin, "pmax": step.pmax, "smoothing": step.smoothing, "groups": step.groups,
        "depth": float(step.depths.max()) if step.depths.size else 0.0, "ended_by": step.ended_by, "warnings": list(step.all_warnings),
    }  # fmt: skip
