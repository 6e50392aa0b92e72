"""Implements the common part of both clients: data about the daemon, and the conversion of calls to requests."""

from __future__ import annotations

import math
import secrets
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ..errors import ProtocolError, TimeoutExpired, invalid
from ..transport.curve import load_curve_keys
from ..transport.frames import Frames, decode, encode
from ..transport.messages import CLIENT, PROTOCOL_VERSION, Reply, Request
from ..values.answers import read
from ..values.generated.service import Limits, Progress, ServerInfo
from ..values.representation import Rows, Shown
from .answer_warnings import sentences_in
from .call import Answering, Noted, asks
from .progress_bar import progress_shown
from .timeouts import may_build, say_that_the_build_goes_on, seconds_of

__all__ = ["Caller", "ProgressCallback", "check_shapes"]

ProgressCallback = Callable[[Progress], None]


class Caller(Shown):
    """Holds the address of the daemon and the timeouts, and makes the call that all others use."""

    def __init__(
        self,
        endpoint: str,
        *,
        timeout: float | None = 60.0,
        build_timeout: float | None = 3600.0,
        connect_timeout: float | None = 5.0,
        server_key: str | Path | None = None,
        own_key: str | Path | None = None,
    ) -> None:
        self.endpoint = endpoint
        self.timeout = seconds_of("timeout", timeout)
        self.build_timeout = seconds_of("build_timeout", build_timeout)
        self.connect_timeout = seconds_of("connect_timeout", connect_timeout)
        self._curve = load_curve_keys(server_key, own_key)
        self._key_files = [None if key is None else Path(key).absolute() for key in (server_key, own_key)]
        self._limits: Limits | None = None

    @property
    def is_closed(self) -> bool:
        """Returns whether close() was called."""
        raise NotImplementedError

    def __getstate__(self) -> dict[str, Any]:
        names = ("endpoint", "timeout", "build_timeout", "connect_timeout")
        server_key, own_key = self._key_files
        return {**{name: getattr(self, name) for name in names}, "server_key": server_key, "own_key": own_key}

    def _title(self) -> str:
        return f"Client of {self.endpoint}"

    def _rows(self) -> Rows:
        rows: Rows = [("timeout", f"{self.timeout:g} s"), ("builds", f"{self.build_timeout:g} s")]
        rows.append(("encryption", "none" if self._curve is None else f"as {self._curve.public.decode()[:8]}..."))
        return [*rows, ("state", "closed" if self.is_closed else "open")]

    @asks
    def call(
        self,
        method: str,
        params: dict[str, Any] | None = None,
        *,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[dict[str, Any]]:
        """Calls any method of the daemon by its name. Parameters and answer are plain JSON and numpy arrays.

        `timeout` is in seconds. If None, it is the client's `build_timeout` for requests that may wait for finite
        elements, otherwise its `timeout`. `progress` shows a progress bar (needs rich) in addition to calling
        `on_progress`.
        """
        return (yield from self.asked(method, params, timeout=timeout, on_progress=on_progress, progress=progress))

    def asked(
        self,
        method: str,
        params: dict[str, Any] | None = None,
        *,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
        builds: bool = False,
    ) -> Answering[dict[str, Any]]:
        """The steps of `call`, for use in other calls. Set `builds` if the call may wait for finite elements and its
        parameters do not show it.
        """
        builds = builds or may_build(params or {})
        usual = self.build_timeout if builds else self.timeout
        seconds = seconds_of("timeout", usual if timeout is None else timeout)
        deadline = time.monotonic() + seconds
        frames = Frames()
        envelope = {
            "contactd": PROTOCOL_VERSION,
            "id": secrets.token_hex(8),
            "method": method,
            "timeout_ms": math.ceil(seconds * 1000),
            "metadata": {"client": CLIENT},
            "params": encode(params or {}, "", frames),
        }
        if frames:
            yield from self._check_limits(frames, deadline)
        build = ""
        with progress_shown(method, progress) as show:

            def report(reported: dict[str, Any]) -> None:
                nonlocal build
                given = read(Progress, reported, "progress")
                if builds and given.job.startswith("build-"):
                    build = given.job
                show(given)
                if on_progress is not None:
                    on_progress(given)

            try:
                reply: Reply = yield Request(envelope, frames, deadline, self.connect_timeout, report)
            except TimeoutExpired as error:
                if builds:
                    say_that_the_build_goes_on(error, build)
                raise
        if sentences := sentences_in(method, reply.result):
            yield Noted(sentences)
        if not reply.frames:  # Nothing to decode: "$array" in the answer of server.describe is not an array.
            return reply.result
        result: dict[str, Any] = decode(reply.result, reply.frames)
        return result

    def info_asked(self, timeout: float | None) -> Answering[ServerInfo]:
        """The steps of `info`."""
        return read(ServerInfo, (yield from self.asked("server.info", timeout=timeout)))

    def _check_limits(self, frames: list[bytes], deadline: float) -> Answering[None]:
        """Refuses requests that exceed the daemon's limits before sending them."""
        if self._limits is None:
            self._limits = (yield from self.info_asked(max(1e-3, deadline - time.monotonic()))).limits
        limits = self._limits
        for n, frame in enumerate(frames, 1):
            _check_limit(f"array frame {n}", len(frame) // 8, limits.max_array_elements, "numbers")
            _check_limit(f"array frame {n}", len(frame), limits.max_frame_bytes, "bytes")
        _check_limit("the request", len(frames) + 1, limits.max_frames, "frames")
        _check_limit("the request", sum(map(len, frames)), limits.max_message_bytes, "bytes")


def _check_limit(what: str, size: int, limit: int, unit: str) -> None:
    if size > limit:
        raise invalid(what, f"has {size} {unit}, but the daemon accepts at most {limit}", "LIMIT_EXCEEDED")


def check_shapes(answer: Any, names: list[str], shape: tuple[int, ...]) -> None:
    """Raises ProtocolError if an array of the answer has another shape."""
    for name in names:
        if (array := getattr(answer, name)) is None:
            raise ProtocolError(f"The answer lacks the requested {name}.")
        if array.shape != shape:
            raise ProtocolError(f"The answer's {name} has shape {list(array.shape)} instead of {list(shape)}.")
