"""Tests tables as files: written files can be read, and errors name the unreadable part."""

import dataclasses
import hashlib
import json
import sys

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactProblem,
    FemIcs,
    Grid,
    IcEvidence,
    Layer,
    LayeredBody,
    Material,
    MissingExtra,
    Paraboloid,
    RigidBody,
    TableFileError,
    TableIcs,
    combined_modulus,
    load_table,
    save_table,
)
from contactd.values.contact_params import problem_params, table_params
from contactd.values.generated.evidence import ComponentError, IcErrors, LoadCase
from support.tables import DX, DY, NX, NY, ic_table, made_up

PAIR = TableIcs(made_up(), DX, DY, 320)
FEM_EVIDENCE = IcEvidence(
    source="fem", version="0.2", elements=10, dofs=99, processes=1, seconds={"total": 1.5},
    load_cases=(LoadCase("z", 3, 1e-9, True, 0.5), LoadCase("x", 0, 1e-9, True, 0.5, update=1e-8)),
    errors=IcErrors(*[ComponentError(-1e-3, 2e-3)] * 3, 1e-3, 2e-3),
    warnings=("Mind the gap.",), solver="direct", mesh=FemIcs(order=3, h_over_hs=4.0), family_nu=(0.0, 0.49),
    interpolation_error=1e-5,
)  # fmt: skip


SPEC = json.dumps(table_params(Material(200, 0.42), Grid(NX, NY, DX, DY), AnalyticIcs()) | {"ics": {"source": "analytic"}})


def with_hole(value=np.nan):
    array = made_up()
    array[0, 2, 2, 1] = value
    return array


# --- TableIcs ---------------------------------------------------------------------------------------------------------


def test_two_equal_bodies_count_twice_without_coupling():
    table = ic_table()
    pair = TableIcs.from_table(table)
    np.testing.assert_array_equal(pair["zz"], 2 * table["zz"])
    np.testing.assert_array_equal(pair["yx"], 2 * table["yx"])
    assert not any(pair[name].any() for name in ("xz", "zx", "yz", "zy"))
    assert (pair.dx, pair.dy, pair.G, pair.shape) == (DX, DY, 200, (NY, NX))


def test_two_different_bodies_subtract_what_couples():
    upper, lower = ic_table(1), ic_table(2, Material(800, 0.1))
    pair = TableIcs.from_table(upper, lower)
    np.testing.assert_array_equal(pair["xx"], upper["xx"] + lower["xx"])
    np.testing.assert_array_equal(pair["zy"], lower["zy"] - upper["zy"])
    assert pair.G == pytest.approx(320)


def test_bodies_of_different_extent_share_the_smaller_one():
    assert TableIcs.from_table(ic_table(nx=7), ic_table(nx=5)).shape == (NY, 5)


def test_bodies_of_different_element_size_are_no_pair():
    with pytest.raises(ValueError, match=r"different dx, 0\.06 and 0\.07"):
        TableIcs.from_table(ic_table(), ic_table(dx=0.07))


def test_the_combined_modulus_is_the_harmonic_mean():
    assert combined_modulus(Material(82000, 0.3)) == 82000
    assert combined_modulus(Material(200, 0.3), Material(800, 0)) == pytest.approx(320)
    rubber = LayeredBody([Layer(2, 1, 0.5), Layer(1, 70, 0.4)], RigidBody())
    assert combined_modulus(rubber) == 1
    assert combined_modulus(rubber, Material(4, 0.3)) == pytest.approx(1.6)


@pytest.mark.parametrize("shape", [(9, 3, 4), (3, 3, 12), (2, 3, 3, 4), (3, 3, 0, 4)])
def test_an_array_of_another_shape_is_no_table(shape):
    with pytest.raises(ValueError, match=r"must be \[3, 3, ny, nx\]"):
        TableIcs(np.ones(shape), DX, DY)


def test_a_table_of_columns_is_to_be_imported():
    with pytest.raises(ValueError, match=r"\[3, 3, 4, 4, 2\], that of the columns of a longitudinally uniform body; export it .* \(import_ic\)"):
        TableIcs(np.ones((3, 3, 4, 4, 2)), DX, DY)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_coefficients_are_finite(value):
    with pytest.raises(ValueError, match=r"for xz at the offset \(1, 2\); every coefficient must be finite"):
        TableIcs(with_hole(value), DX, DY)


