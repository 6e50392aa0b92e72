"""Tests docs/contactctl.md: every example runs and prints the documented output; the manual page has every option."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

import click
import numpy as np
import pytest
import typer

from contactctl.app import app
from contactctl.codes import Code
from support.slowness import SLOWER

ROOT = Path(__file__).parents[4]
PAGE = (ROOT / "docs" / "contactctl.md").read_text()
MANUAL = (ROOT / "packaging" / "man" / "contactctl.1").read_text().replace("\\-", "-")


def examples():
    """Yields commands and their documented output, or None."""
    for block in re.findall(r"(?:^    .*\n(?:\n(?=    ))?)+", PAGE, re.MULTILINE):
        lines = [line[4:] for line in block.splitlines()]
        starts = [number for number, line in enumerate(lines) if line.startswith("$ ")]
        for start, end in zip(starts, [*starts[1:], len(lines)]):
            yield lines[start][2:], "\n".join(lines[start + 1 : end]).strip("\n") or None


@pytest.fixture
def folder(own):
    """Provides the files of the page, and contactctl on the path."""
    files = re.findall(r"^```(?:yaml\n#|text\n%) (\S+)\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    for name, text in files:
        own.write(name, text)
    x = (np.arange(40) - 19.5) * 0.06
    np.savetxt(own.folder / "gap.csv", (x[:, None] ** 2 + x**2) / 100, delimiter=",")
    own.write("head.csv", "y;z\n" + "".join(f"{y};{y * y / 600:.4f}\n".replace(".", ",") for y in range(-36, 37)))
    places = np.arange(1200)
    own.write("rail.csv", "x (m);r (um)\n" + "".join(f"{x / 1e3};{5 * np.sin(x / 7):.3f}\n".replace(".", ",") for x in places))
    program = own.folder / "bin" / "contactctl"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m contactctl "$@"\n')
    program.chmod(0o755)
    own.environment["PATH"] = f"{program.parent}:{own.environment['PATH']}"
    assert len(files) == 11
    return own


@pytest.mark.slow  # runs every example of the page
@pytest.mark.timeout(300)
def test_the_examples_of_the_page_run_and_show_what_they_show(folder):
    found = list(examples())
    assert len(found) > 20
    for command, shown in found:
        ended = subprocess.run(
            ["bash", "-o", "pipefail", "-c", command], cwd=folder.folder, env=folder.environment,
            capture_output=True, text=True, timeout=50 * SLOWER,
        )  # fmt: skip
        assert ended.returncode == 0, f"{command}: {ended.stderr}"
        assert shown is None or ended.stdout.strip("\n") == shown, command
    assert folder("solve", "rough.yaml").code == 0
    assert len((folder.folder / "study.csv").read_text().splitlines()) == 13


def test_every_command_has_an_example_that_runs():
    shown = "\n".join(command for command, _ in examples())
    assert not [name for name in COMMANDS if not re.search(rf"\b{name}\b|--local .*{name.removeprefix('contactctl')}\b", shown)]


def test_exit_codes_are_on_both_pages():
    table = {int(code) for code in re.findall(r"^\| (\d+) \| ", PAGE, re.MULTILINE)}
    section = MANUAL.partition(".SH EXIT STATUS")[2].partition(".SH")[0]
    manual = {int(code) for code in re.findall(r"^\.B (\d+)$", section, re.MULTILINE)}
    assert manual == {int(code) for code in Code}
    assert table == manual - {129, 143}
    assert "143: SIGTERM; 129: SIGHUP" in PAGE


def commands(command, name):
    """Returns all commands by their names."""
    if isinstance(command, click.Group):
        for word, part in command.commands.items():
            yield from commands(part, f"{name} {word}")
    else:
        yield name, command


COMMANDS = dict(commands(typer.main.get_command(app), "contactctl"))


def long_options(command):
    return {word for option in command.params if isinstance(option, click.Option) for word in option.opts if word.startswith("--")}


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_is_on_both_pages(name):
    words = name.removeprefix("contactctl ")
    assert re.search(rf"\b{words}\b", PAGE)
    assert re.search(rf"^\.B {words}\b|^\.BR {words}\b|^\.BI \"?{words}\b", MANUAL, re.MULTILINE), words


def test_the_manual_page_has_every_option_and_no_other():
    options = {"--version", "--help"}.union(*(long_options(command) for command in COMMANDS.values()))
    assert set(re.findall(r"--[A-Za-z][A-Za-z0-9-]*", MANUAL)) == options


@pytest.mark.parametrize("name", COMMANDS)
def test_every_option_says_what_it_means(name):
    for parameter in COMMANDS[name].params:
        assert getattr(parameter, "help", None), parameter.name
    assert len(COMMANDS[name].get_short_help_str(200)) > 15
