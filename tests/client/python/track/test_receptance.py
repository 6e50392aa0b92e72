"""Tests receptances of tracks against an endless track: exact dynamic stiffness of a bay, and decaying waves."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from contactd import InvalidArgument
from contactd.calls.answer_warnings import ContactWarning
from contactd.track import Rail, Ring, Track, named_track

R1 = named_track("R1")
SOFT = replace(R1, pad_stiffness=20e6, ballast_stiffness=1e6, sleeper_mass=300)
STIFF = replace(R1, spacing=0.65, pad_stiffness=120e6, pad_damping=16e3, sleeper_mass=150, ballast_stiffness=140e6, ballast_damping=165e3)
LIGHT = Track(Rail(E=70e9, G=26e9, density=2700, area=4e-3, inertia=6e-6, kappa=0.5, loss_factor=0.01), 0.9, 50e6, 20e3, 40, 30e6, 40e3)


def segment(track: Track, length: float, omega: float) -> np.ndarray:
    """Returns the exact dynamic stiffness of a free rail of this length: w and t on its left, then on its right end."""
    rail = track.rail
    factor = 1 + 1j * omega * rail.loss_time
    bending, shear = rail.bending_stiffness * factor, rail.shear_stiffness * factor
    m, j = rail.mass * omega**2, rail.rotary_inertia * omega**2
    # With w = W exp(q x), t = T exp(q x): (S q^2 + m) W = S q T and (EI q^2 - S + j) T = -S q W.
    q = np.sqrt(np.roots([shear * bending, shear * j + m * bending, m * (j - shear)]).astype(complex))
    q = np.concatenate([q, -q])
    t = (shear * q**2 + m) / (shear * q)
    start = np.where(q.real > 0, length, 0.0)  # keeps exponentials small
    left, right = np.exp(-q * start), np.exp(q * (length - start))
    shapes = np.array([left, t * left, right, t * right])
    force, moment = shear * (q - t), bending * q * t
    loads = np.array([-force * left, -moment * left, force * right, moment * right])
    return loads @ np.linalg.inv(shapes)


def support(track: Track, omega: float) -> complex:
    pad = track.pad_stiffness + 1j * omega * track.pad_damping
    below = track.ballast_stiffness + 1j * omega * track.ballast_damping - omega**2 * track.sleeper_mass
    return pad * below / (pad + below)


def endless(track: Track, omega: float) -> np.ndarray:
    """Returns the stiffness of half an endless track that begins with half a support, for w and t on its left end."""
    k = segment(track, track.spacing, omega)
    k[0, 0] += support(track, omega) / 2
    k[2, 2] += support(track, omega) / 2
    right = np.linalg.inv(k[:2, 2:])
    transfer = np.block([[-right @ k[:2, :2], right], [k[2:, 2:] @ right @ k[:2, :2] - k[2:, :2], -k[2:, 2:] @ right]])
    # States are (displacements, loads on the left part of the joint); loads on the right part have the other sign.
    factors, vectors = np.linalg.eig(transfer)
    decaying = vectors[:, np.argsort(np.abs(factors))[:2]]
    return decaying[2:] @ np.linalg.inv(decaying[:2])


def exact(track: Track, hertz: float, x: float, y: float) -> complex:
    """Returns the receptance of an endless track between two positions within the bay from 0 to spacing."""
    omega = 2 * math.pi * hertz
    half = endless(track, omega)
    mirror = np.diag([1.0, -1.0])
    ends = sorted({0.0, x, y, track.spacing})
    total = np.zeros((2 * len(ends), 2 * len(ends)), dtype=complex)
    for i, (a, b) in enumerate(zip(ends, ends[1:])):
        total[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += segment(track, b - a, omega)
    for place, part in ((slice(0, 2), mirror @ half @ mirror), (slice(-2, None), half)):
        total[place, place] += part
    for i in (0, -2):
        total[i, i] += support(track, omega) / 2
    load = np.zeros(len(total))
    load[2 * ends.index(y)] = 1
    return np.linalg.solve(total, load)[2 * ends.index(x)]


@pytest.mark.parametrize("track", [R1, SOFT, STIFF, LIGHT], ids=["R1", "soft", "stiff", "light"])
@pytest.mark.parametrize("highest", [12e3, None])
def test_receptances_are_those_of_an_endless_track(track, highest):
    ring = Ring(track, 192, highest)
    for hertz, error in ((0.01, 1e-6), (50, 1e-4), (173, 3e-4), (500, 1e-3), (1000, 1e-2), (2000, 1e-2)):
        for x, y in ((0.0, 0.0), (0.5, 0.5), (0.21, 0.21), (0.1, 0.8), (0.5, 0.55)):
            x, y = x * track.spacing, y * track.spacing
            found, wanted = ring.receptance([hertz], x, y)[0], exact(track, hertz, x, y)
            scale = math.sqrt(abs(wanted) * abs(exact(track, hertz, y, y)))  # transfer receptances have zeros
            assert abs(found - wanted) < error * scale, (hertz, x, y)


def test_given_values_of_r1():
    assert R1.foundation_stiffness == pytest.approx(55.556e6, rel=1e-5)
    assert R1.winkler_deflection("euler") == pytest.approx(1.09170e-8, abs=5e-14)
    assert R1.winkler_deflection() == pytest.approx(1.15590e-8, abs=5e-14)
    assert R1.critical_speed == pytest.approx(790.9, abs=0.05)
    assert R1.pinned_pinned_frequency("euler") == pytest.approx(1422.4, abs=0.05)
    assert R1.pinned_pinned_frequency() == pytest.approx(1058.2, abs=0.05)
    ring = Ring(R1)
    assert ring.static_deflection(0.0) == pytest.approx(1.14227e-8, abs=3e-13)
    assert ring.static_deflection(0.3) == pytest.approx(1.17589e-8, abs=3e-13)
    hertz = [50, 100, 200, 500, 1000, 2000]
    over = [14.85, 9.595, 1.903, 2.863, 0.5360, 0.3067], [-22.0, -92.8, -78.4, -105.9, -136.7, -100.9]
    middle = [15.16, 9.485, 1.957, 3.501, 1.330, 0.3024], [-21.4, -91.2, -55.1, -97.8, -89.5, -111.1]
    for x, (size, degrees) in ((0.0, over), (0.3, middle)):
        found = ring.receptance(hertz, x)
        np.testing.assert_allclose(1e9 * np.abs(found), size, rtol=3e-3)
        np.testing.assert_allclose(np.angle(found, deg=True), degrees, atol=0.3)


def test_load_and_place_can_be_exchanged_and_bays_are_alike():
    ring = Ring(R1)
    there = ring.receptance([30, 700, 1500], 0.13, 4.71)
    np.testing.assert_allclose(there, ring.receptance([30, 700, 1500], 4.71, 0.13), rtol=1e-9)
    np.testing.assert_allclose(there, ring.receptance([30, 700, 1500], -0.13, -4.71), rtol=1e-9)
    np.testing.assert_allclose(there, ring.receptance([30, 700, 1500], 0.13 + 60, 4.71 + 60), rtol=1e-9)


def test_too_few_bays_and_too_little_damping_give_a_warning():
    with pytest.warns(ContactWarning, match="come around the ring of 64 bays"):
        Ring(R1, 64)
    with pytest.warns(ContactWarning, match="more damping"):
        Ring(replace(R1, pad_damping=0))
    with pytest.warns(ContactWarning, match="more damping"):
        Ring(replace(R1, pad_damping=0, ballast_damping=0, rail=replace(R1.rail, loss_factor=0)))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"pad_stiffness": 200.0}, "track.pad_stiffness = 200: it must lie between 100000 and 1e"),
        ({"pad_damping": 28.0}, "did you give kN s/m"),
        ({"spacing": 600}, "did you give mm"),
        ({"sleeper_mass": 0}, "give a small mass"),
        ({"ballast_stiffness": float("nan")}, "finite"),
        ({"rail": 60}, "must be a Rail"),
    ],
)
def test_wrong_tracks_are_refused(change, message):
    with pytest.raises(InvalidArgument, match=message):
        replace(R1, **change)


def test_other_mistakes_are_refused():
    with pytest.raises(InvalidArgument, match="did you give cm"):
        replace(R1.rail, area=76.9)
    with pytest.raises(InvalidArgument, match="named tracks are R1"):
        named_track("R7")
    with pytest.raises(InvalidArgument, match="at least 0 Hz"):
        Ring(R1).receptance([-1], 0)
    with pytest.raises(InvalidArgument, match="bays = 1:"):
        Ring(R1, 1)
