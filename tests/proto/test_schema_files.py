"""Tests that the files of proto/schema are JSON Schemas that other tools can use unchanged."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import referencing
import referencing.jsonschema

ROOT = Path(__file__).parents[2]
DOCUMENTS = {path.name: json.loads(path.read_text()) for path in (ROOT / "proto" / "schema").glob("*.json")}
REGISTRY: referencing.Registry[Any] = referencing.Registry().with_resources(
    (name, referencing.jsonschema.DRAFT7.create_resource(document)) for name, document in DOCUMENTS.items()
)


def is_valid(name: str, document: object) -> bool:
    return jsonschema.Draft7Validator(DOCUMENTS[name], registry=REGISTRY).is_valid(document)


def example_of(method: str) -> Any:
    """Returns the first example request in the schema of the method."""
    return copy.deepcopy(DOCUMENTS[f"{method}.params.json"]["examples"][0])


@pytest.mark.parametrize("name", sorted(DOCUMENTS))
def test_is_a_draft_7_schema(name: str) -> None:
    jsonschema.Draft7Validator.check_schema(DOCUMENTS[name])
    assert DOCUMENTS[name]["title"]
    assert DOCUMENTS[name]["description"]


def test_every_method_says_what_it_does_and_how_it_may_fail() -> None:
    methods = {name: document for name, document in DOCUMENTS.items() if name.endswith(".params.json")}
    for name, document in methods.items():
        assert document["x-summary"].endswith("."), name
        assert isinstance(document["x-errors"], list), name
    assert len({document["x-order"] for document in methods.values()}) == len(methods), "two methods have one place"


def examples() -> Iterator[tuple[str, object]]:
    """Yields the examples of each schema, and of each part of definitions.json."""
    for name, document in DOCUMENTS.items():
        if name == "definitions.json":
            for part, schema in document["definitions"].items():
                yield from ((f"{name}#/definitions/{part}", example) for example in schema["examples"])
        else:
            yield from ((name, example) for example in document["examples"])


@pytest.mark.parametrize(("reference", "example"), examples(), ids=lambda part: part if isinstance(part, str) else "")
def test_examples_conform(reference: str, example: object) -> None:
    errors = jsonschema.Draft7Validator({"$ref": reference}, registry=REGISTRY).iter_errors(example)
    assert [error.message for error in errors] == []


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (["grid", "nx"], 0),
        (["grid", "dx"], -1),
        (["grid", "extra"], 1),
        (["bodies", "upper", "nu"], 0.6),
        (["ics", "order"], 2),
        (["ics"], {"source": "analytic", "accuracy": 1e-3}),
        (["ics"], {"source": "fem", "accuracy": 1e-3, "order": 2}),
        (["ics"], {"source": "fem", "accuracy": 1e-3, "L_over_h": 20}),
        (["ics"], {"source": "fem", "accuracy": 1e-5}),
        (["gap", "array"], [[1.0]]),
        (["gap", "paraboloid", "Rx"], 0),
        (["gap", "semi_axes"], {"a": 1, "b": 1}),
        (["gap"], {"semi_axes": {"a": 1, "b": 0}}),
        (["Fn"], 9.2),
        (["model"], "exact"),
        (["bodies", "lower"], {"rigid": False}),
        (["bodies", "lower", "rigid"], True),
        (["friction", "rigid_shift"], [1]),
        (["friction", "mu"], "high"),
        (["friction", "force"], [None, None]),
        (["friction", "rolling"], {}),
        (["friction"], {"mu": 0.4}),
        (["friction"], {"mu": 0.4, "rolling": {"kind": "slow"}}),
        (["friction", "kinetic"], {"mu": 0.1}),
        (["previous"], {"traction_z": [[1.0]]}),
    ],
)
def test_refuses_what_the_daemon_refuses(path: list[str], value: object) -> None:
    document = copy.deepcopy(example_of("contact.solve"))
    target = document
    for key in path[:-1]:
        target = target[key]
    target[path[-1]] = value
    assert not is_valid("contact.solve.params.json", document)


@pytest.mark.parametrize(
    "changes",
    [
        {"gap": {"semi_axes": {"a": 1, "b": 2}}},
        {"bodies": {"upper": {"rigid": True}, "lower": {"G": 1, "nu": 0}}},
        {"friction": {"mu": [[0.1, 0.2]], "force": [1, None]}},
        {"friction": {"mu": 0.1, "rigid_shift": [0, 0], "force": [None, 1], "rotation": 1, "duration": 2}},
        {"friction": {"mu": 0.1, "rolling": {}, "kinetic": {"law": "linear", "mu": 0, "slip_velocity": 1}}},
        {"previous": {"pressure": [[1.0]]}, "settings": {"outer": {"max_iterations": 1}}, "model": "full"},
    ],
)
def test_takes_every_kind_of_contact(changes: dict[str, object]) -> None:
    assert is_valid("contact.solve.params.json", {**example_of("contact.solve"), **changes})


def test_takes_either_the_approach_or_the_force() -> None:
    document = example_of("contact.solve")
    del document["approach"]
    assert not is_valid("contact.solve.params.json", document)
    document["Fn"] = 0
    assert is_valid("contact.solve.params.json", document)


def test_coefficients_are_required_for_the_full_model_only() -> None:
    document = example_of("contact.solve")
    del document["ics"]
    assert not is_valid("contact.solve.params.json", document)
    document["model"] = "fastsim"
    assert is_valid("contact.solve.params.json", document)
    del document["bodies"]
    assert not is_valid("contact.solve.params.json", document)


@pytest.mark.parametrize(
    "ics",
    [
        {"source": "fem"},
        {"source": "fem", "accuracy": 1e-4, "any_nu": True, "load_shape": "bilinear"},
        {"source": "fem", "accuracy": 1e-2, "body": "block", "L_over_h": 20},
        {"source": "fem", "mesh": "prism", "order": 6, "diagonal": "across", "stopping_criterion": "update"},
    ],
)
def test_takes_an_accuracy_or_a_mesh(ics: object) -> None:
    assert is_valid("contact.solve.params.json", {**example_of("contact.solve"), "ics": ics})


def test_array_is_a_list_or_a_reference() -> None:
    document = example_of("contact.solve")
    document["gap"] = {"array": {"$array": {"frame": 1, "dtype": "<f8", "shape": [40, 40]}}}
    assert is_valid("contact.solve.params.json", document)
    document["gap"] = {"array": {"frame": 1}}
    assert not is_valid("contact.solve.params.json", document)


def test_bodies_are_required_unless_the_request_holds_its_coefficients() -> None:
    document = example_of("contact.solve")
    del document["bodies"]
    assert not is_valid("contact.solve.params.json", document)
    document["ics"] = {"source": "table", "table": [[[[1.0]]]], "dx": 0.06, "dy": 0.06}
    assert is_valid("contact.solve.params.json", document)
    document["ics"]["order"] = 2
    assert not is_valid("contact.solve.params.json", document)


def test_a_second_body_goes_with_contacts_text_only() -> None:
    document = example_of("ic.export")
    document["format"] = "hdf5"
    assert not is_valid("ic.export.params.json", document)
    del document["lower"]
    assert is_valid("ic.export.params.json", document)


@pytest.mark.parametrize(
    "changes",
    [
        {"body": "upper"},
        {"traction_y": [[0.0, 0.0]]},
        {"points": {"$array": {"frame": 1, "dtype": "<f8", "shape": [7, 3]}}, "block": None},
    ],
)
def test_takes_points_or_a_block_inside_either_body(changes: dict[str, object]) -> None:
    document = {**example_of("contact.subsurface"), **changes}
    assert is_valid("contact.subsurface.params.json", {k: v for k, v in document.items() if v is not None})


@pytest.mark.parametrize(
    "changes",
    [
        {"points": [[0, 0, -1]]},
        {"block": None},
        {"block": {"x": [0], "y": [0]}},
        {"nu": 0.6},
        {"nu": None},
        {"pressure": None},
        {"body": "both"},
        {"E": 82000},
        {"G": 0},
    ],
)
def test_refuses_stresses_that_are_not_well_asked_for(changes: dict[str, object]) -> None:
    document = {**example_of("contact.subsurface"), **changes}
    assert not is_valid("contact.subsurface.params.json", {k: v for k, v in document.items() if v is not None})
