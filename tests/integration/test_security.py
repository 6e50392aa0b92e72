"""Tests which clients are admitted, and what others at the port cannot do."""

import json
import os
import stat
import subprocess
import time

import pytest

from contactd import Client, ResourceExhausted, Unauthenticated
from support.daemons import BIN, eventually
from support.fortress import Fortress, keygen
from support.problems import CATTANEO, GRID, LONG, STEEL


@pytest.fixture
def fortress(daemons, tmp_path):
    return Fortress(daemons, tmp_path)


@pytest.mark.parametrize("endpoint", ["tcp://127.0.0.1:*", None], ids=["tcp", "ipc"])
def test_an_allowed_key_is_served(daemons, tmp_path, endpoint):
    fortress = Fortress(daemons, tmp_path, **({"endpoint": endpoint} if endpoint else {}))
    with fortress.client() as client:
        assert client.health() == "serving"


def test_an_unknown_key_is_told_that_it_is_not_known(fortress):
    with fortress.client(own_key=fortress.make_user("mallory")) as stranger, fortress.client() as alice:
        with pytest.raises(Unauthenticated, match="does not accept this client's key") as caught:
            stranger.health()
        assert caught.value.reason == "HANDSHAKE_FAILED"
        assert alice.health() == "serving"
    assert "connection refused: from 127.0.0.1 with the unknown key" in fortress.daemon.log


def test_a_wrong_key_of_the_server_is_named(fortress):
    _, other = keygen(fortress.folder / "other", "server")
    with fortress.client(server_key=other) as client, pytest.raises(Unauthenticated, match="server_key is not the daemon's key"):
        client.health()


def test_a_client_without_encryption_is_told_what_to_do(fortress):
    with Client(fortress.daemon.endpoint) as plain, pytest.raises(Unauthenticated, match="give server_key and own_key"):
        plain.health()


def test_a_client_that_encrypts_is_told_that_the_daemon_does_not(daemons, tmp_path):
    secret, public = keygen(tmp_path, "alice")
    daemon = daemons.start(endpoint="tcp://127.0.0.1:*")
    with daemon.client(server_key=public, own_key=secret) as client:
        with pytest.raises(Unauthenticated, match="not use encryption"):
            client.health()


def test_a_client_of_the_server_key_alone_is_not_let_in(fortress):
    """The public key of the daemon gives no access, and neither does the daemon's own pair."""
    with fortress.client(own_key=fortress.secret) as client, pytest.raises(Unauthenticated):
        client.health()


def test_a_client_may_try_again_once_it_is_allowed(fortress):
    with fortress.client(own_key=fortress.make_user("bob")) as bob:
        with pytest.raises(Unauthenticated):
            bob.health()
        fortress.allow("bob")
        fortress.reload()
        assert bob.health() == "serving"


def test_a_revoked_key_is_refused_on_its_open_connection_and_on_new_ones(fortress):
    bob_key = fortress.make_user("bob")
    fortress.allow("bob")
    fortress.reload()
    with fortress.client() as alice, fortress.client(own_key=bob_key) as bob:
        assert bob.health() == "serving"
        (fortress.allowed / "bob.key").unlink()
        fortress.reload()
        with pytest.raises(Unauthenticated) as caught:
            bob.health()
        assert caught.value.reason == "KEY_REVOKED"
        with pytest.raises(Unauthenticated) as caught:
            bob.health()
        assert caught.value.reason == "HANDSHAKE_FAILED"
        assert alice.health() == "serving"


def test_a_revoked_user_loses_the_requests_that_are_open(fortress, background):
    with fortress.client() as alice:
        waiting = background(alice.get_ic, STEEL, GRID, LONG)
        eventually(fortress.daemon.builders)
        (fortress.allowed / "alice.key").unlink()
        fortress.reload()
        assert waiting.exception(timeout=20).reason == "KEY_REVOKED"


def test_a_key_that_took_the_place_of_another_under_its_name_replaces_it(fortress):
    with fortress.client() as old:
        assert old.health() == "serving"
        fortress.make_user("alice2")
        text = (fortress.folder / "users" / "alice2.key").read_text()
        (fortress.allowed / "alice.key").write_text(text)
        fortress.reload()
        with pytest.raises(Unauthenticated):
            old.health()
        with fortress.client(own_key=fortress.folder / "users" / "alice2.key_secret") as new:
            assert new.health() == "serving"


