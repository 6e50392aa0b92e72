"""Tests arrays and numbers to the wire and back."""

import math

import numpy as np
import pytest

from contactd import ContactProblem, Estimate, Friction, Grid, InvalidArgument, Material, ProtocolError
from contactd.transport.frames import Frames, decode, encode
from contactd.values.contact_params import problem_params
from contactd.values.params import array_of

VALUES = np.arange(6.0).reshape(2, 3)


def masked():
    return np.ma.masked_less(VALUES, 1)


@pytest.mark.parametrize(
    ("field", "changes"),
    [
        ("gap.array", {"gap": masked()}),
        ("gap.array", {"gap": [masked()[0], masked()[1]]}),
        ("friction.mu", {"friction": Friction(masked(), (0, 0))}),
        ("friction.mu", {"friction": Friction(np.ma.masked, (0, 0))}),
        ("previous.traction_x", {"previous": Estimate(VALUES, masked())}),
        ("initial.pressure", {"initial": Estimate(masked())}),
    ],
)
def test_a_masked_array_is_refused_by_name_instead_of_losing_its_mask(field, changes):
    problem = ContactProblem(Grid(3, 2, 1, 1), Material(1, 0.3), VALUES, 0.1).replace(**changes)
    with pytest.raises(InvalidArgument, match=rf"^{field} has 1 masked values; .*filled"):
        encode(problem_params(problem), "", Frames())


def test_a_mask_of_nothing_loses_nothing():
    whole = np.ma.masked_less(VALUES, -1)
    assert encode(array_of(whole), "gap.array", frames := Frames())["$array"]["shape"] == [2, 3]
    assert frames == [VALUES.tobytes()]


@pytest.mark.parametrize(
    "array",
    [
        VALUES,
        VALUES.astype("<f4"),
        VALUES.astype(">f8"),
        VALUES.astype(int),
        np.asfortranarray(VALUES),
        np.repeat(VALUES, 2, axis=1)[:, ::2],
    ],
    ids=["f8", "f4", "big-endian", "integers", "fortran-order", "strided"],
)
def test_every_dtype_and_layout_arrives_as_little_endian_doubles_in_c_order(array):
    frames = Frames()
    reference = encode(array, "gap.array", frames)
    assert reference == {"$array": {"frame": 1, "dtype": "<f8", "shape": [2, 3]}}
    assert frames == [VALUES.astype("<f8").tobytes()]


def test_frames_are_numbered_in_the_order_of_the_arrays():
    frames = Frames()
    encoded = encode({"a": VALUES, "b": [VALUES + 1, 1]}, "", frames)
    assert encoded["a"]["$array"]["frame"] == 1
    assert encoded["b"][0]["$array"]["frame"] == 2
    assert len(frames) == 2


def test_an_array_that_occurs_twice_is_one_frame():
    frames = Frames()
    encoded = encode([VALUES, VALUES[:, :2], VALUES, VALUES[:, :2]], "", frames)
    assert [item["$array"]["frame"] for item in encoded] == [1, 2, 1, 2]
    assert frames == [VALUES.tobytes(), VALUES[:, :2].tobytes()]


def test_views_of_one_memory_are_told_apart():
    frames = Frames()
    square = VALUES[:, :2]
    encode([square, square.T, square.reshape(4), square.view("i8")], "", frames)
    assert len(frames) == 4


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_arrays_that_are_not_finite_are_refused_with_their_place(value):
    array = VALUES.copy()
    array[1, 2] = value
    with pytest.raises(InvalidArgument, match=r"gap\.array contains .* at \[1, 2\]") as caught:
        encode({"gap": {"array": array}}, "", Frames())
    assert caught.value.reason == "ARRAY_INVALID"
    assert caught.value.violations[0].field == "gap.array"


@pytest.mark.parametrize("value", [math.nan, np.float32("inf")])
def test_numbers_that_are_not_finite_are_refused_by_name(value):
    with pytest.raises(InvalidArgument) as caught:
        encode({"friction": {"rigid_shift": [0.0, value]}}, "", Frames())
    assert caught.value.violations[0].field == "friction.rigid_shift[1]"


@pytest.mark.parametrize("array", [np.array([1j]), np.array(["a"]), np.array([None])])
def test_arrays_of_anything_but_real_numbers_are_refused(array):
    with pytest.raises(InvalidArgument, match="real numbers"):
        encode(array, "gap.array", Frames())


def test_scalars_of_numpy_become_plain_numbers():
    encoded = encode({"nx": np.int64(3), "dx": np.float32(0.5)}, "", Frames())
    assert encoded == {"nx": 3, "dx": 0.5}
    assert type(encoded["nx"]) is int


def test_what_json_cannot_hold_is_refused_by_name():
    with pytest.raises(InvalidArgument, match="metadata.when is a object"):
        encode({"metadata": {"when": object()}}, "", Frames())


def test_references_become_arrays_of_their_type_and_shape():
    reference = {"$array": {"frame": 1, "dtype": "|u1", "shape": [2, 2]}}
    decoded = decode({"division": reference, "other": [1]}, [bytes([0, 1, 2, 2])])
    assert decoded["division"].dtype == np.uint8
    assert decoded["division"].tolist() == [[0, 1], [2, 2]]
    assert decoded["other"] == [1]


@pytest.mark.parametrize(
    "reference",
    [
        {"frame": 2, "dtype": "<f8", "shape": [1]},
        {"frame": 0, "dtype": "<f8", "shape": [1]},
        {"frame": True, "dtype": "<f8", "shape": [1]},
        {"frame": 1, "dtype": "<f8", "shape": [2]},
        {"frame": 1, "dtype": "<f8", "shape": [-1]},
        {"frame": 1, "dtype": "|O", "shape": [1]},
        {"frame": 1, "dtype": ["<f8"], "shape": [1]},
        {"frame": 1, "dtype": "<f8"},
        {"frame": 1, "dtype": "<f8", "shape": 1},
        "frame 1",
    ],
)
def test_references_that_do_not_fit_their_frames_break_the_protocol(reference):
    with pytest.raises(ProtocolError):
        decode({"$array": reference}, [bytes(8)])
