"""Tests that every bad request gets a specific answer that names the field, and that the daemon serves the next
one."""

import copy
import json
from enum import Enum

import numpy as np
import pytest

from support.problems import CATTANEO_PARAMS

TABLE_PARAMS = {
    "material": {"G": 82000, "nu": 0.28},
    "grid": {"nx": 6, "ny": 6, "dx": 0.8, "dy": 0.8},
    "ics": {"source": "fem", "preset": "paper-test3"},
}
ENVELOPE = {"contactd": 1, "id": "7f", "method": "server.health", "params": {}}
REMOVED = Enum("Sign", "REMOVED").REMOVED


@pytest.fixture(autouse=True)
def still_serving(raw):
    """After any request of this module, the next request on the same socket is served."""
    yield
    assert raw.ask("server.health").result["state"] == "serving"


def changed(params, path, value):
    """Returns `params` with the field at the dotted `path` changed, added or removed."""
    params = copy.deepcopy(params)
    *parents, name = path.split(".")
    place = params
    for parent in parents:
        place = place[parent]
    if value is REMOVED:
        del place[name]
    else:
        place[name] = value
    return params


def assert_names(answer, field, reason="FIELD_INVALID"):
    assert answer.status == "INVALID_ARGUMENT"
    assert answer.reason == reason
    assert field in answer.fields
    assert field.split(".")[-1] in answer.message


@pytest.mark.parametrize(
    "text",
    [b"", b"hello", b"{", b'{"contactd": 1,}', b"\xff\xfe\x00", b'{"a": "\xc3\x28"}', b"[" * 100_000, b"{} {}"],
    ids=["empty", "words", "cut off", "trailing comma", "bytes", "bad UTF-8", "deep", "two"],
)
def test_what_is_no_json(raw, text):
    raw.send_bytes(text)
    answer = raw.receive()
    assert (answer.status, answer.reason) == ("INVALID_ARGUMENT", "NOT_JSON")
    assert answer.envelope["id"] is None


@pytest.mark.parametrize("text", [b"[]", b"3", b'"text"', b"null", b"true"])
def test_json_that_is_no_object(raw, text):
    raw.send_bytes(text)
    answer = raw.receive()
    assert (answer.status, answer.reason) == ("INVALID_ARGUMENT", "NOT_AN_OBJECT")
    assert answer.envelope["id"] is None


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("contactd", REMOVED), ("contactd", 1.5), ("contactd", "1"),
        ("id", REMOVED), ("id", ""), ("id", "x" * 129), ("id", 7),
        ("method", REMOVED), ("method", 3), ("method", None), ("method", ""),
        ("params", []), ("params", None),
        ("timeout_ms", 0), ("timeout_ms", -5), ("timeout_ms", 1.5), ("timeout_ms", 86_400_001), ("timeout_ms", "10"),
        ("arrays", "base64"), ("arrays", 1),
        ("metadata", "me"),
        ("priority", 1),
    ],
)  # fmt: skip
def test_an_envelope_that_breaks_the_rules(raw, field, value):
    raw.send_bytes(json.dumps(changed(ENVELOPE, field, value)).encode())
    answer = raw.receive()
    assert_names(answer, field, "ENVELOPE_INVALID")


@pytest.mark.parametrize("method", ["server.inof", "ic", "IC.GET", "contact.solve ", "\u2028", "ic.get.params"])
def test_an_unknown_method(raw, method):
    answer = raw.ask(method)
    assert (answer.status, answer.reason) == ("UNIMPLEMENTED", "UNKNOWN_METHOD")


@pytest.mark.parametrize("method", ["server.info", "server.health", "server.describe", "job.list"])
def test_a_superfluous_field_of_a_method_without_parameters(raw, method):
    assert_names(raw.ask(method, {"verbose": True}), "verbose")


