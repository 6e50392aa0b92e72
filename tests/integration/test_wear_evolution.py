"""Tests wearing profiles by a daemon: areas are conserved, mirror images and halves are consistent, and runs can be
resumed."""

from __future__ import annotations

import json
import re
import warnings
from dataclasses import replace

import numpy as np
import pytest

from contactd import DamageFunction, EnergyWear, FatigueRequest, FatigueStrength, InvalidArgument, Passage, WearLaw
from contactd.wear import Section, WearStudy, WeightedState, evolve, read_record, write_record
from contactd.wheel_rail import (
    ArcProfile,
    ConeProfile,
    ProfilePoints,
    Track,
    WheelRailSetup,
    WheelRailState,
    Wheelset,
    WheelsetPosition,
    WheelsetVelocity,
)

WHEEL = WearLaw("energy", "a test", "lower", (0, 100), energy=EnergyWear(6.75e-4))
RAIL = WearLaw("energy", "a test", "upper", (0, 100), energy=EnergyWear(6.75e-4))


def state(y: float, yaw: float, weight: float = 1.0, group: str = "", side: int = 1) -> WeightedState:
    made = WheelRailState(
        position=WheelsetPosition(y=side * y, yaw=side * yaw), velocity=WheelsetVelocity(x=30e3, pitch=-30e3 / 460), Fz=80e3
    )
    return WeightedState(made, weight, group)


PAIRS = [(y, yaw) for y in (-2.0, -1.0, 0.5, 1.5) for yaw in (-1e-3, 1e-3)]
STUDY = WearStudy(
    WheelRailSetup(dx=0.8, dy=0.8),
    [*(state(*pair, group="straight") for pair in PAIRS), state(5.0, 2e-3, 0.5, "curve")],
    "wheel", WHEEL, until=200, depth=0.02,
)  # fmt: skip


def run(client, study, steps=None, most=99):
    found = []
    for step in evolve(client, study, steps):
        found.append(step)
        if len(found) == most:
            break
    return found


def test_areas_are_kept_and_told_by_groups(shared):
    steps = run(shared, STUDY)
    assert steps[0].number == 0 and steps[-1].distance == 200 and len(steps) > 2
    assert steps[-1].removed == pytest.approx(steps[-1].area, rel=1e-9)
    for step in steps[1:]:
        assert step.depths.max() <= 0.02 * (1 + 1e-9)
        assert (step.depths * np.diff(step.edges)).sum() == pytest.approx(sum(step.groups.values()), rel=1e-12)
        assert step.groups.keys() == {"straight", "curve"}
    # Returns the area that T gamma removes from a circumference of the mean radius.
    first = steps[1]
    km = first.distance * 1e6 * 6.75e-7 * first.T_gamma_with_spin / (2 * np.pi * 460)
    assert first.area == pytest.approx(km, rel=0.01)


def test_a_left_wheel_in_the_mirror_wears_alike(shared):
    mirrored = replace(
        STUDY, setup=STUDY.setup.replace(side="left"), until=40,
        states=[*(state(*pair, group="straight", side=-1) for pair in PAIRS), state(5.0, 2e-3, 0.5, "curve", -1)],
    )  # fmt: skip
    right, left = (run(shared, study)[-1] for study in (replace(STUDY, until=40), mirrored))
    np.testing.assert_allclose(left.points, right.points, atol=1e-12)


def test_two_halves_of_a_collective_are_the_whole(shared):
    halves = replace(STUDY, until=40, states=[*STUDY.states, *STUDY.states])
    whole, twice = (run(shared, study)[-1] for study in (replace(STUDY, until=40), halves))
    np.testing.assert_allclose(twice.points, whole.points, atol=1e-9)


