"""Tests the plain contact as an FMU."""

from __future__ import annotations

import pytest

from support import c_interface

NAMES = ("Fn", "Fx", "Fy", "Mz", "approach", "pmax", "area.contact", "area.adhesion", "area.slip", "power", "converged")


def c_answers(direct):
    single = [direct.get(name) for name in ("frictional_power", "converged")]
    return [*direct.array("forces"), direct.get("approach"), direct.get("pmax"), *direct.array("area")[:3], *single]


def set_up(direct, model="full"):
    """Describes an FMU without parameters."""
    direct.set({"grid.nx": 25, "grid.ny": 25, "grid.dx": 0.56, "grid.dy": 0.56})
    direct.set({"bodies.upper.G": 82000, "bodies.upper.nu": 0.28, "bodies.lower.G": 82000, "bodies.lower.nu": 0.28})
    direct.set_word("model", model)
    direct.set({"gap.paraboloid.Rx": 460, "gap.paraboloid.Ry": 300, "friction.mu": 0.3})


@pytest.mark.parametrize(("model", "keyword"), [(0, "full"), (2, "fastsim")], ids=["full", "fastsim"])
def test_rolling_steps_are_those_of_the_c_interface_to_the_last_bit(contact, model, keyword):
    fmu = contact().start({"model": model})
    with c_interface.contact() as direct:
        set_up(direct, keyword)
        direct.set({"Fn": 50e3, "friction.rolling.velocity": 20e3})
        direct.start()
        for k in range(6):
            Fn, xi, eta, phi = 50e3 + 2e3 * k, 4e-4 * k, -2e-4 * k, 1e-5 * k
            direct.set({"Fn": Fn, "friction.rolling.xi": xi, "friction.rolling.eta": eta, "friction.rolling.phi": phi})
            direct.step()
            outputs = fmu.step({"load.Fn": Fn, "motion.xi": xi, "motion.eta": eta, "motion.phi": phi})
            assert [outputs[name] for name in NAMES] == c_answers(direct)
            assert (outputs["xi"], outputs["patches"]) == (xi, 1)
    assert abs(outputs["Fx"]) > 1e3


def test_transient_rolling_goes_as_far_as_the_step_does(contact):
    """Makes steps of 0.5, 1.25 and 3 elements: the last ones take two and three steps of rolling."""
    fmu = contact().start({"motion.kind": 1, "motion.velocity": 560.0})
    with c_interface.contact() as direct:
        set_up(direct)
        direct.set_word("friction.rolling.kind", "transient")
        direct.set({"Fn": 50e3, "friction.rolling.xi": 0.001, "friction.rolling.velocity": 560})
        direct.start()
        for elements, steps in ((0.5, 1), (1.25, 2), (3.0, 3), (0.5, 1)):
            size = elements * 1e-3
            direct.set({"friction.rolling.steps": steps, "friction.rolling.dq": 560.0 * size / steps})
            direct.step()
            outputs = fmu.step({"motion.xi": 0.001}, size)
            assert [outputs[name] for name in NAMES] == c_answers(direct)
    if fmu.fmi == 3:
        assert fmu.get("time") == fmu.time


def test_a_shift_is_a_velocity_times_the_step(contact):
    fmu = contact().start({"motion.kind": 2, "load.kind": 1})
    with c_interface.contact() as direct:
        set_up(direct)
        direct.set({"approach": 0.04, "friction.rigid_shift.x": 0})
        direct.start()
        for size, velocity in ((0.01, 0.2), (0.002, -0.5), (0.03, 0.1)):
            direct.set({"friction.rigid_shift.x": velocity * size, "friction.duration": size})
            direct.step()
            outputs = fmu.step({"load.approach": 0.04, "motion.shift_x": velocity}, size)
            assert [outputs["Fn"], outputs["Fx"]] == direct.array("forces")[:2]
            assert outputs["work"] == direct.get("frictional_work")
            assert outputs["approach"] == 0.04


def test_bodies_apart_have_no_forces(contact):
    outputs = contact().start({"load.kind": 1}).step({"load.approach": -0.01})
    assert outputs["patches"] == 0
    assert outputs["Fn"] == outputs["Fx"] == outputs["area.contact"] == outputs["power"] == 0


def test_a_creepage_is_found_for_a_force(contact):
    fmu = contact().start({"force.prescribe_x": True})
    outputs = fmu.step({"force.x": -5e3})
    assert outputs["Fx"] == pytest.approx(-5e3, rel=1e-4)
    assert outputs["xi"] > 1e-5


