"""Tests studies: their meaning, and that rows are neither lost nor duplicated however the process ends."""

import csv
import json
import random
import resource
import signal
import time
import zlib

import numpy as np
import pytest

from contactctl.codes import Ended
from contactctl.study.journal import Journal
from contactd import Client
from support.daemons import eventually

STUDY = """\
problem: contact.yaml
vary:
  friction.mu: [0.1, 0.4]
  approach: {from: 0.005, to: 0.02, count: 3}
answers: [forces.Fn, forces.Fx, converged]
"""


def test_rows_are_what_single_solves_answer(ctl):
    ctl.write("study.yaml", STUDY)
    rows = ctl("study", "study.yaml", "--json").json["rows"]
    assert [(row["values"]["friction.mu"], row["values"]["approach"]) for row in rows] == [
        (mu, approach) for mu in (0.1, 0.4) for approach in (0.005, 0.0125, 0.02)
    ]
    for row in rows[::5]:
        sets = [f"--set={path}={value}" for path, value in row["values"].items()]
        alone = ctl("solve", "contact.yaml", "--json", "--fields", "none", *sets).json
        assert row["answers"] == {"forces.Fn": alone["forces"]["Fn"], "forces.Fx": alone["forces"]["Fx"], "converged": True}


def test_rows_that_are_there_are_not_solved_again(own):
    own.write("study.yaml", STUDY)
    with Client(own.endpoint) as client:
        first = own("study", "study.yaml", "--json").json
        assert own("study", "study.yaml", "--json").json == first
        assert client.info().counters["solves"] == 6
        own.write("study.yaml", STUDY.replace("[0.1, 0.4]", "[0.1, 0.4, 0.3]"))
        assert len(own("study", "study.yaml", "--json").json["rows"]) == 9
        assert client.info().counters["solves"] == 9, "a study that grows keeps its rows"
        own("study", "study.yaml", "--fresh")
        assert client.info().counters["solves"] == 18


def test_fields_move_together_and_by_logarithms(ctl):
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {approach: {from: 1e-3, to: 1e-1, count: 3, scale: log}}\n"
                            "together: {grid.nx: [20, 10], grid.ny: [20, 10]}\nanswers: [converged]\n")  # fmt: skip
    values = [list(row["values"].values()) for row in ctl("study", "study.yaml", "--json").json["rows"]]
    assert [row[1:] for row in values] == [[20, 20], [10, 10]] * 3
    assert [row[0] for row in values[::2]] == pytest.approx([1e-3, 1e-2, 1e-1])


def test_arrays_that_vary_are_named_in_their_rows(ctl):
    x = (np.arange(20) - 9.5) * 0.12
    for number in (1, 2):
        np.save(ctl.folder / f"gap{number}.npy", (x[:, None] ** 2 + x**2) / 100 * number)
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {gap: [{array: {$file: gap1.npy}}, {array: {$file: gap2.npy}}]}\nanswers: [forces.Fn]\n")
    first, second = ctl("study", "study.yaml", "--json").json["rows"]
    assert first["values"] == {"gap": {"array": {"$file": "gap1.npy"}}}
    assert first["answers"]["forces.Fn"] == pytest.approx(ctl("solve", "contact.yaml", "--json").json["forces"]["Fn"], rel=1e-9)
    assert second["answers"] != first["answers"]
    np.save(ctl.folder / "gap2.npy", (x[:, None] ** 2 + x**2) / 100 * 3)
    assert ctl("study", "study.yaml", "--json").json["rows"][1]["answers"] != second["answers"], "the file is another one now"
    assert "gap2.npy" in ctl("study", "study.yaml").out


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("vary: {friction.mu: [0.1, 0.2, 0.3]}\nanswers: [forces.Fm, pmax]\n", "answers has forces.Fm, which the answer does not have; it has approach,"),
        ("vary: {friction.nu: [0.1, 0.2, 0.3]}\n", "vary has friction.nu, which is not a field of friction; known fields are duration,"),
    ],
)
def test_a_name_that_is_of_no_row_stops_the_study_after_its_first_row(own, text, sentence):
    own.write("study.yaml", f"problem: contact.yaml\n{text}")
    ended = own("study", "study.yaml", "--workers", "1")
    assert ended.code == 2
    assert sentence in ended.err
    assert "0 of 3 rows are in study.yaml.rows; repeat the command to continue." in ended.err
    with Client(own.endpoint) as client:
        assert client.info().counters["solves"] <= 1


