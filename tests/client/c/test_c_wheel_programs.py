"""Programs of wheels on rails, in C and in Octave: they answer as Python does."""

from __future__ import annotations

import re

import pytest

from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from support.c_programs import needs, octave, run
from support.daemons import BIN


def test_the_sweep_in_c_is_that_in_python_and_in_process(shared_daemon):
    ended = run(BIN / "contactd-c-sweep", shared_daemon.endpoint)
    assert ended.returncode == 0, ended.stderr
    found = [
        [float(number) for number in line]
        for line in re.findall(r"y +(\d+) mm, right: z +(\S+) mm, Fx +(\S+) N, Fy +(\S+) N", ended.stdout)
    ]
    assert [y for y, *_ in found] == list(range(7))
    rolling = WheelsetVelocity(x=20e3, pitch=-20e3 / 460)
    with shared_daemon.client() as client:
        for y, z, Fx, Fy in found:
            state = WheelRailState(position=WheelsetPosition(y=y, yaw=2.4e-3 * y), velocity=rolling, Fz=80e3)
            solution = client.wheel_rail(WheelRailSetup(dx=0.5, dy=0.5), state, fields=[])
            track = solution.forces.track
            assert (z, Fx, Fy) == pytest.approx((solution.z, track.Fx, track.Fy), abs=1e-4)
    for place in ("local", shared_daemon.endpoint):
        again = run(BIN / "contactd-c-local-sweep", place)
        assert again.returncode == 0, again.stderr
        assert again.stdout == ended.stdout
    assert run(BIN / "contactd-c-sweep", "local").returncode == 1


@needs("octave-cli")
@pytest.mark.timeout(120)
def test_octave_solves_a_wheelset(shared_daemon):
    ended = octave(
        f"c = contactd('open', '{shared_daemon.endpoint}'); w = {{}};"
        "for side = {'left', 'right'}, w{end + 1} = contactd('wheel_new', c); contactd('wheel_set_side', w{end}, side{1});"
        "contactd('wheel_set_elements', w{end}, 1, 1, 0); contactd('wheel_set_Fz', w{end}, 1e4);"
        "contactd('wheel_set_velocity', w{end}, 2000, 0, 0, 0, 0, -2000 / 460); end;"
        "contactd('wheel_solve_wheelset', w{2}, w{1});"
        "for k = 1:2, F = contactd('wheel_get_forces', w{k}, 'in_track');"
        "printf('%.12g %.12g\\n', F(3), contactd('wheel_get_roll', w{k})); end;"
        "contactd('wheel_get_evidence', w{1}, 'roll'); contactd('wheel_solve_wheelset', w{1}, 7);"
    )
    assert "Argument 3 must be what" in ended.stderr
    left, right = ([float(number) for number in line.split()] for line in ended.stdout.splitlines())
    assert left == pytest.approx([1e4, 0], abs=1e-1)
    assert left[1] == right[1]


@needs("octave-cli")
@pytest.mark.timeout(120)
def test_octave_solves_a_wheel_on_its_rail(shared_daemon):
    ended = octave(
        f"c = contactd('open', '{shared_daemon.endpoint}'); w = contactd('wheel_new', c);"
        "contactd('wheel_set_elements', w, 1, 1, 0); contactd('wheel_set_side', w, 'right');"
        "contactd('wheel_set_velocity', w, 2000, 0, 0, 0, 0, -2000 / 460); contactd('wheel_set_Fz', w, 1e4);"
        "contactd('wheel_want', w, 'pressure', 1); contactd('wheel_solve', w);"
        "F = contactd('wheel_get_forces', w, 'in_track'); p = contactd('wheel_get_array', w, 0, 'pressure');"
        "[nx, ny] = contactd('wheel_get_grid', w, 0); [approach, pmax] = contactd('wheel_get_pressure', w, 0);"
        "printf('%d %d %d %.10g %.10g\\n', numel(F), all(size(p) == [nx ny]), max(p(:)) == pmax, F(3), sum(p(:)));"
        "contactd('wheel_free', w); contactd('close', c);"
    )
    assert ended.returncode == 0, ended.stderr
    count, fits, largest, Fz, pressures = (float(number) for number in ended.stdout.split())
    assert (count, fits, largest) == (6, 1, 1)
    assert Fz == pytest.approx(1e4, rel=1e-5)
    assert pressures == pytest.approx(1e4, rel=1e-2)
