"""Holds the known state of a daemon at one time, as immutable values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from contactd import Job, RecentSolve, ServerInfo
from contactd.values.generated.service import SessionSummary

__all__ = ["AWAY", "CONNECTING", "Sample", "View"]

CONNECTING = "connecting"
AWAY = "away"


@dataclass(frozen=True)
class Sample:
    """Holds rates and values between two updates.

    Attributes:
        at: Time of the second update (s since 1970).
        said: Rates and values, from `measured.difference`.
        median: Median time of requests (s) without those of observers; None without requests.
        slow: 95th percentile of the time (s).
    """

    at: float
    said: Mapping[str, Any]
    median: float | None
    slow: float | None


@dataclass(frozen=True)
class View:
    """Holds results of an update. If the daemon does not answer, it has those of the last answer.

    Attributes:
        state: "connecting", "serving", "stopping", or "away" (no answer).
        why: Reason for "away"; otherwise "".
        since: Start of the state (s since 1970).
        warnings: Warnings of the daemon.
        info: Versions and limits; None before the first answer.
        config: Its configuration without secrets; None before the first answer, and if the daemon does not report it.
        store: A value that changes with the tables of the store.
        samples: Samples of the last minutes, oldest first.
    """

    state: str
    why: str = ""
    since: float = 0.0
    warnings: tuple[str, ...] = ()
    info: ServerInfo | None = None
    config: Mapping[str, Any] | None = None
    jobs: tuple[Job, ...] = ()
    sessions: tuple[SessionSummary, ...] = ()
    solves: tuple[RecentSolve, ...] = ()
    store: tuple[float, ...] = ()
    samples: tuple[Sample, ...] = field(default=(), repr=False)

    @property
    def is_there(self) -> bool:
        """True if the daemon answered the last query."""
        return self.state not in (AWAY, CONNECTING)
