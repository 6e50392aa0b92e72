"""Queries a daemon regularly in a separate thread, and stores the results."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from types import TracebackType
from typing import TypeVar

from contactd import Client, ContactdError, NotFound, RecentPatch, StatusError, StoredIc

from ..measured import Reading, difference, quantile
from ..reporting import sentence
from .view import AWAY, CONNECTING, Sample, View

__all__ = ["Watcher"]

_SAMPLES = 600  #: Number of stored samples: ten minutes at one per second.
_CONNECTING = 1.0  #: Timeout of a connection (s).
T = TypeVar("T")


class Watcher:
    """Holds the state of a daemon in `view`, which is replaced as a whole. Queries continue whatever happens to the
    daemon.

    All methods may be called from any thread. Those that query the daemon raise ContactdError.
    """

    def __init__(self, client: Client, *, interval: float = 1.0, patience: float = 3.0) -> None:
        """Queries every `interval` seconds, with `patience` as the timeout of an answer (s)."""
        client.connect_timeout = min(_CONNECTING, patience)
        self.endpoint = client.endpoint
        self.view = View(CONNECTING, since=time.time())
        self._client = client
        self._interval = interval
        self._patience = patience
        self._samples: deque[Sample] = deque(maxlen=_SAMPLES)
        self._last: Reading | None = None
        self._looks = threading.Lock()  # one at a time
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._run, name="watcher")

    def __enter__(self) -> Watcher:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._ends.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._ends.is_set():
            self.look()
            self._ends.wait(self._interval)

    def look(self) -> None:
        """Queries once, like the thread."""
        with self._looks:
            self._look()

    def _look(self) -> None:
        try:
            seen = self._seen()
        except ContactdError as error:
            self._last = None  # Rates are reset when a daemon is reachable again,
            why = error.message if isinstance(error, StatusError) else str(error)
            seen = replace(self.view, state=AWAY, why=why, jobs=(), sessions=())
        if seen.state == self.view.state:
            seen = replace(seen, since=self.view.since)
        else:
            seen = replace(seen, since=time.time())
        self.view = seen

    def _seen(self) -> View:
        wait = self._patience
        health = self._client.call("server.health", timeout=wait)
        known = self.view
        if not known.is_there:  # or it was restarted, possibly as another version
            config = self._if_it_can(lambda: self._client.config(timeout=wait))
            known = replace(known, info=self._client.info(timeout=wait), config=config)
        now = Reading.of(self._client.metrics(timeout=wait))
        self._add_sample(now)
        return replace(
            known,
            state=str(health["state"]),
            why="",
            warnings=tuple(health.get("warnings", ())),
            jobs=self._client.jobs(timeout=wait),
            sessions=self._client.sessions(timeout=wait),
            solves=self._if_it_can(lambda: self._client.recent_solves(timeout=wait)) or (),
            store=tuple(now.value(name) for name in ("contactd_store_tables", "contactd_store_bytes", "contactd_builds_total")),
            samples=tuple(self._samples),
        )

    def _if_it_can(self, ask: Callable[[], T]) -> T | None:
        """Returns None if the daemon is older than the method."""
        try:
            return ask()
        except StatusError as error:
            if error.name == "UNIMPLEMENTED":
                return None
            raise

    def _add_sample(self, now: Reading) -> None:
        before = self._last
        if before is not None and now.at - before.at < self._interval / 2:
            return  # an extra query, whose interval is too short for rates
        self._last = now
        if before is None:
            return
        median, slow = (quantile(before, now, part) for part in (0.5, 0.95))
        self._samples.append(Sample(time.time(), difference(before, now), median, slow))

    def cancel(self, job: str) -> bool:
        """Ends a job; returns False if it had already ended."""
        try:
            self._client.cancel_job(job, timeout=self._patience)
        except NotFound:
            return False
        finally:
            self.look()
        return True

    def tables(self) -> list[StoredIc]:
        """Returns the tables of the store. A worker of the daemon lists them, so a busy daemon may miss the timeout."""
        return list(self._client.stored_ics(evidence=True, timeout=self._patience))

    def pressures(self, number: int) -> tuple[RecentPatch, ...]:
        """Returns the pressures of one of the last solves."""
        return self._client.recent_pressures(number, timeout=self._patience)

    def explain(self, error: ContactdError) -> str:
        """Returns the error as a sentence."""
        return sentence(error)