BAD_TABLES = [
    ("material", REMOVED), ("grid", REMOVED), ("ics", REMOVED), ("material.G", REMOVED), ("material.nu", REMOVED),
    ("grid.nx", REMOVED), ("grid.dy", REMOVED), ("ics.source", REMOVED),
    ("colour", "red"), ("material.E", 210e3), ("grid.nz", 3), ("grid.x0", 0), ("ics.h", 1),
    ("material", []), ("material", "steel"), ("material.G", "82000"), ("material.G", None), ("material.nu", True),
    ("grid.nx", 2.5), ("grid.nx", "6"), ("grid.dx", [0.8]), ("ics.source", 1), ("ics.order", 1.5),
    ("ics.L_over_h", "1"),
    ("grid.nx", 0), ("grid.nx", -6), ("grid.ny", 0), ("grid.dx", 0), ("grid.dx", -0.8), ("grid.dy", 0),
    ("material.G", 0), ("material.G", -1), ("material.G", 1e-300),
    ("material.nu", -0.01), ("material.nu", 0.51), ("material.nu", 0.5), ("material.nu", 1),
    ("ics.source", "measured"), ("ics.preset", "paper-test4"), ("ics.body", "cone"), ("ics.load_shape", "cubic"),
    ("ics.mesh", "tetrahedra"), ("ics.far_boundary", "free"), ("ics.sampling", "cubic"), ("ics.diagonal", "up"),
    ("ics.solver", "lu"), ("ics.stopping_criterion", "energy"), ("ics.any_nu", 1), ("ics.any_nu", "yes"),
    ("ics.max_dofs", 999), ("ics.max_dofs", 1e4), ("ics.t1_over_hs", -1), ("ics.t1_over_hs", 1e-4),
    ("ics.order", 0), ("ics.order", 7), ("ics.f", 0.9), ("ics.f", -1), ("ics.l_over_h", 0), ("ics.l_over_h", -1),
    ("ics.L_over_h", 0), ("ics.L_over_h", -640), ("ics.L_over_h", 1), ("ics.L_over_h", 2),
    ("ics.tolerance", 0), ("ics.tolerance", -1e-8), ("ics.tolerance", 1), ("ics.max_iterations", 0),
    ("ics.max_iterations", -1), ("ics.strength_threshold", -0.1), ("ics.strength_threshold", 1.1),
    ("ics.h_over_hs", 3), ("ics.h_over_hs", 5), ("ics.h_over_hs", 2.5), ("ics.h_over_hs", 0), ("ics.h_over_hs", -4),
    ("ics.l_over_h", 1.1), ("ics.l_over_h", 0.25),
]  # fmt: skip


@pytest.mark.parametrize(("path", "value"), BAD_TABLES, ids=lambda part: str(part)[:24])
def test_a_table_that_cannot_be_asked_for(raw, path, value):
    assert_names(raw.ask("ic.get", changed(TABLE_PARAMS, path, value)), path)


MESH_FIELDS = {
    "preset": "paper-test3", "mesh": "hex", "order": 2, "l_over_h": 1, "h_over_hs": 4, "f": 1.2, "t1_over_hs": 0,
    "L_over_h": 640, "diagonal": "outward", "max_dofs": 60000, "far_boundary": "half_space", "sampling": "fem",
    "solver": "auto", "stopping_criterion": "residual", "tolerance": 1e-8, "max_iterations": 1000, "strength_threshold": 0.5,
}  # fmt: skip


@pytest.mark.parametrize("name", MESH_FIELDS)
def test_a_mesh_does_not_go_with_an_accuracy(raw, name):
    ics = {"source": "fem", "accuracy": 1e-3, name: MESH_FIELDS[name]}
    answer = raw.ask("ic.get", changed(TABLE_PARAMS, "ics", ics))
    assert_names(answer, f"ics.{name}")
    assert "an accuracy chooses the mesh and the solver by itself" in answer.message


FEM = {"source": "fem"}
BLOCK = {"source": "fem", "body": "block"}


