"""Reports the daemon's version, its health and its current work."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..errors import ProtocolError
from ..values.answers import read
from ..values.generated.records import RecentPatch, RecentSolve
from ..values.generated.service import Job, Progress, ServerInfo
from .call import Answering, asks
from .caller import Caller, check_shapes

__all__ = ["ServerCalls"]


class ServerCalls(Caller):
    """Calls the methods server.*, health.*, job.* and solves.* of the daemon."""

    @asks
    def info(self, *, timeout: float | None = None) -> Answering[ServerInfo]:
        """Versions, limits and counters of the daemon."""
        return (yield from self.info_asked(timeout))

    @asks
    def health(self, *, timeout: float | None = None) -> Answering[str]:
        """Returns ``"serving"`` or ``"stopping"``. It never waits for other work."""
        state = (yield from self.asked("server.health", timeout=timeout)).get("state")
        if not isinstance(state, str):
            raise ProtocolError("The answer to server.health lacks its state.")
        return state

    @asks
    def metrics(self, *, timeout: float | None = None) -> Answering[list[dict[str, Any]]]:
        """Returns the metrics of the daemon (docs/operations.md): name, type, help and samples of each."""
        metrics = (yield from self.asked("server.metrics", timeout=timeout)).get("metrics")
        if not isinstance(metrics, list):
            raise ProtocolError("The answer to server.metrics lacks its metrics.")
        return metrics

    @asks
    def watch_health(self, on_state: Callable[[str], None], *, timeout: float | None = None) -> Answering[str]:
        """Calls `on_state` with the state of the daemon, immediately and after each change, until the daemon ends.

        Returns the last state, ``"stopping"``. An exception of `on_state` ends the watch.
        """
        last = ""

        def report(progress: Progress) -> None:
            nonlocal last
            if progress.state != last:
                last = progress.state
                on_state(last)

        state = (yield from self.asked("health.watch", timeout=timeout, on_progress=report)).get("state")
        if not isinstance(state, str):
            raise ProtocolError("The answer to health.watch lacks its state.")
        if state != last:
            on_state(state)
        return state

    @asks
    def describe(self, *, timeout: float | None = None) -> Answering[dict[str, Any]]:
        """Returns the OpenRPC document of the daemon, with the JSON Schema of every message."""
        return (yield from self.asked("server.describe", timeout=timeout))

    @asks
    def config(self, *, timeout: float | None = None) -> Answering[dict[str, Any]]:
        """Returns the configuration of the daemon (docs/configuration.md) with its defaults, except secrets and the
        names of files, programs, variables and addresses.
        """
        config = (yield from self.asked("server.config", timeout=timeout)).get("config")
        if not isinstance(config, dict):
            raise ProtocolError("The answer to server.config lacks the configuration.")
        return config

    @asks
    def jobs(self, *, timeout: float | None = None) -> Answering[tuple[Job, ...]]:
        """Returns the jobs that wait or run."""
        jobs = (yield from self.asked("job.list", timeout=timeout)).get("jobs")
        if not isinstance(jobs, list):
            raise ProtocolError("The answer to job.list lacks its jobs.")
        return tuple(read(Job, job, f"result.jobs[{i}]") for i, job in enumerate(jobs))

    @asks
    def cancel_job(self, job: str, *, timeout: float | None = None) -> Answering[None]:
        """Ends a job. Every call that waits for it raises Cancelled."""
        yield from self.asked("job.cancel", {"job": job}, timeout=timeout)

    @asks
    def recent_solves(self, *, timeout: float | None = None) -> Answering[tuple[RecentSolve, ...]]:
        """Returns the last solves of this user, the latest first. A user is a key; without keys, an address or, over
        ipc, a user of the machine. The daemon's `recent_solves` limits their number for all users.
        """
        solves = (yield from self.asked("solves.recent", timeout=timeout)).get("solves")
        if not isinstance(solves, list):
            raise ProtocolError("The answer to solves.recent lacks its solves.")
        return tuple(read(RecentSolve, solve, f"result.solves[{i}]") for i, solve in enumerate(solves))

    @asks
    def recent_pressures(self, number: int, *, timeout: float | None = None) -> Answering[tuple[RecentPatch, ...]]:
        """Returns the pressures of a solve on each of its grids, by its number in recent_solves.

        Raises NotFound if the daemon does not have them or no longer has them.
        """
        patches = (yield from self.asked("solves.pressures", {"number": number}, timeout=timeout)).get("patches")
        if not isinstance(patches, list):
            raise ProtocolError("The answer to solves.pressures lacks its patches.")
        found = tuple(read(RecentPatch, patch, f"result.patches[{i}]") for i, patch in enumerate(patches))
        for patch in found:
            check_shapes(patch, ["pressure", "element_division"], (patch.grid.ny, patch.grid.nx))
        return found
