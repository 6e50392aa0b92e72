"""Tests limits of one user, and the handling of a user who is no longer allowed."""

import signal

import pytest
import zmq
import zmq.auth

from conformance.queues import line_up
from conformance.requests import ENDLESS, SOLVE, STRESS
from conformance.wire import NOT_FOUND, OK, RESOURCE_EXHAUSTED, UNAUTHENTICATED, Daemon, Keys


def test_a_user_who_asks_too_often_is_told_when_to_ask_again(start):
    daemon = start(security={"per_user": {"requests_per_second": 0.001, "burst": 2}})
    with daemon.peer() as first, daemon.peer() as second:
        assert [first.ask("server.health").code, second.ask("server.health").code] == [OK, OK]
        reply = first.ask("server.health")
        assert (reply.code, reply.reason) == (RESOURCE_EXHAUSTED, "RATE_LIMITED")
        assert reply.details["retry_delay_ms"] > 0


def test_a_user_has_so_many_requests_open_over_all_sockets(start):
    daemon = start(security={"per_user": {"open_requests": 1}})
    with daemon.peer() as first, daemon.peer() as second:
        name = first.send("health.watch")
        assert first.message().progress["state"] == "serving"
        reply = second.ask("health.watch")
        assert (reply.code, reply.reason) == (RESOURCE_EXHAUSTED, "TOO_MANY_OPEN")
        assert reply.details["retry_delay_ms"] > 0
        assert second.ask("server.health").code == OK
        first.cancel(name)


@pytest.fixture
def guarded(tmp_path):
    """Provides a daemon with encryption, the folder of its allowed keys, and the keys of its user alice."""
    for folder, name in (("server", "server"), ("users", "alice"), ("users", "bob")):
        (tmp_path / folder).mkdir(exist_ok=True)
        zmq.auth.create_certificates(tmp_path / folder, name)
    (tmp_path / "server" / "server.key_secret").chmod(0o600)
    allowed = tmp_path / "allowed"
    allowed.mkdir()
    for name in ("alice", "bob"):
        (allowed / f"{name}.key").write_text((tmp_path / "users" / f"{name}.key").read_text())
    curve = {"secret_key_file": str(tmp_path / "server" / "server.key_secret"), "allowed_keys": str(allowed)}
    daemon = Daemon({"endpoint": "tcp://127.0.0.1:*", "workers": 1, "security": {"curve": curve}})
    server, _ = zmq.auth.load_certificate(tmp_path / "server" / "server.key")
    pairs = {name: zmq.auth.load_certificate(tmp_path / "users" / f"{name}.key_secret") for name in ("alice", "bob")}
    yield daemon, allowed, {name: Keys(server, pair) for name, pair in pairs.items()}
    daemon.finish()


def test_a_revoked_key_ends_what_is_open_and_what_comes_after(guarded):
    daemon, allowed, users = guarded
    with daemon.peer(keys=users["alice"]) as alice, daemon.peer(keys=users["bob"]) as bob:
        assert bob.ask("server.health").code == OK
        open_one = alice.send("health.watch")
        assert alice.message().progress["state"] == "serving"
        (allowed / "alice.key").unlink()
        daemon.process.send_signal(signal.SIGHUP)
        ended = alice.reply()
        assert (ended.id, ended.code, ended.reason) == (open_one, UNAUTHENTICATED, "KEY_REVOKED")
        reply = alice.ask("server.health")
        assert (reply.code, reply.reason) == (UNAUTHENTICATED, "KEY_REVOKED")
        assert bob.ask("server.health").code == OK


def test_nobody_is_told_of_the_solves_of_others(guarded):
    daemon, _, users = guarded
    with daemon.peer(keys=users["alice"]) as alice, daemon.peer(keys=users["bob"]) as bob:
        assert alice.ask("contact.solve", SOLVE).code == OK
        (own,) = alice.ask("solves.recent").result["solves"]
        assert alice.ask("solves.pressures", {"number": own["number"]}).code == OK
        assert bob.ask("solves.recent").result["solves"] == []
        refused = bob.ask("solves.pressures", {"number": own["number"]})
        assert (refused.code, refused.reason) == (NOT_FOUND, "SOLVE_UNKNOWN")
        with daemon.peer(keys=users["alice"]) as again:
            assert again.ask("solves.recent").result["solves"] == [own]


def test_users_take_turns_however_many_sockets_they_have(guarded):
    daemon, _, users = guarded
    alice, bob = users["alice"], users["bob"]
    with daemon.peer(keys=bob) as first, daemon.peer(keys=bob) as second, daemon.peer(keys=alice) as one:
        running = first.send("contact.solve", ENDLESS)
        assert first.message().progress["stage"]
        then = line_up(one, first, "contact.solve", ENDLESS)
        last = line_up(one, second, "contact.solve", ENDLESS)
        with daemon.peer(keys=alice) as onlooker:
            line_up(onlooker, one, "contact.subsurface", STRESS)
        first.cancel(running)
        assert first.message().id == then
        first.cancel(then)
        assert one.reply().code == OK, "the other socket of the first user came before"
        second.cancel(last)