def test_an_answer_that_some_rows_have_stops_nothing(ctl):
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {friction.mu: [0.1]}\nanswers: [derivatives, 'motion.rigid_shift[0]', evidence.tangential.iterations]\n")
    ended = ctl("study", "study.yaml")
    assert (ended.code, ended.err) == (0, "warning: no answer has derivatives\n")


def test_youngs_modulus_stands_in_for_the_shear_modulus(ctl):
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {bodies.upper: [{G: 200, nu: 0.42}, {E: 568, nu: 0.42}]}\nanswers: [forces.Fn]\n")
    first, second = ctl("study", "study.yaml", "--json").json["rows"]
    assert second["answers"]["forces.Fn"] == pytest.approx(first["answers"]["forces.Fn"], rel=1e-12)
    twice = ctl("solve", "contact.yaml", "--set", "bodies.upper.E=568")
    assert twice.code == 2
    assert "bodies.upper.E cannot be combined with G" in twice.err


def test_a_range_by_steps_has_its_end(ctl):
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {friction.mu: {from: 0.1, to: 0.3, step: 0.1}}\n")
    assert [row["values"]["friction.mu"] for row in ctl("study", "study.yaml", "--json").json["rows"]] == pytest.approx([0.1, 0.2, 0.3])


def test_wheels_on_rails_are_studied(ctl):
    ctl.write("study.yaml", "method: wheelrail.solve\nproblem: {setup: {dx: 0.8, dy: 0.8}, state: {Fz: 60e3}}\nvary: {state.position.y: [0, 3]}\n")
    rows = ctl("study", "study.yaml", "--json").json["rows"]
    assert [row["answers"]["forces.track.Fz"] for row in rows] == pytest.approx([60e3, 60e3], rel=1e-4)


def test_all_rows_go_to_a_csv_file(ctl):
    ctl.write("study.yaml", STUDY)
    shown = ctl("study", "study.yaml", "--csv", "rows.csv")
    assert "6 rows: 6 done" in shown.out
    with open(ctl.folder / "rows.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 6
    assert float(rows[5]["forces.Fn"]) == ctl("study", "study.yaml", "--json").json["rows"][5]["answers"]["forces.Fn"]


def test_a_row_that_fails_is_a_row_and_an_exit_code(ctl):
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {bodies.upper.nu: [0.3, 0.7]}\n")
    ended = ctl("study", "study.yaml", "--json")
    assert ended.code == 4
    assert [row["code"] for row in ended.json["rows"]] == [0, 4]
    assert "bodies.upper.nu" in ended.json["rows"][1]["error"]
    ctl.write("rough.yaml", 'problem: contact.yaml\nvary: {settings.tangential: [{"max_iterations": 1}, {}]}\n')
    ended = ctl("study", "rough.yaml", "--json")
    assert (ended.code, [row["code"] for row in ended.json["rows"]]) == (5, [5, 0])
    assert ctl("study", "rough.yaml", "--retry").code == 5


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("vary: {approach: [1]}", "lacks problem"),
        ("problem: contact.yaml", "lacks vary"),
        ("problem: contact.yaml\nvary: {approach: 3}", "the values of approach must be a list"),
        ("problem: contact.yaml\nvary: {approach: {from: 1, to: x, count: 3}}", "finite numbers"),
        ("problem: contact.yaml\nvary: {approach: {from: 1, to: 1" + 400 * "0" + ", count: 3}}", "finite numbers"),
        ("problem: contact.yaml\nvary: {approach: {from: 1, to: 2}}", "either count or"),
        ("problem: contact.yaml\nvary: {approach: {from: 0, to: 2, count: 3, scale: log}}", "between positive numbers"),
        ("problem: contact.yaml\nvary: {approach: {from: 0, to: 2, step: -1}}", "does not lead from 0 to 2"),
        ("problem: contact.yaml\nvary: {approach: {from: 0, to: 2, count: 0}}", "count of approach"),
        ("problem: contact.yaml\nvary: {approach: [1, 1]}", "has a row twice"),
        ("problem: contact.yaml\nvary: {approach: [1, .nan]}", "the values of approach must be valid in JSON; every number must be finite"),
        ("problem: contact.yaml\nvary: {approach: [!!binary aGk=]}", "the values of approach must be valid in JSON"),
        ("problem: contact.yaml\nvary: {approach: {from: -1e308, to: 1e308, count: 3}}", "which is too large a range"),
        ("problem: contact.yaml\nvary: {gap.array: [{$file: nowhere.npy}]}", "nowhere.npy, which cannot be read"),
        ("problem: contact.yaml\nvary: {approach.x: [1, 2]}", "approach.x cannot be set"),
        ("problem: contact.yaml\nvary: {a: [1]}\ntogether: {a: [1]}", "a is in both vary and together"),
        ("problem: contact.yaml\ntogether: {a: [1], b: [1, 2]}", "different numbers of values"),
        ("problem: contact.yaml\nvary: {approach: {from: 0, to: 1, count: 1000000}, Fn: [1, 2]}", "more than 1000000 rows"),
        ("problem: contact.yaml\nmethod: ic.get\nvary: {a: [1]}", "method is 'ic.get'"),
        ("problem: contact.yaml\nanswers: 3\nvary: {a: [1]}", "answers must be a list"),
        ("problem: contact.yaml\nvery: {a: [1]}", "has 'very'"),
    ],
)
def test_a_study_that_cannot_be_meant_is_refused_before_anything_is_solved(lonely, text, sentence):
    lonely.write("study.yaml", text)
    ended = lonely("study", "study.yaml")
    assert (ended.code, ended.out) == (2, "")
    assert sentence in ended.err


