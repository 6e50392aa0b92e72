"""Tests the multibody part of the example of a bogie with springs as wheels, against known results and a second
method."""

from __future__ import annotations

import math

import numpy as np
import pytest

from support.wheelset import bogie

__all__ = ["bogie"]

#: y, roll and yaw, and their rates, change their signs in a mirror image.
MIRROR = np.array([1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1])


def springy(bogie, stiffness=1e6, across=2e4):
    """Replaces contactd's wheels by springs down and across, 750 mm from the middle, with the same interface."""
    OnWheelset = bogie.wheels.OnWheelset

    def wheels(states):
        found = []
        for number, state in enumerate(states):
            side = 1 if number % 2 else -1
            place, rail = state.position, state.rail
            force = np.array([0, -across * (place.y - rail.y), -stiffness * (place.z + side * 750 * place.roll - rail.z)])
            found.append(OnWheelset(force, np.array([side * 750 * force[2], 0, -side * 750 * force[0]]), 0.0))
        return found

    return wheels


def equations(bogie, line=None, wheels=None, vehicle=None):
    vehicle = vehicle or bogie.vehicle.bogie()
    rolling = bogie.rolling.Rolling(vehicle, wheels or springy(bogie), line or bogie.line.Line(), bogie.track.Track())
    return bogie.equations.Equations(rolling)


def disturbed(law, speed=4e4):
    bodies = law.start(speed, z=0.06).reshape(-1, 12)
    random = np.random.default_rng(1)
    for places, scale in ((slice(0, 3), 0.3), (slice(3, 6), 3e-4), (slice(6, 9), 5.0), (slice(9, 12), 5e-3)):
        bodies[:, places] += scale * random.uniform(-1, 1, bodies[:, places].shape)
    return bodies.ravel()


def test_at_rest_springs_bear_what_lies_on_them(bogie):
    law = equations(bogie)
    vehicle = law.vehicle
    _, forces, moments = law.springs(law.start(4e4, z=0).reshape(-1, 12))
    weights = [body.mass * 9810 for body in vehicle.bodies]
    assert forces[2:, 2] == pytest.approx([-weight for weight in weights[2:]], rel=1e-12)
    assert forces[:2, 2] == pytest.approx(2 * [vehicle.axle_load - weights[0]], rel=1e-12)
    assert forces[:, :2] == pytest.approx(np.zeros((4, 2)), abs=1e-6)
    assert moments == pytest.approx(np.zeros((4, 3)), abs=1e-3)


def test_springs_take_no_momentum(bogie):
    law = equations(bogie)
    bodies = disturbed(law).reshape(-1, 12)
    _, forces, moments = law.springs(bodies)
    assert np.abs(forces).max() > 1e3
    assert forces.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-8)
    about_origin = (moments + np.cross(bodies[:, :3], forces)).sum(axis=0)
    assert about_origin == pytest.approx(np.zeros(3), abs=1e-4)


def test_motion_in_a_mirror_is_the_mirror_of_motion(bogie):
    law = equations(bogie, line=bogie.line.Line(curvature=1e-6, cant=100, begin=-5e3, transition=4e3, length=1e4))
    mirrored = equations(bogie, line=bogie.line.Line(curvature=-1e-6, cant=100, begin=-5e3, transition=4e3, length=1e4))
    state = disturbed(law)
    mirror = np.tile(MIRROR, 4)
    vehicle_in_mirror = law.rates(0, state).reshape(-1, 12)
    # The springs on the left are the mirror images of those on the right.
    assert mirrored.rates(0, mirror * state).reshape(-1, 12) == pytest.approx(MIRROR * vehicle_in_mirror, rel=1e-9, abs=1e-6)


def test_a_body_that_nothing_holds_keeps_its_energy_and_its_angular_momentum(bogie):
    # It falls and tumbles, so Euler's equations apply to a body with three different inertias.
    vehicle = bogie.vehicle
    alone = vehicle.Vehicle((vehicle.Body("stone", 1.0, (1e5, 2e5, 4e5), (0, 0, 0)),), (), 0, 460.0, 0.0)

    law = equations(bogie, wheels=lambda states: [], vehicle=alone)
    state = np.zeros(12)
    state[9:] = 1.0, 2.0, 0.5

    def momentum(state):
        pitched = bogie.equations.about_y(state[4:5])[0]
        spin, inertia = pitched.T @ state[9:], np.array(alone.bodies[0].inertia)
        return bogie.motion.axes(state[3], state[5]) @ pitched @ (inertia * spin), spin @ (inertia * spin)

    _, states = bogie.module("railway.runge_kutta").integrate(law.rates, state, 0.5, 1e-3)
    before, after = momentum(states[0]), momentum(states[-1])
    assert np.abs(states[-1, 3:6]).max() > 0.3
    assert after[0] == pytest.approx(before[0], rel=1e-8, abs=1e-8 * np.abs(before[0]).max())
    assert after[1] == pytest.approx(before[1], rel=1e-8)
    assert states[-1, 8] == pytest.approx(9810 * 0.5)


