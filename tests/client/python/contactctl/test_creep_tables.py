"""Tables of creep forces: built in rows that survive any end of the process, and compared with solves."""

import json
import zlib
from pathlib import Path

import numpy as np
import pytest

import contactd
from contactctl.table.bound_cells import BOUND_CELLS, adjacent, cell_numbers, is_apex
from contactctl.table.check_plan import RANDOM, CheckPlan
from contactctl.table.nodes import extrapolated, interpolated
from contactctl.table.plan import TablePlan
from contactctl.table.recipes import RECIPES, recipe_named
from support.daemons import eventually

NOWHERE = {"CONTACTD_ENDPOINT": ""}
SMALL = ("--ratios", "0.7", "1.4", "--cells", "4", "8", "4", "8", "--grids", "8", "16")
PLAN = TablePlan((0.28,), (0.7, 1.4), (4, 8, 4, 8), recipe_named("double", (8, 16)))
NODES = 4 * 7 * 5 * 7 + 7 * 5 * 7 + 5 * 2 * 7  #: with one second angle at both poles

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
    assert built(lonely, "small.creep") == {"file": "small.creep", "rows": 45, "nodes": NODES, "unconverged": 0}
    row = PLAN.rows[2 * 9 + 3]
    states = PLAN.states(row)
    assert (len(states), row.nodes) == (35, 35)
    assert states[:, 0] == pytest.approx(np.sqrt(0.7 * 1.4))
    table = contactd.CreepTable(lonely.folder / "small.creep")
    described = table.description
    assert (table.nu, described["nodes"], described["fallback"], described["statement"]) == (0.28, NODES, [], None)
    assert described["recipe"]["elements"] == [[8, 16], [16, 32]]
    stored = next(json.loads(line[9:]) for line in lines(lonely.folder / "small.creep.rows") if row.key in line)
    assert interpolated(table, states).ravel() == pytest.approx(stored["answers"]["forces"], abs=2e-5)


def test_a_long_table_has_more_nodes_at_the_apex():
    plan = TablePlan((0.28,), (1.0, 8.0), (6, 8, 4, 8), RECIPES["double"])
    assert len(plan.rows) == 7 * 9 + 4 * 7
    ratio, *creepages = plan.states(plan.rows[-4]).T
    assert ratio == pytest.approx(8)
    assert np.abs(creepages[1]).max() < 1e-12, "the middle of the box is at pure spin and longitudinal creepage"


@pytest.mark.parametrize(("name", "grids"), [("double", (16, 30)), ("square", (25, 50)), ("fine", None)])
def test_a_node_is_extrapolated_from_its_grids(name, grids):
    states = np.array([[1.2, 0.1, -0.2, 0.15]])
    with contactd.local(in_process=True) as client:
        found, converged = extrapolated(client, states, 0.28, recipe_named(name, grids))
        finer, _ = extrapolated(client, states, 0.28, RECIPES["double"])
    assert converged.all()
    assert found == pytest.approx(finer, abs=4e-3)
    assert (found[0, :2] * [1, -1] > 0).all(), "forces have the sign of the creepages"


@pytest.mark.parametrize("recipe", RECIPES.values())
def test_recipes_remove_the_powers_of_the_element_size_that_they_name(recipe):
    n = np.array(recipe.grids)
    forces = 3 + 2 / n + (5 / n**2 if recipe.degree == 2 else 0)
    assert np.dot(recipe.weights, forces) == pytest.approx(3, abs=1e-12)


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
    low, middle, high = (interpolated(contactd.CreepTable(lonely.folder / "two.creep", nu), states) for nu in (0.2, 0.25, 0.3))
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


CHECK = ("--points", 50, "--grids", 12, 24, "--searches", 2)


def test_a_check_writes_its_statement_and_bounds_into_the_table(lonely):
    built(lonely, "small.creep")
    assert "not checked" in lonely("table", "show", "small.creep").out
    contact = (5, 5, 82000, 0.3, 50000, 1e-3, 0, 0)
    before = contactd.CreepTable(lonely.folder / "small.creep").forces(*contact)
    found = lonely("table", "check", "small.creep", *CHECK, "--json", **NOWHERE).json
    assert 1e-4 < found["errors"]["random"]["mean"][0] < 0.02
    assert (found["errors"]["random"]["states"], found["states"], found["unconverged"]) == (50, 100, 0)
    assert found["largest"][0] >= found["errors"]["random"]["largest"][0]
    table = contactd.CreepTable(lonely.folder / "small.creep")
    assert table.statement == found["statement"]
    assert "Seed 7, recipe square: 12 x 12, 24 x 24" in table.statement
    assert "everywhere" not in table.statement
    assert "apex" not in table.statement, "this table has no contacts longer than wide"
    after = table.forces(*contact)
    assert np.isnan(before.force_bound)
    assert (after.Fx, after.by_creepage.tolist()) == (before.Fx, before.by_creepage.tolist())
    assert found["solver"][0] < after.force_bound / 15000 <= found["bounds"]["away"]["largest"][0] * (1 + 1e-6)
    assert "Other states may have larger differences" in " ".join(lonely("table", "show", "small.creep").out.split())


