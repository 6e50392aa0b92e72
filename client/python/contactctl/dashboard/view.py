"""All that is known of a daemon at one time, as plain, immutable values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from contactd import Job, RecentSolve, ServerInfo
from contactd.values.service import SessionSummary

__all__ = ["AWAY", "CONNECTING", "Sample", "View"]

CONNECTING = "connecting"
AWAY = "away"


@dataclass(frozen=True)
class Sample:
    """Rates and values between two looks.

    Attributes:
        at: When the second was (s since 1970).
        said: Rates and values (`measured.difference`).
        median: Time of half of the requests (s), those of who looks left out; None where there were none.
        slow: Time that 95 % stayed below (s).
    """

    at: float
    said: Mapping[str, Any]
    median: float | None
    slow: float | None


@dataclass(frozen=True)
class View:
    """Findings of a look; of a daemon that does not answer, what the last one had.

    Attributes:
        state: "connecting", "serving", "stopping", or "away": it does not answer.
        why: A sentence: why it is away; else "".
        since: Of the state (s since 1970).
        warnings: What the daemon warns of.
        info: Versions and limits; None before the first answer.
        config: Its configuration, without secrets; None before the first answer, and of a daemon that does not tell it.
        store: What changes when tables of the store do.
        samples: Of the last minutes, oldest first.
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
        """Whether the daemon answered the last look."""
        return self.state not in (AWAY, CONNECTING)
