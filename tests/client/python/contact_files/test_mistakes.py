"""Values that no problem has."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from contactd.contact_files.problems import refusals
from contactd.contact_files.problems.basic import BasicContact, goes_on
from contactd.contact_files.problems.mistakes import mistakes
from contactd.contact_files.problems.refusals import in_words_of
from contactd.contact_files.runner import chains_of, checked
from contactd.errors import InvalidArgument, Violation
from support.contact_cases import basic_case, rail_case

SCHEMAS = Path(__file__).parents[4] / "proto" / "schema"


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"AA": 0.0}, "AA is 0; it must be positive"),
        ({"BB": -1.0}, "BB is -1; it must be positive"),
        ({"AA": 1e200}, "AA is 1e\\+200; it must be positive, from 1e-30 to 1e\\+30"),
        ({"AA": 1e8, "BB": 1.0}, "AA/BB is 1e\\+08; it must be from 1e-06 to 1e\\+06"),
        ({"SCALE": 0.0}, "SCALE is 0"),
        ({"M": 4, "GG3": 1000.0, "LAYTHK": -0.1}, "LAYTHK is -0.1; it must be zero or positive"),
        ({"GG1": 0.0}, "GG1 is 0; it must be positive"),
        ({"POISS1": 0.6, "POISS2": 0.2}, "POISS1 is 0.6; it must be from 0 to 0.5"),
        ({"EPS": 0.0}, "EPS is 0; it must be positive"),
        ({"IPOTCN": -1, "A1": 0.001, "B1": 0.0}, "B1 is 0"),
        ({"IPOTCN": -1, "A1": 1e-12, "B1": 1e12}, "A1/B1 is 1e-24"),
        ({"IPOTCN": -2, "A1": 0.001, "AOB": 1e7}, "AOB is 1e\\+07"),
        ({"IPOTCN": -4, "A1": 0.001, "BB": 0.0}, "BB is 0"),
        ({"IPOTCN": 1, "IBASE": 9, "GAP": [0.0] * 35}, "IBASE = 9.* for 35 elements, but MX, MY are 12, 10; give it anew"),
        ({"E": 1, "EXRHS": 9, "SLIP_X": [0.0] * 35}, "extra rigid slip .E = 9. is kept for 35 elements"),
    ],
)
def test_values_that_are_none_are_told_by_name(changes: dict[str, object], sentence: str) -> None:
    (outcome,) = checked([basic_case(**changes)])
    assert outcome.status == "wrong"
    assert re.search(sentence, outcome.sentence)


def test_a_refusal_has_the_names_of_the_file() -> None:
    error = InvalidArgument(
        "", violations=[Violation("setup.track.gauge", "is 0.0; it must be positive"), Violation("setup.wheel.file.unit", "is 0.0")]
    )
    assert in_words_of(rail_case(), error) == (
        "GAUGWD (setup.track.gauge) is 0.0; it must be positive; WFNAME, MIRRORY, SCALE, SMOOTH (setup.wheel.file.unit) is 0.0."
    )
    assert in_words_of(basic_case(), InvalidArgument("the whole is wrong")).startswith("the whole is wrong")


def has_field(schema: dict[str, Any], document: str, parts: list[str]) -> bool:
    """Tells whether a path leads to a field of a schema, by references and through alternatives."""
    while "$ref" in schema:
        file, _, place = schema["$ref"].partition("#")
        document = file or document
        schema = json.loads((SCHEMAS / document).read_text())
        for name in place.strip("/").split("/"):
            schema = schema[name]
    if not parts:
        return True
    first = schema.get("properties", {}).get(parts[0])
    if first is not None and has_field(first, document, parts[1:]):
        return True
    return any(has_field(one, document, parts) for key in ("oneOf", "anyOf") for one in schema.get(key, []))


@pytest.mark.parametrize(
    ("names", "method", "objects"),
    [({**refusals._BOTH, **refusals._ALONE}, "contact.solve", ("",)),
     ({**refusals._BOTH, **refusals._ON_RAILS}, "wheelrail.solve", ("setup.", "state."))],
)  # fmt: skip
def test_names_of_refusals_are_of_fields_that_there_are(names: dict[str, str], method: str, objects: tuple[str, ...]) -> None:
    document = f"{method}.params.json"
    schema = json.loads((SCHEMAS / document).read_text())
    assert [name for name in names if not any(has_field(schema, document, (first + name).split(".")) for first in objects)] == []


def test_cases_that_can_be_have_none() -> None:
    assert mistakes(basic_case()) == mistakes(rail_case()) == []
    assert mistakes(basic_case(IPOTCN=-4, A1=0.001, BB=500.0)) == []


def test_an_approach_is_positive_where_hertz_finds_the_contact() -> None:
    case = basic_case(N=0, PEN=0.0)
    case.values.pop("FN", None)
    assert mistakes(case) == ["PEN is 0; it must be positive, from 1e-30 to 1e+30"]


def test_an_area_of_too_many_elements_is_refused_before_it_takes_memory() -> None:
    (outcome,) = checked([basic_case(MX=2_000_000_000, MY=2_000_000_000)])
    assert outcome.status == "refused"
    assert "MX, MY" in outcome.sentence


def test_a_first_case_that_keeps_extra_slip_has_none() -> None:
    case = basic_case(E=1)
    del case.values["EXRHS"]
    contact = BasicContact.of(case, lambda problem: 0.0)
    assert contact.problem.friction.rigid_slip is None
    assert contact.phi == case.values["CPHI"]


def test_a_case_without_digits_goes_on_from_none() -> None:
    case = basic_case(errors=("line 2, column 1: no digits",))
    case.digits.clear()
    assert not goes_on(case)
    assert [len(chain) for chain in chains_of([case, case, basic_case(T=1, P=0)])] == [1, 2]
