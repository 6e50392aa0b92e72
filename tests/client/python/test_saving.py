"""Tests problems and solutions as dictionaries, as files, and as arrays of xarray, without losses in both
directions."""

import errno
import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields, is_dataclass

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactProblem,
    ContactSolution,
    Estimate,
    FemIcs,
    Friction,
    Grid,
    KineticFriction,
    Layer,
    LayeredBody,
    LineContact,
    Material,
    MissingExtra,
    Paraboloid,
    RigidBody,
    Rolling,
    SavedFileError,
    SemiAxes,
    SolverSettings,
    StepSolution,
    StressBlock,
    SubsurfaceStress,
    TableIcs,
    from_dict,
    load,
    save,
    to_dict,
)
from contactd.files.whole import write_whole
from contactd.transport.frames import decode
from contactd.values.answers import read
from contactd.values.step_solution import checked, read_solution
from contactd.values.tables import IcTable
from contactd.wheel_rail import (
    S1002,
    ConeProfile,
    ProfileFile,
    ProfilePoints,
    Rail60E1,
    RailSprings,
    Track,
    WheelRailFriction,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
)
from support import answers
from support.sessions import STEP

GRID, STEEL = Grid(3, 2, 1.0, 0.5, x0=-1.5), Material(82000, 0.28)
ARRAY = np.arange(6.0).reshape(2, 3)


def solution(**changes) -> ContactSolution:
    result, *frames = answers.solution(2, 3)
    frames[1] = ARRAY.tobytes()
    found = read_solution(GRID, None, decode({**result, **changes}, frames))
    assert isinstance(found, ContactSolution)
    return found


def partial_solution() -> ContactSolution:
    result, *frames = answers.solution(2, 3)
    told = {name: part for name, part in decode(result, frames).items() if name not in ("pressure", "traction_x", "element_division")}
    return read_solution(GRID, ["traction_y"], told)


def table() -> IcTable:
    result, frame = answers.table(2, 3)
    result["array"] = result.pop("table")
    return read(IcTable, decode(result, [frame]))


def stress(block=None, points=None) -> SubsurfaceStress:
    result, *frames = answers.stresses(*((2, 1, 3) if block else (4,)))
    told = decode(result, frames)
    made = read(SubsurfaceStress, {**told, **told.pop("stress")})
    return SubsurfaceStress(**{**vars(made), "block": block, "points": points})


PROBLEM = ContactProblem(grid=GRID, upper=STEEL, gap=Paraboloid(460, 300), approach=0.02)
LAYERS = LayeredBody([Layer(1.0, 2.0, 0.5), Layer(2.0, 3.0, 0.3)], base=RigidBody())
VALUES = {
    "a problem": PROBLEM,
    "a problem with a force": PROBLEM.replace(Fn=5.0, gap=SemiAxes(1.0, 2.0), lower=RigidBody(), normal=SolverSettings(1e-9)),
    "a gap of one's own": PROBLEM.replace(gap=ARRAY, model="full", derivatives=True),
    "a shift under a force": PROBLEM.replace(friction=Friction(0.4, force=(-3.2, None), kinetic=KineticFriction(0.1, 2.0))),
    "friction by element": PROBLEM.replace(friction=Friction(ARRAY, rigid_shift=(0.1, 0.0), rigid_slip=(ARRAY, -ARRAY))),
    "rolling": PROBLEM.replace(friction=Friction(0.3, rolling=Rolling(xi=1e-3, kind="transient", steps=3))),
    "finite elements": PROBLEM.replace(upper_ics=FemIcs("paper-test3", L_over_h=1280.0), ics=AnalyticIcs(load_shape="bilinear")),
    "a table": PROBLEM.replace(ics=TableIcs(np.ones((3, 3, 2, 3)), 1.0, 0.5)),
    "layers": PROBLEM.replace(upper=LAYERS, lower=STEEL),
    "a line": ContactProblem(grid=Grid(3, 1, 1, 1), upper=STEEL, gap=Paraboloid(5), Fn=1, ics=AnalyticIcs(line_contact=LineContact(9.0))),
    "a history": PROBLEM.replace(previous=solution(), initial=Estimate(ARRAY)),
    "a solution": solution(warnings=["One.", "Two."], motion={"xi": 1e-3, "eta": 0.0, "phi": 0.0, "chi": 0.0, "kind": "steady"}),
    "forces": partial_solution(),
    "a step": checked(read(StepSolution, STEP), [], GRID),
    "stresses in a block": stress(StressBlock(GRID.x, 0.0, [0.0, -1.0])),
    "stresses at points": stress(points=np.zeros((4, 3))),
    "a wheel on a rail": WheelRailSetup(
        side="left", wheel=ConeProfile(-0.05, ends=(-30.0, 30.0)), track=Track(rail_origin=(717.5, 0.0), springs=RailSprings(z=1e5)), lower=STEEL, upper=STEEL,
        rail_slices=[(0.0, Rail60E1(0.025)), (9.0, ProfilePoints([[float(i), 0.1] for i in range(200)]))],
        wheel_slices=[(-0.1, S1002()), (0.1, ConeProfile(-0.05)), (0.2, ProfileFile("folder/a.whl", text="0 0\n1 1", mirror_y=True))],
        friction=WheelRailFriction([(-1.2, 0.1), (-0.4, 0.3)]),
    ),
    "a state": WheelRailState(position=WheelsetPosition(y=3.0), Fz=8e4, derivatives=True),
}  # fmt: skip


