"""wear: profiles that wear, from files to a file."""

from __future__ import annotations

import signal
import subprocess
import sys
import time

import numpy as np
import pytest

h5py = pytest.importorskip("h5py")

STATES = """position.y, position.yaw, velocity.x, velocity.pitch, Fz, weight, group
-1.5, -0.0005, 30000, -65.217, 80000, 0.4, straight
1, 0.001, 30000, -65.217, 80000, 0.4, straight
"""
STUDY = """setup: {dx: 0.8, dy: 0.8}
states: states.csv
wears: wheel
law: {name: mild, source: a test, body: lower, range: [0, 10], energy: {coefficient: 0.000675}}
until: 60
step: {depth: 0.005}
"""


@pytest.fixture
def files(ctl):
    ctl.write("wear.yaml", STUDY)
    ctl.write("states.csv", STATES)
    for path in ctl.folder.glob("*.h5"):
        path.unlink()
    return ctl


def points(path):
    with h5py.File(path) as file:
        return file["points"][()], file["distance"][()]


def test_steps_are_shown_and_kept(files):
    shown = files("wear", "wear.yaml", "--profile", "worn.txt")
    assert shown.code == 0, shown.err
    assert "largest depth, mm" in shown.out
    sections, distances = points(files.folder / "wear.yaml.h5")
    assert distances[0] == 0 and distances[-1] == 60 and len(distances) > 3
    np.testing.assert_allclose(np.loadtxt(files.folder / "worn.txt"), sections[-1], atol=1e-6)
    steps = files("wear", "wear.yaml", "--json").json["steps"]
    assert steps[-1]["km"] == 60 and steps[-1]["removed"] == pytest.approx(steps[-1]["area"], rel=1e-9)
    assert steps[1]["groups"].keys() == {"straight"}


def test_a_run_that_is_killed_ends_as_an_undisturbed_one(files):
    files("wear", "wear.yaml", "--output", "whole.h5")
    path = files.folder / "killed.h5"
    for _ in range(3):
        command = [*files.command, "wear", "wear.yaml", "--output", "killed.h5"]
        process = subprocess.Popen(command, cwd=files.folder, env=files.environment, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        until, before = time.monotonic() + 30, path.stat().st_mtime_ns if path.exists() else 0
        while time.monotonic() < until and process.poll() is None and (path.stat().st_mtime_ns if path.exists() else 0) == before:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert files("wear", "wear.yaml", "--output", "killed.h5").code == 0
    assert path.read_bytes() == (files.folder / "whole.h5").read_bytes()


def test_steps_of_another_study_are_left_alone(files):
    assert files("wear", "wear.yaml").code == 0
    files.write("wear.yaml", STUDY.replace("0.005", "0.01"))
    ended = files("wear", "wear.yaml")
    assert ended.code == 2 and "differs in depth" in ended.err and "--fresh begins anew" in ended.err
    assert files("wear", "wear.yaml", "--fresh").code == 0


def test_a_study_that_was_refused_is_in_no_ones_way(files):
    files.write("wear.yaml", STUDY.replace("energy: {", "energie: {"))
    ended = files("wear", "wear.yaml")
    assert ended.code == 4 and "the same command goes on" not in ended.err
    assert "energie is not a field" in ended.err and ended.err.count("INVALID_ARGUMENT") == 1
    files.write("wear.yaml", STUDY)
    assert files("wear", "wear.yaml").code == 0


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (STUDY.replace("source: a test, ", ""), "law has no name or no source"),
        (STUDY.replace("until: 60", ""), "until is missing"),
        (STUDY.replace("until: 60", "until: far"), "until is 'far'; it must be a number"),
        (STUDY.replace("body: lower", "body: upper"), "law.body is upper, and the wheel wears"),
        (STUDY.replace("states.csv", "nothing.csv"), "nothing.csv: No such file"),
        (STUDY + "rate: 1\n", "a study of wear has no rate"),
        (STUDY.replace("depth", "height"), "step has no height"),
    ],
)
def test_a_study_that_cannot_be_meant_is_refused(files, text, sentence):
    files.write("wear.yaml", text)
    ended = files("wear", "wear.yaml")
    assert ended.code == 2 and sentence in ended.err


@pytest.mark.parametrize("option", ["--profiles", "--pictures"])
def test_a_folder_that_cannot_be_is_refused_before_anything_is_solved(files, option):
    ended = files("wear", "wear.yaml", option, "states.csv/worn")
    assert ended.code == 2 and f"{option} states.csv/worn must be the name of a folder, and states.csv is a file" in ended.err
    assert not (files.folder / "wear.yaml.h5").exists()


