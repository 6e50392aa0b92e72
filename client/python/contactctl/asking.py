"""Sends one request to the daemon, with a progress bar, and ends its builds if it is interrupted."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from contactd import Client, ContactdError, Job, Progress, StatusError, TimeoutExpired
from contactd.calls.timeouts import may_build

from .codes import Code, Ended
from .interrupts import uninterrupted
from .output import note
from .progress import Bar

__all__ = ["OwnBuilds", "ask", "reports_of_rounds"]

_LONGEST_WAIT = 1.0  # seconds until the daemon has received the cancellation


class OwnBuilds:
    """Records the builds that requests start from now on, without those that they join."""

    def __init__(self, client: Client) -> None:
        self._client = client
        self._others = {job.job for job in client.jobs()}
        self._seen: set[str] = set()

    def notice(self, progress: Progress) -> None:
        """Reads the progress of a request."""
        if progress.job.startswith("build-"):
            self._seen.add(progress.job)

    @property
    def latest(self) -> str:
        """Returns the name of the latest build, or ""."""
        return max(self._seen, default="")

    def cancel(self) -> None:
        """Ends the builds of abandoned requests, after the requests are cancelled."""
        with uninterrupted():
            self._cancel()

    def _cancel(self) -> None:
        try:
            deadline = time.monotonic() + _LONGEST_WAIT
            while self._may_change(mine := self._running()) and time.monotonic() < deadline:
                time.sleep(0.05)
            for job in mine:
                if job.callers:
                    note(f"{job.job} continues, because other requests wait for it.")
                    continue
                self._client.cancel_job(job.job, timeout=_LONGEST_WAIT)
                note(f"{job.job} is cancelled.")
        except ContactdError as error:
            note(f"contactctl: the started jobs cannot be cancelled: {error}")

    def _may_change(self, mine: list[Job]) -> bool:
        return any(job.callers for job in mine) or not (mine or self._seen)

    def _running(self) -> list[Job]:
        jobs = [job for job in self._client.jobs(timeout=_LONGEST_WAIT) if job.job.startswith("build-")]
        new = [job for job in jobs if job.job not in self._others]
        if self._seen:
            return [job for job in new if job.job in self._seen]
        # An interrupted build whose name the daemon has not reported counts as abandoned.
        return [job for job in new if not job.callers]


@contextmanager
def own_builds(client: Client, params: dict[str, Any]) -> Iterator[OwnBuilds | None]:
    """Yields the builds of requests with these parameters, None if they start none. Ends them if interrupted."""
    builds = OwnBuilds(client) if may_build(params) else None
    try:
        yield builds
    except KeyboardInterrupt:
        if builds is not None:
            builds.cancel()
        raise


@contextmanager
def reports_of_rounds(client: Client, params: dict[str, Any], bar: Bar) -> Iterator[Callable[[Progress], None]]:
    """Shows the progress of several requests together, and that of a build that they wait for."""
    with own_builds(client, params) as builds:

        def report(progress: Progress) -> None:
            if builds is not None:
                builds.notice(progress)
            if progress.job:
                bar.report(progress)
            else:
                bar.show(progress.fraction, progress.stage)

        yield report


def ask(client: Client, method: str, params: dict[str, Any], what: str) -> dict[str, Any]:
    """Returns the result of a request; its bar shows `what`. Ends its builds if interrupted."""
    with own_builds(client, params) as builds:
        try:
            with Bar(what) as bar:

                def report(progress: Progress) -> None:
                    if builds is not None:
                        builds.notice(progress)
                    bar.report(progress)

                return client.call(method, params, on_progress=report)
        except TimeoutExpired as error:
            raise Ended(Code.TIMEOUT, _late(error, builds)) from None


def _late(error: TimeoutExpired, builds: OwnBuilds | None) -> str:
    if builds is None:
        return error.message if isinstance(error, StatusError) else str(error)
    job = builds.latest
    which = f"as {job}: `contactctl cancel {job}` ends it" if job else ": `contactctl cancel` ends it"
    return (
        f"The table was not available in time. Its build continues in the daemon {which}, `contactctl jobs` shows its " "progress, and repeating the command joins it."
    )
