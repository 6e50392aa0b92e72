"""Tests the multibody part of the example of a wheelset with linear contacts, against known results and a second
method."""

from __future__ import annotations

import math

import numpy as np
import pytest

from support.wheelset import wheelset

__all__ = ["wheelset"]

#: Coefficients of an ellipse of 6 mm by 5 mm of steel, by Kalker's table.
CREEP = -82000 * 30 * np.array([[4.2, 0, 0], [0, 3.7, 1.5 * 30**0.5], [0, -1.5 * 30**0.5, 1.2 * 30]])
#: y, roll and yaw, their rates, and the moments about x and z change their signs in a mirror image.
MIRROR = np.array([1, -1, 1, -1, -1, 1, -1, 1, -1, 1, -1])


def wheels(wheelset, conicity=0.15, angle=0.05, creep=CREEP):
    return wheelset.contact.LinearContact(
        load=54500, normal_stiffness=1.4e6, half_distance=750, radius=460, conicity=conicity, angle=angle, creep=creep
    )


def at_speed(wheelset, speed, vehicle=None, **contact):
    """Of m/s."""
    contacts = wheels(wheelset, **contact)
    return wheelset.runge_kutta.Wheelset(vehicle or wheelset.vehicle.Vehicle(), contacts, 1000 * speed, rest=0)


def disturbed(body):
    state = body.start(y=2, yaw=1e-3)
    state[[0, 3, 5, 6, 8, 9, 10]] = 0.1, 1e-4, 5, 20, 0.01, 0.02, -0.01
    return state


def test_springs_push_back(wheelset):
    vehicle = wheelset.vehicle.Vehicle(stiffness=(1500, 500, 1200), damping=(0, 0, 0))
    motion = wheelset.motion.Motion(0, 2, 0.5, 0, 1e-5, 2e4, 0, 0, 0, 0, 0)
    force, moment = wheelset.vehicle.suspension(vehicle, 0.3, 0.5, motion, 2e4)
    assert force == pytest.approx((-2 * 1500 * 0.3, -2 * 500 * 2, 109e3 - 1.813 * 9810))
    assert moment[2] == pytest.approx(-2 * 1500 * 1000**2 * 1e-5, rel=1e-6)


def test_a_wheelset_without_springs_runs_along_klingels_wave(wheelset):
    # Klingel 1883: the wave number is sqrt(conicity/(r b)) if inertia is negligible. A wheelset that moves across also
    # rolls by conicity/b, which moves the contact points by an additional fraction r/b.
    vehicle = wheelset.vehicle.Vehicle(stiffness=(0, 0, 0), damping=(0, 0, 0))
    body = at_speed(wheelset, 0.5, vehicle, conicity=0.05, angle=0, creep=np.diag(np.diag(CREEP) * (1, 1, 0)))
    swing = wheelset.module("stability").hunting(body)
    assert swing.imag / 500 == pytest.approx(math.sqrt(0.05 / (460 * 750) / (1 + 0.05 * 460 / 750)), rel=5e-4)


def test_motion_in_a_mirror_is_the_mirror_of_motion(wheelset):
    body = at_speed(wheelset, 40)
    state = disturbed(body)
    assert body.rates(0, MIRROR * state) == pytest.approx(MIRROR * body.rates(0, state), rel=1e-9, abs=1e-6)


def test_a_body_that_nothing_holds_keeps_its_energy_and_its_angular_momentum(wheelset):
    # It falls, spins and tumbles, so only Euler's equations apply.
    vehicle = wheelset.vehicle.Vehicle(stiffness=(0, 0, 0), damping=(0, 0, 0), axle_load=1.813 * 9810)
    body = wheelset.runge_kutta.Wheelset(vehicle, lambda motion: (np.zeros(3), np.zeros(3)), 4e4, 0)
    state = body.start()
    state[[8, 10]] = 0.8, -0.5
    _, states = wheelset.runge_kutta.integrate(body, state, 0.5, 1e-3)
    inertia = np.array([1120e3, 112e3, 1120e3])

    def momentum(state):
        motion = body.motion(0, state)
        rates = np.array([motion.roll_rate, motion.pitch_rate, motion.yaw_rate])
        return wheelset.motion.axes(motion.roll, motion.yaw) @ (inertia * rates), rates @ (inertia * rates)

    before, after = momentum(states[0]), momentum(states[-1])
    assert abs(states[-1, 3]) > 0.01
    assert after[0] == pytest.approx(before[0], rel=1e-7, abs=1e-7 * np.abs(before[0]).max())
    assert after[1] == pytest.approx(before[1], rel=1e-7)
    assert states[-1, 7] == pytest.approx(9810 * 0.5)


def test_hunting_grows_above_the_speed_that_eigenvalues_tell(wheelset):
    stability, hunting = wheelset.railway, wheelset.module("stability").hunting
    critical = stability.critical_speed(lambda v: hunting(at_speed(wheelset, v)).real, 40, 100, 0.01)
    assert 50 < critical < 90
    for part in (0.85, 1.15):
        body = at_speed(wheelset, part * critical)
        times, states = wheelset.runge_kutta.integrate(body, body.start(y=0.1), 1.5, 2e-3)
        growth = stability.growth_of_swing(times, states[:, 1])
        assert growth == pytest.approx(hunting(body).real, rel=0.15)
        assert (growth > 0) == (part > 1)


def test_speeds_on_one_side_are_refused(wheelset):
    with pytest.raises(ValueError, match="between 40 and 50 m/s; give speeds further apart"):
        wheelset.railway.critical_speed(lambda speed: -1.0, 40, 50, 1)


def test_a_track_is_smooth_and_the_same_for_the_same_seed(wheelset):
    track = wheelset.track.IrregularTrack(seed=3)
    assert track.deviation("left", 0) == (0, 0, 0, 0)
    for distance in (5e3, 19.9e3, 20.1e3, 300e3):
        for side in ("left", "right"):
            (y0, z0, *_), (y1, z1, *_) = (track.deviation(side, distance + step) for step in (-10, 10))
            _, _, *slopes = track.deviation(side, distance)
            assert slopes == pytest.approx([(y1 - y0) / 20, (z1 - z0) / 20], abs=1e-6)
    assert wheelset.track.IrregularTrack(seed=3).deviation("left", 9e4) == track.deviation("left", 9e4)
    assert wheelset.track.IrregularTrack(seed=4).deviation("left", 9e4) != track.deviation("left", 9e4)


def test_exudyn_moves_the_wheelset_as_its_equations_do(wheelset):
    pytest.importorskip("exudyn", reason="Exudyn is not installed; Debian has no package of it")
    body = at_speed(wheelset, 60)
    state = disturbed(body)
    ours, theirs = (
        wheelset.module(name).integrate(body, state, 0.3, 1e-3) for name in ("runge_kutta", "multibody")
    )  # fmt: skip
    assert theirs[0] == pytest.approx(ours[0])
    largest = np.abs(ours[1]).max(axis=0)
    assert np.abs(theirs[1] - ours[1]).max(axis=0) / largest == pytest.approx(np.zeros(11), abs=1e-4)
