"""contactd --check-config, --version and --ping: what can be asked without starting a daemon."""

import json
import re
import subprocess

import pytest

from support.daemons import BIN


def run(*arguments, **options):
    return subprocess.run([BIN / "contactd", *arguments], capture_output=True, text=True, timeout=30, **options)


@pytest.fixture
def check(tmp_path):
    """check(section=...) runs --check-config on a sound configuration with these sections laid over it."""

    def run_check(**sections):
        config = {
            "endpoint": f"ipc://{tmp_path}/socket",
            "store": {"folder": str(tmp_path / "store")},
            "log": {"file": str(tmp_path / "contactd.log")},
            "http": {"address": "127.0.0.1:9465"},
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
        ({"store": {"folder": "/dev/null"}}, "no folder"),
        ({"builds": {"program": "/no/such/contactd-ic"}}, "builds.program"),
        ({"builds": {"program": "/etc/passwd"}}, "builds.program"),
        ({"builds": {"launcher": ["no-such-launcher"]}}, "builds.launcher"),
        ({"log": {"file": "/dev/null/contactd.log"}}, "log.file"),
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
    assert {"zeromq", "hdf5", "fftw", "prometheus-cpp", "civetweb", "systemd", "spdlog"} <= set(libraries)


def test_a_ping_says_whether_a_daemon_serves(shared_daemon):
    ended = run("--ping", shared_daemon.endpoint)
    assert (ended.returncode, ended.stdout) == (0, "serving\n")


def test_a_ping_of_nothing_gives_status_one(tmp_path):
    for endpoint, words in ((f"ipc://{tmp_path}/nobody", "No answer"), ("nonsense", "cannot be asked")):
        ended = run("--ping", endpoint)
        assert ended.returncode == 1
        assert words in ended.stderr
