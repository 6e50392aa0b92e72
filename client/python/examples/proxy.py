"""Serves many daemons at one address, by a ZeroMQ proxy that assigns a daemon to each connection of a client.

    python3 proxy.py tcp://127.0.0.1:5555 ipc:///run/contactd/1.socket ipc:///run/contactd/2.socket

A connection keeps its daemon, which had the fewest connections at its first request. Messages are passed on unchanged
in both directions, including progress and arrays, for DEALER and REQ clients. If a daemon stops, its open requests are
answered with UNAVAILABLE, and the connection gets another daemon with its next request. docs/scaling.md describes its
use. The proxy ends on SIGINT and SIGTERM.
"""

from __future__ import annotations

import argparse
import json
import signal
import sys
import time
from pathlib import Path
from types import FrameType

import zmq
from zmq.utils.monitor import recv_monitor_message

CONNECT_SECONDS, DOWN_SECONDS = 5.0, 10.0
LOST = {"code": 14, "name": "UNAVAILABLE", "message": "The daemon behind the proxy went away.",
        "details": {"reason": "STOPPING"}}  # fmt: skip


class Lane:
    """Holds one client's connection to its daemon."""

    def __init__(self, context: zmq.Context[zmq.Socket[bytes]], client: bytes, daemon: str) -> None:
        self.client, self.daemon = client, daemon
        self.socket = context.socket(zmq.DEALER)
        self.socket.setsockopt(zmq.LINGER, 1000)
        self.socket.setsockopt(zmq.IPV6, daemon.startswith("tcp://["))
        self.monitor = self.socket.get_monitor_socket(zmq.EVENT_CONNECTED | zmq.EVENT_DISCONNECTED)
        self.connected = False
        self.socket.connect(daemon)
        self.owed: dict[str, bool] = {}  #: ids of requests without an answer, and whether a REQ socket sent them
        self.made = self.used = time.monotonic()

    def request(self, frames: list[bytes]) -> None:
        delimited = len(frames) > 1 and frames[0] == b""
        if (name := _id(frames[1 if delimited else 0])) is not None:
            self.owed[name] = delimited
        self.used = time.monotonic()
        self.socket.send_multipart(frames, zmq.DONTWAIT)

    def answer(self) -> list[bytes]:
        frames = self.socket.recv_multipart(zmq.DONTWAIT)
        envelope = frames[1 if frames[0] == b"" else 0]
        if b'"status"' in envelope and (name := _id(envelope)) is not None:
            self.owed.pop(name, None)
        self.used = time.monotonic()
        return frames

    def close(self) -> None:
        self.socket.disable_monitor()
        self.monitor.close()
        self.socket.close()


def _id(envelope: bytes) -> str | None:
    try:
        name = json.loads(envelope)["id"]
    except (ValueError, KeyError, TypeError, RecursionError):
        return None  # the daemon's answer, without an ID
    return name if isinstance(name, str) else None


class Proxy:
    """Serves all lanes of one address, in the calling thread."""

    def __init__(self, address: str, daemons: list[str], idle_seconds: float = 3600.0) -> None:
        self._context: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
        self._front = self._context.socket(zmq.ROUTER)
        self._front.setsockopt(zmq.LINGER, 1000)
        self._front.setsockopt(zmq.ROUTER_MANDATORY, 1)
        self._front.setsockopt(zmq.IPV6, address.startswith("tcp://["))
        path = Path(address.removeprefix("ipc://"))
        if address.startswith("ipc:///") and path.exists() and not path.is_socket():
            raise SystemExit(f"{path} is not a socket; listening there would remove it.")
        self._front.bind(address)
        self.address = self._front.getsockopt_string(zmq.LAST_ENDPOINT)
        self._daemons, self._idle_seconds = daemons, idle_seconds
        self._lanes: dict[bytes, Lane] = {}
        self._down: dict[str, float] = {}  #: Time at which a stopped daemon may be tried again.
        self._poller = zmq.Poller()
        self._poller.register(self._front, zmq.POLLIN)

    def turn(self, timeout: float) -> None:
        """Passes on pending messages; waits up to `timeout` seconds for new ones."""
        ready = dict(self._poller.poll(round(timeout * 1000)))
        for lane in list(self._lanes.values()):
            if lane.socket in ready:
                self._to_client(lane.client, lane.answer())
            if lane.monitor in ready:
                lane.connected = recv_monitor_message(lane.monitor)["event"] == zmq.EVENT_CONNECTED
                if not lane.connected:
                    self._give_up(lane)
        if self._front in ready:
            client, *frames = self._front.recv_multipart()
            lane = self._lane_of(client)
            try:
                lane.request(frames)
            except zmq.Again:  # it does not read
                self._give_up(lane)
        now = time.monotonic()
        for lane in list(self._lanes.values()):
            if not lane.connected and now - lane.made > CONNECT_SECONDS:
                self._give_up(lane)
            elif not lane.owed and now - lane.used > self._idle_seconds:
                self._close(lane)

    def close(self) -> None:
        for lane in list(self._lanes.values()):
            self._close(lane)
        self._front.close()
        self._context.term()

    def _lane_of(self, client: bytes) -> Lane:
        if (known := self._lanes.get(client)) is not None:
            return known
        busy = [lane.daemon for lane in self._lanes.values()]
        up = [daemon for daemon in self._daemons if time.monotonic() >= self._down.get(daemon, 0.0)]
        lane = Lane(self._context, client, min(up or self._daemons, key=busy.count))
        self._poller.register(lane.socket, zmq.POLLIN)
        self._poller.register(lane.monitor, zmq.POLLIN)
        self._lanes[client] = lane
        return lane

    def _give_up(self, lane: Lane) -> None:
        self._down[lane.daemon] = time.monotonic() + DOWN_SECONDS
        self._close(lane)

    def _close(self, lane: Lane) -> None:
        while lane.socket.poll(0):  # a stopping daemon answers before it closes the connection
            self._to_client(lane.client, lane.answer())
        for name, delimited in lane.owed.items():
            envelope = json.dumps({"contactd": 1, "id": name, "status": LOST}).encode()
            self._to_client(lane.client, [b"", envelope] if delimited else [envelope])
        self._poller.unregister(lane.socket)
        self._poller.unregister(lane.monitor)
        del self._lanes[lane.client]
        lane.close()

    def _to_client(self, client: bytes, frames: list[bytes]) -> None:
        try:
            self._front.send_multipart([client, *frames], zmq.DONTWAIT)
        except zmq.ZMQError:
            pass  # the client is lost, or does not read


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("address", help="address for clients")
    parser.add_argument("daemons", nargs="+", help="endpoints of the daemons")
    options = parser.parse_args()

    def end(number: int, frame: FrameType | None) -> None:
        sys.exit(0)

    signal.signal(signal.SIGTERM, end)
    signal.signal(signal.SIGINT, end)
    proxy = Proxy(options.address, options.daemons)
    print(json.dumps({"ready": True, "endpoint": proxy.address}), flush=True)
    try:
        while True:
            proxy.turn(timeout=1)
    finally:
        proxy.close()


if __name__ == "__main__":
    main()
