"""Tests the comparison of two commits (python3 -m equality): it reports nothing without changes, and a change of one
bit."""

from __future__ import annotations

import dataclasses
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from equality import __main__ as equality
from equality import contacts
from equality.cases import KINDS, Case, cases
from equality.contents import Array, Contents, Number
from equality.differences import Explained, differences
from equality.run import Run, run
from support.daemons import BIN

#: One case of each kind that builds nothing.
FEW = [Case(number, kind, f"test/{kind}") for number, kind in enumerate(KINDS, 1) if "finite-element" not in kind]
ANSWER: Contents = {
    "status.name": "OK",
    "result.Fn": Number("9.5"),
    "result.evidence.normal.seconds": Number("0.1"),
    "result.pressure": Array("<f8", (2,), bytes(16)),
}


@pytest.fixture
def folder() -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="contactd-test-") as name:
        yield Path(name)


def played(folder: Path, chosen: list[Case]) -> Run:
    return run(BIN / "contactd", folder, chosen)


def test_a_daemon_answers_the_same_when_it_is_asked_again(folder):
    one, other = (played(folder / name, FEW) for name in ("one", "other"))
    assert equality.compare(one.played, other.played) == {}
    assert one.statuses["OK"] > 30
    assert one.statuses["INVALID_ARGUMENT"] > 3


def test_a_solver_that_stops_earlier_is_seen(folder, monkeypatch):
    some = [case for case in cases(30, 1) if case.kind in ("shift", "steady rolling")]
    before = played(folder / "before", some)
    solve = contacts.solve
    loose = {"normal": {"tolerance": 1e-3}, "tangential": {"tolerance": 1e-3}}
    monkeypatch.setattr(contacts, "solve", lambda dice, problem: solve(dice, {**problem, "settings": loose}))
    after = played(folder / "after", some)
    found = equality.compare(before.played, after.played)
    fields = {difference.field for unlike in found.values() for difference in unlike}
    assert {"result.pressure", "result.traction_x", "result.evidence.normal.residual"} <= fields


def test_cases_are_those_of_their_seed_and_of_every_kind():
    assert cases(300, 1) == cases(300, 1) != cases(300, 2)
    assert {case.kind: sum(other.kind == case.kind for other in cases(300, 1)) for case in cases(300, 1)} == {
        kind: often for kind, (often, _) in KINDS.items()
    }


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("result.pressure", Array("<f8", (2,), bytes(15) + b"\x80")),  # a zero with a sign
        ("result.pressure", Array("<f8", (1, 2), bytes(16))),
        ("result.Fn", Number("9.50")),
        ("result.Fn", "9.5"),
        ("status.name", "INTERNAL"),
        ("result.new", None),
    ],
)
def test_every_bit_counts(field, value):
    assert [difference.field for difference in differences(ANSWER, {**ANSWER, field: value})] == [field]
    assert [difference.field for difference in differences({**ANSWER, field: value}, ANSWER)] == [field]


def test_durations_do_not_count():
    assert differences(ANSWER, {**ANSWER, "result.evidence.normal.seconds": Number("7")}) == []


def test_an_explained_difference_is_passed_over_and_counted(monkeypatch):
    case = FEW[0]
    before, after = (
        [equality.Played(case, ["contact.solve"], [{**ANSWER, "result.Fn": Number(force)}])] for force in ("1", "2")
    )
    assert list(equality.compare(before, after)) == [f"case 1, {case.kind}, request 1 (contact.solve)"]
    why = Explained(case.kind, r"result\.F.", "The force is stated in other units.")
    monkeypatch.setattr(equality, "EXPLAINED", [why])
    assert equality.compare(before, after) == {}
    assert equality.explained(before, after) == {why.why: 1}
    monkeypatch.setattr(equality, "EXPLAINED", [dataclasses.replace(why, kind="another kind")])
    assert equality.compare(before, after) != {}