def same(one, other, path=""):
    """Returns whether two values have equal contents; lists equal tuples, as for the daemon."""
    if is_dataclass(one):
        assert type(one) is type(other), path
        for field in fields(one):
            same(getattr(one, field.name, "absent"), getattr(other, field.name, "absent"), f"{path}.{field.name}")
    elif isinstance(one, dict):
        assert one.keys() == other.keys(), path
        for name in one:
            same(one[name], other[name], f"{path}.{name}")
    elif isinstance(one, (list, tuple)) and not isinstance(other, np.ndarray):
        assert len(one) == len(other), path
        for i, pair in enumerate(zip(one, other)):
            same(*pair, f"{path}[{i}]")
    elif isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        assert np.asarray(one).dtype == other.dtype, path
        assert (np.asarray(one) == other).all(), path
    else:
        assert one == other, path
        assert isinstance(one, (bool, str)) == isinstance(other, (bool, str)), path


@pytest.mark.parametrize("name", VALUES)
def test_a_value_is_saved_and_loaded_whole(name, tmp_path):
    value = VALUES[name]
    value.save(tmp_path / "kept.h5")
    same(value, load(tmp_path / "kept.h5"))
    same(value, type(value).load(tmp_path / "kept.h5"))
    assert [path.name for path in tmp_path.iterdir()] == ["kept.h5"]


@pytest.mark.parametrize("name", VALUES)
def test_a_dictionary_makes_the_value_again(name):
    told = VALUES[name].to_dict()
    same(VALUES[name], from_dict(told))
    assert told["type"] == type(VALUES[name]).__name__


def test_a_dictionary_without_arrays_is_json():
    told = json.loads(json.dumps(PROBLEM.to_dict()))
    assert told["gap"] == {"type": "Paraboloid", "Rx": 460, "Ry": 300}
    assert "lower" not in told
    same(PROBLEM, from_dict(told))


def test_tables_tell_themselves_too():
    told = table().to_dict()
    assert told["spec"]["grid"] == {"type": "Grid", "nx": 3, "ny": 2, "dx": 1.0, "dy": 1.0}
    same(table(), from_dict(told))


def test_what_is_loaded_can_be_a_history(tmp_path):
    solution().save(tmp_path / "step.h5")
    loaded = ContactSolution.load(tmp_path / "step.h5")
    assert PROBLEM.replace(previous=loaded).previous is loaded
    assert loaded.grid == GRID
    with pytest.raises(ValueError, match="read-only"):
        loaded.pressure[0] = 1


@pytest.mark.parametrize(
    ("told", "wrong"),
    [
        ({"type": "Nonsense"}, "the value is of the type 'Nonsense', which this version does not support"),
        ({"type": "Grid", "nx": 1, "my": 2}, "the value has my, which Grid does not have"),
        ({"type": "ContactProblem", "gap": {"type": "SemiAxes", "a": 1}}, "gap is not a valid SemiAxes: .*missing.*'b'"),
        ({"type": "ContactProblem", "layers": [{"type": "?"}]}, r"layers\[0\] is of the type '\?'"),
    ],
)
def test_a_dictionary_that_makes_no_value_is_told_where(told, wrong):
    with pytest.raises(ValueError, match=wrong):
        from_dict(told)