@pytest.mark.parametrize(
    ("ics", "field"),
    [
        ({"source": "analytic", "body": "block"}, "ics.body"),
        ({"source": "analytic", "accuracy": 1e-3}, "ics.accuracy"),
        ({"source": "analytic", "any_nu": True}, "ics.any_nu"),
        ({**BLOCK, "far_boundary": "half_space"}, "ics.far_boundary"),
        ({**BLOCK, "preset": "paper-test3", "far_boundary": "half_space"}, "ics.far_boundary"),
        ({**BLOCK, "accuracy": 1e-3, "order": 2}, "ics.order"),
        ({**BLOCK, "accuracy": 1e-3, "L_over_h": 5}, "ics.L_over_h"),
        ({**BLOCK, "L_over_h": 5}, "ics.L_over_h"),
        ({**BLOCK, "accuracy": 1e-2, "L_over_h": 0.4}, "ics.L_over_h"),
        ({**FEM, "accuracy": 0}, "ics.accuracy"),
        ({**FEM, "accuracy": 9e-5}, "ics.accuracy"),
        ({**FEM, "accuracy": 0.2}, "ics.accuracy"),
        ({**FEM, "accuracy": "1e-3"}, "ics.accuracy"),
        ({**FEM, "accuracy": None}, "ics.accuracy"),
        ({**FEM, "load_shape": "bilinear", "l_over_h": 0.5}, "ics.l_over_h"),
        ({**FEM, "mesh": "adaptive", "solver": "direct"}, "ics.solver"),
    ],
    ids=lambda part: str(part)[:60],
)
def test_options_that_do_not_go_together(raw, ics, field):
    assert_names(raw.ask("ic.get", changed(TABLE_PARAMS, "ics", ics)), field)


@pytest.mark.parametrize("ics", [{**FEM, "accuracy": 1e-3}, {**FEM, "any_nu": True}, {**FEM, "f": 2, "any_nu": True}])
def test_an_accuracy_and_a_family_end_at_a_poissons_ratio_of_049(raw, ics):
    params = changed(changed(TABLE_PARAMS, "ics", ics), "material.nu", 0.495)
    assert_names(raw.ask("ic.get", params), "material.nu")


@pytest.mark.parametrize("body", ["upper", "lower"])
def test_a_solve_names_the_body_whose_material_does_not_go_with_an_accuracy(raw, body):
    bodies = {"upper": {"G": 200, "nu": 0.42}, "lower": {"G": 200, "nu": 0.42}, body: {"G": 200, "nu": 0.495}}
    params = {**CATTANEO_PARAMS, "bodies": bodies, "ics": {**FEM, "accuracy": 1e-2}}
    assert_names(raw.ask("contact.solve", params), f"bodies.{body}.nu")


def test_an_accuracy_does_not_go_with_slender_elements(raw):
    params = changed(changed(TABLE_PARAMS, "ics", {**FEM, "accuracy": 1e-3}), "grid.dx", 10)
    assert_names(raw.ask("ic.get", params), "ics.accuracy")


def test_fields_of_finite_elements_do_not_go_with_the_closed_form(raw):
    params = changed(TABLE_PARAMS, "ics", {"source": "analytic", "order": 2})
    answer = raw.ask("ic.get", params)
    assert answer.status == "INVALID_ARGUMENT"
    assert any(field.startswith("ics") for field in answer.fields)


def test_an_incompressible_material_goes_with_the_closed_form(raw):
    params = changed(changed(TABLE_PARAMS, "material.nu", 0.5), "ics", {"source": "analytic"})
    assert raw.ask("ic.get", params).status == "OK"


