"""Tests arrays as lists and as frames, in both directions."""

import json

import numpy as np
import pytest

from conformance.requests import SOLVE, STRESS, TABLE
from conformance.wire import INVALID_ARGUMENT

NX, NY = SOLVE["grid"]["nx"], SOLVE["grid"]["ny"]
GAP = np.add.outer((np.arange(NY) - 2.0) ** 2, (np.arange(NX) - 2.5) ** 2) * 0.16 / 100
FRAME = {"$array": {"frame": 1, "dtype": "<f8", "shape": [NY, NX]}}


def with_gap(array):
    return {**SOLVE, "gap": {"array": array}}


def test_a_list_and_a_frame_mean_the_same(peer):
    listed = peer.ask("contact.solve", with_gap(GAP.tolist()))
    framed = peer.ask("contact.solve", with_gap(FRAME), GAP.tobytes())
    assert (listed.array(listed.result["pressure"]) == framed.array(framed.result["pressure"])).all()
    assert listed.result["forces"] == framed.result["forces"]


def test_results_come_as_frames_or_as_lists(peer):
    framed = peer.ask("contact.solve", SOLVE)
    listed = peer.ask("contact.solve", SOLVE, arrays="list")
    assert listed.frames == []
    for name in ["pressure", "element_division"]:
        assert isinstance(listed.result[name], list)
        assert framed.array(framed.result[name]).shape == (NY, NX)
        assert (framed.array(framed.result[name]) == listed.array(listed.result[name])).all()
    assert framed.result["element_division"]["$array"]["dtype"] == "|u1"


def test_a_table_has_four_axes(peer):
    reply = peer.ask("ic.get", TABLE)
    table = reply.array(reply.result["table"])
    assert table.shape == (3, 3, 6, 4)
    assert table[2, 2].argmax() == 0


def test_one_frame_may_be_named_twice(peer):
    # Uses the gap's frame also as friction of each element.
    friction = np.full((NY, NX), 0.3)
    params = {**with_gap(FRAME), "friction": {"mu": FRAME, "rigid_shift": [0.001, 0]}}
    assert peer.ask("contact.solve", params, friction.tobytes()).result["converged"]


@pytest.mark.parametrize(
    ("array", "frames"),
    [
        (FRAME, []),
        (FRAME, [GAP.tobytes()[:-1]]),
        (FRAME, [GAP.tobytes(), GAP.tobytes()]),
        ({"$array": {**FRAME["$array"], "frame": 2}}, [GAP.tobytes()]),
        ({"$array": {**FRAME["$array"], "frame": 0}}, [GAP.tobytes()]),
        ({"$array": {**FRAME["$array"], "dtype": "|u1"}}, [GAP.tobytes()]),
        ({"$array": {**FRAME["$array"], "dtype": ">f8"}}, [GAP.tobytes()]),
        ({"$array": {**FRAME["$array"], "shape": [NX, NY]}}, [GAP.tobytes()]),
        (FRAME, [np.where(GAP == GAP.max(), np.nan, GAP).tobytes()]),
        (GAP[:-1].tolist(), []),
        ([*GAP[:-1].tolist(), GAP[-1, :-1].tolist()], []),
    ],
    ids=["no frame", "short", "one too many", "wrong number", "zero", "dtype", "byte order", "shape", "nan", "rows", "row"],
)
def test_an_array_that_does_not_fit_is_refused(peer, array, frames):
    reply = peer.ask("contact.solve", with_gap(array), *frames)
    assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "ARRAY_INVALID")


def test_frames_are_for_requests_that_name_them(peer):
    reply = peer.ask("server.health", {}, b"12345678")
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "ARRAY_INVALID", ["frame 1"])


@pytest.mark.parametrize("number", ["6.0", "6e0", "60e-1"])
def test_a_whole_number_has_neither_fraction_nor_exponent(peer, number):
    request = {"contactd": 1, "id": "x", "method": "contact.solve", "params": SOLVE}
    reply = peer.ask_text(json.dumps(request).replace('"nx": 6', f'"nx": {number}'))
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "FIELD_INVALID", ["grid.nx"])


def test_the_numbers_of_an_envelope_are_bounded(start):
    daemon = start(limits={"max_array_elements": 100})
    with daemon.peer() as peer:
        reply = peer.ask("contact.subsurface", {**STRESS, "points": [[0, 0, -1]] * 3400})
        assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "LIMIT_EXCEEDED")
