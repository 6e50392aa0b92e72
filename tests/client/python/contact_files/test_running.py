"""Chains of cases, and what follows from one that is not computed."""

from __future__ import annotations

from contactd.contact_files.runner import chains_of, checked
from support.contact_cases import basic_case


def test_steps_that_go_on_are_chained_and_others_stand_alone() -> None:
    first, next_step = basic_case(number=1, T=2), basic_case(number=2, T=2, P=0)
    steady, shift = basic_case(number=3), basic_case(number=4, T=1, P=0)
    chains = chains_of([first, next_step, steady, shift])
    assert [[case.number for case in chain] for chain in chains] == [[1, 2], [3, 4]]


def test_result_elements_have_histories_of_their_own() -> None:
    cases = [basic_case(reid=reid, number=number, T=1, P=2 if number == 1 else 0) for number in (1, 2) for reid in (5, 7)]
    chains = chains_of(cases)
    assert [[(case.reid, case.number) for case in chain] for chain in chains] == [[(5, 1), (5, 2)], [(7, 1), (7, 2)]]


def test_what_follows_from_a_case_that_is_refused_is_told_and_others_go_on() -> None:
    cases = [
        basic_case(number=1, line=10, T=1, M=1, reid=1), basic_case(number=1, line=20, T=1, reid=2),
        basic_case(number=2, line=30, T=1, P=0, reid=1), basic_case(number=2, line=40, T=1, P=0, reid=2),
        basic_case(number=3, line=50, T=1, reid=1), basic_case(number=4, line=60, reid=1, errors=("line 61, column 3: no number.",)),
    ]  # fmt: skip
    outcomes = checked(cases)
    assert [outcome.case.line for outcome in outcomes] == [10, 20, 30, 40, 50, 60]
    assert [outcome.status for outcome in outcomes] == ["refused", "read", "follows", "read", "read", "wrong"]
    assert "viscoelastic bodies" in outcomes[0].sentence
    assert outcomes[2].sentence == "It continues case 1 in line 10, which is not computed."
    assert "line 61, column 3" in outcomes[5].sentence
