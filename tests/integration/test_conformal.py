"""Tests wheelrail.solve with coefficients that consider the curvature of wheel and rail, and the sources of their
tables."""

from __future__ import annotations

import dataclasses

import pytest

from contactd import Cancelled, InvalidArgument
from contactd.wheel_rail import (
    ConeProfile,
    ProfilePoints,
    Rail60E1,
    Track,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)
from support.daemons import eventually

SETUP = WheelRailSetup(rail=Rail60E1(1 / 40), dx=0.8, dy=0.8)
#: A rail with a kink of 67 degrees under the wheel.
RIDGE = SETUP.replace(
    wheel=ConeProfile(0, ends=(-40, 40)),
    rail=ProfilePoints([(-30, 20), (0, 0), (30, 20)]),
    track=Track(rail_origin=(750, 0)),
)
IN_THE_CORNER = WheelRailState(
    position=WheelsetPosition(y=6.5), velocity=WheelsetVelocity(x=20e3, pitch=-20e3 / 460), Fz=80e3
)


def pmax(solution):
    return max(patch.solution.pmax for patch in solution.patches)


def test_sections_and_rotated_half_spaces_agree_in_a_gauge_corner(shared):
    heard = []
    rotated = shared.wheel_rail(SETUP.replace(conformal="rotated"), IN_THE_CORNER)
    fem = shared.wheel_rail(SETUP.replace(conformal="fem"), IN_THE_CORNER, timeout=300, on_progress=heard.append)
    assert rotated.converged
    assert fem.converged
    for solution in (rotated, fem):
        assert solution.forces.track.Fz == pytest.approx(80e3, rel=1e-5)
        assert solution.warnings == ()
    assert pmax(fem) == pytest.approx(pmax(rotated), rel=0.03)
    assert fem.forces.track.Fx == pytest.approx(rotated.forces.track.Fx, abs=0.03 * 0.3 * 80e3)
    assert any("mesh" in progress.stage or progress.fraction > 0 for progress in heard)


@pytest.mark.parametrize("conformal", ["half_space", "rotated_displacements", "rotated"])
def test_small_elements_of_curved_contacts_are_not_refused_for_their_memory(shared, conformal):
    setup = WheelRailSetup(rail=Rail60E1(), track=Track(cant=0.03), conformal=conformal)
    state = WheelRailState(
        position=WheelsetPosition(y=6.1, yaw=0.011), velocity=WheelsetVelocity(x=4000.0, pitch=-8.68), Fz=14e3
    )
    coarse, fine = (shared.wheel_rail(setup.replace(dx=size, dy=size), state, fields=[]) for size in (0.2, 0.1))
    assert fine.forces.track.Fz == pytest.approx(14e3, rel=1e-5)
    assert fine.forces.track.Fx == pytest.approx(coarse.forces.track.Fx, rel=5e-3)


def test_a_curved_patch_whose_tables_are_too_large_is_refused_when_it_is_found(daemons):
    daemon = daemons.start(limits={"max_work_bytes": 100_000_000})
    with daemon.client() as client:
        setup = SETUP.replace(dx=0.1, dy=0.1)
        with pytest.raises(InvalidArgument, match="results in a curved patch of .* conformal half_space"):
            client.wheel_rail(setup.replace(conformal="rotated"), IN_THE_CORNER, fields=[])
        assert client.wheel_rail(setup.replace(conformal="half_space"), IN_THE_CORNER, fields=[]).converged


def test_tables_of_sections_are_built_once_for_neighbouring_positions_and_both_sides(shared):
    setup = SETUP.replace(conformal="fem")
    first = shared.wheel_rail(setup, IN_THE_CORNER, fields=[], timeout=300)
    built = shared.info().counters["builds_started"]
    again = shared.wheel_rail(setup, IN_THE_CORNER, fields=[])
    assert again.z == first.z
    left = dataclasses.replace(IN_THE_CORNER, position=WheelsetPosition(y=-6.5))
    mirrored = shared.wheel_rail(setup.replace(side="left"), left, fields=[])
    assert mirrored.forces.track.Fy == -first.forces.track.Fy
    shared.wheel_rail(setup, dataclasses.replace(IN_THE_CORNER, position=WheelsetPosition(y=6.52)), fields=[])
    assert shared.info().counters["builds_started"] == built


def test_automatic_contacts_are_rotated_in_the_corner_and_planes_on_the_tread(shared):
    setup = SETUP.replace(conformal="auto")
    corner = shared.wheel_rail(setup, IN_THE_CORNER, fields=[])
    assert corner.z == shared.wheel_rail(SETUP.replace(conformal="rotated"), IN_THE_CORNER, fields=[]).z
    tread = shared.wheel_rail(setup, dataclasses.replace(IN_THE_CORNER, position=WheelsetPosition()), fields=[])
    assert tread.patches[0].place.rows == ()


def test_who_gives_up_leaves_the_build_to_the_store(daemon, client, background):
    setup = SETUP.replace(conformal="fem")
    asked = background(client.wheel_rail, setup, IN_THE_CORNER, timeout=300)
    eventually(daemon.builders)
    (solve,) = (job for job in client.jobs() if job.kind == "solve")
    client.cancel_job(solve.job)
    with pytest.raises(Cancelled):
        asked.result()
    eventually(lambda: client.info().counters["builds_finished"] == 1, "the build has ended with its caller", seconds=60)
    assert client.wheel_rail(setup, IN_THE_CORNER, fields=[]).converged
    assert client.info().counters["builds_started"] == 2  # one table each of rail and wheel, the first one cached


def test_whoever_waits_for_a_build_that_is_cancelled_is_told_so(daemon, client, background):
    asked = background(client.wheel_rail, SETUP.replace(conformal="fem"), IN_THE_CORNER, timeout=300)
    eventually(daemon.builders)
    (build,) = (job for job in client.jobs() if job.kind == "build")
    client.cancel_job(build.job)
    with pytest.raises(Cancelled):
        asked.result()
    eventually(lambda: not daemon.builders(), "the builder is still there")


@pytest.mark.parametrize(
    ("setup", "sentence"),
    [
        (
            SETUP.replace(
                conformal="fem", track=Track(rail_origin=(750, 0)), rail_slices=[(0, Rail60E1()), (1000, Rail60E1(1 / 20))]
            ),
            "setup.conformal is fem, but the rail has slices",
        ),
        (SETUP.replace(conformal="fem", model="hertz"), "setup.conformal is not off"),
        (
            RIDGE.replace(conformal="fem"),
            "setup.conformal is fem, but the cross-section of the rail cannot be used",
        ),
    ],
)
def test_what_has_no_section_is_refused_by_a_sentence(shared, setup, sentence):
    with pytest.raises(InvalidArgument) as failure:
        shared.wheel_rail(setup, dataclasses.replace(IN_THE_CORNER, position=WheelsetPosition()), timeout=100)
    assert sentence in str(failure.value)