@pytest.mark.slow  # 2000 rows, begun four times
@pytest.mark.timeout(240)
def test_a_study_that_is_killed_three_times_has_every_row_once(own):
    # There are so many elements that even a fast machine does not finish all rows between two checks.
    own.write("fine.yaml", (own.folder / "contact.yaml").read_text().replace("{nx: 20, ny: 20, dx: 0.12, dy: 0.12}",
                                                                              "{nx: 100, ny: 100, dx: 0.024, dy: 0.024}"))  # fmt: skip
    own.write("study.yaml", "problem: fine.yaml\nvary:\n  approach: {from: 1e-3, to: 2e-2, count: 500}\n"
                            "  friction.mu: [0.1, 0.2, 0.3, 0.4]\nanswers: [forces.Fn, forces.Fx]\n")  # fmt: skip
    rows = own.folder / "study.yaml.rows"

    def count():
        return rows.read_bytes().count(b"\n") if rows.exists() else 0

    seen = [0]
    for _ in range(3):
        goal = seen[-1] + 300
        with own.start("study", "study.yaml", "--workers", 2) as running:
            eventually(lambda: count() >= goal or running.poll() is not None, seconds=60)  # noqa: B023
            time.sleep(random.random() / 10)
            running.send_signal(signal.SIGKILL)
            running.communicate(timeout=30)
            assert running.returncode == -signal.SIGKILL
        seen.append(count())
        assert seen[-2] < seen[-1] < 2000, "it was killed on its way"
    ended = own("study", "study.yaml", "--json", "--workers", 2)
    assert ended.code == 0
    assert f"{seen[-1]} of 2000 rows" in ended.err
    found = [json.loads(line.partition(" ")[2]) for line in rows.read_text().splitlines()]
    values = {(row["values"]["approach"], row["values"]["friction.mu"]) for row in found}
    assert len(found) == len(values) == len(ended.json["rows"]) == 2000
    for row in ended.json["rows"]:
        assert abs(row["answers"]["forces.Fx"]) <= row["values"]["friction.mu"] * row["answers"]["forces.Fn"] * (1 + 1e-9)


def test_a_daemon_that_comes_back_ends_no_study(daemons, own):
    daemon = daemons.start("mortal")
    own.write("study.yaml", "problem: contact.yaml\nvary: {approach: {from: 1e-3, to: 2e-2, count: 2000}}\n")
    with own.start("study", "study.yaml", "-e", daemon.endpoint, "--json") as running:
        with daemon.client() as client:
            eventually(lambda: client.info().counters["solves"] > 50)
        daemon.kill()
        daemons.start("mortal")
        out, err = running.communicate(timeout=60)
    assert running.returncode == 0, err
    assert len(json.loads(out)["rows"]) == 2000


@pytest.mark.slow  # waits until the client abandons the daemon, and solves 2000 rows
def test_a_daemon_that_stays_away_ends_it_with_3_and_keeps_its_rows(daemons, own):
    daemon = daemons.start("mortal")
    own.write("study.yaml", "problem: contact.yaml\nvary: {approach: {from: 1e-3, to: 2e-2, count: 2000}}\n")
    with own.start("study", "study.yaml", "-e", daemon.endpoint) as running:
        with daemon.client() as client:
            eventually(lambda: client.info().counters["solves"] > 50)
        daemon.kill()
        _, err = running.communicate(timeout=60)
    assert running.returncode == 3, err
    assert "repeat the command to continue" in err
    assert own("study", "study.yaml").code == 0


