"""Tests wear: worn profiles, from files to a file."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from contactd.wear import read_record

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


def test_a_step_says_why_it_ended_and_a_line_the_depth_of_all(files):
    files.write("wear.yaml", STUDY.replace("0.8", "0.5").replace("0.005", "0.02").replace("until: 60", "until: 100"))
    shown = files("wear", "wear.yaml")
    assert (shown.code, shown.err) == (0, "")
    told = files("wear", "wear.yaml", "--json").json
    assert [step["ended_by"] for step in told["steps"]] == ["", *(len(told["steps"]) - 2) * ["stability"], "until"]
    assert all(step["depth"] < 0.02 for step in told["steps"])
    steps = read_record(files.folder / "wear.yaml.h5")
    total = told["total"]["wheel"]
    # Returns depths of steps along the normals; where one is largest no other one is deeper.
    assert max(step.depths.max() for step in steps[1:]) < total["depth"] <= sum(step.depths.max() for step in steps[1:]) * (1 + 1e-6)
    assert f"After 100 km the wheel is worn by up to {total['depth']:.4g} mm, at y = {total['y']:.2f} mm" in shown.out
    assert f"{len(steps) - 2} of {len(steps) - 1} steps limited by stability: they are less deep than step.depth = 0.02 mm" in shown.out


def test_steps_that_are_as_deep_as_asked_say_so(files):
    for step, bound in (("{depth: 0.001}", "depth"), ("{depth: 0.5, distance: 2}", "distance")):
        files.write("wear.yaml", STUDY.replace("step: {depth: 0.005}", f"step: {step}\nsmoothing: 0").replace("until: 60", "until: 5"))
        _, *told, last = files("wear", "wear.yaml", "--fresh", "--json").json["steps"]
        assert told and {one["ended_by"] for one in told} == {bound} and last["ended_by"] == "until"
        if bound == "depth":
            assert [one["depth"] for one in told] == pytest.approx([0.001] * len(told), rel=1e-9)
        else:
            assert [one["km"] for one in told] == [2, 4]
        assert "limited by stability" not in files("wear", "wear.yaml").out


def test_warnings_of_steps_name_states(files):
    files.write("wear.yaml", STUDY.replace("dx: 0.8, dy: 0.8", "dx: 1.6, dy: 1.6").replace("until: 60", "until: 20"))
    ended = files("wear", "wear.yaml")
    lines = [line for line in ended.err.splitlines() if line.startswith("warning: ")]
    assert lines and all(re.match(r"warning: steps? [0-9, and]+: states\[[01]\](, states\[1\])?: ", line) for line in lines), ended.err
    assert len(lines) == len(set(lines))
    # They are recorded, so that a resumed run repeats them.
    assert files("wear", "wear.yaml").err == ended.err


def test_laws_take_lists_as_python_has_them(files):
    usfd = "usfd: {pieces: [%s], density: 7850}"
    listed = STUDY.replace("energy: {coefficient: 0.000675}", usfd % "[0, 0, 5.3], [10.4, 55, 0]").replace("range: [0, 10]", "range: [0, 77], zones: [[-0.8, 0.1], [-0.7, 1]]")
    spelled = listed.replace("[0, 0, 5.3], [10.4, 55, 0]", "{from: 0, value: 0, slope: 5.3}, {from: 10.4, value: 55, slope: 0}")
    spelled = spelled.replace("[[-0.8, 0.1], [-0.7, 1]]", "[{angle: -0.8, factor: 0.1}, {angle: -0.7, factor: 1}]")
    tired = "\nfatigue: {body: lower, damages: [{name: ours, source: a test, range: [0, 200], pieces: [%s]}], passage: {residual: [%s]}}\n"
    files.write("lists.yaml", listed + tired % ("[0, 0, 0], [20, 0, 2.0e-7]", "[0, -200, -150], [5, 50, 0]"))
    files.write("objects.yaml", spelled + tired % ("{from: 0, value: 0, slope: 0}, {from: 20, value: 0, slope: 2.0e-7}", "{depth: 0, xx: -200, yy: -150}, {depth: 5, xx: 50, yy: 0}"))
    for name in ("lists", "objects"):
        ended = files("wear", f"{name}.yaml", "--json")
        assert ended.code == 0, ended.err
    assert (files.folder / "lists.yaml.h5").read_bytes() == (files.folder / "objects.yaml.h5").read_bytes()


def test_the_study_of_the_page_warns_of_nothing(files):
    page = (Path(__file__).parents[4] / "docs" / "contactctl.md").read_text()
    for name in ("wear.yaml", "states.csv"):
        (text,) = re.findall(rf"^```(?:yaml\n# |text\n% ){re.escape(name)}\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
        files.write(name, text)
    shown = files("wear", "wear.yaml")
    assert (shown.code, shown.err) == (0, "")
    number = r"-?[0-9]+(?:\.[0-9]+)?"
    (expected,), (found,) = (re.findall(r"^ *(After 100 km .*)$", text, re.MULTILINE) for text in (page, shown.out))
    assert re.sub(number, "N", found) == re.sub(number, "N", expected)
    assert [float(one) for one in re.findall(number, found)] == pytest.approx([float(one) for one in re.findall(number, expected)], rel=0.02)


def test_the_law_of_the_page_is_taken(files):
    page = (Path(__file__).parents[4] / "docs" / "damage.md").read_text()
    (law,) = re.findall(r"^```yaml\n# law.yaml\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    files.write("wear.yaml", re.sub("law: .*\n", law, STUDY).replace("until: 60", "until: 10"))
    ended = files("wear", "wear.yaml", "--json")
    assert ended.code == 0, ended.err
    (damages,) = {tuple(step.fatigue.damages) for step in read_record(files.folder / "wear.yaml.h5")[1:]}
    assert damages == ("ours",)


def test_lists_of_laws_are_taken_wherever_a_problem_has_them(files):
    laws = "{laws: [{name: usfd, source: a test, body: upper, range: [0, 77], usfd: {pieces: [%s], density: 7850}}]}"
    problem = "{setup: {dx: 0.8, dy: 0.8, wear: %s, bodies: {upper: {E: 210000, nu: 0.28}}}, state: {Fz: 60e3, position: {y: 3}, velocity: {x: 20000, pitch: -43.478}}, fields: []}"
    found = []
    for pieces in ("[0, 0, 5.3]", "{from: 0, value: 0, slope: 5.3}"):
        files.write("rail.yaml", problem % (laws % pieces))
        found.append(files("wheelrail", "solve", "rail.yaml", "--json").json["patches"][0]["solution"]["wear"])
    assert found[0] == found[1]
    refused = files("wheelrail", "solve", "rail.yaml", "--set", 'setup.wear={"laws": [{"br": {"pieces": [[1]]}}]}')
    assert refused.code == 2 and "setup.wear.laws[0].br.pieces[0] has 1 numbers; it must have 3" in refused.err


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
    assert ended.code == 2 and "differs in depth" in ended.err and "--fresh to start anew" in ended.err
    assert files("wear", "wear.yaml", "--fresh").code == 0


def test_a_study_that_was_refused_is_in_no_ones_way(files):
    files.write("wear.yaml", STUDY.replace("energy: {", "energie: {"))
    ended = files("wear", "wear.yaml")
    assert ended.code == 4 and "repeat the command to continue" not in ended.err
    assert "energie is not a field" in ended.err and ended.err.count("INVALID_ARGUMENT") == 1
    files.write("wear.yaml", STUDY)
    assert files("wear", "wear.yaml").code == 0


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (STUDY.replace("source: a test, ", ""), "law has no name or no source"),
        (STUDY.replace("until: 60", ""), "until is missing"),
        (STUDY.replace("until: 60", "until: far"), "until is 'far'; it must be a number"),
        (STUDY.replace("body: lower", "body: upper"), "law.body is upper, but the wheel wears"),
        (STUDY.replace("states.csv", "nothing.csv"), "nothing.csv: No such file"),
        (STUDY + "rate: 1\n", "a study of wear has no rate"),
        (STUDY + "smothing: auto\n", "Did you mean smoothing?"),
        (STUDY.replace("depth", "height"), "step has no height"),
        (STUDY.replace("depth", "dept"), "Did you mean depth?"),
        (STUDY.replace("energy: {coefficient: 0.000675}", "br: {pieces: [[0, 1]]}"), "law.br.pieces[0] has 2 numbers; it must have 3: from, value, slope"),
    ],
)
def test_a_study_that_cannot_be_meant_is_refused(files, text, sentence):
    files.write("wear.yaml", text)
    ended = files("wear", "wear.yaml")
    assert ended.code == 2 and sentence in ended.err


@pytest.mark.parametrize("option", ["--profiles", "--pictures"])
def test_a_folder_that_cannot_be_is_refused_before_anything_is_solved(files, option):
    ended = files("wear", "wear.yaml", option, "states.csv/worn")
    assert ended.code == 2 and f"{option} states.csv/worn must be the name of a folder, but states.csv is a file" in ended.err
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
        ("{x: [-10, 10, 20], y: [735, 775, 0.5]}", "{x: [-10, 10, 0.1], y: [735, 775, 0.0005]}", 2, "at most 10000000 are allowed"),
        ("[735, 775, 0.5]", "[0.735, 0.775, 0.0005]", 4, "y_edges reach from 0.735 to 0.775 mm, but contacts wear from 7"),
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
    made = files("wear", "loop.yaml", "--allow-program")
    assert made.code == 0, made.err
    with h5py.File(files.folder / "loop.yaml.h5") as file:
        stages = file["stage"][()]
    assert stages[0] == 0 and stages[-1] >= 1
    assert sorted(path.name for path in (files.folder / "loop.yaml.h5.stages").iterdir())[:2] == ["stage-000", "stage-001"]
    before = points(files.folder / "loop.yaml.h5")[0]
    assert files("wear", "loop.yaml", "--allow-program").code == 0
    np.testing.assert_array_equal(points(files.folder / "loop.yaml.h5")[0], before)
    files.write("told.py", "raise SystemExit('no track')")
    ended = files("wear", "loop.yaml", "--allow-program", "--fresh")
    assert ended.code != 0 and "no track" in ended.err


def test_states_and_dynamics_do_not_go_together(files):
    files.write("loop.yaml", LOOP % sys.executable + "states: states.csv\n")
    ended = files("wear", "loop.yaml", "--allow-program")
    assert ended.code == 2 and "dynamics computes the states" in ended.err


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
    assert ended.code == 2 and "use one of them" in ended.err
