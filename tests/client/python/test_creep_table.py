"""Tables of creep forces in Python: vectorised, with derivatives and bounds, and clear errors."""

import re
import shutil
import warnings
from pathlib import Path

import numpy as np
import pytest

import contactd
from support.creep_tables import invented_table

CONTACT = {"a": 6.0, "b": 5.0, "G": 82000.0, "mu": 0.3, "Fn": 80e3}
CREEPAGES = {"xi": 1e-3, "eta": -2e-3, "phi": 3e-4}


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return invented_table(tmp_path_factory.mktemp("table"), (0.2, 0.3))


@pytest.fixture(scope="module")
def table(path):
    return contactd.CreepTable(path, 0.25)


def scaled(table, **changes):
    return table.forces(**{**CONTACT, **CREEPAGES, **changes})


def test_forces_of_numbers_are_numbers_that_oppose_the_creepages(table):
    assert (table.nu, table.ratios, table.statement) == (0.25, pytest.approx((0.5, 2)), None)
    found = scaled(table)
    assert isinstance(found.Fx, float)
    assert found.Fx < 0 < found.Fy
    assert (found.by_creepage.shape, found.by_contact.shape) == ((3, 3), (3, 5))
    assert np.isnan(found.force_bound), "the table was not checked"


def test_forces_of_arrays_are_those_of_their_elements(table):
    xi, a = np.array([[1e-3], [2e-3]]), np.array([5.0, 6.0, 7.0])
    found = scaled(table, xi=xi, a=a)
    assert found.Fx.shape == (2, 3)
    assert found.by_contact.shape == (2, 3, 3, 5)
    for i, j in np.ndindex(2, 3):
        single = scaled(table, xi=xi[i, 0], a=a[j])
        assert (found.Fy[i, j], found.Mz[i, j]) == (single.Fy, single.Mz)
        assert (found.by_creepage[i, j] == single.by_creepage).all()
    assert scaled(table, xi=np.empty((0, 2))).by_creepage.shape == (0, 2, 3, 3)


@pytest.mark.parametrize("name", [*CONTACT, *CREEPAGES])
def test_derivatives_are_those_of_the_forces(table, name):
    value = {**CONTACT, **CREEPAGES}[name]
    step = 1e-3 * abs(value)
    low, high = (scaled(table, **{name: value + change}) for change in (-step, step))
    found = scaled(table)
    column = found.by_creepage[:, [*CREEPAGES].index(name)] if name in CREEPAGES else found.by_contact[:, [*CONTACT].index(name)]
    for i, force in enumerate(("Fx", "Fy", "Mz")):
        difference = (getattr(high, force) - getattr(low, force)) / (2 * step)
        assert column[i] == pytest.approx(difference, rel=2e-2, abs=2e-3 * abs(getattr(found, force) / value))


def test_forces_have_the_symmetries_of_the_full_theory(table):
    found, turned, mirrored = scaled(table), scaled(table, xi=-1e-3, eta=2e-3, phi=-3e-4), scaled(table, eta=2e-3, phi=-3e-4)
    assert (turned.Fx, turned.Fy, turned.Mz) == (-found.Fx, -found.Fy, -found.Mz)
    assert (mirrored.Fx, mirrored.Fy, mirrored.Mz) == (found.Fx, -found.Fy, -found.Mz)


def test_the_examples_of_the_page(path, tmp_path, monkeypatch):
    page = (Path(__file__).parents[3] / "docs" / "creep-tables.md").read_text()
    shutil.copy(path, tmp_path / "creep-0.28.creep")
    monkeypatch.chdir(tmp_path)
    names = {}
    for example in re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL):
        exec(compile(example, "docs/creep-tables.md", "exec"), names)
    assert names["stiffness"].shape == names["by_friction"].shape == (201,)
    assert names["stiffness"][100] < 0, "at no creepage"
    change = [names["table"].forces(6.0, 5.0, 82000.0, names["mu"](xi, 1e-3), 80e3, xi=xi, eta=1e-3).Fx for xi in (2e-3 - 1e-5, 2e-3 + 1e-5)]
    assert names["dFx_dxi"] == pytest.approx((change[1] - change[0]) / 2e-5, rel=1e-2)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"a": -1}, "a is -1; it must be positive"),
        ({"mu": [0.3, 0]}, r"mu\[1\] is 0; it must be positive"),
        ({"Fn": float("nan")}, "Fn is nan; it must be finite"),
        ({"xi": [[1e-3, np.inf]]}, r"xi\[0, 1\] is inf; it must be finite"),
        ({"a": 50}, r"a/b is 10; the table holds 0.5 to 2; a lies along the rolling direction"),
        ({"b": [5, 0.5]}, r"a/b\[1\] is 12"),
        ({"xi": [1e-3, 2e-3], "eta": [1e-3, 2e-3, 3e-3]}, r"contacts have shapes that do not broadcast: xi \(2,\), eta \(3,\)"),
        ({"G": "steel"}, "G is 'steel'; it must be a real number"),
        ({"phi": None}, "phi is None; it must be a real number"),
        ({"eta": 1j}, "eta is 1j; it must be a real number"),
    ],
)
def test_invalid_values_are_refused_by_their_names(table, changes, sentence):
    with pytest.raises(contactd.InvalidArgument, match=sentence):
        scaled(table, **changes)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"xi": 1.5}, "xi reaches 1.5, .* not in percent"),
        ({"eta": [0, -2]}, "eta reaches 2, .* not in percent"),
        ({"mu": 30}, "mu reaches 30, .* not in percent"),
        ({"G": 8.2e10}, "G reaches 8.2e.10, .* not in Pa"),
        ({"phi": 0.5}, "not in 1/m"),
    ],
)
def test_values_in_other_units_are_warned_of(table, changes, sentence):
    with pytest.warns(contactd.ContactWarning, match=sentence):
        scaled(table, **changes)


def test_usual_values_are_not_warned_of(table):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        scaled(table, xi=0.3, mu=0.6)


def test_files_and_ratios_without_a_table_are_refused(path, tmp_path):
    with pytest.raises(contactd.InvalidArgument, match=r"nu is 0.4; this table holds 0.2 to 0.3"):
        contactd.CreepTable(path, 0.4)
    for nu, sentence in (("steel", "nu is 'steel'; it must be a real"), ([0.2, 0.3], "nu has 2 values"), (float("nan"), "nu is nan; it must be finite")):
        with pytest.raises(contactd.InvalidArgument, match=sentence):
            contactd.CreepTable(path, nu)
    with pytest.raises(contactd.TableFileError, match="is not the name of a file"):
        contactd.CreepTable("no\0table.creep")
    with pytest.raises(contactd.TableFileError, match="none.creep"):
        contactd.CreepTable(tmp_path / "none.creep")
    cut = tmp_path / "cut.creep"
    cut.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(contactd.TableFileError, match="cut.creep has"):
        contactd.CreepTable(cut)


def test_tables_need_the_compiled_package_and_name_it(path, monkeypatch):
    monkeypatch.setattr("contactd.creep_tables.can_solve_here", lambda: False)
    with pytest.raises(contactd.MissingExtra, match=r"contactd\[local\]"):
        contactd.CreepTable(path)
