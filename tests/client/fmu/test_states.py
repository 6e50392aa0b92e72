"""Tests states of an FMU: saved, restored, serialized, and read by other instances."""

from __future__ import annotations

import pytest

KINDS = {
    "steady": {},
    "transient": {"motion.kind": 1, "motion.velocity": 560.0},
    "shift": {"motion.kind": 2},
    "unlike bodies": {"lower.G": 20000.0, "motion.kind": 1, "motion.velocity": 560.0},
    "fastsim": {"model": 2},
    "a layer that hardens": {
        "motion.kind": 1, "motion.velocity": 560.0, "friction.layer.yield_stress": 40.0, "friction.layer.hardening": 2e3,
    },
    "memory": {
        "motion.kind": 1, "motion.velocity": 560.0, "friction.kinetic.law": 2, "friction.kinetic.slip_velocity": 0.1,
        "friction.kinetic.memory.distance": 1e-3,
    },
}  # fmt: skip
SMALL = {"grid.nx": 15, "grid.ny": 15, "grid.dx": 1.0, "grid.dy": 1.0}


def inputs(k):
    return {"load.Fn": 40e3 + 1e3 * (k % 7), "motion.xi": 3e-4 * (k % 5), "motion.shift_x": 1e-2 * (k % 3)}


def run(fmu, steps):
    return [fmu.step(inputs(k)) for k in steps]


@pytest.mark.parametrize("parameters", KINDS.values(), ids=KINDS)
def test_a_run_is_repeated_to_the_last_bit_from_any_state(contact, parameters):
    whole = run(contact(name="whole").start({**SMALL, **parameters}), range(9))
    fmu = contact().start({**SMALL, **parameters})
    run(fmu, range(3))
    state = fmu.slave.getFMUState()
    assert run(fmu, range(3, 9)) == whole[3:]
    for _ in range(2):
        fmu.go_back(state, 3e-3)
        assert fmu.outputs() == whole[2]
        assert run(fmu, range(3, 9)) == whole[3:]
    fmu.slave.freeFMUState(state)


@pytest.mark.parametrize("parameters", KINDS.values(), ids=KINDS)
def test_another_instance_goes_on_from_bytes(contact, parameters):
    one = contact(name="one").start({**SMALL, **parameters})
    run(one, range(3))
    state = one.slave.getFMUState()
    written = one.slave.serializeFMUState(state)
    one.slave.freeFMUState(state)
    other = contact(name="another")
    read = other.slave.deserializeFMUState(written)
    other.slave.setFMUState(read)
    assert other.outputs() == one.outputs()
    assert run(other, range(3, 7)) == run(one, range(3, 7))
    again = other.slave.getFMUState()
    assert len(other.slave.serializeFMUState(again)) == len(written)
    for state in (read, again):
        other.slave.freeFMUState(state)


def test_a_state_that_was_just_restored_can_be_taken(contact):
    fmu = contact().start({**SMALL, **KINDS["transient"]})
    run(fmu, range(3))
    state = fmu.slave.getFMUState()
    fmu.slave.setFMUState(state)
    copy = fmu.slave.getFMUState()
    assert fmu.slave.serializeFMUState(copy) == fmu.slave.serializeFMUState(state)
    whole = run(fmu, range(3, 6))
    fmu.slave.setFMUState(copy)
    assert run(fmu, range(3, 6)) == whole


def test_a_step_is_tried_again_in_halves(contact):
    """Behaves like masters with variable steps."""
    fmu = contact().start({**SMALL, **KINDS["transient"]})
    reference = contact(name="reference").start({**SMALL, **KINDS["transient"]})
    run(fmu, range(2)), run(reference, range(2))
    state = fmu.slave.getFMUState()
    fmu.step(inputs(2), 2e-3)
    fmu.go_back(state, 2e-3)
    halves = [fmu.step(inputs(2), 1e-3) for _ in range(2)]
    assert halves == [reference.step(inputs(2), 1e-3) for _ in range(2)]


def test_a_state_of_before_the_start_is_started_from(contact):
    fmu = contact()
    fmu.set(SMALL)
    state = fmu.slave.getFMUState()
    first = run(fmu.start(), range(2))
    fmu.go_back(state, 0)
    assert fmu.get("Fx") == 0
    assert run(fmu.start(), range(2)) == first


@pytest.mark.parametrize("damage", ["cut", "flipped", "empty", "of another kind"])
def test_bytes_that_are_no_state_are_refused(contact, wheel, damage):
    from fmpy.fmi1 import FMICallException

    fmu = contact().start({"model": 2})
    fmu.step()
    written = fmu.slave.serializeFMUState(fmu.slave.getFMUState())
    if damage == "of another kind":
        other = wheel()
        written = other.slave.serializeFMUState(other.slave.getFMUState())
    flipped = written[:40] + bytes([written[40] ^ 1]) + written[41:]
    bad = {"cut": written[:-3], "flipped": flipped, "empty": b"", "of another kind": written}[damage]
    with pytest.raises(FMICallException):
        fmu.slave.deserializeFMUState(bad)
    assert "not a state of this FMU" in fmu.log[-1][2]


def test_a_wheel_goes_back_and_on(wheel):
    coarse = {"elements.dx": 0.5, "elements.dy": 0.5, "model": 2}
    fmu = wheel().start(coarse)
    before = fmu.step({"position.y": 1.0})
    state = fmu.slave.getFMUState()
    slopes = fmu.derivatives(["Fy"], "position.y")
    later = fmu.step({"position.y": 3.0})
    fmu.slave.setFMUState(state)
    assert fmu.outputs() == before
    assert fmu.derivatives(["Fy"], "position.y") == slopes
    assert fmu.step({"position.y": 3.0}) == later
    other = wheel(name="another")
    other.slave.setFMUState(other.slave.deserializeFMUState(fmu.slave.serializeFMUState(state)))
    assert other.outputs() == before
    assert other.derivatives(["Fy"], "position.y") == slopes


def test_derivatives_are_those_between_neighbours(contact):
    fmu = contact().start({"model": 2})
    at = {"motion.xi": 1e-3, "motion.eta": 2e-4, "load.Fn": 50e3, "friction.mu": 0.3}
    before = fmu.step(at)
    of = ["Fx", "Fy", "Mz", "Fn", "approach"]
    for name, h in {"motion.xi": 1e-8, "motion.eta": 1e-8, "load.Fn": 1e-2, "friction.mu": 1e-6}.items():
        told = fmu.derivatives(of, name)
        more, less = (fmu.step({**at, name: at[name] + sign * h}) for sign in (1, -1))
        measured = [(more[one] - less[one]) / (2 * h) for one in of]
        assert told == pytest.approx(measured, rel=1e-3, abs=1e-4 * max(map(abs, measured))), name
        assert fmu.step(at) == before
    assert fmu.derivatives(of, "load.approach") == [0] * 5


def test_derivatives_by_several_inputs_at_once_are_added(contact):
    fmu = contact().start({"model": 2})
    fmu.step({"motion.xi": 1e-3})
    xi, Fn = (fmu.derivatives(["Fx"], name)[0] for name in ("motion.xi", "load.Fn"))
    references = [fmu.reference(name) for name in ("motion.xi", "load.Fn")]
    both = fmu.slave.getDirectionalDerivative([fmu.reference("Fx")], references, [2.0, -3.0])
    assert both == pytest.approx([2 * xi - 3 * Fn], rel=1e-14)
