"""A daemon's account of itself, of its work and of sessions.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .representation import ProgressText

__all__ = ["Job", "Limits", "Progress", "ServerInfo", "SessionSummary"]


@dataclass(frozen=True)
class Progress(ProgressText):
    """A sign of life of the job that a call waits for.

    Attributes:
        stage: Stage of the work.
        fraction: Estimated fraction of the whole work.
        job: The job that the request waits for.
        iteration: Iteration within the stage.
        residual: The figure that the stage's stopping criterion compares.
        state: State of the daemon, of health.watch. One of "serving", "stopping".
        seconds_left: Until the work ends, an estimate (s); None while there is none.
        memory_bytes: Largest memory that the build is expected to take (bytes), an estimate; None while there is none.
    """

    stage: str
    fraction: float
    job: str = ""
    iteration: int = 0
    residual: float = 0.0
    state: str = ""
    seconds_left: float | None = None
    memory_bytes: int | None = None


@dataclass(frozen=True)
class Limits:
    """Limits of one message.

    Attributes:
        max_frame_bytes: Bytes of one frame.
        max_frames: Frames of one message, the envelope included.
        max_message_bytes: Bytes of one message.
        max_array_elements: Elements of one array.
        max_grid_elements: Elements of one grid, offsets of one table.
        max_queue: Requests that may wait for an answer.
        max_queue_per_client: Requests of these that came through one socket.
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
    """Version, limits and counters of the daemon.

    Attributes:
        version: Version of contactd.
        commit: Commit of the sources, with -dirty when they were changed after it; unknown when no repository said it.
        protocol: Version of the protocol.
        libraries: Versions of the libraries by name.
        limits: Limits of one message.
        counters: Counted since the start.
        cache: Tables in memory.
        queue: Work that waits and runs.
        uptime_seconds: Time since the start (s).
        protocol_versions: Versions of the protocol that are served, oldest first.
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
        job: Name of a job, as progress and job.list give it.
        kind: Kind of work. One of "build", "solve", "subsurface", "temperature", "step".
        state: State of the job: queued or running. One of "queued", "running".
        stage: Stage of the work, empty while queued.
        fraction: Estimated fraction of the whole job.
        callers: Requests that wait for it.
        seconds: Time since it was queued (s).
        seconds_left: Time to go as last reported, of builds where there is an estimate (s).
        memory_bytes: Largest memory that it is expected to take (bytes), of builds where there is an estimate.
        users: Users whose requests wait for it, each once: names of keys, IP addresses, or uid:NUMBER over ipc.
        description: Words for people: what is built or solved.
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
class SessionSummary:
    """One session of the daemon; its name is the key to it and is not told.

    Attributes:
        age_seconds: Time since it was opened (s).
        idle_seconds: Time since a request used it last, 0 while one does (s).
        lease_seconds: It ends when idle for that long (s).
        step: Number of its last step.
        states: Saved states.
        bytes: Bytes that it counts of limits.max_session_bytes, saved states included.
        elements: Elements of its grid; of a wheel on its rail those of all patches of its last step.
    """

    age_seconds: float
    idle_seconds: float
    lease_seconds: float
    step: int
    states: int
    bytes: int
    elements: int
