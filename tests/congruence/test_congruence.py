"""Tests one contact in eight ways: every interface has the same answers to all cases, to the last bit, and the same
refusals."""

from __future__ import annotations

import asyncio
import os
import pickle
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import contactd
from congruence.cases import CASES, write
from congruence.driver import CALLS, answers
from congruence.paths import write_paths
from integration.conftest import shared_daemon  # noqa: F401
from support.daemons import BIN
from support.slowness import SLOWER

#: The drivers that set fields by their paths.
BY_PATH = {"c", "c-local-with-a-daemon", "c-local", "fortran"}

#: Cases that an interface does not support, with reasons; none at present.
CANNOT: dict[str, dict[str, str]] = {}


@pytest.fixture(scope="module")
def cases(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("congruence") / "cases.txt")


@pytest.fixture(scope="module")
def expected(shared_daemon, cases) -> list[str]:  # noqa: F811
    """Returns the output of Python with a daemon."""
    with contactd.Client(shared_daemon.endpoint) as client:
        return list(answers(client, cases))


@pytest.fixture(scope="module")
def cases_by_path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_paths(tmp_path_factory.mktemp("congruence") / "paths.txt")


def program(name: str) -> Callable[[str, Path], list[str]]:
    def run(where: str, cases: Path) -> list[str]:
        environment = {**os.environ, "LD_LIBRARY_PATH": str(BIN.parent / "lib")}
        command = [str(BIN / f"congruence-{name}"), where, str(cases)]
        ended = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=50 * SLOWER)
        assert ended.returncode == 0, ended.stderr
        return ended.stdout.splitlines()

    return run


def python_in_process(where: str, cases: Path) -> list[str]:
    with contactd.local(in_process=True) as client:
        return list(answers(client, cases))


SESSIONS = (contactd.AsyncSession, contactd.AsyncWheelRailSession)


class Awaited:
    """Returns the answer of an AsyncClient or its session, for a driver without an event loop."""

    def __init__(self, runner: Callable[[Any], Any], of: Any) -> None:
        self._runner, self._of = runner, of

    def __getattr__(self, name: str) -> Callable[..., Any]:
        def call(*args: Any, **keywords: Any) -> Any:
            answer = self._runner(getattr(self._of, name)(*args, **keywords))
            return Awaited(self._runner, answer) if isinstance(answer, SESSIONS) else answer

        return call


def python_async(where: str, cases: Path) -> list[str]:
    loop = asyncio.new_event_loop()
    try:
        client: Any = Awaited(loop.run_until_complete, contactd.AsyncClient(where))
        said = list(answers(client, cases))
        client.close()
        return said
    finally:
        loop.close()


def python_pickled(where: str, cases: Path) -> list[str]:
    with contactd.Client(where) as client, pickle.loads(pickle.dumps(client)) as arrived:
        client.health()
        return list(answers(arrived, cases))


WAYS: dict[str, tuple[Callable[[str, Path], list[str]], bool]] = {  # true if they use the daemon
    "python-local": (python_in_process, False),
    "python-async": (python_async, True),
    "python-pickled": (python_pickled, True),
    "cpp": (program("cpp"), True),
    "c": (program("c"), True),
    "c-local-with-a-daemon": (program("c-local"), True),
    "c-local": (program("c-local"), False),
    "fortran": (program("fortran"), True),
}


def one_reason(line: str) -> str:
    """C, C++ and Fortran check a problem before they send it, and have one reason for all errors in it."""
    return line.replace(" ARRAY_INVALID ", " FIELD_INVALID ")


def by_case(lines: list[str]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for line in lines:
        found.setdefault(line.split()[0], []).append(line.rstrip())
    return found


def calls() -> Iterator[tuple[str, str]]:
    for name, text in CASES.items():
        yield from ((name, part.split()[0]) for part in text.split(";") if part.split()[0] in CALLS)


def test_there_are_enough_cases_of_each_kind(expected):
    assert len(CASES) >= 60
    assert sum(len(line.split()) > 50 for line in expected) >= 100, "steps that were solved"
    refused = {line.split()[0] for line in expected if " refused " in line}
    assert len(refused) >= 20
    assert len({tuple(line.split()[2:]) for line in expected if " step " in line}) >= 100, "that are not all the same"


def test_every_call_of_every_case_has_its_line(expected):
    assert [tuple(line.split()[:2]) for line in expected] == list(calls())


def test_only_what_is_meant_to_be_refused_is(expected):
    """A case that all interfaces refuse by mistake would be congruent, too."""
    names = list(CASES)
    bad = set(names[names.index("no-elements") :])
    fail = {"a-step-that-does-not-converge", "a-step-again-after-one-that-failed"}
    assert {line.split()[0] for line in expected if " refused " in line} == bad | fail


def test_what_was_restored_takes_the_same_step_again(expected):
    _, first, _, second, third, _, again = by_case(expected)["save-and-restore"]
    assert again == second
    assert len({first, second, third}) == 3


@pytest.mark.timeout(200)
@pytest.mark.parametrize("way", WAYS)
def test_every_way_answers_alike(way, expected, shared_daemon, cases, cases_by_path):  # noqa: F811
    run, asks_daemon = WAYS[way]
    where = shared_daemon.endpoint if asks_daemon else "local"
    found, wanted = by_case(run(where, cases_by_path if way in BY_PATH else cases)), by_case(expected)
    assert found.keys() == wanted.keys() == CASES.keys()
    if not way.startswith("python"):
        found, wanted = ({name: [*map(one_reason, lines)] for name, lines in all_.items()} for all_ in (found, wanted))
    cannot = CANNOT.get(way, {})
    wrong = {name: (found[name], wanted[name]) for name in CASES if name not in cannot and found[name] != wanted[name]}
    assert not wrong, "\n".join(f"{name}:\n  {way}: {own}\n  daemon: {other}" for name, (own, other) in wrong.items())
    assert all(found[name] != wanted[name] for name in cannot), "they agree now: take them off the list"