def test_masked_coefficients_are_no_table():
    with pytest.raises(ValueError, match="array has 1 masked values"):
        TableIcs(np.ma.masked_invalid(with_hole()), DX, DY)


@pytest.mark.parametrize(("name", "size"), [("dx", 0), ("dy", -1), ("dx", np.nan), ("G", np.inf), ("G", 0)])
def test_sizes_and_modulus_are_positive(name, size):
    with pytest.raises(ValueError, match=f"{name} is .*; it must be positive and finite"):
        TableIcs(**{"array": made_up(), "dx": DX, "dy": DY, "G": 1, name: size})


def test_a_problem_with_its_own_coefficients_needs_no_bodies():
    pair = TableIcs(made_up(), DX, DY)
    problem = ContactProblem(grid=Grid(2, 2, DX, DY), gap=Paraboloid(50), approach=0.1, ics=pair)
    params = problem_params(problem)
    assert "bodies" not in params
    assert {name: params["ics"][name] for name in ("source", "dx", "dy")} == {"source": "table", "dx": DX, "dy": DY}
    np.testing.assert_array_equal(params["ics"]["table"], pair.array[:, :, :2, :2])
    assert "bodies" not in problem_params(problem.replace(upper=Material(1, 0)))


@pytest.mark.parametrize("lacking", ["gap", "approach"])
def test_a_problem_still_needs_the_rest(lacking):
    fields = {"grid": Grid(2, 2, DX, DY), "gap": Paraboloid(50), "approach": 0.1}
    del fields[lacking]
    with pytest.raises(TypeError, match=lacking):
        ContactProblem(**fields)


# --- numpy's archive --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("ics", "evidence"),
    [(AnalyticIcs("half_space", "bilinear"), IcEvidence("analytic")), (FemIcs("paper-test1", order=1), FEM_EVIDENCE)],
)
def test_an_archive_is_read_back_with_all_it_says(tmp_path, ics, evidence):
    table = ic_table(ics=ics, evidence=evidence)
    save_table(tmp_path / "table.npz", table)
    read = load_table(tmp_path / "table.npz")
    assert (read.spec, read.evidence, read.key, read.origin) == (table.spec, table.evidence, "abc", "file")
    np.testing.assert_array_equal(read.array, table.array)


@pytest.mark.parametrize("G", [None, 320])
def test_a_pair_goes_through_an_archive(tmp_path, G):
    ics = TableIcs(made_up(), DX, DY, G)
    save_table(str(tmp_path / "pair.npz"), ics)
    read = load_table(str(tmp_path / "pair.npz"))
    assert (read.dx, read.dy, read.G) == (DX, DY, G)
    np.testing.assert_array_equal(read.array, ics.array)


def test_an_archive_is_plain_numpy_and_json(tmp_path):
    save_table(tmp_path / "table.npz", ic_table(evidence=FEM_EVIDENCE))
    with np.load(tmp_path / "table.npz", allow_pickle=False) as archive:
        assert archive["array"].shape == (3, 3, NY, NX)
        assert json.loads(str(archive["spec"]))["material"] == {"G": 200, "nu": 0.42}
        assert json.loads(str(archive["evidence"]))["warnings"] == ["Mind the gap."]


