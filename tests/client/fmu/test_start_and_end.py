"""Tests an FMU before its first step, refusals at its start, the progress of time, and the end of instances."""

from __future__ import annotations

import pytest

COARSE = {"elements.dx": 0.5, "elements.dy": 0.5, "model": 2}
QUICK = {"model": 2}
SMALL = {"grid.nx": 15, "grid.ny": 15}
ROLLING_ON, SHIFT = {"motion.kind": 1}, {"motion.kind": 2}


def started(fmu, values):
    """Returns its outputs before any step."""
    return fmu.start(values).outputs()


@pytest.mark.parametrize("velocity", [20e3, 1.0, 1e5])
def test_transient_rolling_starts_at_any_velocity(contact, velocity):
    fmu = contact().start({**SMALL, **ROLLING_ON, "motion.velocity": velocity})
    assert fmu.step({"motion.xi": 1e-3}, 0.56 / velocity)["Fx"] < 0


def test_outputs_of_steady_rolling_are_there_before_the_first_step(contact):
    values = {**SMALL, "motion.xi": 1e-3}
    before = started(fmu := contact(), values)
    assert before["Fn"] == pytest.approx(50e3)
    assert before["Fx"] < -1e3
    assert before["converged"]
    assert fmu.step() == pytest.approx(before, rel=1e-4)


@pytest.mark.parametrize("motion", [ROLLING_ON, SHIFT], ids=["transient", "shift"])
def test_what_goes_on_from_step_to_step_is_pressed_together_at_first(contact, motion):
    values = {**SMALL, **motion, "motion.xi": 1e-3, "motion.shift_x": 1.0}
    before = started(fmu := contact(), values)
    assert before["Fn"] == pytest.approx(50e3)
    assert (before["Fx"], before["Fy"], before["power"], before["work"]) == (0, 0, 0, 0)
    assert before["area.adhesion"] == before["area.contact"] > 0
    assert before["pmax"] > 100
    assert before["xi"] == (1e-3 if motion == ROLLING_ON else 0)
    assert before["converged"]
    after = fmu.step()
    other = contact(name="not looked at").start(values)
    assert other.step() == after
    assert after["Fx"] < 0


def test_outputs_of_a_wheel_are_there_before_the_first_step(wheel):
    before = started(fmu := wheel(), {**COARSE, "position.y": 2.0, "load.Fz": 70e3})
    assert before["Fz"] == pytest.approx(70e3, rel=1e-5)
    assert before["patch[1].Fn"] > 0
    assert fmu.step() == before