def test_a_line_is_as_curved_as_it_says(bogie):
    line = bogie.line.Line(curvature=-1 / 500e3, cant=150, begin=10e3, transition=30e3, length=200e3)
    for s in (-5e3, 0, 9e3, 15e3, 25e3, 39e3, 60e3, 199e3):
        (x0, y0, _), (x1, y1, _) = line.place(s - 50), line.place(s + 50)
        assert math.atan2(y1 - y0, x1 - x0) == pytest.approx(line.heading(s), abs=1e-7)
        assert math.hypot(x1 - x0, y1 - y0) == pytest.approx(100, rel=1e-7)
        assert (line.heading(s + 1) - line.heading(s - 1)) / 2 == pytest.approx(line.curvature * line.share(s), abs=1e-13)
        place = line.place(s) + line.axes(s) @ (0, 7.0, -460)
        assert line.way_to(place, s - 300) == pytest.approx(s, abs=1e-6 + 150 / 1500 * 1e-5 * 460)
    # The track is a circle of 500 m to the left, whose right rail is 150 mm higher.
    a, b, c = (line.place(s)[:2] for s in (100e3, 120e3, 140e3))
    sides = [np.linalg.norm(b - a), np.linalg.norm(c - b), np.linalg.norm(a - c)]
    area = abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]) / 2
    assert np.prod(sides) / (4 * area) == pytest.approx(500e3, rel=1e-9)
    assert (line.axes(100e3) @ (0, 750, 0))[2] == pytest.approx(-75, rel=2e-3)
    with pytest.raises(ValueError, match="extends from -10 m to 200 m"):
        line.place(250e3)


def test_a_wheelset_in_a_curve_sees_the_track_that_it_is_on(bogie):
    line = bogie.line.Line(curvature=1 / 300e3, cant=120, begin=0, transition=20e3, length=100e3)
    law = equations(bogie, line=line)
    s, speed = 60e3, 3e4
    axes = line.axes(s)
    body = np.zeros(12)
    body[:3] = line.place(s) + axes @ (0, 4.0, -459.5)
    body[3], body[5] = line.roll(s), line.heading(s)
    body[6:9] = axes @ (speed, 20.0, 0)
    body[9:] = 0, -speed / 460, speed / 300e3
    law.rolling._ways[0] = s - 1e3
    motion = law.rolling.motion(0, body)
    assert motion.distance == pytest.approx(s, abs=0.1)
    assert motion[1:5] == pytest.approx((4.0, 0.5, 0, 0), abs=1e-5)
    assert motion[5:8] == pytest.approx((speed, 20, 0), abs=0.05)
    assert motion[8:] == pytest.approx((0, -speed / 460, speed / 300e3), abs=1e-9)


@pytest.mark.slow  # takes 4200 steps, because the coach comes to rest slowly
@pytest.mark.timeout(300)
def test_in_a_curve_the_rails_bear_what_the_cant_leaves(bogie):
    line = bogie.line.Line(curvature=1 / 600e3, cant=100, begin=5e3, transition=30e3, length=2e5)
    law = equations(bogie, line=line)
    times, states = bogie.runs.by_numpy(law, law.start(30e3, z=0.06), 4.2, 1e-3)
    swing = states.reshape(len(times), -1, 12)[-1950::50]  # frequency of the coach, which comes to rest slowly
    found, speeds = [], []
    for bodies in swing:
        axes = line.axes(line.way_to(bodies[2, :3], float(np.linalg.norm(bodies[2, :2]))))
        found.append(axes.T @ law.rolling(bodies).forces.sum(axis=0))
        speeds.append(np.linalg.norm(bodies[3, 6:9]))
    mass, roll, outwards = sum(body.mass for body in law.vehicle.bodies), 100 / 1500, np.mean(np.square(speeds)) / 600e3
    _, across, down = np.mean(found, axis=0)
    assert across == pytest.approx(mass * (outwards * np.cos(roll) - 9810 * np.sin(roll)), rel=0.03)
    assert -down == pytest.approx(mass * (outwards * np.sin(roll) + 9810 * np.cos(roll)), rel=0.01)


def test_energy_is_kept_to_the_fourth_order_of_the_step(bogie):
    law = equations(bogie, line=bogie.line.Line(curvature=1 / 400e3, cant=0, begin=-9e3, transition=8e3, length=1e5))
    errors = []
    for step in (5e-4, 2.5e-4):
        times, states = bogie.module("railway.runge_kutta").integrate(law.rates, disturbed(law), 0.03, step)
        found = bogie.energy.balance(law, times, states.reshape(len(times), -1, 12))
        assert found.damped[-1] > 1e3
        errors.append(np.abs(found.error).max())
    assert errors[0] < 1e-3 * found.damped[-1]
    assert errors[1] < errors[0] / 10


def test_exudyn_moves_the_bogie_as_its_equations_do(bogie):
    pytest.importorskip("exudyn", reason="Exudyn is not installed; Debian has no package of it")
    line = bogie.line.Line(curvature=1 / 400e3, cant=100, begin=0, transition=5e3, length=1e5)
    ours, theirs = (
        integrate(law, disturbed(law), 0.05, 1e-3)
        for law, integrate in (
            (equations(bogie, line=line), bogie.runs.by_numpy), (equations(bogie, line=line), bogie.module("multibody").integrate)
        )
    )  # fmt: skip
    assert theirs[0] == pytest.approx(ours[0])
    largest = np.abs(ours[1]).max(axis=0)
    assert np.abs(theirs[1] - ours[1]).max(axis=0) / largest == pytest.approx(np.zeros(48), abs=1e-4)
