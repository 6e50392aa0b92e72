"""Tests contact problems: answers, errors, and signs."""

import math

import numpy as np
import pytest

from conformance.requests import HEAT, SOLVE, STRESS
from conformance.wire import INVALID_ARGUMENT, OK

NX, NY = SOLVE["grid"]["nx"], SOLVE["grid"]["ny"]
FRAME = {"$array": {"frame": 1, "dtype": "<f8", "shape": [NY, NX]}}
FLAT = np.zeros((NY, NX))


def test_no_contact_is_an_answer(peer):
    result = peer.ask("contact.solve", {**SOLVE, "approach": -0.01}).result
    assert result["elements"]["contact"] == 0
    assert result["forces"]["Fn"] == 0


def test_a_solve_that_did_not_converge_is_an_answer_that_says_so(peer):
    settings = {"normal": {"tolerance": 1e-14, "max_iterations": 1}}
    result = peer.ask("contact.solve", {**SOLVE, "settings": settings}).result
    assert result["converged"] is result["evidence"]["normal"]["converged"] is False
    assert result["evidence"]["normal"]["residual"] > 1e-14


def test_a_tangential_force_beyond_friction_is_refused(peer):
    friction = {"mu": 0.3, "force": [1e6, None]}
    reply = peer.ask("contact.solve", {**SOLVE, "friction": friction})
    assert reply.code == INVALID_ARGUMENT
    assert reply.fields == ["friction.force"]


def test_without_friction_every_contact_element_slips(peer):
    elements = peer.ask("contact.solve", SOLVE).result["elements"]
    assert elements["slip"] == elements["contact"] > 0


def test_traction_opposes_slip(peer):
    friction = {"mu": 0.1, "rigid_shift": [0.01, 0]}
    reply = peer.ask("contact.solve", {**SOLVE, "friction": friction})
    slip, traction, division = (reply.array(reply.result[name]) for name in ("slip_x", "traction_x", "element_division"))
    assert (division == 2).any()
    assert (slip * traction)[division == 2].max() < 0
    assert reply.result["forces"]["Fx"] < 0


def test_derivatives_are_answered_where_they_are_asked_for(peer):
    friction = {"mu": 0.1, "rolling": {"xi": 1e-3}}
    asked = {**SOLVE, "friction": friction, "derivatives": True}
    assert "derivatives" not in peer.ask("contact.solve", {**asked, "derivatives": False}).result
    result = peer.ask("contact.solve", asked).result
    derivatives, evidence = result["derivatives"], result["evidence"]["derivatives"]
    assert evidence["converged"] is True
    assert set(derivatives) == {"Fx", "Fy", "Mz", "Fn"}
    for row in derivatives.values():
        assert set(row) == {"xi", "eta", "phi", "approach", "mu"}
    assert derivatives["Fx"]["xi"] < 0
    assert derivatives["Fn"]["approach"] > 0
    assert derivatives["Fx"]["mu"] * 0.1 + derivatives["Fx"]["xi"] * 1e-3 == pytest.approx(result["forces"]["Fx"])
    (entry,) = many(peer, asked).result["solutions"]
    assert entry["result"]["derivatives"] == derivatives


def test_derivatives_that_are_not_known_are_refused(peer):
    friction = {"mu": 0.1, "rolling": {"xi": 1e-3, "kind": "transient", "steps": 2}}
    reply = peer.ask("contact.solve", {**SOLVE, "friction": friction, "derivatives": True})
    assert reply.code == INVALID_ARGUMENT
    assert reply.fields == ["derivatives"]


def many(peer, *problems, frames=(), **envelope):
    return peer.ask("contact.solve_many", {"problems": list(problems)}, *frames, **envelope)


def test_many_problems_refer_to_one_frame(peer):
    framed = {**SOLVE, "gap": {"array": FRAME}}
    entries = many(peer, framed, {**framed, "approach": 0.01}, frames=[FLAT.tobytes()]).result["solutions"]
    forces = [entry["result"]["forces"]["Fn"] for entry in entries]
    assert forces[0] == pytest.approx(2 * forces[1])


