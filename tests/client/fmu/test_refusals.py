"""Tests that mistakes cause an error and a message that names the variable, the value and valid values. Nothing
crashes."""

from __future__ import annotations

import math

import pytest

COARSE = {"elements.dx": 0.5, "elements.dy": 0.5, "model": 2}


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_not_finite(contact, wheel, refused, value):
    one, two = contact().start(), wheel().start()
    refused(one, lambda: one.set({"motion.xi": value}), "motion.xi", "finite")
    refused(two, lambda: two.set({"position.y": value}), "position.y", "finite")
    assert one.step()["Fn"] == pytest.approx(50e3)


def test_a_step_that_is_none(contact, refused):
    fmu = contact().start({"model": 2})
    for time, size in ((0, 0), (0, -1e-3), (0, math.nan), (math.inf, 1e-3)):
        refused(fmu, lambda time=time, size=size: fmu.slave.doStep(time, size), "step")
    assert fmu.step()["Fn"] == pytest.approx(50e3)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"grid.nx": 0}, ["nx"]),
        ({"grid.dx": -1.0}, ["dx"]),
        ({"upper.nu": 0.7}, ["nu"]),
        ({"lower.G": -82000.0}, ["G"]),
        ({"gap.kind": 1, "gap.a": -3.0}, ["semi_axes"]),
        ({"gap.Rx": 0.0}, ["Rx"]),
        ({"upper.rigid": True, "lower.rigid": True}, ["rigid"]),
        ({"load.Fn": -5.0}, ["Fn"]),
        ({"friction.mu": -0.1}, ["mu"]),
        ({"motion.velocity": -1.0}, ["velocity"]),
        ({"tolerances.normal": 0.0}, ["tolerance"]),
        ({"limits.step": 0.0}, ["seconds"]),
        ({"endpoint": "nowhere"}, ["nowhere", "tcp://"]),
        ({"own_key": "/none"}, ["server_key"]),
        ({"upper.coefficients": 1, "elements.accuracy": 7.0}, ["accuracy"]),
    ],
    ids=lambda value: ", ".join(map(str, value)) if isinstance(value, dict) else "",
)
def test_parameters_of_a_contact(contact, refused, values, words):
    fmu = contact()
    fmu.enter(values)
    refused(fmu, fmu.slave.exitInitializationMode, *words)
    fmu.slave.reset()
    assert fmu.start({"model": 2}).step()["Fn"] == pytest.approx(50e3)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"rail.profile": "nothing.txt"}, ["rail.profile", "nothing.txt", "60E1"]),
        ({"wheel.profile": "/nothing.prw"}, ["wheel.profile", "/nothing.prw"]),
        ({"wheel.profile": "60E1"}, ["wheel.profile", "S1002"]),
        ({"rail.profile": ""}, ["rail.profile"]),
        ({"rail.profile": "../../modelDescription.xml"}, []),
        ({"elements.dx": 0.0}, ["dx"]),
        ({"wheelset.nominal_radius": -1.0}, ["nominal_radius"]),
        ({"rail.nu": 0.9}, ["nu"]),
        ({"track.roller_radius": -5.0}, ["roller"]),
    ],
    ids=lambda value: ", ".join(map(str, value)) if isinstance(value, dict) else "",
)
def test_parameters_of_a_wheel(wheel, refused, values, words):
    fmu = wheel()
    fmu.enter(values)
    refused(fmu, fmu.slave.exitInitializationMode, *words)
    fmu.slave.reset()
    fmu.time = 0
    assert fmu.start(COARSE).step()["patches"] > 0


def test_inputs_that_make_no_sense_leave_the_instance_where_it_was(contact, refused):
    fmu = contact().start({"grid.nx": 15, "grid.ny": 15})
    before = fmu.step({"motion.xi": 1e-3})
    for name, value in {"friction.mu": -1.0, "load.Fn": -1.0, "gap.Ry": 0.0}.items():
        good = fmu.get(name)
        fmu.set({name: value})
        refused(fmu, lambda: fmu.slave.doStep(1e-3, 1e-3), name.split(".")[1])
        assert fmu.outputs() == before
        fmu.set({name: good})
    assert fmu.step({"motion.xi": 1e-3})["Fn"] == pytest.approx(50e3)


