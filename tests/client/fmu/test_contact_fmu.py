"""The plain contact as an FMU."""

from __future__ import annotations

import pytest

from support import c_interface

NAMES = ("Fn", "Fx", "Fy", "Mz", "approach", "pmax", "area.contact", "area.adhesion", "area.slip", "power", "converged")


def c_answers(call):
    forces = call("get_forces", out="dddd")
    rest = [call(f"get_{name}", out="d")[0] for name in ("approach", "pmax")]
    return [
        *forces, *rest, *call("get_areas", out="ddd"), *call("get_frictional_power", out="d"), *call("get_converged", out="i")
    ]  # fmt: skip


def set_up(call, model=0):
    """As an FMU is without parameters."""
    call("set_grid_centred", 25, 25, 0.56, 0.56)
    call("set_material", c_interface.BOTH, 82000.0, 0.28)
    call("set_model", model)
    call("set_paraboloid", 460.0, 300.0)
    call("set_mu", 0.3)
    call("set_velocity", 20e3)


@pytest.mark.parametrize("model", [0, 2], ids=["full", "fastsim"])
def test_rolling_steps_are_those_of_the_c_interface_to_the_last_bit(contact, model):
    fmu = contact().start({"model": model})
    with c_interface.contact() as call:
        set_up(call, model)
        call("set_Fn", 50e3)
        call("set_rolling", 0, 0.0, 0.0, 0.0)
        call("start")
        for k in range(6):
            Fn, xi, eta, phi = 50e3 + 2e3 * k, 4e-4 * k, -2e-4 * k, 1e-5 * k
            call("set_Fn", Fn)
            call("set_rolling", 0, xi, eta, phi)
            call("step")
            outputs = fmu.step({"load.Fn": Fn, "motion.xi": xi, "motion.eta": eta, "motion.phi": phi})
            assert [outputs[name] for name in NAMES] == c_answers(call)
            assert (outputs["xi"], outputs["patches"]) == (xi, 1)
    assert abs(outputs["Fx"]) > 1e3


def test_transient_rolling_goes_as_far_as_the_step_does(contact):
    """Steps of 0.5, 1.25 and 3 elements: the last ones take two and three steps of rolling."""
    fmu = contact().start({"motion.kind": 1, "motion.velocity": 560.0})
    with c_interface.contact() as call:
        set_up(call)
        call("set_Fn", 50e3)
        call("set_rolling", 1, 0.001, 0.0, 0.0)
        call("set_velocity", 560.0)
        call("start")
        for elements, steps in ((0.5, 1), (1.25, 2), (3.0, 3), (0.5, 1)):
            size = elements * 1e-3
            call("set_rolling_steps", steps)
            call("set_direction", 0.0, 560.0 * size / steps)
            call("step")
            outputs = fmu.step({"motion.xi": 0.001}, size)
            assert [outputs[name] for name in NAMES] == c_answers(call)
    if fmu.fmi == 3:
        assert fmu.get("time") == fmu.time


def test_a_shift_is_a_velocity_times_the_step(contact):
    fmu = contact().start({"motion.kind": 2, "load.kind": 1})
    with c_interface.contact() as call:
        set_up(call)
        call("set_approach", 0.04)
        call("set_shift", 0.0, 0.0, 0.0)
        call("start")
        for size, velocity in ((0.01, 0.2), (0.002, -0.5), (0.03, 0.1)):
            call("set_shift", velocity * size, 0.0, 0.0)
            call("set_duration", size)
            call("step")
            outputs = fmu.step({"load.approach": 0.04, "motion.shift_x": velocity}, size)
            assert [outputs["Fn"], outputs["Fx"]] == call("get_forces", out="dddd")[:2]
            assert outputs["work"] == call("get_frictional_work", out="d")[0]
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
    """The same as the C interface does with them."""
    fmu = contact().start({
        "upper.rigid": True, "lower.coefficients": 3, "lower.layer.thickness": 0.8, "lower.layer.G": 40000.0,
        "friction.kinetic.law": 2, "grid.nx": 15, "grid.ny": 15,
    })  # fmt: skip
    outputs = fmu.step({"motion.xi": 0.002, "load.Fn": 20e3})
    with c_interface.contact() as call:
        from ctypes import byref, c_double

        set_up(call)
        call("set_grid_centred", 15, 15, 0.56, 0.56)
        call("set_rigid", 0)
        layer = [byref(c_double(value)) for value in (0.8, 40000, 0.28)]
        call("set_layers", 1, 0, *layer, 1, 82000.0, 0.28)
        call("set_kinetic", 1, 0.2, 1000.0)
        call("set_Fn", 20e3)
        call("set_rolling", 0, 0.002, 0.0, 0.0)
        call("start")
        call("step")
        assert [outputs[name] for name in NAMES] == c_answers(call)


def test_ten_instances_at_once_do_not_meet(contact):
    several = [contact(name=f"contact {k}").start({"model": 2}) for k in range(10)]
    alone = [contact(name="alone").start({"model": 2}).step({"motion.xi": 1e-4 * k})["Fx"] for k in range(10)]
    for _ in range(3):
        assert [fmu.step({"motion.xi": 1e-4 * k})["Fx"] for k, fmu in enumerate(several)] == alone
    assert len(set(alone)) == 10
