"""Tests which contactd the programs of bench/ start."""

from pathlib import Path

from daemon_program import daemon_program


def test_programs_start_that_of_the_folder_which_the_environment_names(monkeypatch):
    monkeypatch.setenv("CONTACTD_BIN", "build/production/bin")
    assert daemon_program() == Path("build/production/bin/contactd")
    monkeypatch.delenv("CONTACTD_BIN")
    assert daemon_program() == "contactd"
