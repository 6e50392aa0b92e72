"""Tests wheels that roll over a track with contact solves in each step."""

from __future__ import annotations

import numpy as np
import pytest

from contactd import Grid, InvalidArgument, Material
from contactd.track import ContactLaw, Flat, Hertz, Record, Ring, Wheel, WheelRailLaw, named_track, roll, third_octaves
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

STEEL = Material(G=82e3, nu=0.28)
GRID = Grid.centred(32, 24, 20.0, 15.0)
GAP = GRID.x[None, :] ** 2 / (2 * 460) + GRID.y[:, None] ** 2 / (2 * 300)
#: Levels of ISO 3095:2013 (dB, 1 um) from 400 mm downwards by third octaves.
LIMIT = (17.1, 15, 13, 11, 9, 7, 4.9, 2.9, 0.9, -1.1, -3.2, -5, -5.6, -6.2, -6.8, -7.4, -8, -8.6, -9.2, -9.8, -10.4, -11)
WHEEL = Wheel(600, 50e3)
SPACING, COUNT = 0.5e-3, 4096


@pytest.fixture(scope="module")
def ring():
    return Ring(named_track("R1"), highest=8e3)


@pytest.fixture(scope="module")
def hertz(client):
    solution = client.solve(grid=GRID, upper=STEEL, gap=GAP, Fn=WHEEL.load)
    return Hertz(WHEEL.load / (solution.approach / 1e3) ** 1.5)


@pytest.fixture
def session(client):
    with client.session(grid=GRID, upper=STEEL, gap=GAP) as opened:
        yield opened


def lines(decibels):
    """Returns wave numbers (1/m) and lines of a periodic record at the limit of ISO 3095 plus `decibels`."""
    random = np.random.default_rng(3)
    waves = np.fft.rfftfreq(COUNT, SPACING)
    found = np.zeros(len(waves), dtype=complex)
    for i, level in enumerate(LIMIT):
        centre = 1 / (0.4 * 10 ** (-i / 10))
        band = (waves >= centre * 10**-0.05) & (waves < centre * 10**0.05)
        if band.any():
            size = 1e-6 * 10 ** ((level + decibels) / 20) * np.sqrt(2 / band.sum()) * COUNT / 2
            found[band] = size * np.exp(2j * np.pi * random.random(band.sum()))
    return waves, found


def record(spectrum):
    x = SPACING * np.arange(-COUNT, 2 * COUNT)
    return Record(x, np.tile(np.fft.irfft(spectrum, COUNT), 3), x_unit="m", unit="m")


def test_a_flat_has_the_force_of_hertz(ring, session, hertz):
    given = {"speed": 100 / 3.6, "duration": 0.0036, "position": 0.295, "rate": 20e3, "start": "static"}
    given["irregularities"] = [Flat(0.05, 0.46, 0.3)]
    wanted = roll(ring, WHEEL, hertz, **given)
    found = roll(ring, WHEEL, ContactLaw(session), **given)
    assert wanted.force.min() == 0
    np.testing.assert_allclose(found.force, wanted.force, atol=0.015 * WHEEL.load)
    assert found.evidence.losses == wanted.evidence.losses
    assert found.evidence.residual <= 1e-6 * WHEEL.load
    assert np.isnan(found.evidence.error)


def test_rough_contacts_converge_and_filter_the_roughness(ring, client, session, hertz):
    waves, spectrum = lines(15)
    touched = client.solve(grid=GRID, upper=STEEL, gap=GAP, Fn=WHEEL.load).pressure > 0
    punch = client.solve(grid=GRID, upper=STEEL, gap=np.where(touched, 0, 1e3), Fn=100.0).pressure
    weights = punch.sum(axis=0) / punch.sum()
    filtered = spectrum * (np.exp(2j * np.pi * waves[:, None] * GRID.x / 1e3) @ weights)
    given = {"speed": 30.0, "duration": 0.025, "rate": 20e3, "start": "static"}
    wanted = roll(ring, WHEEL, hertz, irregularities=[record(filtered)], **given)
    law = ContactLaw(session, GAP, [record(spectrum)])
    found = roll(ring, WHEEL, law, **given)
    assert found.evidence.residual <= 1e-6 * WHEEL.load
    assert found.evidence.most_trials < 10
    centres, levels = third_octaves(found.force, found.rate, 400, 1600, 0.0125)
    _, others = third_octaves(wanted.force, wanted.rate, 400, 1600, 0.0125)
    differences = 20 * np.log10(levels / others)  # A run this short has few lines in a band.
    assert np.sqrt(np.mean(differences**2)) < 0.6
    assert np.abs(differences).max() < 1.2
    assert len(centres) == 7


def test_a_wheel_on_its_rail_reaches_its_load_and_rolls(ring, client):
    setup = WheelRailSetup(side="right")
    position, velocity = WheelsetPosition(y=0.5), WheelsetVelocity(x=30e3, pitch=-30e3 / 460)
    free = client.wheel_rail(setup, WheelRailState(position=position, velocity=velocity, Fz=1.0))
    state = WheelRailState(position=WheelsetPosition(y=0.5, z=free.z), velocity=velocity)
    with client.wheel_rail_session(setup) as opened:
        run = roll(ring, WHEEL, WheelRailLaw(opened, state), speed=30, duration=0.001, rate=20e3, start="static",
                   irregularities=[Record([0, 0.03, 0.06], [0, 10, 0], x_unit="m", unit="um")])  # fmt: skip
    assert run.evidence.residual <= 1e-6 * WHEEL.load
    assert 52e3 < run.force.max() < 65e3
    assert run.force[0] == pytest.approx(WHEEL.load, rel=3e-2)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda session: ContactLaw(5), "must be a session of a contact"),
        (lambda session: ContactLaw(session, roughness=[Flat(0.05, 0.46, 0)]), "requires the gap"),
        (lambda session: ContactLaw(session, GAP[:3]), r"requires \[24, 32\]"),
        (lambda session: ContactLaw(session, GAP / 1e3), "Gaps are in mm; did you give m"),
        (lambda session: ContactLaw(session, GAP, gap_at=lambda x: GAP), "Give one of them"),
        (lambda session: WheelRailLaw(session, WheelRailState(Fz=1e4)), "must be a session of a wheel"),
    ],
)
def test_wrong_laws_are_refused(session, make, message):
    with pytest.raises(InvalidArgument, match=message):
        make(session)


def test_energy_needs_a_law_with_energy(ring, session):
    with pytest.raises(InvalidArgument, match="requires a law with energy"):
        roll(ring, WHEEL, ContactLaw(session), speed=30, duration=0.001, scheme="gradient")