def test_a_rail_wears_by_passages(shared):
    study = replace(STUDY, wears="rail", law=RAIL, until=20_000.0)
    steps = run(shared, study)
    last = steps[-1]
    assert last.distance == 20_000
    assert last.removed == pytest.approx(last.area, rel=1e-9)
    assert steps[1].area == pytest.approx(steps[1].distance * 6.75e-7 * steps[1].T_gamma_with_spin, rel=1e-9)
    moved = last.points - steps[0].points
    assert moved[:, 1].max() > 0 and moved[:, 1].min() > -1e-12


def test_a_run_that_was_killed_goes_on_to_the_same_end(shared, tmp_path):
    pytest.importorskip("h5py")
    study = replace(STUDY, until=100, depth=0.01)
    whole = run(shared, study)
    write_record(tmp_path / "run.h5", study, run(shared, study, most=2))
    before = read_record(tmp_path / "run.h5", study)
    after = [*before, *run(shared, study, before)]
    assert len(after) == len(whole) > 3
    for one, other in zip(after, whole):
        np.testing.assert_array_equal(one.points, other.points)
        assert (one.distance, one.area, one.groups, one.warnings) == (other.distance, other.area, other.groups, other.warnings)
    with pytest.raises(InvalidArgument, match="differs in depth from the one"):
        read_record(tmp_path / "run.h5", replace(study, depth=0.02))


def test_explicit_smoothing_below_what_steps_ask_for_warns(shared):
    steps = run(shared, replace(STUDY, smoothing=1.0, depth=0.05), most=2)
    assert any("grooves grow that smoothing" in warning for warning in steps[1].warnings)


def test_what_answers_warn_of_names_step_and_states(shared):
    coarse = replace(STUDY, setup=WheelRailSetup(dx=2, dy=2), until=20)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        steps = run(shared, coarse)
    given = [sentence for one in caught for sentence in one.message.sentences]
    assert given == [f"step {step.number}: {sentence}" for step in steps for sentence in step.warnings]
    few = [sentence for sentence in given if "elements across, fewer than" in sentence]
    assert few and all(re.match(r"step 1: states\[[0-8]\](, states\[[0-8]\])*( and [0-9]+ more)?: The contact at y", one) for one in few)
    # A mirror image is the same state.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        both = run(shared, replace(coarse, symmetric=True))
    assert not any(f"states[{i}]" in sentence for sentence in both[1].warnings for i in range(9, 18))


def test_a_step_tells_what_ended_it(shared, tmp_path):
    pytest.importorskip("h5py")
    for asked, ended in (({"depth": 0.001}, "depth"), ({"depth": 1.0}, "stability"), ({"distance": 2.0}, "distance")):
        study = replace(STUDY, until=100, **asked)
        steps = run(shared, study, most=2)
        assert [step.ended_by for step in steps] == ["", ended]
        assert (steps[1].depths.max() == pytest.approx(study.depth, rel=1e-9)) == (ended == "depth")
        write_record(tmp_path / f"{ended}.h5", study, steps)
        assert [step.ended_by for step in read_record(tmp_path / f"{ended}.h5", study)] == ["", ended]
    assert run(shared, replace(STUDY, until=1.0))[-1].ended_by == "until"
    # Rails with many passages wear first; rails with few passages wait for the wheel.
    for passages, part in ((1e4, "rail"), (1.0, "wheel")):
        made = run(shared, replace(BOTH, depth=0.001, until=100, passages_per_km=passages), most=2)
        assert made[1].ended_by == f"depth of the {part}" == made[1].rail.ended_by


def test_warnings_of_the_rail_alone_are_among_those_of_a_step(shared):
    deep = replace(BOTH, smoothing=0.5, depth=0.05, passages_per_km=5000.0)
    step = run(shared, deep, most=2)[1]
    grooves = [sentence for sentence in step.rail.warnings if "grooves grow" in sentence]
    assert grooves and not set(grooves) & set(step.warnings)
    assert set(step.all_warnings) == {*step.warnings, *step.rail.warnings}


