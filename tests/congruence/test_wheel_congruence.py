"""Tests one wheel on its rail in eight ways: every interface has the same answers to all cases, to the last bit, and
the same refusals."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import contactd
from congruence.test_congruence import Awaited, by_case, one_reason, program
from congruence.wheel_cases import EVERYWHERE, REFUSED, WITHOUT_C, write
from congruence.wheel_driver import CALLS, wheel_answers
from integration.conftest import shared_daemon  # noqa: F401

EVERY = {**EVERYWHERE, **WITHOUT_C}


@pytest.fixture(scope="module")
def cases(tmp_path_factory: pytest.TempPathFactory) -> dict[bool, Path]:
    """Returns all cases, and those that C supports."""
    folder = tmp_path_factory.mktemp("wheels")
    return {True: write(folder / "every.txt", EVERY), False: write(folder / "everywhere.txt", EVERYWHERE)}


@pytest.fixture(scope="module")
def expected(shared_daemon, cases) -> list[str]:  # noqa: F811
    """Returns the output of Python with a daemon."""
    with contactd.Client(shared_daemon.endpoint) as client:
        return list(wheel_answers(client, cases[True]))


def in_process(where: str, cases: Path) -> list[str]:
    with contactd.local(in_process=True) as client:
        return list(wheel_answers(client, cases))


def awaited(where: str, cases: Path) -> list[str]:
    loop = asyncio.new_event_loop()
    try:
        client: Any = Awaited(loop.run_until_complete, contactd.AsyncClient(where))
        said = list(wheel_answers(client, cases))
        client.close()
        return said
    finally:
        loop.close()


WAYS: dict[str, tuple[Callable[[str, Path], list[str]], bool, bool]] = {  # whether they ask the daemon, and know every case
    "python-local": (in_process, False, True),
    "python-async": (awaited, True, True),
    "cpp": (program("wheel-cpp"), True, True),
    "c": (program("wheel-c"), True, False),
    "c-local-with-a-daemon": (program("wheel-c-local"), True, False),
    "c-local": (program("wheel-c-local"), False, False),
    "fortran": (program("wheel-fortran"), True, False),
}


def test_every_call_of_every_case_has_its_line(expected):
    calls = [(name, word) for name, text in EVERY.items() for part in text.split(";") if (word := part.split()[0]) in CALLS]
    assert [tuple(line.split()[:2]) for line in expected] == calls


def test_only_what_is_meant_to_be_refused_is(expected):
    """A case that all interfaces refuse by mistake would be congruent, too."""
    assert {line.split()[0] for line in expected if " refused " in line} == REFUSED


def test_answers_are_not_all_the_same(expected):
    solved = [tuple(words[2:]) for line in expected if len(words := line.split()) > 2 and words[2] != "refused"]
    assert len(set(solved)) >= len(solved) - 2
    assert sum(len(line) > 120 for line in solved) > 30, "that have patches"


@pytest.mark.timeout(200)
@pytest.mark.parametrize("way", WAYS)
def test_every_way_answers_alike(way, expected, shared_daemon, cases):  # noqa: F811
    run, asks_daemon, knows_every = WAYS[way]
    found = by_case(run(shared_daemon.endpoint if asks_daemon else "local", cases[knows_every]))
    wanted = {name: lines for name, lines in by_case(expected).items() if knows_every or name in EVERYWHERE}
    if not way.startswith("python"):
        found, wanted = ({name: [*map(one_reason, lines)] for name, lines in all_.items()} for all_ in (found, wanted))
    assert found.keys() == wanted.keys()
    wrong = {name: (found[name], wanted[name]) for name in wanted if found[name] != wanted[name]}
    assert not wrong, "\n".join(f"{name}:\n  {way}: {own}\n  daemon: {other}" for name, (own, other) in wrong.items())
