"""Tests interfacial layers and friction with memory on the wire: the state of steps, answers, refusals."""

import numpy as np
import pytest

from contactd import (
    ContactProblem,
    ContactWarning,
    Friction,
    FrictionMemory,
    Grid,
    InterfacialLayer,
    InvalidArgument,
    KineticFriction,
    Paraboloid,
    Rolling,
    SecondTerm,
    TangentialSettings,
)
from support.problems import STEEL

LAYER = InterfacialLayer(1e-5, 150, 20000)
SPHERE = ContactProblem(
    grid=Grid.centred(15, 15, 2.25, 2.25),
    upper=STEEL,
    gap=Paraboloid(50, 50),
    Fn=1500,
    friction=Friction(0.5, rigid_shift=(0.004, 0.001), layer=LAYER),
)
MEMORY = KineticFriction(0.15, 90, second=SecondTerm(0.08, 36), memory=FrictionMemory(0.003, 1))
WHEEL = ContactProblem(
    grid=Grid.centred(17, 15, 11.05, 9.0),
    upper=STEEL,
    gap=Paraboloid(460, 300),
    Fn=30000,
    friction=Friction(0.35, kinetic=MEMORY, rolling=Rolling(xi=4e-3, eta=1e-3, dq=0.65, velocity=8000)),
)
SHIFTS = [(0.004, 0.001), (-0.006, 0.0), (0.001, -0.003)]
FORCES = [(-296.643888, -74.1632714), (197.589645, -73.15625), (112.993968, 174.792149)]


def test_a_solution_as_previous_brings_the_state_of_the_layer(shared):
    last = None
    for shift, (fx, fy) in zip(SHIFTS, FORCES):
        last = shared.solve(SPHERE.replace(friction=Friction(0.5, rigid_shift=shift, layer=LAYER), previous=last))
        assert (last.Fx, last.Fy) == (pytest.approx(fx, rel=1e-5), pytest.approx(fy, rel=1e-5))
    assert last.yield_stress.max() == pytest.approx(160.901382, rel=1e-6)


def test_flow_is_a_part_of_the_contact_and_of_what_friction_dissipates(shared):
    found = shared.solve(SPHERE)
    assert found.elements.contact == found.elements.adhesion + found.elements.slip + found.elements.flow
    assert found.elements.flow == np.count_nonzero(found.element_division == 3) > 0
    assert 0 < found.plastic_work <= found.frictional_work
    assert found.largest_flow == pytest.approx(np.hypot(found.flow_x, found.flow_y).max(), rel=1e-12)


def test_a_session_carries_the_state_of_the_layer(shared):
    with shared.session(SPHERE) as session:
        for step, (shift, (fx, fy)) in enumerate(zip(SHIFTS, FORCES), 1):
            found = session.step(rigid_shift=shift)
            assert (found.Fx, found.Fy) == (pytest.approx(fx, rel=1e-5), pytest.approx(fy, rel=1e-5)), step
        again = session.step(rigid_shift=SHIFTS[-1], again=True)
    assert again.Fx == pytest.approx(FORCES[-1][0], rel=1e-5)


def test_friction_with_memory_has_its_coefficients(shared):
    found = shared.solve(WHEEL)
    there = found.pressure > 0
    assert found.friction_coefficient[~there].min() == 0.35
    assert 0.15 < found.friction_coefficient[there].min() < found.friction_coefficient[there].max() <= 0.35
    sticky = shared.solve(WHEEL.replace(friction=Friction(0.35, rolling=WHEEL.friction.rolling)))
    assert abs(found.Fx) < abs(sticky.Fx)
    assert sticky.friction_coefficient is None and sticky.flow_x is None


def test_steps_that_outrun_what_particles_remember_warn(shared):
    brief = KineticFriction(0.15, 90, memory=FrictionMemory(1e-5, 1))
    with pytest.warns(ContactWarning, match="does not resolve the memory"):
        shared.solve(WHEEL.replace(friction=Friction(0.35, kinetic=brief, rolling=WHEEL.friction.rolling)))


@pytest.mark.parametrize(
    ("layer", "field"),
    [
        (InterfacialLayer(hardening=5), "friction.layer.hardening"),
        (InterfacialLayer(1e-4, 100, -2e4), "friction.layer.hardening"),
    ],
)
def test_a_layer_that_makes_no_sense_is_refused_by_name(shared, layer, field):
    with pytest.raises(InvalidArgument) as refused:
        shared.solve(SPHERE.replace(friction=Friction(0.5, rigid_shift=(1e-3, 0), layer=layer)))
    assert [violation.field for violation in refused.value.violations] == [field]


def test_what_does_not_go_with_a_layer_is_refused_by_name(shared):
    with pytest.raises(InvalidArgument, match="settings.tangential.solver"):
        shared.solve(SPHERE.replace(tangential=TangentialSettings(solver="tangcg")))
    with pytest.raises(InvalidArgument, match="derivatives"):
        shared.solve(SPHERE.replace(derivatives=True))
    with pytest.raises(InvalidArgument, match="friction.layer"):
        shared.solve(SPHERE.replace(model="hertz", friction=Friction(0.5, rigid_shift=(1e-3, 0), layer=LAYER)))