def test_a_step_that_does_not_converge_is_discarded_or_told(contact, refused):
    strict = {"tolerances.iterations": 1, "grid.nx": 15, "grid.ny": 15}
    fmu = contact().start(strict)
    refused(fmu, lambda: fmu.step({"motion.xi": 1e-3}), "converge", status=2)
    told = contact(name="told").start({**strict, "accept_unconverged": True})
    assert told.step({"motion.xi": 1e-3})["converged"] == 0


def test_words_that_there_are_not(contact, refused):
    fmu = contact()
    refused(fmu, lambda: fmu.set({"motion.kind": 3}), "motion.kind", "0 (steady)", "2 (shift)")
    refused(fmu, lambda: fmu.set({"model": -1}), "model", "fastsim")


def test_what_is_set_when_it_cannot_be(contact, refused):
    fmu = contact().start({"model": 2})
    refused(fmu, lambda: fmu.set({"grid.nx": 9}), "grid.nx", "fixed")
    refused(fmu, lambda: fmu.set({"Fx": 9.0}), "Fx", "computes")
    refused(fmu, fmu.slave.enterInitializationMode, "initialized")
    fmu.set({"gap.Rx": 300.0})
    assert fmu.step()["pmax"] > 0


def test_steps_before_the_start(contact, refused):
    fmu = contact()
    refused(fmu, lambda: fmu.slave.doStep(0, 1), "initialized")
    refused(fmu, fmu.slave.exitInitializationMode, "initialization")
    refused(fmu, lambda: fmu.derivatives(["Fx"], "motion.xi"), "initialized")
    assert fmu.start({"model": 2}).step()["Fn"] == pytest.approx(50e3)


def test_references_and_types_that_there_are_not(contact, refused):
    fmu = contact()
    get = fmu.slave.getReal if fmu.fmi == 2 else fmu.slave.getFloat64
    refused(fmu, lambda: get([100_000]), "100000")
    refused(fmu, lambda: get([fmu.reference("grid.nx")]), "grid.nx", "type")


def test_derivatives_that_there_are_not(contact, refused):
    fmu = contact().start({"model": 2})
    refused(fmu, lambda: fmu.derivatives(["Fx"], "motion.xi"), "step", status=2)
    fmu.step({"motion.xi": 1e-3})
    refused(fmu, lambda: fmu.derivatives(["pmax"], "motion.xi"), "pmax", "approach", status=2)
    refused(fmu, lambda: fmu.derivatives(["Fx"], "motion.velocity"), "motion.velocity", status=2)
    several = contact(name="several").start({"motion.kind": 1, "motion.velocity": 5600.0})
    before = several.step({"motion.xi": 1e-3})
    refused(several, lambda: several.derivatives(["Fx"], "motion.xi"), "derivatives")
    assert several.outputs() == before
    assert several.step({"motion.xi": 1e-3})["Fn"] == pytest.approx(50e3)


def test_another_shared_object(instances):
    """Returns the model description of one kind, with the contents of another."""
    fmu = instances("contactd_contact", 2)
    assert "{contactd_contact-" in fmu.description.guid
    fmu.slave.guid = "{another}"
    first, fmu.slave.component = fmu.slave.component, None
    with pytest.raises(Exception, match="instantiate"):
        fmu.slave.instantiate(callbacks=fmu.slave.callbacks)
    fmu.slave.component = first
    ((status, _, sentence),) = fmu.log
    assert status == 3 and "GUID" in sentence


def test_texts_with_a_percent_reach_the_log_as_they_are(contact, refused):
    fmu = contact()
    fmu.enter({"endpoint": "100%s and %n"})
    refused(fmu, fmu.slave.exitInitializationMode, '"100%s and %n"')
