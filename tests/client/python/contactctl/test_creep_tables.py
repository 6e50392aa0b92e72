"""Tables of creep forces: built in rows that survive any end of the process, and compared with solves."""

import json
import zlib

import numpy as np
import pytest

import contactd
from contactctl.table.checking import random_states
from contactctl.table.extension import read_table, table_nodes
from contactctl.table.nodes import extrapolated
from contactctl.table.plan import TablePlan
from support.daemons import eventually

NOWHERE = {"CONTACTD_ENDPOINT": ""}
SMALL = ("--ratios", "0.7", "1.4", "--cells", "4", "8", "4", "8", "--grids", "8", "16")
PLAN = TablePlan((0.28,), (0.7, 1.4), (4, 8, 4, 8), (8, 16))

pytest.importorskip("contactd_local")


def built(ctl, name, *words):
    ended = ctl("table", "build", name, *SMALL, *words, "--json", **NOWHERE)
    assert ended.code == 0, ended.err
    return ended.json


def lines(path):
    return path.read_text().splitlines() if path.exists() else []


def kill_after(ctl, words, rows, count):
    """Kills the command when its file has so many rows, unless it has ended."""
    with ctl.start(*words) as running:
        eventually(lambda: len(lines(rows)) >= count or running.poll() is not None)
        running.kill()
        running.communicate()


def test_a_table_holds_the_extrapolated_solves_at_its_nodes(lonely):
    assert built(lonely, "small.creep") == {"file": "small.creep", "rows": 45, "nodes": 45 * 35, "unconverged": 0}
    row = PLAN.rows[2 * 9 + 3]
    ratio, creepages = table_nodes(PLAN, row)
    assert ratio == pytest.approx(np.sqrt(0.7 * 1.4))
    states = np.column_stack([np.full(35, ratio), creepages])
    nu, described, forces = read_table(lonely.folder / "small.creep", None, states)
    assert (nu, described["nodes"], described["fallback"], described["statement"]) == (0.28, 1575, 0, None)
    stored = next(json.loads(line[9:]) for line in lines(lonely.folder / "small.creep.rows") if row.key in line)
    assert forces.ravel() == pytest.approx(stored["answers"]["forces"], abs=2e-5)


def test_a_node_is_extrapolated_from_two_grids():
    states = np.array([[1.2, 0.1, -0.2, 0.15]])
    with contactd.local(in_process=True) as client:
        found, converged = extrapolated(client, states, 0.28, (16, 30))
        finer, _ = extrapolated(client, states, 0.28, (36, 72))
    assert converged.all()
    assert found == pytest.approx(finer, abs=4e-3)
    assert (found[0, :2] * [1, -1] > 0).all(), "forces have the sign of the creepages"


def test_shares_that_are_killed_make_the_same_bytes(lonely):
    built(lonely, "alone.creep", "--workers", 1)
    lonely.environment["CONTACTD_ENDPOINT"] = ""
    for index in range(3):
        rows = lonely.folder / f"shared.creep.rows.{index}-of-3"
        words = ("table", "build", "shared.creep", *SMALL, "--share", f"{index}/3", "--workers", "1")
        for kills in range(2 if index == 0 else 0):
            kill_after(lonely, words, rows, 3 * kills + 1)
        assert lonely(*words, **NOWHERE).code == 0
        assert len(lines(rows)) == 15
    assert not (lonely.folder / "shared.creep").exists()
    built(lonely, "shared.creep")
    assert (lonely.folder / "shared.creep").read_bytes() == (lonely.folder / "alone.creep").read_bytes()


def test_a_table_of_two_poissons_ratios_is_interpolated(lonely):
    built(lonely, "two.creep", "--nu", 0.2, "--nu", 0.3)
    states = np.array([[1, 0.2, 0.1, 0.05]])
    low, middle, high = (read_table(lonely.folder / "two.creep", nu, states)[2] for nu in (0.2, 0.25, 0.3))
    assert middle == pytest.approx((low + high) / 2, abs=1e-3)
    ended = lonely("table", "check", "two.creep", "--nu", 0.4)
    assert ended.code == 2
    assert "this table holds 0.2 to 0.3" in ended.err