def test_a_start_that_does_not_converge_is_told_and_no_error(contact):
    fmu = contact(logging=True)
    outputs = started(fmu, {**SMALL, "tolerances.iterations": 1, "motion.xi": 1e-3})
    assert not outputs["converged"]
    assert any(status == 1 and "before the first step" in sentence for status, _, sentence in fmu.log)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"model": 2, "motion.kind": 1}, ["transient", "fastsim"]),
        ({"model": 2, "motion.kind": 2}, ["shift", "fastsim"]),
        ({"model": 1, "motion.phi": 1e-4}, ["friction.rolling.phi"]),
        ({"model": 1, "motion.kind": 1}, ["transient", "hertz"]),
        ({"model": 1, "gap.Rx": -5.0}, ["gap.paraboloid.Rx"]),
        ({"model": 1, "lower.coefficients": 3}, ["hertz", "layers"]),
        ({"friction.kinetic.law": 1, "friction.kinetic.mu": 0.9}, ["friction.kinetic.mu"]),
        ({"friction.kinetic.law": 2, "friction.kinetic.slip_velocity": 0.0}, ["slip_velocity"]),
        ({"force.prescribe_x": True, "force.x": 1e6}, ["friction.rolling.force"]),
        ({"motion.kind": 1, "motion.velocity": 0.0}, ["velocity"]),
        ({"tolerances.iterations": -3}, ["iterations"]),
        ({"limits.connect": -1.0}, ["seconds"]),
    ],
    ids=lambda value: ", ".join(map(str, value)) if isinstance(value, dict) else "",
)
def test_a_contact_that_makes_no_sense_does_not_start(contact, refused, values, words):
    fmu = contact()
    fmu.enter({**SMALL, **values})
    refused(fmu, fmu.slave.exitInitializationMode, *words)
    fmu.slave.reset()
    assert fmu.start(QUICK).step()["Fn"] == pytest.approx(50e3)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"elements.dx": 0.0}, ["dx"]),
        ({"elements.dq": -1.0}, ["dq"]),
        ({"wheelset.nominal_radius": -1.0}, ["nominal_radius"]),
        ({"wheelset.flange_back_distance": 0.0}, ["flange_back_distance"]),
        ({"track.gauge": -1435.0}, ["gauge"]),
        ({"rail.nu": 0.9}, ["nu"]),
        ({"wheel.rigid": True, "rail.rigid": True}, ["rigid"]),
        ({"model": 0, "conformal": 1, "mesh_search": True, "elements.dy": -1.0}, ["dy"]),
        ({"conformal": 1}, ["conformal"]),
        ({"slip_of_surfaces": True}, ["rigid_slip"]),
        ({"load.Fz": -8e4}, ["Fz"]),
        ({"load.Fz": 0.0}, ["Fz"]),
        ({"friction.mu": -0.3}, ["mu"]),
        ({"prescribe_Fx": True, "friction.none": True}, ["Fx"]),
        ({"tolerances.force": 0.0}, ["tolerance"]),
        ({"rail.profile": "arc", "rail.from": 30.0, "rail.to": -30.0}, ["rail.arc.to", "30"]),
        ({"model": 1}, ["model", "hertz", "spin"]),
        ({"position.roll": 2.0}, ["roll"]),
    ],
    ids=lambda value: ", ".join(map(str, value)) if isinstance(value, dict) else "",
)
def test_a_wheel_that_makes_no_sense_does_not_start(wheel, refused, values, words):
    fmu = wheel()
    fmu.enter({**COARSE, **values})
    refused(fmu, fmu.slave.exitInitializationMode, *words)
    fmu.slave.reset()
    assert fmu.start(COARSE).step()["patches"] > 0


def test_an_experiment_that_ends_before_it_begins_is_refused(contact, refused):
    fmu = contact()
    begin = fmu.slave.setupExperiment if fmu.fmi == 2 else fmu.slave.enterInitializationMode
    refused(fmu, lambda: begin(startTime=3.0, stopTime=2.0), "stop time", "3")


ROOF = {"elements.dx": 0.4, "elements.dy": 0.4, "model": 2}


@pytest.fixture
def roof(tmp_path):
    path = tmp_path / "roof.txt"
    path.write_text("-8 1\n0 0\n8 1\n")
    return {**ROOF, "rail.profile": str(path)}


def test_a_wheel_whose_force_is_missed_is_discarded_or_told(wheel, refused, roof):
    at = {"load.Fz": 1e7, "position.y": 5.0}  # more than the roof carries
    fmu = wheel().start(roof)
    before = fmu.outputs()
    fmu.set(at)
    refused(fmu, fmu.step, "did not converge", "1e+07", "accept_unconverged", status=2)
    assert fmu.outputs() == before
    told = wheel(name="told").start({**roof, "accept_unconverged": True}).step(at)
    assert not told["converged"]
    assert told["Fz"] != pytest.approx(1e7, rel=1e-4)


def test_time_goes_forward(contact, wheel, refused):
    for fmu in (contact().start(QUICK), wheel().start(COARSE)):
        for _ in range(3):
            fmu.step()
        before = fmu.outputs()
        for past in (0.0, 1e-3, 2.9e-3, -1.0):
            refused(fmu, lambda fmu=fmu, past=past: fmu.slave.doStep(past, 1e-3), "past", "0.003", "FMU state")
        assert fmu.outputs() == before
        state = fmu.slave.getFMUState()
        fmu.step()
        fmu.go_back(state, 3e-3)
        fmu.step()
        fmu.time *= 1 + 1e-14  # rounding errors of masters that multiply
        fmu.step()
        fmu.go_back(state, 0.0)  # a state may be continued at any time
        fmu.step()
        refused(fmu, lambda fmu=fmu: fmu.slave.doStep(0.0, 1e-3), "past", "0.001")


