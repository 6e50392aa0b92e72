"""Tests shares of a study: together they form the study, also after kills and with another number of shares."""

import json
import random
import signal
import time

import pytest

from contactd import Client
from support.daemons import eventually

STUDY = """\
problem: contact.yaml
vary:
  friction.mu: [0.1, 0.4]
  approach: {from: 0.005, to: 0.02, count: 5}
answers: [forces.Fn, forces.Fx, converged]
"""


def solves(ctl):
    with Client(ctl.endpoint) as client:
        return client.info().counters["solves"]


def keys(path):
    return [json.loads(line.partition(" ")[2])["key"] for line in path.read_text().splitlines()]


def test_shares_solve_each_row_once_and_the_study_finds_them(own):
    own.write("study.yaml", STUDY)
    sizes = [len(own("study", "study.yaml", "--share", f"{index}/3", "--json").json["rows"]) for index in range(3)]
    assert sizes == [4, 3, 3]
    assert solves(own) == 10
    ended = own("study", "study.yaml", "--json")
    assert "10 of 10 rows are in study.yaml.rows and beside it." in ended.err
    assert solves(own) == 10
    own("study", "study.yaml", "--rows", "alone", "--json")
    alone = own("study", "study.yaml", "--rows", "alone", "--json").json
    assert [row["answers"] for row in ended.json["rows"]] == [row["answers"] for row in alone["rows"]]


def test_another_number_of_shares_keeps_what_is_there(own):
    own.write("study.yaml", STUDY)
    own("study", "study.yaml", "--share", "1/2")
    assert solves(own) == 5
    for index in range(4):
        own("study", "study.yaml", "--share", f"{index}/4")
    assert solves(own) == 10
    assert len(own("study", "study.yaml", "--json").json["rows"]) == 10
    own("study", "study.yaml", "--fresh")
    assert solves(own) == 20


def test_a_row_that_failed_in_its_share_is_tried_again_where_one_likes(own):
    own.write("study.yaml", "problem: contact.yaml\nvary: {bodies.upper.nu: [0.3, 0.7]}\n")
    assert own("study", "study.yaml", "--share", "1/2").code == 4
    assert own("study", "study.yaml").code == 4
    assert len(keys(own.folder / "study.yaml.rows")) == 1
    assert own("study", "study.yaml", "--retry").code == 4
    assert len(keys(own.folder / "study.yaml.rows")) == 2


def test_a_study_waits_for_its_shares(own):
    own.write("study.yaml", "problem: endless.json\nvary: {approach: [0.02, 0.021]}\n")
    with own.start("study", "study.yaml", "--share", "0/2") as running, Client(own.endpoint) as client:
        eventually(lambda: client.info().queue["solves_running"] == 1)
        ended = own("study", "study.yaml")
        running.kill()
        running.communicate()
    assert ended.code == 2
    assert "study.yaml.rows.0-of-2 belongs to a running share" in ended.err


@pytest.mark.parametrize("share", ["1", "2/2", "-1/2", "1/0", "a/b", "1/2/3", "0.5/2"])
def test_a_share_that_there_is_not_is_refused(lonely, share):
    lonely.write("study.yaml", STUDY)
    ended = lonely("study", "study.yaml", f"--share={share}")
    assert ended.code == 2
    assert "it must be INDEX/COUNT with INDEX below COUNT" in ended.err


@pytest.mark.parametrize("option", ["--csv", "--hdf5"])
def test_a_share_writes_no_table(lonely, option):
    lonely.write("study.yaml", STUDY)
    ended = lonely("study", "study.yaml", "--share", "0/2", option, "all")
    assert ended.code == 2
    assert f"{option} requires all rows" in ended.err
    ended = lonely("study", "study.yaml", option, "no/where")
    assert f"{option} no/where: there is no folder no." in ended.err


@pytest.mark.slow  # 6000 rows, begun four times
@pytest.mark.timeout(240)
def test_two_shares_that_are_killed_three_times_have_every_row_once(lonely):
    lonely.write("study.yaml", "problem: contact.yaml\nvary:\n  approach: {from: 1e-3, to: 2e-2, count: 1500}\n"
                               "  friction.mu: [0.1, 0.2, 0.3, 0.4]\nanswers: [forces.Fn, forces.Fx]\n")  # fmt: skip
    lonely.environment["TMPDIR"] = str(lonely.folder)  # a killed process leaves the folder of its tables
    files = [lonely.folder / f"study.yaml.rows.{index}-of-2" for index in range(2)]

    def count():
        return sum(file.read_bytes().count(b"\n") for file in files if file.exists())

    seen = [0]
    for _ in range(3):
        tasks = [lonely.start("--local", "study", "study.yaml", "--share", f"{index}/2", "--workers", 1) for index in range(2)]
        eventually(lambda: count() > seen[-1], seconds=60)
        time.sleep(random.random() / 10)
        for task in tasks:
            task.send_signal(signal.SIGKILL)
            task.communicate(timeout=30)
        seen.append(count())
        assert seen[-2] < seen[-1] < 6000, "they were killed on their way"
    for index in range(2):
        assert lonely("--local", "study", "study.yaml", "--share", f"{index}/2").code == 0
    ended = lonely("--local", "study", "study.yaml", "--json")
    found = [key for file in files for key in keys(file)]
    assert len(found) == len(set(found)) == len(ended.json["rows"]) == 6000
    for row in ended.json["rows"]:
        assert abs(row["answers"]["forces.Fx"]) <= row["values"]["friction.mu"] * row["answers"]["forces.Fn"] * (1 + 1e-9)
