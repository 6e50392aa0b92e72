"""Information about a daemon, its jobs and its sessions.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..representation import ProgressText

__all__ = ["Job", "Limits", "Progress", "ServerInfo", "SessionSummary"]


@dataclass(frozen=True)
class Progress(ProgressText):
    """A progress report of the job that a call waits for.

    Attributes:
        stage: Stage of the work.
        fraction: Estimated fraction of the whole work.
        job: The job that the request waits for.
        iteration: Iteration within the stage.
        residual: Value that the stopping criterion of the stage compares with its tolerance.
        state: State of the daemon, of health.watch. One of "serving", "stopping".
        seconds_left: Estimated time until the work ends (s). None while there is no estimate.
        memory_bytes: Estimated largest memory of the build (bytes). None while there is no estimate.
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
    """Limits of a message.

    Attributes:
        max_frame_bytes: Bytes of a frame.
        max_frames: Frames of a message, including the envelope.
        max_message_bytes: Bytes of a message.
        max_array_elements: Elements of an array.
        max_grid_elements: Elements of a grid, or offsets of a table.
        max_queue: Requests that may wait for an answer.
        max_queue_per_client: Requests from one socket that may wait for an answer.
        max_queue_bytes: Bytes of the messages whose requests wait for an answer.
        max_sessions: Sessions that may be open.
        max_session_bytes: Bytes of all sessions and their saved states together.
        max_session_states: Saved states of a session.
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
        commit: Commit of the sources, with -dirty if they were changed after it; unknown if they were not built from a
            repository.
        protocol: Version of the protocol.
        libraries: Versions of the libraries by name.
        limits: Limits of a message.
        counters: Counters since the start.
        cache: Tables in memory.
        queue: Waiting and running work.
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
    """A waiting or running build, solve or computation of stresses.

    Attributes:
        job: Name of a job, as progress and job.list give it.
        kind: Kind of work. One of "build", "solve", "subsurface", "temperature", "step".
        state: State of the job: queued or running. One of "queued", "running".
        stage: Stage of the work, empty while queued.
        fraction: Estimated fraction of the whole job.
        callers: Requests that wait for it.
        seconds: Time since it was queued (s).
        seconds_left: Last reported remaining time, for builds with an estimate (s).
        memory_bytes: Expected largest memory (bytes), for builds with an estimate.
        users: Users whose requests wait for it, without repetition: names of keys, IP addresses, or uid:NUMBER over
            ipc.
        description: Description of the build or solve in words.
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
    """A session of the daemon. Its name is the key to it and is not included.

    Attributes:
        age_seconds: Time since it was opened (s).
        idle_seconds: Time since the last request of the session ended, 0 during one (s).
        lease_seconds: Lease (s): the session ends after this time without a request.
        step: Number of the last step.
        states: Saved states.
        bytes: Bytes of the session that are counted towards limits.max_session_bytes, including saved states.
        elements: Elements of the grid; for a wheel on its rail those of all patches of the last step.
    """

    age_seconds: float
    idle_seconds: float
    lease_seconds: float
    step: int
    states: int
    bytes: int
    elements: int