BAD_PROBLEMS = [
    ("grid", REMOVED), ("bodies", REMOVED), ("bodies.upper", REMOVED), ("ics", REMOVED), ("gap", REMOVED),
    ("approach", REMOVED), ("friction.mu", REMOVED), ("friction.rigid_shift", REMOVED),
    ("temperature", 20), ("bodies.middle", {"G": 1, "nu": 0}), ("friction.kind", "Coulomb"), ("gap.cone", {}),
    ("gap.paraboloid.R", 50), ("settings", {"rolling": {}}),
    ("approach", "0.02"), ("approach", None), ("gap", []), ("gap.paraboloid", 50), ("friction", 0.4),
    ("friction.rigid_shift", 0.00817), ("initial", 0),
    ("grid.nx", 0), ("grid.ny", -40), ("grid.dx", 0), ("grid.dy", -0.06),
    ("bodies.upper.nu", -0.1), ("bodies.upper.nu", 0.6), ("bodies.lower", {"G": 200, "nu": 0.7}),
    ("bodies.upper.G", 0), ("friction.mu", -0.4), ("gap.paraboloid.Rx", 0),
]  # fmt: skip


@pytest.mark.parametrize(("path", "value"), BAD_PROBLEMS, ids=lambda part: str(part)[:24])
def test_a_problem_that_cannot_be_solved(raw, path, value):
    answer = raw.ask("contact.solve", changed(CATTANEO_PARAMS, path, value))
    assert (answer.status, answer.reason) == ("INVALID_ARGUMENT", "FIELD_INVALID")
    # A value of the wrong kind is named itself, or by its content.
    assert any(field.startswith(path) for field in answer.fields), answer.fields


@pytest.mark.parametrize("shift", [[], [0.1], [0.1, 0, 0], [0.1, "0"], [None, 0]])
def test_a_rigid_shift_is_two_numbers(raw, shift):
    answer = raw.ask("contact.solve", changed(CATTANEO_PARAMS, "friction.rigid_shift", shift))
    assert answer.status == "INVALID_ARGUMENT"
    assert any(field.startswith("friction.rigid_shift") for field in answer.fields)


@pytest.mark.parametrize(
    "gap", [{}, {"paraboloid": {}}, {"paraboloid": {"Rx": 50}, "array": [[0]]}], ids=["nothing", "flat", "two"]
)
def test_a_gap_is_a_paraboloid_or_an_array(raw, gap):
    answer = raw.ask("contact.solve", changed(CATTANEO_PARAMS, "gap", gap))
    assert answer.status == "INVALID_ARGUMENT"
    assert any(field.startswith("gap") for field in answer.fields)


@pytest.mark.parametrize("word", ["NaN", "Infinity", "-Infinity", "1e999", "-1e999"])
@pytest.mark.parametrize("field", ["approach", "grid.dx", "friction.mu"])
def test_numbers_in_the_text_that_are_not_finite(raw, field, word):
    params = changed(CATTANEO_PARAMS, field, "WORD")
    text = json.dumps({**ENVELOPE, "method": "contact.solve", "params": params}).replace('"WORD"', word)
    raw.send_bytes(text.encode())
    answer = raw.receive()
    assert answer.status == "INVALID_ARGUMENT"
    assert field in answer.fields
    assert "finite" in answer.message


@pytest.mark.parametrize("method", ["ic.get", "contact.solve"])
@pytest.mark.parametrize("n", [10**6, 4 * 10**6, 10**12, 10**300])
def test_a_grid_that_is_far_too_large(raw, method, n):
    params = TABLE_PARAMS if method == "ic.get" else CATTANEO_PARAMS
    answer = raw.ask(method, changed(changed(params, "grid.nx", n), "grid.ny", n))
    assert answer.status == "INVALID_ARGUMENT"
    assert "grid.nx" in answer.fields


# --- arrays ----------------------------------------------------------------------------------------------------------

SMALL = {**CATTANEO_PARAMS, "grid": {"nx": 3, "ny": 2, "dx": 0.8, "dy": 0.8}}
ZEROS = np.zeros((2, 3))


def reference(**changes):
    return {"$array": {"frame": 1, "dtype": "<f8", "shape": [2, 3], **changes}}


def ask_with_gap(raw, gap, *frames):
    return raw.ask("contact.solve", {**SMALL, "gap": {"array": gap}}, *frames)