def test_what_is_no_value_is_refused(tmp_path):
    with pytest.raises(TypeError, match="is a socket|is a object"):
        to_dict(object())
    with pytest.raises(TypeError, match=r"is a list; save\(\) accepts problems"):
        save(tmp_path / "x.h5", [PROBLEM])
    assert not list(tmp_path.iterdir())


def test_a_file_of_something_else_is_refused(tmp_path):
    path = tmp_path / "kept.h5"
    PROBLEM.save(path)
    with pytest.raises(SavedFileError, match=r"kept\.h5 contains a ContactProblem, not a ContactSolution"):
        ContactSolution.load(path)
    whole = path.read_bytes()
    for content in (b"", b"rubbish", whole[: len(whole) // 2]):
        path.write_bytes(content)
        with pytest.raises(SavedFileError, match=r"kept\.h5"):
            load(path)
    with pytest.raises(FileNotFoundError):
        load(tmp_path / "nowhere.h5")


def test_a_file_of_hdf5_that_is_not_ours_is_refused(tmp_path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file.attrs["x"] = 1
    with pytest.raises(SavedFileError, match="is not a file of contactd's problems and solutions"):
        load(tmp_path / "other.h5")


def test_without_h5py_it_is_said_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "h5py", None)
    with pytest.raises(MissingExtra, match=r'needs h5py: pip install "contactd\[hdf5\]"'):
        PROBLEM.save(tmp_path / "x.h5")


def test_a_solution_has_coordinates_and_units_in_xarray():
    pytest.importorskip("xarray")
    data = solution().to_xarray()
    assert data.pressure.sel(x=0, y=0.25).item() == ARRAY[1, 1]
    assert (data.x.values == GRID.x).all()
    assert (data.pressure.units, data.x.units, data.Fn.units, data.Fn.item()) == ("N/mm^2", "mm", "N", 9.2)
    assert "slip_x" not in data
    with pytest.raises(ValueError, match="grid is None"):
        read(StepSolution, STEP).to_xarray()


def test_tables_and_stresses_have_coordinates_in_xarray():
    pytest.importorskip("xarray")
    found = table()
    assert (found.to_xarray().sel(displacement="x", load="z").values == found["xz"]).all()
    block = stress(StressBlock(GRID.x, 0.0, [0.0, -1.0])).to_xarray()
    assert dict(block.sizes) == {"z": 2, "y": 1, "x": 3}
    assert block.von_mises.sel(z=-1, x=0, y=0).item() == 6
    assert stress(points=np.zeros((4, 3))).to_xarray().xx.dims == ("point",)


def test_without_xarray_it_is_said_what_to_install(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "xarray", None)
    with pytest.raises(MissingExtra, match=r'to_xarray\(\) needs xarray: pip install "contactd\[xarray\]"'):
        solution().to_xarray()


def test_of_several_that_write_a_file_at_once_none_leaves_half_of_its_own(tmp_path):
    contents = [bytes([i]) * 300_000 for i in range(4)]
    found = set()

    def write(content):
        def in_pieces(file):
            for at in range(0, len(content), 10_000):
                file.write(content[at : at + 10_000])
                file.flush()

        for _ in range(10):
            write_whole(tmp_path / "file", in_pieces)
            found.add((tmp_path / "file").read_bytes())

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(write, contents))
    assert found <= set(contents)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_full_disk_is_told_with_the_name_of_the_file(tmp_path):
    def full(file):
        raise OSError(errno.ENOSPC, "No space left on device")

    with pytest.raises(OSError, match="No space left") as raised:
        write_whole(tmp_path / "file", full)
    assert raised.value.filename == str(tmp_path / "file")
    with pytest.raises(FileNotFoundError) as raised:
        write_whole(tmp_path / "nothing" / "file", full)
    assert raised.value.filename == str(tmp_path / "nothing" / "file")
    assert not list(tmp_path.iterdir())