def test_a_scheduler_without_a_port_is_refused(files):
    pytest.importorskip("distributed")
    ended = files("wear", "wear.yaml", "--dask", "host")
    assert ended.code == 2 and "such as tcp://host:8786" in ended.err


def test_states_without_weight_are_refused(files):
    files.write("states.csv", STATES.replace("weight", "speed"))
    ended = files("wear", "wear.yaml")
    assert ended.code == 2 and "states.csv: states have neither weight nor distance" in ended.err


def test_shares_together_make_the_steps_of_one(files):
    files("wear", "wear.yaml", "--output", "whole.h5")
    command = [*files.command, "wear", "wear.yaml", "--output", "shared.h5", "--longest-wait", "60", "--share"]
    others = [subprocess.Popen([*command, f"{i}/3"], cwd=files.folder, env=files.environment, stderr=subprocess.DEVNULL) for i in (2, 1)]
    try:
        made = files("wear", "wear.yaml", "--output", "shared.h5", "--longest-wait", "60", "--share", "0/3")
        assert made.code == 0, made.err
        assert [process.wait(timeout=60) for process in others] == [0, 0]
    finally:
        for process in others:
            process.kill()
            process.wait()
    for one, other in zip(points(files.folder / "shared.h5"), points(files.folder / "whole.h5"), strict=True):
        np.testing.assert_array_equal(one, other)


def test_a_share_that_is_alone_ends_with_a_sentence(files):
    ended = files("wear", "wear.yaml", "--share", "0/2", "--longest-wait", "1")
    assert ended.code == 7 and "Share 1/2 has not answered for 1 s" in ended.err
    ended = files("wear", "wear.yaml", "--share", "1/2", "--output", "none.h5", "--longest-wait", "1")
    assert ended.code == 7 and "has had no new step for 1 s" in ended.err


def test_profiles_and_pictures_are_written(files):
    pytest.importorskip("matplotlib")
    made = files("wear", "wear.yaml", "--profiles", "worn", "--pictures", "pictures")
    assert made.code == 0, made.err
    folder = files.folder
    sections, _ = points(folder / "wear.yaml.h5")
    for name in ("wheel.prw", "wheel.whl"):
        assert "a test" in (folder / "worn" / name).read_text()
        shown = files("profile", "convert", f"worn/{name}", f"worn/{name}.csv")
        assert shown.code == 0, shown.err
        lines = [line for line in (folder / "worn" / f"{name}.csv").read_text().splitlines() if line[0] in "-0123456789"]
        rows = np.array([[float(number) for number in line.split(",")] for line in lines])
        np.testing.assert_allclose(rows, sections[-1], atol=1e-6)
    assert {path.name for path in (folder / "pictures").iterdir()} == {
        "wheel-worn.png", "wheel-depths.png", "wheel-groups.png", "wheel-wear.gif", "conicity.png", "flange.png", "measures.json",
    }  # fmt: skip


def test_wheel_and_rail_wear_together_from_a_file(files):
    both = STUDY.replace("wears: wheel", "wears: both\npassages_per_km: 20") + "rail_law: {name: r, source: a test, body: upper, range: [0, 10], energy: {coefficient: 0.0006}}\n"
    files.write("both.yaml", both)
    made = files("wear", "both.yaml", "--profiles", "both")
    assert made.code == 0, made.err
    assert {path.name for path in (files.folder / "both").iterdir()} == {"wheel.prw", "wheel.whl", "rail.prr", "rail.ban"}


NOSE = """setup: {wheel: {cone: {slope: -0.05}}, rail_slices: [{x: -500, profile: {arc: {radius: 300}}}, {x: 500, profile: {arc: {radius: 200}}}], track: {rail_origin: {y: 755, z: 0}}, dx: 1, dy: 1}
states: states.csv
law: {name: mild, source: a test, body: upper, range: [0, 10], energy: {coefficient: 0.000675}}
along: {x: [-10, 10, 20], y: [735, 775, 0.5]}
until: 1000000
"""


def test_a_rail_of_slices_has_a_map(files):
    files.write("nose.yaml", NOSE)
    made = files("wear", "nose.yaml", "--json")
    assert made.code == 0, made.err
    (piece,) = made.json["pieces"]
    assert piece["depth"] > 0 and piece["area"] > 0 and 735 < piece["y"] < 775
    with h5py.File(files.folder / "nose.yaml.h5") as file:
        assert file["depths"].shape == (1, 80)
        assert 1e6 * file["depths"][()].max() == pytest.approx(piece["depth"])


