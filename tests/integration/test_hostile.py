"""Tests invalid bytes: other clients are not affected, and the sender gets an answer or is disconnected."""

import json
import os
import random
import socket

import pytest

from support import schemas
from support.daemons import eventually
from support.fortress import Fortress

PATHS = ["../../../../etc/passwd", "/etc/passwd", "..", "a/../../b", "..\\..\\b", "file:///etc/passwd", "%2e%2e%2fetc",
         "x\u0000/etc/passwd", "~/.ssh/id_rsa", "$(touch hacked)", "; touch hacked", "/dev/zero", "con"]  # fmt: skip

#: The greeting of a client of ZMTP 3.1, with the mechanism NULL.
GREETING = b"\xff" + bytes(8) + b"\x7f\x03\x01" + b"NULL".ljust(20, b"\0") + bytes(32)
READY = b"\x04\x1c\x05READY\x0bSocket-Type\x00\x00\x00\x06DEALER"

HOSTILE = {
    "HTTP": b"GET /metrics HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "HTTP post": b"POST / HTTP/1.1\r\nContent-Length: 1000000\r\n\r\n" + b"{" * 4096,
    "zeros": bytes(100_000),
    "ones": b"\xff" * 100_000,
    "noise": random.Random(5).randbytes(100_000),
    "TLS": b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(506),
    "SSH": b"SSH-2.0-OpenSSH_9.6\r\n",
    "ZMTP 1": b"\x01\x00" + b"\x03\x00{}" * 50,
    "ZMTP 2": b"\xff" + bytes(8) + b"\x7f\x01\x05\x00\x00" + b"\x00\x02{}" * 50,
    "greeting and noise": GREETING + random.Random(6).randbytes(50_000),
    "another mechanism": GREETING.replace(b"NULL\0\0\0", b"GSSAPI\0") + bytes(1000),
    "message before the handshake": GREETING + b"\x00\x02{}" * 100,
    "frame of 2^63 bytes": GREETING + READY + b"\x02" + b"\x7f" + b"\xff" * 7,
    "command of 2^40 bytes": GREETING + b"\x06" + (1 << 40).to_bytes(8, "big"),
}


def connect(endpoint):
    host, port = endpoint.removeprefix("tcp://").rsplit(":", 1)
    return socket.create_connection((host, int(port)), timeout=20)


def hangs_up(stranger):
    """Reads until the daemon closes the connection."""
    try:
        while stranger.recv(65536):
            pass
    except ConnectionError:
        pass
    return True


@pytest.fixture(params=["plain", "CURVE"])
def target(request, daemons, tmp_path):
    """Provides a daemon at a port and a client that must not be affected."""
    security = {"handshake_seconds": 1}
    if request.param == "plain":
        daemon = daemons.start(endpoint="tcp://127.0.0.1:*", security=security)
        with daemon.client() as client:
            yield daemon, client
    else:
        fortress = Fortress(daemons, tmp_path, security=security)
        with fortress.client() as client:
            yield fortress.daemon, client


def test_strangers_bytes_end_their_connection_and_nothing_else(target):
    daemon, client = target
    assert client.health() == "serving"
    for name, data in HOSTILE.items():
        with connect(daemon.endpoint) as stranger:
            try:
                stranger.sendall(data)
            except ConnectionError:
                pass  # the daemon has already disconnected
            assert client.health() == "serving", name
            assert hangs_up(stranger), name
    assert client.info().counters["requests_failed"] == 0


def test_half_open_connections_are_closed_and_keep_nobody_out(target):
    daemon, client = target
    strangers = [connect(daemon.endpoint) for _ in range(300)]
    for stranger in strangers[::2]:
        stranger.sendall(GREETING[:20])
    assert client.health() == "serving"
    assert all(hangs_up(stranger) for stranger in strangers)
    for stranger in strangers:
        stranger.close()
    assert client.health() == "serving"


def test_a_flood_of_connections_is_survived(target):
    daemon, client = target
    before = len(os.listdir(f"/proc/{daemon.pid}/fd"))
    for n in range(1500):
        connect(daemon.endpoint).close()
        if n % 500 == 0:
            assert client.health() == "serving"
    eventually(lambda: len(os.listdir(f"/proc/{daemon.pid}/fd")) <= before + 10)
    assert client.health() == "serving"


def test_ten_thousand_frames_are_refused_in_words(raw):
    answer = raw.ask("server.health", {}, *[b"x"] * 10_000)
    assert (answer.status, answer.reason) == ("INVALID_ARGUMENT", "LIMIT_EXCEEDED")
    assert raw.ask("server.health").status == "OK"


def test_an_oversize_frame_of_an_allowed_user_costs_that_user_only(daemons, tmp_path):
    fortress = Fortress(daemons, tmp_path, limits={"max_frame_bytes": 4096, "max_message_bytes": 8192})
    with fortress.client() as careless, fortress.client() as client:
        assert careless.health() == "serving"
        connection = careless._connections.take()  # the client itself would refuse it
        connection._socket.send_multipart([b"{}", bytes(1_000_000)])
        assert client.health() == "serving"
        careless._connections.give_back(connection, usable=False)
        assert careless.health() == "serving"


def test_a_message_without_end_is_cut_off_and_messages_that_end_are_not(daemons):
    budget = 1 << 20
    daemon = daemons.start(endpoint="tcp://127.0.0.1:*", limits={"max_inbox_bytes": budget})
    part = b"\x03" + (1 << 16).to_bytes(8, "big") + bytes(1 << 16)  # a long frame, with more to follow
    with daemon.client() as client, daemon.raw() as raw, connect(daemon.endpoint) as endless:
        endless.sendall(GREETING)
        while b"ROUTER" not in endless.recv(4096):
            pass  # it first requests permission
        endless.sendall(READY)
        sent = 0
        with pytest.raises(ConnectionError):
            while sent < 1 << 30:
                endless.sendall(part)
                sent += len(part)
        for _ in range(8):  # exceed the budget together
            assert raw.ask("server.health", {}, bytes(budget // 4)).reason == "ARRAY_INVALID"
            assert client.health() == "serving"
        assert "limits.max_inbox_bytes" in daemon.log


def envelope(**fields):
    return json.dumps({"contactd": 1, "id": "h", "method": "server.health", "params": {}, **fields}).encode()


DEEP = "[" * 50_000 + "]" * 50_000
WRONG = {
    "deep list": envelope().replace(b"{}", DEEP.encode()),
    "deep object": envelope().replace(b"{}", b'{"a":' * 20_000 + b"1" + b"}" * 20_000),
    "deep metadata": envelope(metadata={"x": 0}).replace(b"0", DEEP.encode(), 1),
    "deep and cut off": envelope()[:-2] + b'[{"a":' * 50_000,
    "huge number": envelope(timeout_ms=7).replace(b"7", b"9" * 5000),
    "huge exponent": envelope(timeout_ms=7).replace(b"7", b"1e999999999"),
    "huge fraction": envelope(timeout_ms=7).replace(b"7", b"1." + b"1" * 100_000 + b"e-5"),
    "negative zero": envelope(timeout_ms=7).replace(b"7", b"-0"),
    "NUL in the text": envelope().replace(b"server", b"ser\0ver"),
    "NUL escaped in the method": envelope(method="server.health\0"),
    "invalid UTF-8": envelope().replace(b"server", b"\xc0\xaf"),
    "UTF-8 surrogate": envelope().replace(b"server", b"\xed\xa0\x80"),
    "overlong UTF-8": envelope().replace(b"server", b"\xe0\x80\xaf"),
    "half a surrogate": envelope().replace(b"server", b"\\ud800"),
    "UTF-16": envelope().decode().encode("utf-16"),
    "a long name": envelope(**{"x" * 1_000_000: 1}),
    "many names": envelope(**{f"x{n}": n for n in range(20_000)}),
    "comment": b"/* */" + envelope(),
    "two documents": envelope() + envelope(),
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG.keys())
def test_an_envelope_made_to_hurt_is_refused_in_words(raw, text):
    raw.send_bytes(text)
    answer = raw.receive()
    assert answer.status in ("INVALID_ARGUMENT", "UNIMPLEMENTED")
    assert answer.reason in ("NOT_JSON", "ENVELOPE_INVALID", "FIELD_INVALID", "LIMIT_EXCEEDED", "UNKNOWN_METHOD")
    assert len(answer.message) < 2000
    assert raw.ask("server.health").status == "OK"


def test_a_field_that_is_there_twice_is_refused_before_any_check(raw):
    raw.send_bytes(envelope().replace(b'"method": "server.health"', b'"method": "server.health", "method": "no.such"'))
    answer = raw.receive()
    assert (answer.reason, answer.fields) == ("NOT_JSON", ["method"])
    raw.send_bytes(envelope(timeout_ms=7).replace(b"7", b'7, "timeout_ms": -1'))
    assert raw.receive().fields == ["timeout_ms"]
    raw.send_bytes(envelope(method="no.such").replace(b'"id": "h"', b'"id": "h", "id": "i"'))
    assert raw.receive().fields == ["id"]


def strings_of(value, path=()):
    """Returns the paths of all strings in a JSON value."""
    if isinstance(value, str):
        yield path
    elif isinstance(value, (dict, list)):
        for key, part in value.items() if isinstance(value, dict) else enumerate(value):
            yield from strings_of(part, (*path, key))


def with_string(value, path, text):
    changed = json.loads(json.dumps(value))
    place = changed
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = text
    return changed


TABLE = {"material": {"G": 1, "nu": 0.3}, "grid": {"nx": 4, "ny": 4, "dx": 1, "dy": 1}}
SESSION = {
    "grid": {"nx": 4, "ny": 4, "dx": 1, "dy": 1},
    "bodies": {"upper": {"G": 1, "nu": 0.3}},
    "ics": {"source": "analytic"},
    "gap": {"paraboloid": {"Rx": 5}},
    "approach": 0.1,
    "model": "full",
    "friction": {"mu": 0.3, "kinetic": {"law": "linear", "mu": 0.1, "slip_velocity": 3}, "rolling": {"kind": "steady"}},
}
WHEEL = {
    "side": "left",
    "wheel": {"arc": {"radius": -200}},
    "model": "full",
    "friction": {"mu": 0.3, "kinetic": {"law": "linear", "mu": 0.1, "slip_velocity": 3}},
    "wheel_surface": "exact",
    "rigid_slip": "plane",
}
REQUESTS = [
    ("ic.get", {**TABLE, "ics": {"source": "fem", "preset": "paper-test2", "body": "half_space", "mesh": "hex"}}),
    ("ic.export", {**TABLE, "ics": {"source": "analytic"}, "format": "contact"}),
    ("contact.subsurface", {"grid": TABLE["grid"], "nu": 0.3, "body": "lower", "pressure": [[1] * 4] * 4,
                            "points": [[0, 0, -1]]}),
    ("contact.temperature", {"grid": TABLE["grid"], "velocity": 1e3, **{name: [[1] * 4] * 4 for name in
                             ("pressure", "traction_x", "traction_y", "slip_x", "slip_y")}}),
    ("ic.import", {"attributes": {"spec/body": "half_space", "evidence/warnings": ["a"]}, "datasets": {"frames": [1, 2]}}),
    ("contact.solve", SESSION),
    ("contact.solve_many", {"problems": [SESSION]}),
    ("session.open", SESSION),
    ("session.open", {"wheelrail": {"setup": WHEEL}}),
    ("session.step", {"session": "0" * 32, "step": 1, "fields": ["pressure"], "wheelrail": {"state": {}}}),
    ("session.step", {"session": "0" * 32, "step": 1, "fields": ["pressure"], "friction": SESSION["friction"]}),
    ("session.step_many", {"steps": [{"session": "0" * 32, "step": 1, "friction": SESSION["friction"]}]}),
    ("wheelrail.solve", {"setup": WHEEL, "state": {}, "fields": ["pressure"]}),
    ("wheelrail.wheelset", {"setup": WHEEL, "left": WHEEL, "state": {"Fz_left": 1, "Fz_right": 1}}),
    ("wheelrail.geometry", {"setup": WHEEL, "left": WHEEL, "states": [{}], "contacts": {"shifts": [0], "roll": "demanded"},
                            "conicity": {"amplitudes": [1], "roll": "neglected"}}),
    ("contact_file.read", {"text": "0", "name": "a.inp"}),
    ("contact_file.run", {"text": "0", "name": "a.inp", "files": [{"name": "a.prr", "text": "0 0"}], "wheel_surface": "exact"}),
    ("contact_file.convert", {"text": "0", "name": "a.inp", "files": [{"name": "a.prr", "failure": "No such file"}]}),
    ("contact_file.slices", {"text": "0 1\n2\n0 0 0\n1\n0 'a.prr'\n10 'b.prr'\n", "name": "a.slcs"}),
]  # fmt: skip
REQUESTS += [(method, schemas.example(method)) for method in schemas.method_names() if method not in dict(REQUESTS)]


def files_below(folder):
    return sorted(str(path) for path in folder.rglob("*"))


def test_no_text_of_a_request_reaches_the_file_system(shared_daemon, raw):
    files = files_below(shared_daemon.folder)
    for method, params in REQUESTS:
        for path in strings_of(params):
            for trick in PATHS:
                answer = raw.ask(method, with_string(params, path, trick))
                # The start of a list is only compared with names, and a text is only read.
                is_text = method.startswith("contact_file.")
                refused = ("OK", "INVALID_ARGUMENT") if is_text else ("INVALID_ARGUMENT", "NOT_FOUND")
                allowed = ("OK",) if method == "ic.list" else refused
                if method == "session.step_many" and answer.status == "OK":  # each step has its own status
                    assert answer.envelope["result"]["steps"][0]["status"]["name"] == "NOT_FOUND"
                    continue
                assert answer.status in allowed, (method, path, trick)
                assert "root:" not in json.dumps(answer.envelope)
    for trick in PATHS:
        assert raw.ask(trick).status == "UNIMPLEMENTED"
        assert raw.ask("server.health", metadata={"file": trick}).status == "OK"
        assert raw.ask("server.health", metadata={"name": trick}, arrays=trick).status == "INVALID_ARGUMENT"
        assert raw.ask("job.cancel", {"job": trick}, id=trick).envelope["id"] == trick
    assert files_below(shared_daemon.folder) == files
