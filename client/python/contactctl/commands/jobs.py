"""Implements jobs and cancel, which list and end jobs of the daemon."""

from __future__ import annotations

from typing import Annotated

import click
import typer
from rich.console import RenderableType

from contactd import Job, NotFound

from ..codes import Code
from ..common import Command, connected, setting
from ..output import emit, listing, note, size, span

__all__ = ["add_to", "shown_jobs"]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(jobs)
    app.command(cls=Command)(cancel)


def jobs() -> None:
    """List waiting and running jobs."""
    with connected() as client:
        found = client.jobs()
    emit(setting().json, {"jobs": found}, shown_jobs(found) if found else "no jobs")


def shown_jobs(found: tuple[Job, ...]) -> RenderableType:
    """Shows one line per job."""
    columns = ["job", "state", "stage", "done", "waiting", "since", "to go", "memory", "for", "what"]
    rows = [
        (
            job.job, job.state, job.stage or "-", f"{100 * job.fraction:.0f} %", job.callers, span(job.seconds),
            None if job.seconds_left is None else span(job.seconds_left),
            None if job.memory_bytes is None else size(job.memory_bytes),
            ", ".join(job.users) or None, job.description or None,
        )
        for job in found
    ]  # fmt: skip
    return listing(None, columns, rows)


def cancel(
    job: Annotated[list[str] | None, typer.Argument(metavar="JOB...", help="Names of jobs, as listed by jobs.")] = None,
    every: Annotated[bool, typer.Option("--all", help="All jobs.")] = False,
) -> None:
    """End jobs of the daemon; requests that wait for them fail with CANCELLED."""
    if bool(job) == every:
        raise click.UsageError("Name the jobs to cancel, or give --all.")
    ended, gone = [], []
    with connected() as client:
        for name in job or [found.job for found in client.jobs()]:
            try:
                client.cancel_job(name)
                ended.append(name)
            except NotFound:
                gone.append(name)
                if not every:  # With --all, one may have ended meanwhile.
                    note(f"contactctl: there is no job {name}.")
    emit(setting().json, {"cancelled": ended}, f"cancelled: {', '.join(ended) or 'nothing'}")
    if gone and not every:
        raise typer.Exit(Code.REFUSED)