def test_a_layer_a_rigid_body_and_falling_friction_are_taken(contact):
    """Does the same as the C interface."""
    fmu = contact().start({
        "upper.rigid": True, "lower.coefficients": 3, "lower.layer.thickness": 0.8, "lower.layer.G": 40000.0,
        "friction.kinetic.law": 2, "grid.nx": 15, "grid.ny": 15,
    })  # fmt: skip
    outputs = fmu.step({"motion.xi": 0.002, "load.Fn": 20e3})
    with c_interface.contact() as direct:
        direct.set({"grid.nx": 15, "grid.ny": 15, "grid.dx": 0.56, "grid.dy": 0.56, "bodies.upper.rigid": 1})
        layered = "bodies.lower.ics"
        direct.set_word(f"{layered}.body", "layered")
        direct.set({f"{layered}.layers[0].{name}": value for name, value in {"thickness": 0.8, "G": 40000, "nu": 0.28}.items()})
        direct.set({f"{layered}.base.G": 82000, f"{layered}.base.nu": 0.28})
        direct.set({"gap.paraboloid.Rx": 460, "gap.paraboloid.Ry": 300, "Fn": 20e3, "friction.mu": 0.3})
        direct.set_word("friction.kinetic.law", "exponential")
        direct.set({"friction.kinetic.mu": 0.2, "friction.kinetic.slip_velocity": 1000})
        direct.set({"friction.rolling.xi": 0.002, "friction.rolling.velocity": 20e3})
        direct.start()
        direct.step()
        assert [outputs[name] for name in NAMES] == c_answers(direct)


def test_temperatures_and_friction_that_follows_them_are_those_of_the_c_interface(contact):
    fmu = contact().start({
        "temperature.computed": True, "temperature.lower.conductivity": 20.0, "temperature.upper.bulk_temperature": 150.0,
        "friction.temperature.change": -0.1, "friction.temperature.reference": 20.0, "friction.temperature.range": 300.0,
    })  # fmt: skip
    outputs = fmu.step({"motion.xi": 0.01})
    with c_interface.contact() as direct:
        set_up(direct)
        direct.set({"Fn": 50e3, "friction.rolling.xi": 0.01, "friction.rolling.velocity": 20e3})
        direct.set({"friction.temperature.change": -0.1, "friction.temperature.reference": 20, "friction.temperature.range": 300})
        direct.set({"temperature.upper.bulk_temperature": 150, "temperature.lower.conductivity": 20})
        direct.start()
        direct.step()
        assert [outputs[name] for name in NAMES] == c_answers(direct)
        for name in ("largest", "rise", "heat_upper", "heat_lower"):
            assert outputs[f"temperature.{name}"] == direct.get(f"temperature.{name}")
    assert outputs["temperature.largest"] > 100
    assert abs(outputs["Fx"]) < 0.29 * 50e3
    assert contact(name="cold").start({}).step({"motion.xi": 0.01})["temperature.largest"] == 0


def test_bodies_that_creep_are_taken(contact):
    """Does the same as the C interface."""
    bodies = {f"{body}.{name}": value for body in ("upper", "lower") for name, value in
              {"coefficients": 4, "G": 1143.0, "nu": 0.4, "viscoelastic.f": 1.0, "viscoelastic.tau": 2e-4}.items()}  # fmt: skip
    fmu = contact().start({**bodies, "grid.nx": 15, "grid.ny": 15, "grid.dx": 0.8, "grid.dy": 0.8})
    outputs = fmu.step({"motion.xi": 0.002, "load.Fn": 200.0})
    with c_interface.contact() as direct:
        direct.set({"grid.nx": 15, "grid.ny": 15, "grid.dx": 0.8, "grid.dy": 0.8})
        creep = {"G": 1143, "nu": 0.4, "viscoelastic.f": 1, "viscoelastic.tau": 2e-4}
        direct.set({f"bodies.{body}.{name}": value for body in ("upper", "lower") for name, value in creep.items()})
        direct.set({"gap.paraboloid.Rx": 460, "gap.paraboloid.Ry": 300, "Fn": 200, "friction.mu": 0.3})
        direct.set({"friction.rolling.xi": 0.002, "friction.rolling.velocity": 20e3})
        direct.start()
        direct.step()
        assert [outputs[name] for name in NAMES] == c_answers(direct)
        assert outputs["resistance"] == direct.get("rolling_resistance.force") > 0


def test_ten_instances_at_once_do_not_meet(contact):
    several = [contact(name=f"contact {k}").start({"model": 2}) for k in range(10)]
    alone = [contact(name="alone").start({"model": 2}).step({"motion.xi": 1e-4 * k})["Fx"] for k in range(10)]
    for _ in range(3):
        assert [fmu.step({"motion.xi": 1e-4 * k})["Fx"] for k, fmu in enumerate(several)] == alone
    assert len(set(alone)) == 10
