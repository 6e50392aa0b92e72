"""Tests contactd --check-config, --version and --ping, which do not start a daemon."""

import json
import re
import socket
import subprocess

import pytest

from support.daemons import BIN


def run(*arguments, **options):
    return subprocess.run([BIN / "contactd", *arguments], capture_output=True, text=True, timeout=30, **options)


@pytest.fixture
def check(tmp_path):
    """check(section=...) runs --check-config on a valid configuration with these sections replaced."""

    def run_check(**sections):
        config = {
            "endpoint": f"ipc://{tmp_path}/socket",
            "store": {"folder": str(tmp_path / "store")},
            "log": {"file": str(tmp_path / "contactd.log")},
            "http": {"address": "127.0.0.1:0"},
            **sections,
        }
        path = tmp_path / "config.json"
        path.write_text(json.dumps(config))
        return run("--config", path, "--check-config")

    return run_check


def test_a_sound_configuration_gives_status_zero_and_says_what_was_looked_at(check, tmp_path):
    ended = check(builds={"launcher": ["sh"]})
    assert (ended.returncode, ended.stderr) == (0, "")
    subjects = ["endpoint", "store.folder", "builds.program", "builds.launcher", "log.file", "http.address"]
    assert [line.split()[1] for line in ended.stdout.splitlines()] == subjects
    assert all(line.startswith("ok: ") for line in ended.stdout.splitlines())


def test_a_check_leaves_nothing_behind(check, tmp_path):
    check()
    assert [path.name for path in tmp_path.iterdir()] == ["config.json"]


@pytest.mark.parametrize(
    ("sections", "words"),
    [
        ({"endpoint": "ipc:///no/such/folder/socket"}, "/no/such/folder"),
        ({"endpoint": "ipc:///tmp/" + "x" * 120}, "at most 107"),
        ({"store": {"folder": "/dev/null/store"}}, "store.folder"),
        ({"store": {"folder": "/dev/null"}}, "is not a folder"),
        ({"builds": {"program": "/no/such/contactd-ic"}}, "builds.program"),
        ({"builds": {"program": "/etc/passwd"}}, "builds.program"),
        ({"builds": {"launcher": ["no-such-launcher"]}}, "builds.launcher"),
        ({"log": {"file": "/dev/null/contactd.log"}}, "log.file"),
        ({"store": {"folder": "/proc/contactd"}}, "store.folder: the folder /proc is not writable"),
        ({"store": {"folder": "/proc/self"}}, "store.folder: the folder /proc/self is not writable"),
        ({"endpoint": "ipc:///proc/self/socket"}, "endpoint: the folder /proc/self is not writable"),
        ({"endpoint": "ipc:///etc/passwd"}, "/etc/passwd is a file"),
        ({"endpoint": "ipc:///dev/null"}, "/dev/null is a device"),
    ],
    ids=lambda part: part if isinstance(part, str) else "",
)
def test_a_problem_is_said_in_a_sentence_and_gives_status_two(check, sections, words):
    ended = check(**sections)
    assert ended.returncode == 2
    assert words in ended.stderr
    assert ended.stderr.rstrip().endswith(".")


def test_what_the_schema_refuses_is_said_too(check):
    ended = check(http={"address": "127.0.0.1:99999"}, workers=0)
    assert ended.returncode == 2
    assert "http.address" in ended.stderr
    assert "workers" in ended.stderr


def test_an_address_that_is_taken_is_said(check, daemons):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        address = f"127.0.0.1:{taken.getsockname()[1]}"
        ended = check(endpoint=f"tcp://{address}", http={"address": address})
    assert ended.returncode == 2
    first, second = ended.stderr.splitlines()
    assert first == f'endpoint is "tcp://{address}"; contactd cannot listen there: Address already in use.'
    assert second.startswith(f'http.address is "{address}"; contactd cannot listen there: the address is in use')


def test_an_endpoint_of_another_daemon_is_said_and_left_alone(check, daemon, client):
    ended = check(endpoint=daemon.endpoint)
    assert ended.returncode == 2
    assert ended.stderr == f'endpoint is "{daemon.endpoint}"; another process already listens there.\n'
    assert client.health() == "serving"


def test_an_endpoint_that_names_a_file_leaves_the_file(check, tmp_path):
    path = tmp_path / "precious"
    path.write_text("precious")
    config = tmp_path / "daemon.json"
    config.write_text(json.dumps({"endpoint": f"ipc://{path}", "store": {"folder": str(tmp_path / "store")}}))
    for ended in (check(endpoint=f"ipc://{path}"), run("--config", config)):
        assert ended.returncode in (1, 2)
        assert f"{path} is a file, which listening there would remove" in ended.stderr
    assert path.read_text() == "precious"


def test_localhost_is_this_machine(check):
    ended = check(endpoint="tcp://localhost:*")
    assert ended.returncode == 0, ended.stderr
    assert re.search(r"ok: endpoint tcp://(127\.0\.0\.1|\[::1\]):\*", ended.stdout)


@pytest.mark.parametrize(
    "arguments",
    [["--no-such-flag"], ["--config"], ["stray"], ["keygen"], ["--server-key", "x"], ["--config", "a", "--config", "b"]],
    ids=" ".join,
)
def test_a_command_line_that_cannot_be_used_gives_status_two_and_a_sentence(arguments):
    ended = run(*arguments)
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr


def test_help_and_version_give_status_zero():
    for flag in ("--help", "--version"):
        assert run(flag).returncode == 0


def test_every_problem_is_said(check):
    wrong = {"endpoint": "ipc:///no/folder/s", "store": {"folder": "/dev/null"}, "builds": {"program": "/no/builder"}}
    ended = check(**wrong)
    assert len(ended.stderr.splitlines()) == 3


def test_the_version_names_the_commit_and_every_library(shared):
    lines = run("--version").stdout.splitlines()
    assert re.fullmatch(r"contactd \d+\.\d+\.\d+", lines[0])
    assert re.fullmatch(r"commit (unknown|[0-9a-f]{7,40}(-dirty)?)", lines[1])
    libraries = dict(line.split(" ", 1) for line in lines[2:])
    assert libraries == shared.info().libraries
    assert all(re.search(r"\d+\.\d+|\d{3}", number) for number in libraries.values()), libraries
    assert lines[1] == f"commit {shared.info().commit}"
    assert {"zeromq", "hdf5", "prometheus-cpp", "civetweb", "systemd", "spdlog"} <= set(libraries)
    assert len({"ducc0", "fftw"} & set(libraries)) == 1  # transforms of the build


def test_a_ping_says_whether_a_daemon_serves(shared_daemon):
    ended = run("--ping", shared_daemon.endpoint)
    assert (ended.returncode, ended.stdout) == (0, "serving\n")


def test_a_ping_of_nothing_gives_status_one(tmp_path):
    for endpoint, words in ((f"ipc://{tmp_path}/nobody", "No answer"), ("nonsense", "cannot be reached")):
        ended = run("--ping", endpoint)
        assert ended.returncode == 1
        assert words in ended.stderr
