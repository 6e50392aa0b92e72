"""Tests access to contactctl dashboard by real requests. Skipped if NiceGUI was not available from PyPI."""

import http.client
import os
import re
import signal
import socket
from dataclasses import dataclass
from pathlib import Path

import pytest

from support.slowness import SLOWER

PACKAGES = [*Path(os.environ.get("CONTACTD_DASHBOARD", "/nowhere")).glob("lib/python3*/site-packages")]

pytestmark = pytest.mark.skipif(not PACKAGES, reason="NiceGUI could not be had from PyPI")
SOCKET = "/_nicegui_ws/socket.io/?EIO=4&transport=websocket"
POLLING = "/_nicegui_ws/socket.io/?EIO=4&transport=polling"


@dataclass
class Answer:
    status: int
    headers: dict[str, str]
    text: str


class Running:
    """Provides a dashboard of a missing daemon, and the response to its link."""

    def __init__(self, ctl, *words):
        ctl.environment["PYTHONPATH"] = f"{PACKAGES[0]}{os.pathsep}{ctl.environment['PYTHONPATH']}"
        self.process = ctl.start("dashboard", "--port", "0", *words)
        link = self.process.stdout.readline().strip()
        assert link, self.process.stderr.read()
        self.port, self.token = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=(.+)", link).groups()
        self.host = f"127.0.0.1:{self.port}"
        opened = self.ask(f"/?token={self.token}")
        assert opened.status == 303
        self.key = opened.headers["location"].removeprefix("/#")
        self.cookie, *self.attributes = opened.headers["set-cookie"].split("; ")

    def ask(self, path, method="GET", **headers):
        connection = http.client.HTTPConnection("127.0.0.1", int(self.port), timeout=20 * SLOWER)
        try:
            connection.putrequest(method, path, skip_host="Host" in headers)
            for name, value in headers.items():
                connection.putheader(name, value)
            connection.endheaders()
            answer = connection.getresponse()
            told = {name.lower(): value for name, value in answer.getheaders()}
            return Answer(answer.status, told, answer.read().decode())
        finally:
            connection.close()

    def shake_hands(self, path, **headers):
        """Returns the status that answers a WebSocket; 101 means that it was opened."""
        lines = {"Host": self.host, "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
                 "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==", **headers}  # fmt: skip
        with socket.create_connection(("127.0.0.1", int(self.port)), timeout=20 * SLOWER) as connection:
            text = "".join(f"{name}: {value}\r\n" for name, value in lines.items())
            connection.sendall(f"GET {path} HTTP/1.1\r\n{text}\r\n".encode())
            return int(connection.recv(4096).split()[1])

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        _, said = self.process.communicate(timeout=30 * SLOWER)
        return said


@pytest.fixture(scope="module")
def running(tmp_path_factory):
    from .conftest import Ctl

    made = Running(Ctl(tmp_path_factory.mktemp("running"), "ipc:///nowhere/nobody"))
    yield made
    assert made.end() == ""


def test_the_cookie_is_neither_the_token_nor_the_key_and_is_named_by_the_port(running):
    name, _, value = running.cookie.partition("=")
    assert name.endswith(f"_{running.port}")
    assert len({value, running.token, running.key}) == 3
    assert {"HttpOnly", "SameSite=Strict", "Path=/"} <= set(running.attributes)


def test_with_cookie_and_key_the_page_comes(running):
    door = running.ask("/", Cookie=running.cookie)
    assert door.status == 200
    assert running.key not in door.text
    assert "nobody" not in door.text
    page = running.ask(f"/{running.key}/", Cookie=running.cookie)
    assert page.status == 200
    assert "ipc:///nowhere/nobody" in page.text
    assert page.headers["x-frame-options"] == "DENY"
    assert page.headers["referrer-policy"] == "no-referrer"
    origin = f"http://{running.host}"
    assert running.shake_hands(f"/{running.key}{SOCKET}", Cookie=running.cookie, Origin=origin) == 101


@pytest.mark.parametrize("cookie", ["other=1; {}", "{}; theme=dark", 'a="b; {}', "=; {}", "{name}=wrong; {}"])
def test_cookies_of_others_do_not_hide_ours(running, cookie):
    cookies = cookie.format(running.cookie, name=running.cookie.partition("=")[0])
    assert running.ask(f"/{running.key}/", Cookie=cookies).status == 200