def test_broken_key_files_are_named_and_hurt_no_other(fortress):
    broken = {
        "empty.key": "",
        "words.key": 'curve\n    public-key = "not a key"\n',
        "binary.key": "\x00\x01\x02",
        "sp ace.key": fortress.public.read_text(),
        "secret.key": fortress.alice.read_text(),
        "twice.key": (fortress.allowed / "alice.key").read_text(),
    }
    for name, text in broken.items():
        (fortress.allowed / name).write_text(text)
    (fortress.allowed / "folder.key").mkdir()
    fortress.reload()
    for name in [*broken, "folder.key"]:
        assert name in fortress.daemon.log
    assert "\n1 keys" not in fortress.daemon.log
    with fortress.client() as client:
        assert client.health() == "serving"


def test_checking_the_configuration_looks_at_the_keys(fortress):
    check = [BIN / "contactd", "--config", fortress.daemon.folder / "contactd.json", "--check-config"]
    assert "ok: security.curve" in subprocess.run(check, capture_output=True, text=True, timeout=30).stdout
    (fortress.allowed / "bob.key").write_text("")
    fortress.secret.chmod(0o604)
    ended = subprocess.run(check, capture_output=True, text=True, timeout=30)
    assert ended.returncode == 2
    assert "chmod 600" in ended.stderr


def ping(fortress, **keys):
    options = [word for name, path in keys.items() for word in (f"--{name}-key", path)]
    ask = [BIN / "contactd", "--ping", fortress.daemon.endpoint, *options]
    return subprocess.run(ask, capture_output=True, text=True, timeout=30)


def test_a_ping_with_keys_says_whether_the_daemon_serves(fortress):
    ended = ping(fortress, server=fortress.public, own=fortress.alice)
    assert (ended.returncode, ended.stdout) == (0, "serving\n")


def test_a_ping_with_other_keys_or_none_says_what_it_takes(fortress):
    stranger, (_, other) = fortress.make_user("mallory"), keygen(fortress.folder / "other", "server")
    wrong = [{}, {"server": fortress.public, "own": stranger}, {"server": other, "own": fortress.alice}]
    for keys in wrong:
        ended = ping(fortress, **keys)
        assert ended.returncode == 1
        assert "an allowed --own-key" in ended.stderr
    ended = ping(fortress, server=fortress.public, own=fortress.public)
    assert (ended.returncode, "contains no secret key" in ended.stderr) == (1, True)
    ended = ping(fortress, server=fortress.public)
    assert ended.returncode != 0
    assert "--own-key" in ended.stderr


def test_a_folder_of_keys_that_went_away_changes_nothing(fortress):
    fortress.allowed.rename(fortress.folder / "elsewhere")
    fortress.reload("remain valid")
    with fortress.client() as client:
        assert client.health() == "serving"


def test_no_secret_is_shown(fortress):
    secrets = [
        line.split('"')[1]
        for path in [fortress.secret, fortress.alice]
        for line in path.read_text().splitlines()
        if "secret-key" in line
    ]
    assert len(secrets) == 2
    config = fortress.daemon.folder / "contactd.json"
    printed = subprocess.run(
        [BIN / "contactd", "--config", config, "--print-config"], capture_output=True, text=True, timeout=30
    ).stdout
    with fortress.client() as client:
        info = json.dumps(client.call("server.info"))
    for secret in secrets:
        assert secret not in printed + info + fortress.daemon.log


# --- the configuration -----------------------------------------------------------------------------------------------


def refused(tmp_path, **config):
    """Returns the message with which the daemon refuses to start."""
    path = tmp_path / "refused.json"
    path.write_text(json.dumps({"store": {"folder": str(tmp_path / "store")}, **config}))
    ended = subprocess.run([BIN / "contactd", "--config", path], capture_output=True, text=True, timeout=30)
    assert ended.returncode in (1, 2)
    assert ended.stdout == ""
    return ended.stderr


