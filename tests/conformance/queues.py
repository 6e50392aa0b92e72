"""Fills queues with requests."""

from __future__ import annotations

import time
from typing import Any

from conformance.wire import Peer


def line_up(onlooker: Peer, peer: Peer, method: str, params: Any, times: int = 1, **envelope: Any) -> Any:
    """Sends requests, waits until they are queued, as `onlooker` observes, and returns their ids."""

    def waiting() -> int:
        return onlooker.ask("server.info").result["queue"]["solves_waiting"]

    before = waiting()
    names = [peer.send(method, params, **envelope) for _ in range(times)]
    while waiting() < before + times:
        time.sleep(0.005)
    return names if times > 1 else names[0]
