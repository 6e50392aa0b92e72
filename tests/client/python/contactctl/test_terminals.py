"""Tests bars, colours and Ctrl-C at a terminal, and their absence in a pipe, including a closed one."""

import os
import pty
import re
import select
import signal
import subprocess
import time

import pytest

from contactd import Client
from support.daemons import eventually
from support.slowness import SLOWER

ESCAPE = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")


class Terminal:
    """Runs a command whose standard input, output and error are a terminal of 100 columns."""

    def __init__(self, ctl, *words, before=lambda: None, **environment):
        self.master, slave = pty.openpty()
        self.text = ""
        self.process = subprocess.Popen(
            [*ctl.command, *map(str, words)], cwd=ctl.folder, env={**ctl.environment, **environment},
            stdin=slave, stdout=slave, stderr=slave, preexec_fn=lambda: (_take_terminal(), before()),
        )  # fmt: skip
        os.close(slave)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        os.close(self.master)

    def press(self, keys):
        os.write(self.master, keys)

    def wait_for(self, pattern):
        """Reads until the text appears."""
        deadline = time.monotonic() + 30 * SLOWER
        while not re.search(pattern, self.text):
            assert time.monotonic() < deadline, self.text
            assert self._read(), f"it ended: {self.text}"

    def ended(self):
        """Returns the exit code after everything was read."""
        while self._read():
            pass
        return self.process.wait(30 * SLOWER)

    def _read(self):
        if not select.select([self.master], [], [], 30 * SLOWER)[0]:
            return False
        try:
            chunk = os.read(self.master, 65536)
        except OSError:  # the other side is closed
            return False
        self.text += chunk.decode()
        return bool(chunk)


def _take_terminal():
    """Makes Ctrl-C reach the command."""
    import fcntl
    import termios

    os.setsid()
    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


def test_a_build_has_a_live_bar_that_goes_when_ctrl_c_ends_it(own):
    with Terminal(own, "ic", "build", "long.json") as terminal, Client(own.endpoint) as client:
        terminal.wait_for(r"build-\d+: about [\d.]+ (ms|s|min|h) to go, estimated by the daemon")
        terminal.wait_for(r"[1-9]\d* %.*build-\d+: \w+")
        shown = set(re.findall(r"(\d+) %", terminal.text))
        assert len(shown) > 1, "the bar stands still"
        terminal.press(b"\x03")
        assert terminal.ended() == 130
        assert "is cancelled." in terminal.text
        assert "Traceback" not in terminal.text
        eventually(lambda: not client.jobs())

def test_a_terminal_that_is_closed_ends_the_build(own):
    with Client(own.endpoint) as client:
        with Terminal(own, "ic", "build", "long.json") as terminal:
            terminal.wait_for(r"[1-9]\d* %.*build-\d+: \w+")
            os.dup2(os.open(os.devnull, os.O_RDWR), terminal.master)
            assert terminal.process.wait(30 * SLOWER) == 129
        eventually(lambda: not client.jobs())
        assert client.info().counters["builds_finished"] == 0


def test_who_shall_outlive_the_terminal_does(own):
    with Terminal(own, "solve", "endless.json", before=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)) as terminal, Client(own.endpoint) as client:
        eventually(client.jobs)
        terminal.process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        assert terminal.process.poll() is None
        assert client.jobs()


def test_a_bar_is_on_standard_error_and_json_on_standard_output(own):
    with open(own.folder / "out.json", "w") as out:
        master, slave = pty.openpty()
        ended = own.start("ic", "build", "quick.json", "--json", stdout=out, stderr=slave)
        assert ended.wait(30 * SLOWER) == 0
        os.close(slave)
        os.close(master)
    assert (own.folder / "out.json").read_text().count("\n") == 1
    assert (own.folder / "out.json").read_text().startswith('{"evidence"')


def test_a_study_has_a_live_bar_and_ends_with_ctrl_c(own):
    own.write("study.yaml", "problem: contact.yaml\nvary: {approach: {from: 1e-3, to: 2e-2, count: 20000}}\n")
    with Terminal(own, "study", "study.yaml", "--workers", 2) as terminal, Client(own.endpoint) as client:
        terminal.wait_for(r"[1-9]\d* of 20000 rows")
        terminal.press(b"\x03")
        assert terminal.ended() == 130
        assert "repeat the command to continue" in terminal.text
        assert "Traceback" not in terminal.text
        eventually(lambda: not client.jobs())


def test_a_watch_lives_until_ctrl_c(ctl):
    with Terminal(ctl, "watch", "-i", "0.2") as terminal:
        terminal.wait_for(r"(?s)requests.*workers.*requests.*workers")
        terminal.press(b"\x03")
        assert terminal.ended() == 130
        assert "Traceback" not in terminal.text


@pytest.mark.parametrize("words", [["solve", "contact.yaml"], ["health"]])
def test_colours_are_for_terminals(ctl, words):
    with Terminal(ctl, *words) as terminal:
        assert terminal.ended() == 0
        assert bool(ESCAPE.search(terminal.text)) == (words[0] == "solve"), "titles are bold, and names coloured"
    with Terminal(ctl, *words, NO_COLOR="1") as terminal:
        assert terminal.ended() == 0
        assert "\x1b[36m" not in terminal.text
    assert not ESCAPE.search(ctl.alone(*words).out)


def test_lines_in_a_pipe_are_as_long_as_they_need_to_be(ctl):
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {friction.mu: [0.1, 0.2]}\n")
    lines = ctl("study", "study.yaml", COLUMNS="40").out.splitlines()
    assert lines[0].split() == ["friction.mu", "forces.Fn", "forces.Fx", "forces.Fy", "forces.Mz", "approach", "pmax", "converged"]


def test_numbers_stay_whole_on_a_narrow_terminal(ctl):
    with Terminal(ctl, "solve", "contact.yaml", COLUMNS="30") as terminal:
        assert terminal.ended() == 0
        assert re.search(r"\d+ elements: \d+ in adhesion, \d+ in slip", ESCAPE.sub("", terminal.text))


def test_a_terminal_without_utf_8_gets_ascii(ctl):
    said = ctl.alone("bench", "-n", 3, PYTHONIOENCODING="ascii", LC_ALL="C", PYTHONUTF8="0")
    assert said.code == 0
    assert said.out.isascii()


@pytest.mark.parametrize("words", [["info"], ["watch", "-i", "0.1"], ["solve", "contact.yaml", "--json"]])
def test_who_reads_a_pipe_may_go(ctl, words):
    command = ctl.start(*words)
    command.stdout.close()
    err = command.stderr.read()
    command.stderr.close()
    assert command.wait(30) == 141
    assert err == ""
