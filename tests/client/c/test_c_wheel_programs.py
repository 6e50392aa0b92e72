"""Tests programs of wheels on rails, in C and in Octave, against Python."""

from __future__ import annotations

import math
import re

import pytest

from contactd.wheel_rail import (
    ProfilePoints,
    RailDeviation,
    RailSprings,
    Track,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)
from support.c_programs import LIBRARY, ROOT, STRICT, needs, octave, run
from support.daemons import BIN

FLAT_ON_SPRINGS = """
#include <contactd.h>
#include <math.h>
#include <stdio.h>

int main(int argc, char **argv) {{
    contactd_connection *connection;
    contactd_wheel *wheel;
    double y, z, Fy, solves, converged;
    int i;
    if (argc != 2 || contactd_open(argv[1], &connection) || contactd_wheel_new(connection, &wheel)) return 1;
    contactd_set(wheel, "setup.dx", 0.5);
    contactd_set(wheel, "setup.dy", 0.5);
    contactd_set(wheel, "state.velocity.x", 20e3);
    contactd_set(wheel, "state.velocity.pitch", -20e3 / 460);
    contactd_set(wheel, "state.Fz", 8e4);
    {flat}
    {springs}
    if (contactd_get(wheel, "forces.track.Fy", &Fy)) return 1;
    printf("%.9g %.9g %.9g %d\\n", y, z, Fy, (int)converged);
    contactd_wheel_free(wheel);
    return contactd_close(connection);
}}
"""


def test_the_flat_and_the_springs_on_the_page_are_those_of_python(shared_daemon, tmp_path):
    snippets = re.findall(r"^```c\n(.*?)^```", (ROOT / "docs" / "c.md").read_text(), re.MULTILINE | re.DOTALL)
    (flat,) = (code for code in snippets if "wheel_slices" in code)
    (springs,) = (code for code in snippets if "track.springs" in code)
    source = tmp_path / "flat.c"
    source.write_text(FLAT_ON_SPRINGS.format(flat=flat, springs=springs))
    include = ROOT / "client" / "c" / "include"
    made = run("cc", *STRICT, f"-I{include}", source, f"-L{LIBRARY}", "-lcontactd-local", "-lm", "-o", tmp_path / "flat")
    assert made.returncode == 0, made.stderr

    in_process, ended = run(tmp_path / "flat", "local"), run(tmp_path / "flat", shared_daemon.endpoint)

    assert ended.returncode == 0, ended.stderr
    assert in_process.stdout == ended.stdout
    y, z, Fy, converged = (float(number) for number in ended.stdout.split())
    assert converged == 1
    assert Fy - 500 == pytest.approx(2e4 * y, abs=0.1)
    assert z == pytest.approx((8e4 + 2e3) / 1e5, rel=1e-5)
    slices = []
    for angle in (0.0047 * i for i in range(-20, 21)):
        depth = min(0.0, (460 - 0.5) / math.cos(angle) - 460)
        slices.append((angle, ProfilePoints([[-20, depth], [50, depth]])))
    setup = WheelRailSetup(wheel_slices=slices, track=Track(springs=RailSprings(y=2e4, z=1e5)), dx=0.5, dy=0.5)
    rolling = WheelsetVelocity(x=20e3, pitch=-20e3 / 460)
    state = WheelRailState(position=WheelsetPosition(pitch=0.02), velocity=rolling, rail=RailDeviation(Fy=-500, Fz=2e3), Fz=8e4)
    with shared_daemon.client() as client:
        deflection = client.wheel_rail(setup, state, fields=[]).rail_deflection
    assert (y, z) == pytest.approx((deflection.y, deflection.z), rel=1e-8)


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
            assert z == pytest.approx(solution.z, abs=1.5e-5)  # as printed
            assert (Fx, Fy) == pytest.approx((track.Fx, track.Fy), abs=0.1)  # of 80 kN: steps start where the last one ended
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
        "for side = {'left', 'right'}, w{end + 1} = contactd('wheel_new', c); contactd('set_word', w{end}, 'setup.side', side{1});"
        "contactd('set', w{end}, 'setup.dx', 1); contactd('set', w{end}, 'setup.dy', 1); contactd('set', w{end}, 'state.Fz', 1e4);"
        "contactd('set_array', w{end}, 'state.velocity', [2000 0 0 0 0 -2000 / 460]); end;"
        "contactd('wheel_solve_many', w{1}, w{2}, 2); contactd('wheel_solve_wheelset', w{2}, w{1});"
        "for k = 1:2, F = contactd('get_array', w{k}, 'forces.track');"
        "printf('%.12g %.12g\\n', F(3), contactd('get', w{k}, 'roll')); end;"
        "contactd('get', w{1}, 'roll_search.residual'); contactd('wheel_solve_wheelset', w{1}, 7);"
    )
    assert "Argument 3 must be a handle that" in ended.stderr
    left, right = ([float(number) for number in line.split()] for line in ended.stdout.splitlines())
    assert left == pytest.approx([1e4, 0], abs=1e-1)
    assert left[1] == right[1]


