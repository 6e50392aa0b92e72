"""What a daemon tells of itself, of its work and of sessions, as plain, immutable values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

__all__ = ["Job", "Limits", "Progress", "SavedState", "ServerInfo", "SessionSummary"]


@dataclass(frozen=True)
class Progress:
    """A sign of life of the job that a call waits for.

    Attributes:
        stage: What is being done, e.g. "assembly".
        fraction: 0 to 1, of the whole job.
        job: What cancel_job takes.
        iteration: Within the stage.
        residual: The figure that the stage's stop test compares.
        state: Of health.watch.
        seconds_left: Time to go for the whole job (s), an estimate; None where there is none.
        memory_bytes: The most memory that a build will take, an estimate; None where there is none.
    """

    stage: str
    fraction: float
    job: str = ""
    iteration: int = 0
    residual: float = 0.0
    state: str = ""
    seconds_left: float | None = None
    memory_bytes: int | None = None

    def __str__(self) -> str:
        if self.state:
            return f"the daemon is {self.state}"
        parts = [f"{self.stage} {100 * self.fraction:.0f} %"]
        if self.iteration:
            parts.append(f"iteration {self.iteration}, residual {self.residual:.1e}")
        if self.seconds_left is not None:
            parts.append(f"about {_duration(self.seconds_left)} to go")
        if self.memory_bytes is not None:
            parts.append(f"about {_size(self.memory_bytes)} of memory")
        return ", ".join(parts)


def _duration(seconds: float) -> str:
    whole = round(seconds)
    if whole < 120:
        return f"{whole} s"
    return f"{whole // 60} min" if whole < 7200 else f"{whole / 3600:.1f} h"


def _size(count: float) -> str:
    for unit in ("kB", "MB"):
        count /= 1000
        if count < 1000:
            return f"{count:.0f} {unit}"
    return f"{count / 1000:.1f} GB"


@dataclass(frozen=True)
class Limits:
    """What one message may cost.

    Attributes:
        max_frame_bytes: Bytes of one frame.
        max_frames: The envelope included.
        max_message_bytes: Bytes of one message.
        max_array_elements: Numbers of one array.
        max_grid_elements: Elements of one grid, offsets of one table.
        max_queue: Requests that may wait for an answer.
        max_queue_per_client: Of these, requests that came through one socket.
        max_queue_bytes: Bytes of the messages whose requests wait for an answer.
        max_sessions: Sessions that may be open.
        max_session_bytes: Bytes of all sessions and their saved states together.
        max_session_states: Saved states of one session.
        max_lease_seconds: Longest lease of a session (s).
    """

    max_frame_bytes: int
    max_frames: int
    max_message_bytes: int
    max_array_elements: int
    max_grid_elements: int
    max_queue: int
    max_queue_per_client: int
    max_queue_bytes: int
    max_sessions: int
    max_session_bytes: int
    max_session_states: int
    max_lease_seconds: float


@dataclass(frozen=True)
class ServerInfo:
    """The daemon, its libraries, and what it has done since it started.

    Attributes:
        version: Version of contactd.
        commit: Of the sources it was built from.
        protocol: Version of the protocol that it answers in.
        libraries: Their versions, by name.
        limits: What one message may cost, and how much may wait.
        counters: What was done since it started, by name (docs/protocol.md).
        cache: Tables in memory, and their bytes.
        queue: What waits and runs.
        uptime_seconds: Since it started (s).
        protocol_versions: Versions that it understands.
    """

    version: str
    commit: str
    protocol: int
    libraries: Mapping[str, str]
    limits: Limits
    counters: Mapping[str, int]
    cache: Mapping[str, int]
    queue: Mapping[str, int]
    uptime_seconds: float
    protocol_versions: tuple[int, ...] = ()


@dataclass(frozen=True)
class Job:
    """A build, a solve or stresses that wait or run.

    Attributes:
        job: What cancel_job takes.
        kind: "build", "solve", "subsurface" or "step".
        state: "queued" or "running".
        stage: What is being done; empty while queued.
        fraction: 0 to 1, of the whole job, an estimate.
        callers: How many calls wait for it.
        seconds: Since it was queued (s).
        seconds_left: Time to go as last reported (s), of builds; None where there is no estimate.
        memory_bytes: The most memory that it will take, of builds; None where there is no estimate.
        users: Whose calls these are, each user once: names of keys, IP addresses, or uid:NUMBER over ipc.
        description: Words for people: what is built or solved; "" of a daemon that does not tell it.
    """

    job: str
    kind: str
    state: str
    stage: str
    fraction: float
    callers: int
    seconds: float
    seconds_left: float | None = None
    memory_bytes: int | None = None
    users: tuple[str, ...] = ()
    description: str = ""


@dataclass(frozen=True)
class SavedState:
    """What save() returns and restore() takes.

    Attributes:
        name: What the daemon calls it.
        step: Number of the last step when it was saved.
    """

    name: str
    step: int


@dataclass(frozen=True)
class SessionSummary:
    """One session of the daemon, as Client.sessions lists it; its name is the key to it and is not told.

    Attributes:
        age_seconds: Since it was opened (s).
        idle_seconds: Since a request used it last (s), 0 while one does.
        lease_seconds: It ends when idle for that long (s).
        step: Number of its last step.
        states: Saved states.
        bytes: What it takes of the daemon's memory, saved states included.
        elements: Elements of its grid; of a wheel on its rail those of all patches of its last step.
    """

    age_seconds: float
    idle_seconds: float
    lease_seconds: float
    step: int
    states: int
    bytes: int
    elements: int