def test_states_whose_wheel_climbs_on_its_flange_are_counted(shared):
    def sentences(*states):
        warnings = run(shared, replace(STUDY, states=states), most=2)[1].warnings
        return [one for one in warnings if one.startswith("The wheel ")]

    calm = [state(1.0, 1e-3), state(5.0, 2e-3)]
    assert sentences(*calm) == []
    (found,) = sentences(*calm, state(9.0, 1e-3, 2.0))
    assert found.startswith("The wheel climbs on its flange in 1 of 3 states, 0.5 of all by weight: states[2].")


def test_a_state_that_cannot_be_solved_is_named(shared):
    deep = WeightedState(WheelRailState(position=WheelsetPosition(z=60.0), velocity=WheelsetVelocity(x=30e3)), 1.0)
    with pytest.raises(InvalidArgument, match=r"states\[9\] cannot be solved"):
        run(shared, replace(STUDY, states=[*STUDY.states, deep]))


def groove_left(client, smoothing, depth, wavelength=3.0):
    """Returns the fraction of a groove in a tread that remains after one step of gross sliding, and q of the step."""
    new = Section.of(client.placed_profiles(WheelRailSetup()).right.wheel, "wheel", 0.1)
    sliding = WheelRailState(velocity=WheelsetVelocity(x=30e3, pitch=-30e3 / 460 * 1.02), Fz=80e3)
    y = new.points[:, 0]
    wave = np.cos(2 * np.pi * y / wavelength)
    found = []
    for sign in (1, -1):  # half of their difference is the effect of the groove
        grooved = np.stack([y, new.points[:, 1] + sign * 1e-4 * wave], axis=1)
        setup = WheelRailSetup(wheel=ProfilePoints(grooved), dx=0.3, dy=0.15)
        study = WearStudy(
            setup, [WeightedState(sliding, 1.0)], "wheel", WHEEL, until=1e9, depth=depth, smoothing=smoothing, spacing=0.1
        )
        found.append(run(client, study, most=2))
    sizes = []
    for plus, minus in zip(*found):
        difference = (np.interp(y, *plus.points.T) - np.interp(y, *minus.points.T)) / 2
        middle = np.abs(y - 1) < 2.5
        sizes.append(float((difference * wave)[middle].sum()))
    q = np.pi * 113_889 * depth / (wavelength * found[0][1].mean_pressure)
    return sizes[1] / sizes[0], q


@pytest.mark.parametrize("smoothing", ["auto", "exponential_step"])
@pytest.mark.parametrize("depth", [0.001, 0.005, 0.02])
def test_grooves_neither_grow_nor_vanish_before_they_are_worn(shared, smoothing, depth):
    left, q = groove_left(shared, smoothing, depth)
    assert np.exp(-q) - 0.12 < left < 1


def test_a_step_without_smoothing_lets_grooves_grow_beyond_the_critical_depth(shared):
    left, q = groove_left(shared, 0.0, 0.02)
    assert q > 2 and left < -1.5


def test_a_cylinder_takes_the_shape_of_the_rail_that_wears_it_in_one_place(shared):
    """The wear is (3 A/(4 sqrt(2 R)))^(2/3), with the worn area A and the rail's radius R, in steps without
    oscillations."""
    wheel, rail = ConeProfile(0.0, ends=(-60.0, 60.0)), ArcProfile(300.0)
    setup = WheelRailSetup(
        wheel=wheel, rail=rail, track=Track(rail_origin=(750.0, 0.0), gauge_height=0.0), dx=0.5, dy=0.5,
        wheelset=Wheelset(flange_back_distance=1360.0, flange_back_position=-70.0),
    )  # fmt: skip
    sliding = WheelRailState(velocity=WheelsetVelocity(x=30e3, pitch=-30e3 / 460 * 1.02), Fz=60e3)
    study = WearStudy(setup, [WeightedState(sliding, 1.0)], "wheel", WHEEL, until=1e9, depth=0.1)
    steps = run(shared, study, most=26)
    last = steps[-1]
    depth = -last.points[:, 1].min()
    assert depth > 0.3
    assert depth == pytest.approx((3 * last.area / (4 * (2 * 300) ** 0.5)) ** (2 / 3), rel=0.03)
    pressures = [step.pmax for step in steps[8:]]
    assert max(pressures) < 1.15 * min(pressures)
    np.testing.assert_allclose(last.points[:, 1], last.points[::-1, 1], atol=2e-3)