def test_a_start_time_is_where_time_begins(contact, refused):
    fmu = contact()
    if fmu.fmi == 2:
        fmu.slave.setupExperiment(startTime=5.0)
        fmu.slave.enterInitializationMode()
    else:
        fmu.slave.enterInitializationMode(startTime=5.0)
    fmu.set({"friction.mu": 0.2})
    fmu.slave.exitInitializationMode()
    refused(fmu, lambda: fmu.slave.doStep(0.0, 1e-3), "past", "5")
    fmu.slave.doStep(5.0, 1e-3)


def test_a_gap_between_steps_is_told(contact):
    fmu = contact(logging=True).start(QUICK)
    fmu.step()
    fmu.time = 7.0
    fmu.step()
    assert any(status == 1 and "gap" in sentence and "0.001" in sentence for status, _, sentence in fmu.log)


def test_an_instance_that_is_freed_twice_or_used_afterwards_ends_nothing(contact, wheel):
    for fmu in (contact(), wheel()):
        fmu.start(QUICK if "motion.kind" in fmu.variables else COARSE).step()
        free = getattr(fmu.slave, f"fmi{fmu.fmi}FreeInstance")
        handle = fmu.slave.component
        for _ in range(3):
            free(handle)
        with pytest.raises(Exception, match="rror"):
            fmu.slave.terminate()
        with pytest.raises(Exception, match="rror"):
            fmu.slave.doStep(0.001, 0.001)


def test_a_state_that_is_freed_twice_or_used_afterwards_is_refused(contact, refused):
    from ctypes import c_void_p

    fmu = contact().start(QUICK)
    before = fmu.step()
    state = fmu.slave.getFMUState()
    stale = c_void_p(state.value)
    fmu.slave.freeFMUState(state)
    refused(fmu, lambda: fmu.slave.setFMUState(stale), "freed")
    refused(fmu, lambda: fmu.slave.serializeFMUState(stale), "freed")
    refused(fmu, lambda: fmu.slave.freeFMUState(stale), "freed")
    assert fmu.outputs() == before


def test_enumerations_are_numbers_too(wheel, contact, refused):
    """It serves importers that do not support enumerations."""
    for fmu in (wheel(), contact()):
        words = {name for name, variable in fmu.variables.items() if variable.type == "Enumeration"}
        numbers = {name for name in fmu.variables if name.endswith("_number")}
        assert numbers == {f"{name}_number" for name in words}
        for name in numbers:
            assert fmu.variables[name].type in ("Integer", "Int32")
            assert fmu.get(name) == -1
        refused(fmu, lambda fmu=fmu: fmu.set({"model_number": 5}), "model_number", "4 (polach)")
        refused(fmu, lambda fmu=fmu: fmu.set({"model_number": -2}), "model_number", "0 (full)")


@pytest.mark.parametrize("order", [1, -1], ids=["the enumeration first", "the number first"])
def test_a_number_is_taken_in_the_place_of_its_enumeration_whatever_is_set_last(wheel, order):
    """Importers set all parameters, including unchanged ones, in any order."""
    same = wheel(name="same").start({**COARSE, "side": 0}).step({"position.y": -2.0})
    right = wheel(name="right").start(COARSE).step({"position.y": 2.0})
    for at, told in enumerate(({"side": 1, "side_number": 0}, {"side": 0, "side_number": -1}, {"side_number": 0})):
        fmu = wheel(name=f"left {at}").start({**COARSE, **dict([*told.items()][::order])})
        assert (fmu.get("side"), fmu.get("side_number")) == (0, 0)
        assert fmu.step({"position.y": -2.0}) == same
    assert same["Fy"] < 0 < right["Fy"]
    fmu = wheel(name="quick").start({"elements.dx": 0.5, "elements.dy": 0.5, "model_number": 2})
    assert fmu.step({"position.y": 2.0}) == right
