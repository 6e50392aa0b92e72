"""Tests wheels that roll over a track by Hertz's law: energy, peaks, steady states, and mistakes."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace

import numpy as np
import pytest

from contactd import InvalidArgument
from contactd.calls.answer_warnings import ContactWarning
from contactd.track import (
    DippedJoint,
    Flat,
    Hertz,
    Record,
    Ring,
    SuspendedMass,
    Wheel,
    WheelMode,
    height_at,
    named_track,
    read_run,
    roll,
    third_octaves,
)
from contactd.track.motion import Motion

LAW = Hertz(9.2905e10)
WHEEL, HEAVY = Wheel(600, 50e3), Wheel(600, 100e3)
R1 = named_track("R1")


@pytest.fixture(scope="module")
def ring():
    return Ring(R1, highest=8e3)


@pytest.fixture(scope="module")
def undamped():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ContactWarning)
        return Ring(replace(R1, pad_damping=0, ballast_damping=0, rail=replace(R1.rail, loss_factor=0)), highest=2000)


def bounced(ring, rate, scheme, duration=1.5):
    """Returns evidence and kinetic energy of a wheel that starts downwards at 0.25 m/s."""
    motion = Motion(ring, WHEEL, LAW, [], 0.3, 0.0, 1 / rate, scheme)
    motion._states[1] = 0.25
    motion.begin()
    for _ in motion.blocks(round(duration * rate)):
        pass
    return motion.evidence(0, 0), 0.5 * WHEEL.mass * 0.25**2


def test_a_bouncing_wheel_keeps_its_energy(undamped):
    fine, kinetic = bounced(undamped, 20e3, "mean", 0.5)
    assert fine.losses > 4
    assert abs(fine.change) < 3e-3 * kinetic
    coarse, _ = bounced(undamped, 2.5e3, "mean", 2.0)
    assert abs(coarse.change) < 3e-2 * kinetic
    for rate in (20e3, 2.5e3):
        kept, _ = bounced(undamped, rate, "gradient", 0.2)
        assert abs(kept.error) < 1e-8 * kinetic
        assert kept.dissipation == 0


def test_work_of_the_geometry_is_dissipation_and_change_of_energy(ring):
    vehicle = Wheel(600, 100e3, [SuspendedMass(1e6, 2e4, 3000), SuspendedMass(4e5, 3e4, 6000)], [WheelMode(1800, 0.01, 300)])
    flat = [Flat(0.06, 0.46, 0.3, "fresh")]
    closed = roll(ring, vehicle, LAW, speed=30, duration=0.03, irregularities=flat, scheme="gradient", rate=20e3)
    assert closed.evidence.losses > 0
    assert closed.evidence.work > 5
    assert abs(closed.evidence.error) < 1e-8 * closed.evidence.work
    mean = roll(ring, vehicle, LAW, speed=30, duration=0.03, irregularities=flat)
    assert abs(mean.evidence.error) < 1e-2 * mean.evidence.work
    assert mean.evidence.dissipation == pytest.approx(closed.evidence.dissipation, rel=0.1)


@pytest.mark.parametrize(
    ("irregularity", "speed", "duration", "peak"),
    [
        (Flat(0.05, 0.46, 0.3, "fresh"), 35 / 3.6, 0.012, 216.8e3),
        (Flat(0.05, 0.46, 0.3), 80 / 3.6, 0.01, 154.0e3),
        (Flat(0.1, 0.46, 0.3), 60 / 3.6, 0.015, 328.9e3),
        (DippedJoint(0.6, 0.01, 0.5), 30, 0.025, 169.97e3),
        (DippedJoint(0.9, 0.01, 0.5), 30, 0.035, 173.5e3),
    ],
    ids=["fresh", "rounded", "long", "joint over a sleeper", "joint at mid-span"],
)
def test_peaks_over_flats_and_joints(ring, irregularity, speed, duration, peak):
    position = 0.28 if isinstance(irregularity, Flat) else 0.0
    run = roll(ring, HEAVY, LAW, speed=speed, duration=duration, irregularities=[irregularity], position=position)
    assert run.force.max() == pytest.approx(peak, rel=5e-3)


def test_sleeper_passing_on_smooth_rail(ring):
    run = roll(ring, WHEEL, LAW, speed=30, duration=0.1, rate=20e3)
    assert run.evidence.start_error < 1e-3
    amplitudes = 2 * np.abs(np.fft.rfft(run.force)) / len(run.force)
    np.testing.assert_allclose(amplitudes[[5, 10, 15]], [1214.8, 120.1, 173.2], rtol=1e-2)
    other = roll(ring, WHEEL, LAW, speed=30, duration=0.1, rate=20e3, scheme="linear")
    np.testing.assert_allclose(run.force, other.force, atol=30)


def test_a_slow_wheel_follows_the_static_deflection(ring):
    run = roll(ring, WHEEL, LAW, speed=1, duration=0.6, rate=4e3, start="static")
    np.testing.assert_allclose(run.force, WHEEL.load, rtol=2e-3)
    for share in (0.25, 0.5, 1.0):
        row = round(share * len(run.time)) - 1
        assert run.rail[row] == pytest.approx(WHEEL.load * ring.static_deflection(run.x[row]), rel=1e-3)


def test_small_waves_give_the_force_of_receptances():
    ring, wheel, amplitude = Ring(R1), WHEEL, 1e-8
    stiffness = 1.5 * LAW.constant ** (2 / 3) * wheel.load ** (1 / 3)
    for hertz in (200, 1000):

        class Shaken:
            """A height that oscillates in time under a wheel that hardly moves."""

            def height(self, x, hertz=hertz):
                return amplitude * np.sin(2 * math.pi * hertz * (x - 0.3) / 0.01)

            def unresolved(self, step):
                return 0.0

        run = roll(ring, wheel, LAW, speed=0.01, duration=0.1, irregularities=[Shaken()], position=0.3, rate=20e3, start="static", scheme="linear")
        turned = np.exp(-2j * math.pi * hertz * run.time[1000:])
        force = 2 * np.mean((run.force[1000:] - wheel.load) * turned)
        flexibility = ring.receptance([hertz], 0.3)[0] + 1 / stiffness - 1 / (wheel.mass * (2 * math.pi * hertz) ** 2)
        assert abs(force) == pytest.approx(amplitude / abs(flexibility), rel=1.5e-2)


def test_the_file_of_a_run_is_readable_at_any_time(ring, tmp_path):
    path = tmp_path / "run.csv"

    def stop(progress):
        if progress.fraction > 0.3:
            raise KeyboardInterrupt

    given = {"speed": 40.0, "duration": 0.05, "rate": 20e3, "start": "static", "irregularities": [Flat(0.05, 0.46, 0.3)]}
    whole = roll(ring, WHEEL, LAW, **given)
    assert roll(ring, WHEEL, LAW, **given, path=path).force.size == 0
    kept = read_run(path)
    np.testing.assert_allclose(kept.force, whole.force, rtol=1e-8)
    assert kept.evidence == whole.evidence
    with pytest.MonkeyPatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr("contactd.track.rolling._REPORTS", 0.0)
        roll(ring, WHEEL, LAW, **given, path=path, on_progress=stop)
    cut = read_run(path)
    assert 0.3 * whole.force.size < cut.force.size < whole.force.size
    assert cut.evidence is None
    path.write_text(path.read_text() + "0.1,2,3")
    assert read_run(path).force.size == cut.force.size
    path.write_text("mine")
    with pytest.raises(InvalidArgument, match="another program"):
        roll(ring, WHEEL, LAW, **given, path=path)
    with pytest.raises(ValueError, match="is not a run"):
        read_run(path)


def test_third_octaves_contain_the_power():
    time = np.arange(40000) / 20e3
    values = 3 * np.sin(2 * math.pi * 250 * time) + np.random.default_rng(1).normal(size=time.size)
    centres, levels = third_octaves(values, 20e3, 20, 8000)
    assert levels[np.argmin(abs(centres - 251.2))] ** 2 == pytest.approx(4.5 + 57.8 / 1e4, rel=1e-2)
    top = np.argmin(abs(centres - 5012))
    assert levels[top] ** 2 == pytest.approx(5012 * 0.2307 / 1e4, rel=0.1)
    with pytest.raises(InvalidArgument, match="longer run"):
        third_octaves(values[:1000], 20e3)


def test_heights_have_the_stated_shapes():
    assert height_at([Flat(0.04, 0.5, 1.0, "fresh")], [0.9, 1.01, 1.02, 1.03]) == pytest.approx([0, -1e-4, -4e-4, -1e-4])
    assert height_at([Flat(0.04, 0.5, 1.0)], 1.02) == pytest.approx(-0.04**2 / 8)
    turn = 2 * math.pi * 0.5
    assert height_at([Flat(0.04, 0.5, 1.0, every_turn=True)], [1.02 - turn, 1.02 + 3 * turn]) == pytest.approx([-2e-4] * 2)
    assert height_at([DippedJoint(2, 0.01), DippedJoint(2, 0.01)], [1.75, 2, 2.6]) == pytest.approx([-2.5e-3, -5e-3, 0])
    record = Record([0, 1, 2, 4], [0, 2, 4, 8], x_unit="mm", unit="um")
    np.testing.assert_allclose(record.height(np.array([-1, 0.0015, 0.003, 9])), [0, 3e-6, 6e-6, 8e-6], rtol=1e-9)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"speed": 200}, "speed = 200: .*km/h"),
        ({"speed": -1}, "speed = -1"),
        ({"rate": 1000, "speed": 60}, "a bay must have at least 24 steps"),
        ({"rate": 10e3, "scheme": "linear"}, "diverges"),
        ({"scheme": "newmark"}, "give one of mean, linear, gradient"),
        ({"duration": math.nan}, "duration = nan"),
        ({"law": 1e9}, "must be Hertz"),
        ({"wheel": 600}, "must be a Wheel"),
        ({"irregularities": [1e-6]}, r"irregularities\[0\]"),
        ({"duration": 1e4}, "Give a path"),
    ],
)
def test_wrong_runs_are_refused(ring, change, message):
    given = {"wheel": WHEEL, "law": LAW, "speed": 30, "duration": 0.01, "start": "static", **change}
    with pytest.raises(InvalidArgument, match=message):
        roll(ring, given.pop("wheel"), given.pop("law"), **given)


def test_speeds_above_the_critical_one_are_refused():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ContactWarning)
        soft = Ring(replace(R1, ballast_stiffness=1e5, rail=replace(R1.rail, inertia=1e-7, density=30000)))
    with pytest.raises(InvalidArgument, match="the critical speed of the track is"):
        roll(soft, WHEEL, LAW, speed=60, duration=0.01)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Flat(50, 0.46, 0), "did you give mm"),
        (lambda: Flat(0.3, 0.46, 0), "at most half the radius"),
        (lambda: Flat(0.05, 460, 0), "Did you give mm"),
        (lambda: DippedJoint(0, 10), "milliradians"),
        (lambda: Hertz(9.3e15), "law.constant"),
        (lambda: Wheel(0, 1e5), "wheel.mass = 0"),
        (lambda: Wheel(600, 50), "Did you give kN"),
        (lambda: Record([0, 1, 1], [0, 0, 0], x_unit="m", unit="um"), r"x\[2\] = 1: positions must increase"),
        (lambda: Record([0, 1], [0, math.nan], x_unit="m", unit="um"), r"heights\[1\] = nan"),
        (lambda: Record([0, 1], [0, 20], x_unit="m", unit="m"), "another unit than m"),
        (lambda: Record([0, 1], [0], x_unit="m", unit="m"), "heights has the shape"),
        (lambda: Record([0, 1], [0, 1], x_unit="um", unit="m"), "x_unit"),
    ],
)
def test_wrong_inputs_are_refused(make, message):
    with pytest.raises(InvalidArgument, match=message):
        make()


def test_likely_mistakes_give_a_warning(ring):
    with pytest.warns(ContactWarning, match="those of the wheelset"):
        Wheel(1800, 200e3)
    with pytest.warns(ContactWarning, match="less than the weight of wheel.mass = 600 kg"):
        Wheel(600, 5000)
    x = np.linspace(0, 0.5, 2001)
    short = Record(x, 20 * np.sin(2 * math.pi * x / 0.002), x_unit="m", unit="um")
    with pytest.warns(ContactWarning, match="Its end values apply outside"):
        roll(ring, WHEEL, LAW, speed=30, duration=0.02, start="static", irregularities=[Record(x, 0 * x, x_unit="m", unit="um")])
    with pytest.warns(ContactWarning, match="miss .* um of the height"):
        roll(ring, WHEEL, LAW, speed=60, duration=0.005, start="static", irregularities=[short])
    high = Record([0, 0.1, 0.3], [0, 40, 0], x_unit="m", unit="mm")
    with pytest.warns(ContactWarning, match="times the load, where steel yields"):
        roll(ring, WHEEL, LAW, speed=30, duration=0.005, start="static", irregularities=[high])


def test_a_track_is_no_ring():
    with pytest.raises(InvalidArgument, match="Create one from the track"):
        roll(R1, WHEEL, LAW, speed=30, duration=0.01)
