"""Tests LocalDaemon with programs that behave incorrectly."""

import importlib
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from contactd import DaemonFailed, LocalDaemon
from support.daemons import eventually, processes_with

READY = """print('{"ready": true, "endpoint": "ipc:///tmp/x", "pid": 1}', flush=True)"""


@pytest.fixture
def program(tmp_path):
    """Writes a program of Python statements; sys.argv[2] is the configuration."""

    def write(*lines):
        path = tmp_path / "program"
        path.write_text("\n".join([f"#!{sys.executable}", "import json, signal, sys, time", *lines, ""]))
        path.chmod(0o755)
        return path

    return write


def test_a_daemon_that_is_ready_is_stopped_by_the_with_block(program):
    with LocalDaemon(program(READY, "time.sleep(60)")) as daemon:
        assert daemon.endpoint == "ipc:///tmp/x"
        assert daemon.process.poll() is None
        folder = daemon.folder
    assert daemon.process.returncode == -15
    assert not folder.exists()


def test_a_folder_of_the_caller_is_kept(program, tmp_path):
    with LocalDaemon(program(READY, "time.sleep(60)"), folder=tmp_path / "kept"):
        pass
    assert (tmp_path / "kept" / "contactd.json").exists()


def test_the_configuration_is_laid_over_the_one_written_here(program, tmp_path):
    tell = "print(json.dumps({'endpoint': open(sys.argv[2]).read()}), flush=True)"
    config = {"store": {"size": 3}, "workers": 1}
    with LocalDaemon(program(tell, "time.sleep(60)"), folder=tmp_path / "f", config=config) as daemon:
        assert daemon.config["store"] == {"folder": str(tmp_path / "f" / "store"), "size": 3}
        assert '"workers": 1' in daemon.endpoint


def test_a_program_that_does_not_exist_is_named(tmp_path):
    with pytest.raises(DaemonFailed, match=r"no-such-program cannot be started: No such file[^.]*\.$"):
        LocalDaemon(tmp_path / "no-such-program")


def test_a_program_that_is_not_on_the_path_is_named_with_what_to_do():
    with pytest.raises(DaemonFailed, match=r"^no-such-program cannot be started: .*\. Put it on PATH, or give its path"):
        LocalDaemon("no-such-program")


def test_a_daemon_that_ends_at_once_shows_its_log(program):
    with pytest.raises(DaemonFailed, match=r"status 2[\s\S]*the disk is full"):
        LocalDaemon(program("sys.stderr.write('the disk is full')", "sys.exit(2)"))


def test_a_daemon_that_never_gets_ready_is_ended(program):
    with pytest.raises(DaemonFailed, match=r"not ready within 0\.5 s"):
        LocalDaemon(program("time.sleep(60)"), start_timeout=0.5)


def test_a_program_that_says_something_else_is_no_daemon(program):
    with pytest.raises(DaemonFailed, match="hello"):
        LocalDaemon(program("print('hello', flush=True)", "time.sleep(60)"))


def test_a_daemon_that_ignores_sigterm_is_killed_and_reported(program):
    daemon = LocalDaemon(program("signal.signal(signal.SIGTERM, signal.SIG_IGN)", READY, "time.sleep(60)"))
    with pytest.raises(DaemonFailed, match="SIGTERM"):
        daemon.stop(timeout=0.2)
    assert daemon.process.returncode == -9
    daemon.close()
    assert not Path(daemon.folder).exists()


#: Prints the daemon's process and folder, and is then killed.
CALLER = """
import os, sys, time
from contactd import LocalDaemon
daemon = LocalDaemon(sys.argv[1])
{meanwhile}
print(daemon.pid, daemon.folder, flush=True)
time.sleep(60)
"""


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
@pytest.mark.parametrize("meanwhile", ["", "if not os.fork():\n    time.sleep(60)"], ids=["alone", "with a fork that lives on"])
def test_a_caller_that_is_killed_takes_its_daemon_along(program, end, meanwhile):
    path = program(READY, "time.sleep(60)")
    script = CALLER.format(meanwhile=meanwhile)
    caller = subprocess.Popen([sys.executable, "-c", script, path], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              text=True, start_new_session=True)  # fmt: skip
    try:
        pid, folder = caller.stdout.readline().split()
        assert Path(folder).exists()
        assert Path(f"/proc/{pid}").exists()
        caller.send_signal(end)
        caller.wait()
        eventually(lambda: not processes_with(folder), "the daemon or its watcher goes on")
        eventually(lambda: not Path(folder).exists(), "its folder is left")
    finally:
        os.killpg(caller.pid, signal.SIGKILL) if meanwhile else caller.kill()
        caller.stdout.close()


def test_a_daemon_that_was_stopped_leaves_no_watcher(program):
    with LocalDaemon(program(READY, "time.sleep(60)")) as daemon:
        folder = str(daemon.folder)
        assert len(processes_with(folder)) == 2
    assert not processes_with(folder)


def test_a_daemon_outlives_the_thread_that_started_it(program):
    started = []
    thread = threading.Thread(target=lambda: started.append(LocalDaemon(program(READY, "time.sleep(60)"))))
    thread.start()
    thread.join()
    (daemon,) = started
    with daemon, pytest.raises(subprocess.TimeoutExpired):
        daemon.process.wait(0.3)


def test_it_has_a_module_of_its_name():
    assert importlib.import_module("contactd.daemon").LocalDaemon is LocalDaemon
