"""Tests valid configurations, and messages for invalid ones."""

import json
import socket
import subprocess

import pytest

from contactd import Client
from support.daemons import BIN, eventually


def run(tmp_path, text):
    """Runs the daemon with a configuration that should end it immediately."""
    path = tmp_path / "config.json"
    path.write_text(text)
    return subprocess.run([BIN / "contactd", "--config", path], capture_output=True, text=True, timeout=30)


@pytest.mark.parametrize(
    ("config", "field"),
    [
        ({"endpiont": "tcp://127.0.0.1:*"}, "endpiont"),
        ({"store": {"path": "x"}}, "store.path"),
        ({"builds": {"concurent": 2}}, "builds.concurent"),
        ({"workers": "two"}, "workers"),
        ({"workers": 0}, "workers"),
        ({"workers": 1.5}, "workers"),
        ({"store": "folder"}, "store"),
        ({"builds": {"launcher": "mpirun -np 4"}}, "builds.launcher"),
        ({"builds": {"launcher": ["mpirun", 4]}}, "builds.launcher"),
        ({"limits": {"max_queue": -1}}, "limits.max_queue"),
        ({"log": {"level": "loud"}}, "log.level"),
        ({"endpoint": "127.0.0.1:5555"}, "endpoint"),
    ],
    ids=lambda part: part if isinstance(part, str) else "",
)
def test_a_mistake_is_named_and_ends_the_daemon_with_status_two(tmp_path, config, field):
    ended = run(tmp_path, json.dumps(config))
    assert ended.returncode == 2
    assert field in ended.stderr
    assert ended.stdout == ""


def test_every_mistake_is_named_at_once(tmp_path):
    ended = run(tmp_path, json.dumps({"workers": 0, "colour": "red"}))
    assert "workers" in ended.stderr
    assert "colour" in ended.stderr


@pytest.mark.parametrize("text", ["", "{", "[]", "null", "{'workers': 2}"])
def test_what_is_no_configuration_ends_the_daemon_with_status_two(tmp_path, text):
    ended = run(tmp_path, text)
    assert ended.returncode == 2
    assert "config" in ended.stderr


def test_a_file_that_does_not_exist_is_named(tmp_path):
    ended = subprocess.run(
        [BIN / "contactd", "--config", tmp_path / "missing.json"], capture_output=True, text=True, timeout=30
    )
    assert ended.returncode == 2
    assert "missing.json" in ended.stderr


def test_an_endpoint_that_is_taken_ends_the_daemon_with_a_message(daemon, tmp_path):
    tcp = tmp_path / "config.json"
    security = {"allow_unencrypted_remote": True}
    store = {"folder": str(tmp_path / "store")}
    tcp.write_text(json.dumps({"endpoint": "tcp://192.0.2.1:5555", "security": security, "store": store}))
    ended = subprocess.run([BIN / "contactd", "--config", tcp], capture_output=True, text=True, timeout=30)
    assert ended.returncode == 1
    assert "192.0.2.1" in ended.stderr


def test_a_store_that_cannot_be_made_ends_the_daemon_with_a_message(tmp_path):
    blocker = tmp_path / "file"
    blocker.write_text("")
    config = {"endpoint": f"ipc://{tmp_path}/s", "store": {"folder": str(blocker / "store")}}
    ended = run(tmp_path, json.dumps(config))
    assert ended.returncode == 1
    assert str(blocker) in ended.stderr


def test_a_free_port_of_tcp_is_announced(daemons):
    daemon = daemons.start(endpoint="tcp://127.0.0.1:*")
    assert daemon.endpoint.startswith("tcp://127.0.0.1:")
    with Client(daemon.endpoint) as client:
        assert client.health() == "serving"


def has_ipv6() -> bool:
    try:
        with socket.socket(socket.AF_INET6) as probe:
            probe.bind(("::1", 0))
    except OSError:
        return False
    return True


@pytest.mark.skipif(not has_ipv6(), reason="this machine has no IPv6")
def test_an_address_of_ipv6_is_served(daemons):
    daemon = daemons.start(endpoint="tcp://[::1]:*")
    assert daemon.endpoint.startswith("tcp://[::1]:")
    with Client(daemon.endpoint) as client:
        assert client.health() == "serving"
    eventually(lambda: "user=\"::1\"" in daemon.log)  # the log is written after the answer was sent
    ping = subprocess.run([BIN / "contactd", "--ping", daemon.endpoint], capture_output=True, text=True, timeout=30)
    assert ping.stdout == "serving\n"
    example = subprocess.run([BIN / "contactd-cpp-example", daemon.endpoint], capture_output=True, text=True, timeout=60)
    assert example.stdout.startswith("Fn "), example.stderr


def test_limits_of_the_configuration_are_published(daemons):
    with daemons.start(limits={"max_queue": 7, "max_frames": 5}).client() as client:
        limits = client.info().limits
    assert (limits.max_queue, limits.max_frames) == (7, 5)


def test_a_log_file_takes_one_line_a_request(daemons):
    path = daemons.folder / "daemon" / "contactd.log"
    with daemons.start(log={"file": str(path)}).client() as client:
        client.call("server.health")
    eventually(lambda: "server.health" in path.read_text())  # the log is written after the answer was sent
    lines = [line for line in path.read_text().splitlines() if "server.health" in line]
    assert len(lines) == 1
    assert "OK" in lines[0]