def test_a_check_in_shares_that_is_killed_writes_the_same_bytes(lonely):
    built(lonely, "alone.creep")
    (lonely.folder / "shared.creep").write_bytes((lonely.folder / "alone.creep").read_bytes())
    assert lonely("table", "check", "alone.creep", *CHECK, **NOWHERE).code == 0
    lonely.environment["CONTACTD_ENDPOINT"] = ""
    shares = [("table", "check", "shared.creep", *map(str, CHECK), "--share", f"{index}/2", "--workers", "1") for index in range(2)]
    kill_after(lonely, shares[0], lonely.folder / "shared.creep.check.rows.0-of-2", 1)
    assert "repeat the command when all shares have ended" in lonely(*shares[0], **NOWHERE).out
    for words in (shares[1], shares[0]):
        assert lonely(*words, **NOWHERE).code == 0
    assert lonely("table", "check", "shared.creep", *CHECK, **NOWHERE).code == 0
    assert (lonely.folder / "shared.creep").read_bytes() == (lonely.folder / "alone.creep").read_bytes()


def test_a_table_is_not_checked_by_the_recipe_that_built_it(lonely):
    built(lonely, "small.creep")
    ended = lonely("table", "check", "small.creep", "--recipe", "double", **NOWHERE)
    assert ended.code == 2
    assert "--recipe is double, which built this table; give another one" in " ".join(ended.err.split())


def check_plan(points=1000):
    plan = TablePlan((0.28,), (0.05, 20.0), (16, 16, 8, 16), RECIPES["double"])
    return CheckPlan(Path("none"), plan, None, points, 7, RECIPES["square"], RECIPES["fine"])


def test_random_states_of_a_check_cover_the_table():
    plan = check_plan(2000)
    points = np.array([plan.sampled(sample)[1][:RANDOM] for sample in plan.samples])
    ratio = np.exp(points[:, 0, 0])
    assert (ratio.min(), ratio.max()) == (pytest.approx(0.05, rel=0.2), pytest.approx(20, rel=0.2))
    length = np.tan(np.pi / 4 * points[..., 3])
    assert (length.min(), length.max()) == (pytest.approx(0.02, rel=0.1), pytest.approx(25, rel=0.1))
    assert (points[..., 2] == 0).mean() == pytest.approx(0.25, abs=0.04)


def test_other_states_of_a_check_lie_in_every_cell():
    plan = check_plan(12000)
    points = np.vstack([plan.sampled(sample)[1][RANDOM:] for sample in plan.samples])
    counts = np.bincount(cell_numbers(plan.ends, points), minlength=np.prod(BOUND_CELLS))
    assert counts.min() >= 1
    assert counts[is_apex(plan.ends)].mean() > 2 * counts.mean()


def test_adjacent_cells_share_a_face():
    values = np.zeros((np.prod(BOUND_CELLS), 1))
    corner, inside = 0, int(np.ravel_multi_index((4, 4, 2, 4), BOUND_CELLS))
    values[corner], values[inside] = 1, 2
    found = adjacent(values).ravel()
    assert ((found == 1).sum(), (found == 2).sum()) == (4, 8)
    assert (found[corner], found[inside]) == (0, 0)


def test_the_states_of_a_check_remain_if_it_gets_more():
    few, many = check_plan(100), check_plan(1000)
    assert [sample.key for sample in few.samples] == [sample.key for sample in many.samples[:4]]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--cells", "3", "8", "4", "8"), "--cells is [3, 8, 4, 8]; each of the four numbers must lie between 4 and 512"),
        (("--ratios", "2", "1"), "--ratios is [2.0, 1.0]; it must be the smallest and the largest a/b"),
        (("--nu", "0.6"), "--nu is [0.6]; give one to eight ascending values between 0 and 0.5"),
        (("--grids", "16", "8"), "--grids is [16, 8]; it must be two ascending numbers"),
        (("--recipe", "coarse"), "--recipe is 'coarse'; it must be double, square, fine"),
        (("--recipe", "fine"), "--grids is [8, 16]; it must be two ascending numbers between 4 and 500, for double or square"),
    ],
)
def test_plans_that_no_table_has_are_refused(lonely, words, sentence):
    ended = lonely("table", "build", "none.creep", "--grids", 8, 16, *words)
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

    forces = np.zeros((NODES, 3)).tobytes()
    file = str(lonely.folder / "foreign.creep")
    contactd_local.write_creep_table(PLAN.ratios, PLAN.cells, file, np.array(PLAN.nu).tobytes(), forces, description.encode())
    for words in (("show", "foreign.creep"), ("check", "foreign.creep", "--points", 10)):
        ended = lonely("table", *words, **NOWHERE)
        assert ended.code == 2
        assert "foreign.creep lacks the description" in ended.err