@pytest.mark.parametrize(
    "endpoint",
    ["tcp://*:5555", "tcp://0.0.0.0:5555", "tcp://[::]:5555", "tcp://192.0.2.1:5555",
     "tcp://lo:5555", "tcp://127.0.0.1.example.org:5555", "tcp://[fe80::1%lo]:5555", "tcp://2130706433:5555"],
)  # fmt: skip
def test_an_address_others_may_reach_needs_keys_or_a_word(tmp_path, endpoint):
    assert "allow_unencrypted_remote" in refused(tmp_path, endpoint=endpoint)


def test_localhost_is_this_machine_and_needs_neither(daemons):
    daemon = daemons.start(endpoint="tcp://localhost:*")
    assert daemon.endpoint.startswith(("tcp://127.0.0.1:", "tcp://[::1]:"))
    assert "can be reached" not in daemon.log
    with daemon.client() as client:
        assert client.health() == "serving"


def test_the_flag_and_nothing_less_opens_the_port_to_everybody(daemons):
    daemon = daemons.start(endpoint="tcp://0.0.0.0:*", security={"allow_unencrypted_remote": True})
    assert "can be reached from other machines" in daemon.log
    with Client(daemon.endpoint.replace("0.0.0.0", "127.0.0.1")) as client:
        assert client.health() == "serving"


def test_the_command_line_cannot_open_the_port_either(tmp_path):
    ended = subprocess.run(
        [BIN / "contactd", "--endpoint", "tcp://*:5555"], capture_output=True, text=True, timeout=30
    )
    assert ended.returncode == 2
    assert "allow_unencrypted_remote" in ended.stderr


def test_half_a_configuration_of_curve_is_refused(tmp_path):
    secret, _ = keygen(tmp_path / "keys", "server")
    assert "allowed_keys" in refused(tmp_path, security={"curve": {"secret_key_file": str(secret)}})
    assert "secret_key_file" in refused(tmp_path, security={"curve": {"allowed_keys": str(tmp_path)}})


def test_keys_that_cannot_be_used_keep_the_daemon_from_starting(tmp_path):
    secret, public = keygen(tmp_path / "keys", "server")

    def sentence(secret_key_file, allowed_keys=tmp_path):
        curve = {"secret_key_file": str(secret_key_file), "allowed_keys": str(allowed_keys)}
        return refused(tmp_path, endpoint="tcp://127.0.0.1:*", security={"curve": curve})

    assert "contains no secret key" in sentence(public)
    assert "No such file" in sentence(tmp_path / "missing.key_secret")
    assert "cannot be read" in sentence(secret, tmp_path / "missing")
    secret.chmod(0o640)
    assert f"chmod 600 {secret}" in sentence(secret)


def test_a_client_refuses_a_secret_that_others_can_read(fortress):
    fortress.alice.chmod(0o644)
    with pytest.raises(ValueError, match="chmod 600"):
        fortress.client()


def test_new_keys_are_private_and_never_overwrite(tmp_path):
    secret, public = keygen(tmp_path, "alice")
    assert stat.S_IMODE(secret.stat().st_mode) == 0o600
    assert "secret-key" not in public.read_text()
    before = secret.read_bytes(), public.read_bytes()
    again = [BIN / "contactd", "keygen", "alice", "--folder", tmp_path]
    ended = subprocess.run(again, capture_output=True, text=True, timeout=30)
    assert ended.returncode == 1
    assert "never overwritten" in ended.stderr
    secret.unlink()
    assert subprocess.run(again, capture_output=True, timeout=30).returncode == 1
    assert not secret.exists()
    assert public.read_bytes() == before[1]


def test_new_keys_make_their_folder_or_say_why_not(tmp_path):
    assert keygen(tmp_path / "new" / "folder", "alice")[0].is_file()
    (tmp_path / "file").write_text("")
    ask = [BIN / "contactd", "keygen", "alice", "--folder", tmp_path / "file" / "folder"]
    ended = subprocess.run(ask, capture_output=True, text=True, timeout=30)
    assert (ended.returncode, f"The folder {tmp_path}/file/folder cannot be created" in ended.stderr) == (1, True)


@pytest.mark.parametrize("name", ["../alice", "a/b", "", ".hidden", "a b", "x" * 65, "a\nb"])
def test_a_name_of_keys_is_no_path(tmp_path, name):
    (tmp_path / "in").mkdir()
    ended = subprocess.run(
        [BIN / "contactd", "keygen", "--folder", tmp_path / "in", "--", name], capture_output=True, timeout=30
    )
    assert ended.returncode == 1
    assert [path.name for path in tmp_path.rglob("*")] == ["in"]