BOTH = replace(STUDY, wears="both", rail_law=replace(RAIL, name="of rails"), passages_per_km=50.0, until=60)


def test_wheel_and_rail_wear_together(shared, tmp_path):
    steps = run(shared, BOTH)
    last = steps[-1]
    for part in ("wheel", "rail"):
        assert last.of(part).removed == pytest.approx(last.of(part).area, rel=1e-8)
        assert last.of(part).area > 0
    # A law that is linear in the energy removes equal areas of both in a passage, and a wheel has one passage per
    # revolution.
    first = steps[1]
    assert first.of("rail").area / 50 == pytest.approx(first.of("wheel").area / (1e6 / (2 * np.pi * 460)), rel=0.01)
    pytest.importorskip("h5py")
    write_record(tmp_path / "both.h5", BOTH, steps)
    found = read_record(tmp_path / "both.h5", BOTH)
    np.testing.assert_array_equal(found[-1].of("rail").points, last.of("rail").points)
    np.testing.assert_array_equal(found[-1].points, last.points)


def test_a_symmetric_study_is_that_of_the_states_and_their_mirror_images(shared):
    symmetric = replace(STUDY, until=40, symmetric=True)
    both = [state(y, yaw, 1.0, "straight") for y, yaw in PAIRS] + [state(5.0, 2e-3, 0.5, "curve")]
    both += [state(y, yaw, 1.0, "straight", side=-1) for y, yaw in PAIRS] + [state(5.0, 2e-3, 0.5, "curve", side=-1)]
    one, other = run(shared, symmetric)[-1], run(shared, replace(STUDY, until=40, states=both))[-1]
    np.testing.assert_allclose(one.points, other.points, atol=1e-12)


def test_what_a_rail_bears_is_told_along_its_section(shared, tmp_path):
    function = DamageFunction("ours", "a test", (0, 1000), [(0, 0, 1e-7)])
    request = FatigueRequest("upper", FatigueStrength("rail", "a test", 300, a_DV=1 / 3), [function], Passage())
    study = replace(STUDY, wears="rail", law=RAIL, until=2e4, fatigue=request, states=STUDY.states[:3], depth=0.05)
    steps = run(shared, study, most=2)
    tired = steps[1].fatigue
    size = np.diff(steps[1].edges)[0]
    assert (tired.damages["ours"] > 0).sum() * size > 3
    # Every row of a patch has all of its damage, so the sum over y is the sum of widths.
    assert tired.damages["ours"].max() <= steps[1].distance * 1e-7 * 40
    assert np.nanmax(tired.dang_van) > 0 and 0 < np.nanmin(tired.limits) < 5
    assert tired.contacts.shape[1] == 4 and len(tired.contacts) >= 3
    pytest.importorskip("h5py")
    write_record(tmp_path / "tired.h5", study, steps)
    np.testing.assert_array_equal(read_record(tmp_path / "tired.h5", study)[1].fatigue.limits, tired.limits)


def test_a_file_names_all_of_its_sources(shared, tmp_path):
    h5py = pytest.importorskip("h5py")
    strength = FatigueStrength("steel", "a torsion test", 300)
    function = DamageFunction("ours", "field data", (0, 1000), [(0, 0, 1e-7)])
    study = replace(STUDY, until=5, states=STUDY.states[:2], fatigue=FatigueRequest("lower", strength, [function]))
    write_record(tmp_path / "steps.h5", study, run(shared, study))
    with h5py.File(tmp_path / "steps.h5") as file:
        assert json.loads(file.attrs["sources"]) == ["energy: a test", "steel: a torsion test", "ours: field data"]
        assert file.attrs["contactd"] and "laws" in json.loads(file.attrs["study"])