@pytest.mark.parametrize(
    ("given", "other", "code", "sentence"),
    [
        ("[-10, 10, 20]", "[10, 0, 2]", 2, "must be [from, to, step]"),
        ("[-10, 10, 20]", "[-.inf, .inf, 20]", 2, "must be [from, to, step]"),
        ("{x: [-10, 10, 20], y: [735, 775, 0.5]}", "{x: [-10, 10, 0.1], y: [735, 775, 0.0005]}", 2, "it may have 10000000"),
        ("[735, 775, 0.5]", "[0.735, 0.775, 0.0005]", 4, "y_edges reach from 0.735 to 0.775 mm, and contacts wear from 7"),
        ("until: 1000000", "until: .inf", 2, "must be a positive number of passages"),
        ("states.csv", "nothing.csv", 2, "nothing.csv: No such file"),
    ],
)
def test_a_map_that_cannot_be_is_refused(files, given, other, code, sentence):
    files.write("nose.yaml", NOSE.replace(given, other))
    ended = files("wear", "nose.yaml")
    assert ended.code == code and sentence in ended.err


def test_a_set_up_of_a_map_is_an_object(files):
    files.write("nose.yaml", "setup: 7\n" + NOSE.split("\n", 1)[1])
    ended = files("wear", "nose.yaml")
    assert ended.code == 2 and "setup is 7; it must be an object" in ended.err


PROGRAM = """
import shutil, sys
from pathlib import Path
folder = Path(sys.argv[-1])
assert (folder / "wheel.prw").is_file()
shutil.copy(folder.parents[1] / "states.csv", folder / "states.csv")
"""
LOOP = STUDY.replace("states: states.csv", "dynamics: {program: [%s, told.py], depth: 0.012, conicity: 1}")


def test_a_program_tells_states_again_when_the_profile_has_changed(files):
    files.write("told.py", PROGRAM)
    files.write("loop.yaml", LOOP % sys.executable)
    made = files("wear", "loop.yaml")
    assert made.code == 0, made.err
    with h5py.File(files.folder / "loop.yaml.h5") as file:
        stages = file["stage"][()]
    assert stages[0] == 0 and stages[-1] >= 1
    assert sorted(path.name for path in (files.folder / "loop.yaml.h5.stages").iterdir())[:2] == ["stage-000", "stage-001"]
    before = points(files.folder / "loop.yaml.h5")[0]
    assert files("wear", "loop.yaml").code == 0
    np.testing.assert_array_equal(points(files.folder / "loop.yaml.h5")[0], before)
    files.write("told.py", "raise SystemExit('no track')")
    ended = files("wear", "loop.yaml", "--fresh")
    assert ended.code != 0 and "no track" in ended.err


def test_states_and_dynamics_do_not_go_together(files):
    files.write("loop.yaml", LOOP % sys.executable + "states: states.csv\n")
    ended = files("wear", "loop.yaml")
    assert ended.code == 2 and "dynamics tell the states" in ended.err


def test_convergence_is_told_against_the_finest(files):
    files.write("coarse.yaml", STUDY.replace("dx: 0.8, dy: 0.8", "dx: 1.2, dy: 1.2").replace("until: 60", "until: 10"))
    made = files("wear", "coarse.yaml", "--convergence", "--json")
    assert made.code == 0, made.err
    found = {one["name"]: one for one in made.json["variants"]}
    assert found["finest"]["difference"] == 0
    assert found["elements half as large"]["difference"] < found["elements twice as large"]["difference"]
    assert not (files.folder / "coarse.yaml.h5").exists()


@pytest.mark.slow  # starts a cluster
def test_states_are_solved_by_a_dask_cluster(files):
    pytest.importorskip("distributed")
    files("wear", "wear.yaml", "--output", "whole.h5")
    scheduler = files.start_python("from distributed import LocalCluster", "import sys",
                                   "cluster = LocalCluster(n_workers=1, threads_per_worker=2, processes=False, dashboard_address=None, protocol='tcp', host='127.0.0.1')",
                                   "print(cluster.scheduler_address, flush=True)", "sys.stdin.read()", "cluster.close()")  # fmt: skip
    with scheduler:
        address = scheduler.stdout.readline().strip()
        made = files("wear", "wear.yaml", "--output", "dask.h5", "--dask", address)
        scheduler.communicate("", timeout=60)
    assert made.code == 0, made.err
    assert (files.folder / "dask.h5").read_bytes() == (files.folder / "whole.h5").read_bytes()
    ended = files("wear", "wear.yaml", "--dask", address, "--share", "0/2")
    assert ended.code == 2 and "take one of them" in ended.err