def test_who_has_got_the_cookie_only_sees_nothing(running):
    """Acts like a page that another user serves on another port of the same address."""
    origin = f"http://{running.host}"
    for path in (SOCKET, f"/{running.token}{SOCKET}", f"/{running.cookie.partition('=')[2]}{SOCKET}"):
        assert running.shake_hands(path, Cookie=running.cookie, Origin=origin) == 403
    for path in (POLLING, "/_nicegui/", f"/{running.token}/", "//", "/../", "/none/"):
        answer = running.ask(path, Cookie=running.cookie)
        assert answer.status == 403
        assert answer.text.startswith("Open the address that contactctl dashboard printed")


def test_who_has_the_key_only_sees_nothing(running):
    for cookie in ({}, {"Cookie": f"{running.cookie}x"}, {"Cookie": f"contactd_dashboard={running.cookie.partition('=')[2]}"}):
        assert running.ask(f"/{running.key}/", **cookie).status == 403
        assert running.shake_hands(f"/{running.key}{SOCKET}", Origin=f"http://{running.host}", **cookie) == 403


@pytest.mark.parametrize("origin", [None, "null", "http://evil.example", "http://127.0.0.1:1", "http://127.0.0.1", "https://{}", "http://localhost:{port}"])
def test_pages_of_other_origins_get_no_socket_and_send_nothing(running, origin):
    said = {} if origin is None else {"Origin": origin.format(running.host, port=running.port)}
    assert running.shake_hands(f"/{running.key}{SOCKET}", Cookie=running.cookie, **said) == 403
    assert running.ask(f"/{running.key}{POLLING}", "POST", Cookie=running.cookie, **said).status == 403
    if said:
        assert running.ask(f"/{running.key}/", Cookie=running.cookie, **said).status == 403


@pytest.mark.parametrize("host", ["evil.example", "evil.example:{}", "127.0.0.1", "127.0.0.1:1", "127.0.0.1.evil.example:{}", "localhost.evil.example:{}", "user@127.0.0.1:{}", "127.0.0.2:{}", ""])
def test_names_that_others_may_point_here_are_refused(running, host):
    host = host.format(running.port)
    everything = {"Host": host, "Cookie": running.cookie, "Origin": f"http://{host}"}
    for path in ("/", f"/?token={running.token}", f"/{running.key}/"):
        answer = running.ask(path, **everything)
        assert answer.status == 403
        assert "set-cookie" not in answer.headers
        assert f"This dashboard accepts requests for 127.0.0.1:{running.port}, localhost:{running.port}" in answer.text
        assert "--name" in answer.text
    assert running.shake_hands(f"/{running.key}{SOCKET}", **everything) == 403


def test_two_hosts_are_none(running):
    with socket.create_connection(("127.0.0.1", int(running.port)), timeout=20 * SLOWER) as connection:
        connection.sendall(
            f"GET /?token={running.token} HTTP/1.1\r\nHost: {running.host}\r\nHost: evil.example\r\n\r\n".encode()
        )
        assert int(connection.recv(4096).split()[1]) in (400, 403)


def test_localhost_is_a_name_of_its_own(running):
    host = f"localhost:{running.port}"
    assert running.ask(f"/?token={running.token}", Host=host).status == 303
    path = f"/{running.key}{SOCKET}"
    assert running.shake_hands(path, Host=host, Cookie=running.cookie, Origin=f"http://{host}") == 101


def test_a_name_that_was_given_is_answered_to(lonely):
    running = Running(lonely, "--name", "bench.example", "--name", "localhost:5581")
    for host, scheme in ((f"bench.example:{running.port}", "http"), ("bench.example", "https"), ("localhost:5581", "http")):
        opened = running.ask(f"/?token={running.token}", Host=host)
        assert opened.status == 303
        cookie = opened.headers["set-cookie"].split(";")[0]
        path = f"/{running.key}{SOCKET}"
        assert running.shake_hands(path, Host=host, Cookie=cookie, Origin=f"{scheme}://{host}") == 101
    assert running.ask("/", Host="localhost:5582", Cookie=running.cookie).status == 403
    assert running.end() == ""


@pytest.mark.parametrize("given", ["", "token={}x", "token=", "token={}&token=x"])
def test_a_wrong_token_opens_nothing(running, given):
    answer = running.ask(f"/?{given.format(running.token)}")
    assert answer.status == 403
    assert answer.text.startswith("Open the address that contactctl dashboard printed")


def test_a_prefix_that_somebody_sends_is_not_believed(running):
    page = running.ask(f"/{running.key}/", Cookie=running.cookie, **{"X-Forwarded-Prefix": "/evil"})
    assert page.status == 200
    assert "evil" not in page.text
