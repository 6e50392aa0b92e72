"""Tests the state of the daemon, requested and watched."""

import zmq

from conformance.requests import ENDLESS, SOLVE
from conformance.wire import OK, UNAVAILABLE


def states(peer):
    """Returns the states reported as progress, and the reply."""
    seen = []
    while (message := peer.message()).is_progress:
        seen.append(message.progress["state"])
    return seen, message


def test_health_is_watched_until_the_daemon_ends(start):
    daemon = start()
    with daemon.peer() as peer, daemon.peer(zmq.REQ) as plain:
        peer.send("health.watch")
        assert peer.message().progress["state"] == "serving"
        plain.send("health.watch")
        daemon.terminate()
        seen, reply = states(peer)
        assert (seen, reply.code, reply.result) == (["stopping"], OK, {"state": "stopping"})
        assert plain.message().result == {"state": "stopping"}


def test_health_does_not_wait_for_work(start):
    daemon = start(workers=1)
    with daemon.peer() as peer:
        solve = peer.send("contact.solve", {**SOLVE, "grid": {"nx": 320, "ny": 320, "dx": 0.0075, "dy": 0.0075}})
        health = peer.send("server.health")
        assert [peer.reply().id for _ in range(2)] == [health, solve]


def test_a_daemon_that_ends_answers_what_it_has(start):
    daemon = start(shutdown={"drain_seconds": 0})
    with daemon.peer() as peer:
        name = peer.send("contact.solve", ENDLESS)
        assert peer.message().progress["stage"]
        daemon.terminate()
        reply = peer.reply()
        assert (reply.id, reply.code, reply.reason) == (name, UNAVAILABLE, "STOPPING")
