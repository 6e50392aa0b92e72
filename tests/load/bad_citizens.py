"""Runs clients that behave badly while others work; each function runs until its time is over."""

from __future__ import annotations

import socket as sockets
import time
from collections.abc import Callable

import zmq

from load.workload import KINDS, request

SOLVE, MEDIUM, HEALTH = KINDS[0], KINDS[2], KINDS[-1]


def never_reads(endpoint: str, end: float) -> int:
    """Sends solves with large answers at a moderate rate, and reads none of the answers."""
    sent = 0
    with zmq.Context() as context, context.socket(zmq.DEALER) as dealer:
        dealer.linger = 0
        dealer.rcvhwm = 1
        dealer.connect(endpoint)
        while time.monotonic() < end:
            if dealer.poll(50, zmq.POLLOUT):
                dealer.send_multipart(request(MEDIUM, f"unread-{sent}", 1.0))
                sent += 1
            time.sleep(0.05)
    return sent


def sends_forever(endpoint: str, end: float) -> int:
    """Sends as fast as the socket allows, and reads nothing."""
    sent = 0
    with zmq.Context() as context, context.socket(zmq.DEALER) as dealer:
        dealer.linger = 0
        dealer.rcvhwm = 1
        dealer.connect(endpoint)
        while time.monotonic() < end:
            if not dealer.poll(50, zmq.POLLOUT):
                continue
            kind = SOLVE if sent % 10 == 0 else HEALTH
            dealer.send_multipart(request(kind, f"flood-{sent}", 1.0))
            sent += 1
    return sent


def disconnects(endpoint: str, end: float) -> int:
    """Connects, requests a solve and disconnects; then disconnects in the middle of a message."""
    sent = 0
    while time.monotonic() < end:
        with zmq.Context() as context, context.socket(zmq.DEALER) as dealer:
            dealer.linger = 20
            dealer.connect(endpoint)
            dealer.send_multipart(request(MEDIUM, f"gone-{sent}", 1.0))
            dealer.send(b"{", zmq.SNDMORE)  # the rest never comes
            sent += 1
        _half_a_greeting(endpoint)
        time.sleep(0.05)
    return sent


def _half_a_greeting(endpoint: str) -> None:
    kind, _, address = endpoint.partition("://")
    family, where = (sockets.AF_UNIX, address) if kind == "ipc" else (sockets.AF_INET, (address.partition(":")[0], int(address.partition(":")[2])))
    with sockets.socket(family, sockets.SOCK_STREAM) as raw:
        raw.settimeout(5)
        try:
            raw.connect(where)
            raw.sendall(b"\xff\0\0\0\0\0\0\0\1\x7f\3")
        except OSError:
            pass  # the daemon may lack descriptors, which is not checked here


BAD_CITIZENS: list[Callable[[str, float], int]] = [never_reads, sends_forever, disconnects]
