"""Computes cases of the CONTACT program's input files, given ones and those made by hand, which become a text first."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from contactd.contact_files.case import Case
from contactd.contact_files.input_file import name_and_text
from contactd.contact_files.named_files import NamedFiles
from contactd.contact_files.runner import Runner, chains_of, requests_of
from contactd.contact_files.solved_case import SolvedCase
from contactd.files.profile_text import format_profile
from contactd.wheel_rail import S1002, Rail60E1, WheelRailSetup
from support.contact_text import text_of

__all__ = ["computed", "computed_file", "converted", "runner_of", "text_of_cases", "write_profiles"]


def write_profiles(folder: Path, client: Any) -> None:
    """Writes the profiles of cases made by hand: a rail 60E1 and a wheel S1002."""
    placed = client.placed_profiles(WheelRailSetup(rail=Rail60E1(0.025), wheel=S1002())).right
    (folder / "rail.prr").write_text(format_profile(placed.rail, "rail", ".prr"))
    (folder / "wheel.prw").write_text(format_profile(placed.wheel, "wheel", ".prw"))


def text_of_cases(cases: Sequence[Case], folder: Path) -> str:
    """Returns one text of all cases, with the digits of what they print and from what they go on."""
    return "".join(text_of(case, folder, is_first=False) for case in cases) + "0 MODULE\n"


def runner_of(client: Any, text: str, folder: Path, wheel: Any = "exact") -> tuple[Runner, tuple[Case, ...]]:
    cases = client.read_contact_file(text).cases
    return Runner(client, text, cases, NamedFiles(folder), wheel), cases


def computed(client: Any, cases: Sequence[Case], folder: Path, wheel: Any = "exact") -> list[SolvedCase]:
    """Computes cases that were made by hand, in their order."""
    runner, read = runner_of(client, text_of_cases(cases, folder), folder, wheel)
    assert len(read) == len(cases)
    return _run(runner, read)


def converted(client: Any, cases: Sequence[Case], folder: Path = Path()) -> list[Any]:
    """Returns the problems of cases that were made by hand."""
    runner, read = runner_of(client, text_of_cases(cases, folder), folder)
    assert len(read) == len(cases)
    return list(runner.converted(read))


def computed_file(client: Any, path: Path, wheel: Any = "exact", chosen: Any = slice(None)) -> list[SolvedCase]:
    """Computes the chosen cases of a file, in their order."""
    _, text = name_and_text(path)
    runner, read = runner_of(client, text, path.parent, wheel)
    return _run(runner, [case for case in read if chosen(case)] if callable(chosen) else read[chosen])


def _run(runner: Runner, cases: Sequence[Case]) -> list[SolvedCase]:
    requests = requests_of(chains_of(cases), "")
    found = {id(solved.case): solved for request in requests for solved in runner.run(request)}
    return [found[id(case)] for case in cases]