def test_two_runs_of_one_study_do_not_meet(own):
    own.write("study.yaml", "problem: contact.yaml\nvary: {approach: {from: 1e-3, to: 2e-2, count: 20000}}\n")
    with own.start("study", "study.yaml") as first:
        eventually((own.folder / "study.yaml.rows").exists)
        eventually(lambda: (own.folder / "study.yaml.rows").stat().st_size > 0)
        ended = own("study", "study.yaml")
        assert (ended.code, "belongs to a running study" in ended.err) == (2, True)
        first.send_signal(signal.SIGTERM)
        first.communicate(timeout=30)
    assert first.returncode == 143


@pytest.mark.parametrize("words", [["--local"], ["--local", "--workers", "1"]])
def test_a_study_runs_without_a_daemon(lonely, words):
    lonely.write("study.yaml", STUDY)
    assert "6 rows: 6 done" in lonely("study", "study.yaml", *words).out


@pytest.mark.slow  # starts a cluster
def test_a_study_runs_on_a_dask_cluster(own):
    own.write("study.yaml", STUDY)
    pytest.importorskip("distributed")
    scheduler = own.start_python("from distributed import LocalCluster", "import sys",
                                 "cluster = LocalCluster(n_workers=1, threads_per_worker=2, processes=False, dashboard_address=None, protocol='tcp', host='127.0.0.1')",
                                 "print(cluster.scheduler_address, flush=True)", "sys.stdin.read()", "cluster.close()")  # fmt: skip
    with scheduler:
        address = scheduler.stdout.readline().strip()
        by_dask = own.alone("study", "study.yaml", "--dask", address, "--json")
        folder = own.folder / "tables"
        alone = own.alone("study", "study.yaml", "--dask", address, "--local", "--folder", folder, "--rows", "local.rows", "--json")
        assert (folder / "store").is_dir(), "tables lie where the command says, not in a folder that goes with the worker"
        scheduler.communicate("", timeout=60)
    assert by_dask.code == 0, by_dask.err
    here = own("study", "study.yaml", "--rows", "here.rows", "--json").json["rows"]
    for rows in (by_dask.json["rows"], alone.json["rows"]):
        assert [row["answers"] for row in rows] == [row["answers"] for row in here]


def row(key):
    return {"key": key, "values": {"x": 1.5}, "code": 0, "answers": {}}


def test_a_journal_cut_at_any_byte_loses_no_whole_row(tmp_path):
    path = tmp_path / "rows"
    with Journal(path) as journal:
        for key in "abc":
            journal.add(row(key))
    whole = path.read_bytes()
    ends = [index + 1 for index, byte in enumerate(whole) if byte == 10]
    for cut in range(len(whole) + 1):
        path.write_bytes(whole[:cut])
        with Journal(path) as journal:
            assert len(journal.rows) == sum(end <= cut for end in ends)
            for key in "abc":
                journal.add(row(key))
        assert path.read_bytes() == whole


def test_a_row_for_which_there_is_no_room_leaves_no_part(tmp_path):
    path = tmp_path / "rows"
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    with Journal(path) as journal:
        journal.add(row("a"))
        whole = path.read_bytes()
        resource.setrlimit(resource.RLIMIT_FSIZE, (len(whole) + 10, before[1]))
        try:
            with pytest.raises(OSError, match="File too large"):
                journal.add(row("b"))
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, before)
        assert path.read_bytes() == whole
        journal.add(row("b"))
    with Journal(path) as journal:
        assert list(journal.rows) == ["a", "b"]


def test_a_damaged_row_is_solved_again(tmp_path, capsys):
    path = tmp_path / "rows"
    with Journal(path) as journal:
        for key in "abc":
            journal.add(row(key))
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(lines[0] + lines[1].replace(b"1.5", b"2.5") + lines[2])
    with Journal(path) as journal:
        assert list(journal.rows) == ["a", "c"]
    assert "1 damaged lines" in capsys.readouterr().err


@pytest.mark.parametrize(
    "text",
    [b"[" * 100_000, b'{"key": []}', b'{"key": "a"}', b'{"key": "a", "code": 0, "values": {}, "answers": 1}', b"\xff", b"1" * 5000],
    ids=["deep", "a list as a key", "no values", "answers that are none", "no text", "long"],
)
def test_a_row_that_is_none_is_damaged_whatever_its_checksum_says(tmp_path, text):
    path = tmp_path / "rows"
    path.write_bytes(b"%08x %s\n" % (zlib.crc32(text), text))
    with pytest.raises(Ended, match="is not a file with rows of a study"):
        Journal(path)


def test_a_file_of_something_else_is_left_alone(tmp_path):
    path = tmp_path / "rows"
    path.write_text("the notes of a year\n")
    with pytest.raises(Ended, match="is not a file with rows of a study"):
        Journal(path)
    assert path.read_text() == "the notes of a year\n"