@needs("octave-cli")
@pytest.mark.timeout(120)
def test_octave_has_wheels_that_are_not_round_and_rails_on_springs(shared_daemon):
    ended = octave(
        f"c = contactd('open', '{shared_daemon.endpoint}'); w = contactd('wheel_new', c);"
        "contactd('set', w, 'setup.dx', 1); contactd('set', w, 'setup.dy', 1); contactd('set', w, 'state.Fz', 1e4);"
        "contactd('set', w, 'setup.track.springs.y', 1e4); contactd('set', w, 'setup.track.springs.z', 5e4);"
        "contactd('set_word', w, 'setup.side', 'left'); contactd('clear', w, 'state.Fx'); contactd('set', w, 'state.rail.Fz', 2e3);"
        "for k = 0:6, d = max(0, 0.4 - 0.2 * abs(k - 3)); at = sprintf('setup.wheel_slices[%d]', k);"
        "contactd('set', w, [at '.angle'], 0.03 * (k - 3));"
        "contactd('set_array', w, [at '.profile.points'], [-20 50; -d -d]); end;"
        "for pitch = [0 1], contactd('set', w, 'state.position.pitch', pitch); contactd('wheel_solve', w);"
        "printf('%.10g %.10g %d\\n', contactd('get', w, 'z'), contactd('get', w, 'rail_deflection.z'),"
        "contactd('get', w, 'rail_search.converged')); end;"
        "contactd('clear', w, 'setup.wheel_slices'); contactd('wheel_free', w); contactd('close', c);"
    )
    assert ended.returncode == 0, ended.stderr
    flat, round_ = ([float(number) for number in line.split()] for line in ended.stdout.splitlines())
    assert flat[0] - round_[0] == pytest.approx(0.4, abs=0.1)
    assert flat[1:] == round_[1:] == pytest.approx([1.2e4 / 5e4, 1])


@needs("octave-cli")
@pytest.mark.timeout(120)
def test_octave_solves_a_wheel_on_its_rail(shared_daemon):
    ended = octave(
        f"c = contactd('open', '{shared_daemon.endpoint}'); w = contactd('wheel_new', c);"
        "contactd('set', w, 'setup.dx', 1); contactd('set', w, 'setup.dy', 1); contactd('set_word', w, 'setup.side', 'right');"
        "contactd('set_array', w, 'state.velocity', [2000 0 0 0 0 -2000 / 460]); contactd('set', w, 'state.Fz', 1e4);"
        "contactd('want', w, 'pressure', 1); contactd('wheel_solve', w); F = contactd('get_array', w, 'forces.track');"
        "nx = contactd('get', w, 'patches[0].place.grid.nx'); ny = contactd('get', w, 'patches[0].place.grid.ny');"
        "p = contactd('get_array', w, 'patches[0].solution.pressure', nx, ny); pmax = contactd('get', w, 'patches[0].solution.pmax');"
        "printf('%d %d %d %.10g %.10g\\n', numel(F), all(size(p) == [nx ny]), max(p(:)) == pmax, F(3), sum(p(:)));"
        "contactd('wheel_free', w); contactd('close', c);"
    )
    assert ended.returncode == 0, ended.stderr
    count, fits, largest, Fz, pressures = (float(number) for number in ended.stdout.split())
    assert (count, fits, largest) == (6, 1, 1)
    assert Fz == pytest.approx(1e4, rel=1e-5)
    assert pressures == pytest.approx(1e4, rel=1e-2)