# --- how much one user may ask for -----------------------------------------------------------------------------------


def test_a_rate_belongs_to_a_user_whatever_the_connection(daemons, tmp_path):
    per_user = {"requests_per_second": 0.001, "burst": 5}
    fortress = Fortress(daemons, tmp_path, security={"per_user": per_user})
    bob_key = fortress.make_user("bob")
    fortress.allow("bob")
    fortress.reload()
    with fortress.client() as first, fortress.client() as second, fortress.client(own_key=bob_key) as bob:
        for client in [first, second, first, second, first]:
            assert client.health() == "serving"
        for client in [first, second]:
            with pytest.raises(ResourceExhausted) as caught:
                client.health()
            assert caught.value.reason == "RATE_LIMITED"
            assert caught.value.retry_delay > 0
        assert bob.health() == "serving"


def test_a_rate_without_keys_belongs_to_the_user_of_the_machine(daemons):
    daemon = daemons.start(security={"per_user": {"requests_per_second": 0.001, "burst": 2}})
    with daemon.client() as first, daemon.client() as second:
        assert [first.health(), second.health()] == ["serving"] * 2
        with pytest.raises(ResourceExhausted):
            first.health()


def test_open_requests_of_a_user_are_counted_over_all_connections(daemons, background):
    daemon = daemons.start(security={"per_user": {"open_requests": 1}})
    with daemon.client() as client, daemon.client() as other:
        first = background(client.get_ic, STEEL, GRID, LONG)
        eventually(daemon.builders)
        with pytest.raises(ResourceExhausted) as caught:
            other.solve(CATTANEO)
        assert caught.value.reason == "TOO_MANY_OPEN"
        assert caught.value.retry_delay > 0
        assert other.health() == "serving"
        client.cancel_job(client.jobs()[0].job)
        assert first.exception() is not None
        assert other.solve(CATTANEO).converged


def test_a_client_that_waits_as_long_as_it_is_told_is_served(daemons):
    daemon = daemons.start(security={"per_user": {"requests_per_second": 1, "burst": 1}})
    with daemon.raw() as raw:
        assert raw.ask("server.health").status == "OK"
        refusal = raw.ask("server.health")
        assert (refusal.status, refusal.reason) == ("RESOURCE_EXHAUSTED", "RATE_LIMITED")
        delay = refusal.envelope["status"]["details"]["retry_delay_ms"]
        assert 1 <= delay <= 1000
        time.sleep(delay / 1000)
        assert raw.ask("server.health").status == "OK"


# --- what a builder gets ---------------------------------------------------------------------------------------------


def test_a_builder_gets_no_variable_that_is_not_listed_and_no_open_file(daemons, background, monkeypatch):
    monkeypatch.setenv("CONTACTD_TEST_TOKEN", "sesame")
    monkeypatch.setenv("OMP_NUM_THREADS", "7")
    monkeypatch.setenv("OMPI_MCA_contactd_test", "passed")
    daemon = daemons.start()
    with daemon.client() as client:
        waiting = background(client.get_ic, STEEL, GRID, LONG)
        # The child exists before it has become the builder.
        eventually(lambda: [pid for pid in daemon.builders() if os.readlink(f"/proc/{pid}/exe").endswith("contactd-ic")])
        (builder,) = daemon.builders()
        with open(f"/proc/{builder}/environ") as file:
            names_and_values = file.read().split("\0")
        assert "OMPI_MCA_contactd_test=passed" in names_and_values
        assert "OMP_NUM_THREADS=1" in names_and_values
        assert not any("sesame" in variable or "OMP_NUM_THREADS=7" in variable for variable in names_and_values)
        # In addition to the pipes of standard input, output and error, one pipe shows the daemon the end of the
        # process.
        shared = {os.readlink(link) for link in open_files(builder)} & {os.readlink(link) for link in open_files(daemon.pid)}
        assert all(what.startswith("pipe:") for what in shared), shared
        assert len(shared) <= 4
        client.cancel_job(client.jobs()[0].job)
        assert waiting.exception() is not None


def open_files(pid):
    return [f"/proc/{pid}/fd/{number}" for number in os.listdir(f"/proc/{pid}/fd")]