def test_an_array_that_fits_is_taken(raw):
    assert ask_with_gap(raw, reference(), ZEROS.tobytes()).status == "OK"


@pytest.mark.parametrize("length", [0, 1, 40, 47, 49, 56, 96])
def test_bytes_that_do_not_match_the_shape(raw, length):
    assert_names(ask_with_gap(raw, reference(), bytes(length)), "gap.array", "ARRAY_INVALID")


@pytest.mark.parametrize("shape", [[3, 2], [6], [1, 2, 3], [2, 4], [0, 0]])
def test_a_shape_that_is_not_that_of_the_grid(raw, shape):
    frame = bytes(8 * int(np.prod(shape)))
    assert_names(ask_with_gap(raw, reference(shape=shape), frame), "gap.array", "ARRAY_INVALID")


@pytest.mark.parametrize("shape", [[], [-2, 3], ["2", 3], [2.5, 3], "2x3", [2**63, 2**63], [4294967296, 4294967296]])
def test_a_shape_that_is_none(raw, shape):
    answer = ask_with_gap(raw, reference(shape=shape), ZEROS.tobytes())
    assert answer.status == "INVALID_ARGUMENT"
    assert any(field.startswith("gap.array") for field in answer.fields)


@pytest.mark.parametrize("frame", [2, 7, 10**9])
def test_a_frame_that_does_not_exist(raw, frame):
    assert_names(ask_with_gap(raw, reference(frame=frame), ZEROS.tobytes()), "gap.array", "ARRAY_INVALID")


@pytest.mark.parametrize("frame", [0, -1, 1.5, "1", 2**70])
def test_a_frame_number_that_is_none(raw, frame):
    answer = ask_with_gap(raw, reference(frame=frame), ZEROS.tobytes())
    assert answer.status == "INVALID_ARGUMENT"
    assert any(field.startswith("gap.array") for field in answer.fields)


def test_a_reference_without_any_frame(raw):
    assert_names(ask_with_gap(raw, reference()), "gap.array", "ARRAY_INVALID")


@pytest.mark.parametrize("dtype", [">f8", "<f4", "|u1", "float64", 8])
def test_a_type_that_is_not_taken(raw, dtype):
    answer = ask_with_gap(raw, reference(dtype=dtype), ZEROS.tobytes())
    assert answer.status == "INVALID_ARGUMENT"
    assert any(field.startswith("gap.array") for field in answer.fields)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_values_in_a_frame_that_are_not_finite(raw, value):
    gap = ZEROS.copy()
    gap[1, 2] = value
    answer = ask_with_gap(raw, reference(), gap.tobytes())
    assert_names(answer, "gap.array", "ARRAY_INVALID")
    assert "[1, 2]" in answer.message


@pytest.mark.parametrize(
    "gap",
    [[], [[0] * 3], [[0] * 3, [0] * 2], [0] * 6, [[0] * 3, [0, "0", 0]], [[0] * 3, [0, None, 0]], [[[0]] * 3] * 2],
    ids=["empty", "a row short", "ragged", "flat", "text", "null", "deep"],
)  # fmt: skip
def test_lists_that_do_not_match_the_grid(raw, gap):
    answer = ask_with_gap(raw, gap)
    assert answer.status == "INVALID_ARGUMENT"
    assert any(field.startswith("gap.array") for field in answer.fields)


@pytest.mark.parametrize("name", ["pressure", "traction_x", "traction_y"])
def test_an_estimate_that_does_not_match_the_grid(raw, name):
    answer = raw.ask("contact.solve", {**SMALL, "initial": {name: reference()}}, bytes(8))
    assert_names(answer, f"initial.{name}", "ARRAY_INVALID")


def test_a_frame_that_nothing_refers_to(raw):
    answer = raw.ask("contact.solve", SMALL, ZEROS.tobytes())
    assert (answer.status, answer.reason) == ("INVALID_ARGUMENT", "ARRAY_INVALID")