@pytest.mark.parametrize("answers", [{}, {"forces": [1.0]}, {"forces": [1.0], "fallback": [], "unconverged": []}, {"forces": "a", "fallback": 1}])
def test_rows_that_others_have_written_are_solved_again(lonely, answers):
    built(lonely, "small.creep")
    whole = (lonely.folder / "small.creep").read_bytes()
    rows = lonely.folder / "small.creep.rows"
    text = json.dumps({"key": PLAN.rows[4].key, "code": 0, "values": {}, "answers": answers})
    rows.write_text(f"{zlib.crc32(text.encode()):08x} {text}\n" + "".join(f"{line}\n" for line in lines(rows) if PLAN.rows[4].key not in line))
    built(lonely, "small.creep")
    assert (lonely.folder / "small.creep").read_bytes() == whole


def test_rows_of_another_recipe_are_not_used(lonely):
    built(lonely, "small.creep")
    before = (lonely.folder / "small.creep").read_bytes()
    ended = lonely("table", "build", "small.creep", *SMALL[:-3], "--grids", 6, 12, **NOWHERE)
    assert ended.code == 0
    assert len(lines(lonely.folder / "small.creep.rows")) == 90
    assert (lonely.folder / "small.creep").read_bytes() != before


def test_a_table_is_described_and_checked(lonely):
    built(lonely, "small.creep")
    assert lonely("table", "show", "small.creep", "--json").json["cells"] == [4, 8, 4, 8]
    assert "8 x 16 and 16 x 32" in lonely("table", "show", "small.creep").out
    check = ("table", "check", "small.creep", "--points", 20, "--grids", 25, 50, "--json")
    found = lonely(*check, **NOWHERE).json
    assert found == lonely(*check, **NOWHERE).json, "the seed determines the states"
    assert 1e-4 < found["errors"]["Fx, Fy"]["mean"] < 0.02
    assert found["unconverged"] == 0


def test_states_of_a_check_cover_the_table():
    states = random_states(2000, 7, (0.05, 20), lambda ratio: np.ones((len(ratio), 3)))
    assert (states[0, 0], states[-1, 0]) == (pytest.approx(0.05, rel=0.05), pytest.approx(20, rel=0.05))
    length = np.linalg.norm(states[:, 1:], axis=1)
    assert (length.min(), length.max()) == (pytest.approx(0.02, rel=0.1), pytest.approx(25, rel=0.1))
    assert (states[:, 3] == 0).mean() == pytest.approx(0.25, abs=0.04)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--cells", "3", "8", "4", "8"), "--cells is [3, 8, 4, 8]; each of the four numbers must lie between 4 and 1024"),
        (("--ratios", "2", "1"), "--ratios is [2.0, 1.0]; it must be the smallest and the largest a/b"),
        (("--nu", "0.6"), "--nu is [0.6]; give one to eight ascending values between 0 and 0.5"),
        (("--grids", "16", "8"), "--grids is [16, 8]; it must be two ascending numbers"),
    ],
)
def test_plans_that_no_table_has_are_refused(lonely, words, sentence):
    ended = lonely("table", "build", "none.creep", *words)
    assert ended.code == 2
    assert sentence in " ".join(ended.err.split())
    assert not (lonely.folder / "none.creep.rows").exists()


def test_files_that_are_no_tables_are_refused_by_name(lonely):
    ended = lonely("table", "show", "contact.yaml")
    assert ended.code == 2
    assert "contact.yaml is not a creep-force table" in ended.err
    assert "contactd did not write it" in lonely("table", "build", "contact.yaml", *SMALL).err


@pytest.mark.parametrize("description", ["", "[]", "{}", "[" * 100_000, '{"nu": 1}', '{"ratios": [1, 2], "recipe": {"elements": "ab"}}'])
def test_a_table_with_a_foreign_description_is_refused_by_name(lonely, description):
    import contactd_local

    forces = np.zeros((PLAN.nodes, 3)).tobytes()
    file = str(lonely.folder / "foreign.creep")
    contactd_local.write_creep_table(file, PLAN.ratios, PLAN.cells, np.array(PLAN.nu).tobytes(), forces, description.encode())
    for words in (("show", "foreign.creep"), ("check", "foreign.creep", "--points", 10)):
        ended = lonely("table", *words, **NOWHERE)
        assert ended.code == 2
        assert "foreign.creep lacks the description" in ended.err
