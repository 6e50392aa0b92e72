"""Tests commands with damaged files, malicious names and signals, and that the fuzzer finds known defects."""

import os
import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parents[3] / "fuzz"))
import commands

from support.daemons import BIN


@pytest.fixture
def programs(monkeypatch):
    """Provides the solver of commands without an endpoint."""
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    monkeypatch.delenv("CONTACTD_ENDPOINT", raising=False)


def test_commands_bear_files_and_names_of_strangers(programs):
    assert commands.fuzz(seconds=30, seed=7, most=20) == []


def wicked(harm):
    """Replaces a command by a harmful one."""

    def main(words):
        exec(harm)
        raise SystemExit(0)

    return main


@pytest.mark.parametrize(
    ("harm", "finding"),
    [
        ("open('../other/ran', 'w').close()", "changes what lies beside its folder"),
        ("open('link.txt').read() and print(open('link.txt').read(), flush=True)", "tells a secret in out"),
        ("open('kept', 'w').write('mine')", "writes over kept"),
        ("raise ValueError", "has a traceback"),
        ("import tempfile; tempfile.mkdtemp()", "in the temporary folder"),
        ("import time; time.sleep(1000)", "takes longer than"),
    ],
)
def test_what_a_command_must_not_do_is_found(tmp_path, monkeypatch, harm, finding):
    monkeypatch.setattr(commands, "LONGEST", 1.0)
    commands.prepared(tmp_path, commands.random.Random(1))
    (tmp_path / "own" / "kept").write_bytes(commands.FOREIGN)
    run = commands.Run([], ["kept"], None, 0.0)
    found = commands.findings(run, tmp_path, wicked(harm))
    assert any(finding in sentence for sentence in found), found


def test_a_command_that_does_not_heed_a_signal_is_found(tmp_path, monkeypatch):
    monkeypatch.setattr(commands, "LONGEST_END", 0.2)
    monkeypatch.setattr(commands, "SLACK", 0.2)
    commands.prepared(tmp_path, commands.random.Random(1))
    run = commands.Run([], [], commands.signal.SIGTERM, 0.5)
    harm = "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN); time.sleep(1000)"
    assert "does not end within 0.2 s of SIGTERM" in commands.findings(run, tmp_path, wicked(harm))