def test_one_problem_that_fails_does_not_fail_the_others(peer):
    entries = many(peer, SOLVE, {**SOLVE, "gap": {"array": [[1]]}}, SOLVE).result["solutions"]
    assert [entry["status"]["name"] for entry in entries] == ["OK", "INVALID_ARGUMENT", "OK"]
    assert [violation["field"] for violation in entries[1]["status"]["details"]["violations"]] == ["gap.array"]
    assert "result" not in entries[1]


def test_a_problem_that_breaks_the_schema_fails_all_and_is_named_by_its_place(peer):
    reply = many(peer, SOLVE, {**SOLVE, "bodies": {"upper": {"G": 200, "nu": 0.6}}})
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "FIELD_INVALID", ["problems[1].bodies.upper.nu"])


def test_an_array_counts_as_often_as_it_is_named(start):
    daemon = start(limits={"max_array_elements": 3 * NX * NY})
    framed = {**SOLVE, "gap": {"array": FRAME}}
    with daemon.peer() as peer:
        assert many(peer, *[framed] * 3, frames=[FLAT.tobytes()]).code == OK
        reply = many(peer, *[framed] * 4, frames=[FLAT.tobytes()])
        assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "LIMIT_EXCEEDED")


def test_shear_of_the_upper_body_has_the_other_sign(peer):
    grid = {"nx": 2, "ny": 1, "dx": 1, "dy": 1}
    field = {**STRESS, "grid": grid, "pressure": [[1, 2]], "points": [[0.3, 0.2, -0.7]]}

    def stress(body):
        reply = peer.ask("contact.subsurface", {**field, "body": body}, arrays="list")
        return {name: values[0] for name, values in reply.result["stress"].items()}

    lower, upper = stress("lower"), stress("upper")
    for name in lower:
        assert upper[name] == lower[name], name  # pressure alone is the same in the frame of either body
    field["traction_x"] = [[1, 1]]
    lower, upper = stress("lower"), stress("upper")
    assert lower["xz"] - upper["xz"] != 0


@pytest.mark.parametrize(
    ("points", "allowed"),
    [
        ({"points": [[0, 0, -1]] * 3}, False),
        ({"block": {"x": [0], "y": [0], "z": [-1, -2, -3]}}, False),
        ({"points": [[0, 0, -1]] * 2}, True),
    ],
    ids=["points", "block", "fewer"],
)
def test_the_arrays_of_stresses_together_are_bounded(start, points, allowed):
    daemon = start(limits={"max_array_elements": 14})
    field = {name: value for name, value in STRESS.items() if name != "points"}
    with daemon.peer() as peer:
        reply = peer.ask("contact.subsurface", {**field, **points})
        if allowed:
            assert reply.code == OK
        else:
            assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "LIMIT_EXCEEDED", list(points))


def test_temperatures_meet_in_contact_and_the_leading_element_has_half_of_its_heat(peer):
    answer = peer.ask("contact.temperature", HEAT, arrays="list").result
    (behind, trailing, leading), (lower_behind, *in_contact) = answer["upper_temperature"][0], answer["lower_temperature"][0]
    assert [trailing, leading] == pytest.approx(in_contact)
    assert behind > lower_behind
    # With a slip of 0.01 the upper surface is the slower one.
    upper, lower = (1e-3 * math.sqrt(50 * 7850 * 450) * math.sqrt(20000 * speed) for speed in (0.995, 1.005))
    own = 2 * math.sqrt(0.5) * 240 * 0.01 * 20000 / ((upper + lower) * math.sqrt(math.pi))
    assert leading == pytest.approx(80 * upper / (upper + lower) + own)
    heat = answer["temperature"]
    assert heat["heat_upper"] + heat["heat_lower"] == pytest.approx((270 + 240) * 0.01 * 20000)


@pytest.mark.parametrize(("changed", "field"), [({"chi": 1.5}, "chi"), ({"slip_x": [[0, 1]]}, "slip_x"), ({"velocity": 0}, "velocity")])
def test_temperatures_that_nobody_knows_are_refused_by_name(peer, changed, field):
    reply = peer.ask("contact.temperature", {**HEAT, **changed})
    assert (reply.code, reply.fields) == (INVALID_ARGUMENT, [field])