@pytest.mark.parametrize(
    ("members", "says"),
    [
        ({}, 'must have an array "array"'),
        ({"array": np.ones(3)}, "of shape"),
        ({"array": np.full((3, 3, 1, 1), "x")}, "of shape"),
        ({"array": made_up()}, 'lacks "spec"'),
        ({"array": made_up(), "spec": "{", "evidence": "{}"}, '"spec" is not JSON'),
        ({"array": made_up(), "spec": "{}", "evidence": "{}"}, "spec lacks material"),
        ({"array": made_up(), "pair": "{}"}, '"pair" must contain dx and dy'),
        ({"array": made_up(), "pair": "[]"}, '"pair" must contain dx and dy'),
        ({"array": with_hole(), "pair": '{"dx": 1, "dy": 1}'}, r"contains nan for xz at the offset \(1, 2\)"),
        ({"array": with_hole(np.inf), "pair": '{"dx": 1, "dy": 1}'}, r"contains inf for xz at the offset \(1, 2\)"),
        ({"array": with_hole(), "spec": SPEC, "evidence": '{"source": "analytic"}'}, "contains nan for xz"),
        ({"array": made_up(), "spec": SPEC.replace("0.06", "-1"), "evidence": '{"source": "analytic"}'}, "dx = -1"),
        ({"array": made_up(), "spec": SPEC.replace("200", "0"), "evidence": '{"source": "analytic"}'}, "G = 0"),
        ({"array": made_up(), "spec": SPEC.replace("0.42", "7"), "evidence": '{"source": "analytic"}'}, "nu = 7"),
        ({"array": made_up(), "pair": '{"dx": NaN, "dy": 1}'}, "dx is nan; it must be positive"),
        ({"array": made_up(), "pair": '{"dx": 1, "dy": 0}'}, "dy is 0.0; it must be positive"),
        ({"array": made_up(), "pair": '{"dx": 1, "dy": 1, "G": -1}'}, "G is -1.0; it must be positive"),
        ({"array": made_up(), "pair": '{"dx": 1, "dy": 1, "G": "soft"}'}, "G or null"),
    ],
)
def test_an_archive_of_something_else(tmp_path, members, says):
    np.savez(tmp_path / "table.npz", **members)
    with pytest.raises(TableFileError, match=says):
        load_table(tmp_path / "table.npz")


def test_an_archive_whose_parts_do_not_fit_together(tmp_path):
    table = dataclasses.replace(ic_table(), array=made_up(nx=NX + 1))
    save_table(tmp_path / "table.npz", table)
    with pytest.raises(TableFileError, match=r"array has shape \[3, 3, 3, 5\]; spec.grid requires \[3, 4\]"):
        load_table(tmp_path / "table.npz")


def test_files_that_are_no_archive(tmp_path):
    path = tmp_path / "table.npz"
    for content in (b"", b"PK\x03\x04 broken", b"\x00" * 100, b"plain text"):
        path.write_bytes(content)
        with pytest.raises(TableFileError, match=r"table\.npz is not an archive of numpy"):
            load_table(path)
    with path.open("wb") as file:
        np.save(file, made_up())
    with pytest.raises(TableFileError, match="contains no table"):
        load_table(path)


# --- names and HDF5 ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["table", "table.csv", "table.npz.bak"])
def test_the_name_says_what_a_file_is(tmp_path, name):
    with pytest.raises(ValueError, match=r"must end in \.npz, \.txt or \.h5"):
        load_table(tmp_path / name)
    with pytest.raises(ValueError, match=r"must end in \.npz, \.txt or \.h5"):
        save_table(tmp_path / name, PAIR)


def test_a_file_that_is_not_there(tmp_path):
    for suffix in ("npz", "txt", "h5"):
        with pytest.raises(FileNotFoundError):
            load_table(tmp_path / f"none.{suffix}")


def test_hdf5_is_written_by_the_daemon(tmp_path):
    with pytest.raises(ValueError, match="export_ic"):
        save_table(tmp_path / "table.h5", PAIR)


def test_hdf5_without_h5py_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "h5py", None)
    with pytest.raises(MissingExtra, match="needs h5py: pip install"):
        load_table(tmp_path / "table.h5")


def test_damaged_hdf5_files_are_not_parsed(tmp_path):
    path, image = tmp_path / "table.h5", b"anything but HDF5"
    path.write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(600))
    with pytest.raises(TableFileError, match="is not an IC file of contactd"):
        load_table(path)
    head = b"contactd ic table, format 1, sha256 of the bytes after this block: "
    path.write_bytes((head + b"0" * 64).ljust(512, b"\0") + image)
    with pytest.raises(TableFileError, match="does not match its digest"):
        load_table(path)
    digest = hashlib.sha256(image).hexdigest().encode()
    path.write_bytes((head + digest).ljust(512, b"\0") + image)
    with pytest.raises(TableFileError, match="not an IC file that this version can read"):
        load_table(path)
