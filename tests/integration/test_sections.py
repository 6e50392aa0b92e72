"""Tests tables of longitudinally uniform bodies through a daemon: built once for any elements along x, kept, and
refused with a message."""

import hashlib
import io

import numpy as np
import pytest

from contactd import (
    AnalyticIcs,
    ContactColumns,
    ContactWarning,
    FemIcs,
    Grid,
    InvalidArgument,
    Material,
    Paraboloid,
    RigidBody,
    TableFileError,
    TableIcs,
    load_table,
    save_table,
)
from contactd.wheel_rail import S1002, ProfilePoints

STEEL = Material(G=82000, nu=0.28)
EDGE = {"edge_block": {"width": 100, "height": 50, "edge_distance": 1}}
GRID = Grid.centred(21, 20, 10.5, 10)
SELF = 0.2019960  # zz of the half-space under an element of 0.5 x 0.5 mm, for G = 1


def fem(section, accuracy=1e-2):
    return FemIcs(body="longitudinally_uniform", section=section, accuracy=accuracy)


def test_a_table_by_finite_elements_states_its_error_and_serves_any_length_of_elements(shared):
    table = shared.get_ic(STEEL, GRID, fem(EDGE))
    assert table.array.shape == (3, 3, 20, 20, 21)
    assert table.frames.shape == (20, 3)
    assert table.frames[19] == pytest.approx([-1.25, 0, 0])
    error = table.evidence.section.error
    assert 0 < error <= 1e-2
    assert table["zz"][19, 19, 0] * STEEL.G == pytest.approx(0.220063, abs=(error + 1e-4) * SELF)
    assert table["yy"][19, 19, 4] * STEEL.G == pytest.approx(0.042699, abs=(error + 1e-4) * SELF)
    longer = shared.get_ic(Material(G=1, nu=0.28), Grid.centred(40, 20, 80, 20), fem({**EDGE, "size": 2}))
    assert longer.origin == "memory"
    assert longer.key == table.key
    assert np.array_equal(longer.frames, 2 * table.frames * [1, 1, 0.5])


def test_an_archive_keeps_a_table_with_its_strips(shared, tmp_path):
    table = shared.get_ic(STEEL, GRID, AnalyticIcs(body="longitudinally_uniform", section=EDGE))
    save_table(tmp_path / "table.npz", table)
    back = load_table(tmp_path / "table.npz")
    assert np.array_equal(back.array, table.array)
    assert np.array_equal(back.frames, table.frames)
    assert (back.spec, back.evidence) == (table.spec, table.evidence)
    with pytest.raises(ValueError, match="npz"):
        save_table(tmp_path / "table.txt", table)
    with pytest.raises(ValueError, match="longitudinally uniform"):
        TableIcs.from_table(table)


@pytest.mark.timeout(180)
@pytest.mark.parametrize("accuracy", [1e-2, pytest.param(4e-4, marks=pytest.mark.slow)])
def test_a_table_that_misses_its_accuracy_beside_an_edge_is_warned_of_in_every_answer(shared, accuracy):
    edge = fem({"edge_block": {"width": 20, "height": 10, "edge_distance": 0}}, accuracy)
    grid = Grid(4, 6, 0.5, 0.5, -1, -1.5)
    table = shared.get_ic(STEEL, grid, edge, timeout=150)
    section = table.evidence.section
    assert section.mesh_error + section.wavenumber_error + section.end_error <= accuracy < section.error
    assert any("exceeds the requested accuracy" in warning for warning in table.evidence.warnings)
    sentence = f"exceeds the requested accuracy, {accuracy:g}."
    with pytest.warns(ContactWarning, match=sentence):
        solution = shared.solve(grid=grid, upper=RigidBody(), lower=STEEL, lower_ics=edge, gap=Paraboloid(50, 50), Fn=100)
    assert any(sentence in warning for warning in solution.warnings)


def test_a_table_within_the_accuracy_asked_for_is_not_warned_of_where_its_level_is_finer(shared):
    section = {"edge_block": {"width": 20, "height": 10, "edge_distance": 1}}
    grid = Grid(4, 6, 0.5, 0.5, -1, -1.5)
    error = shared.get_ic(STEEL, grid, fem(section, 5e-3), timeout=150).evidence.section.error
    assert 1e-3 < error < 5e-3
    sphere = {"grid": grid, "upper": RigidBody(), "lower": STEEL, "gap": Paraboloid(50, 50), "Fn": 100}
    for accuracy, is_missed in ((5e-3, False), (1e-3, True), (5e-3, False)):
        warnings = shared.solve(**sphere, lower_ics=fem(section, accuracy)).warnings
        assert any("exceeds the requested accuracy" in warning for warning in warnings) == is_missed


@pytest.mark.timeout(180)  # the table takes a quarter of a minute by itself
@pytest.mark.parametrize(("distance", "change", "more"), [(3, 0.003, 0.09), (0.5, -0.22, 0.43), (0, -0.45, 0.5)])
def test_near_an_edge_pressures_fall_below_those_of_a_half_space_that_is_cut_off(shared, distance, change, more):
    grid = Grid(12, 20, 0.25, 0.25, -1.5, distance - 5)  # next to a cut, finer elements increase the largest pressure
    edge = {"edge_block": {"width": 100, "height": 50}}

    def solve(ics):
        sphere = {"grid": grid, "upper": RigidBody(), "gap": Paraboloid(50, 50), "Fn": 5000}
        return shared.solve(**sphere, lower=STEEL, lower_ics=ics)

    block, half_space = solve(fem(edge)), solve(AnalyticIcs())
    assert block.converged
    assert block.Fn == pytest.approx(5000)
    assert block.pmax / half_space.pmax - 1 == pytest.approx(change, abs=0.03)
    assert block.approach / half_space.approach - 1 == pytest.approx(more, abs=0.02)


def test_a_curved_section_needs_its_strips(shared):
    groove = {"groove": {"radius": 10, "depth": 10, "width": 120, "height": 70}}
    ics = AnalyticIcs(body="longitudinally_uniform", section=groove)
    grid = Grid.centred(15, 21, 7.5, 10.5)
    problem = {"grid": grid, "upper": RigidBody(), "lower": STEEL, "lower_ics": ics, "Fn": 1000}
    frames = shared.get_ic(STEEL, grid, ics).frames
    gap = np.abs(grid.x) ** 2 / 100 + np.zeros(grid.shape) + 0.02 * (1 - np.cos(frames[:, 2]))[:, None]
    with pytest.raises(InvalidArgument, match=r"^columns: are missing.*curved|columns are missing.*curved"):
        shared.solve(**problem, gap=gap)
    solution = shared.solve(**problem, gap=gap, columns=ContactColumns(frames))
    assert solution.converged
    assert solution.resultant.Fz == pytest.approx(1000, rel=1e-6)
    rotated = frames * [1, 1, 1.01]
    with pytest.raises(InvalidArgument, match=r"columns.frames\[\d+\]"):
        shared.solve(**problem, gap=gap, columns=ContactColumns(rotated))


def test_what_only_half_spaces_have_is_refused_of_uniform_bodies(shared):
    ics = AnalyticIcs(body="longitudinally_uniform", section=EDGE)
    with pytest.raises(InvalidArgument, match="a section: use model full"):
        shared.solve(grid=GRID, gap=Paraboloid(50, 50), upper=STEEL, Fn=1000, lower_ics=ics, model="hertz")


def test_half_spaces_that_are_rotated_are_the_half_space_on_a_plane(shared):
    table = shared.get_ic(STEEL, GRID, AnalyticIcs(body="longitudinally_uniform", section=EDGE))
    flat = shared.get_ic(STEEL, GRID, AnalyticIcs())
    assert table.origin in ("closed_form", "memory")
    assert table["zz"][3, 1] == pytest.approx(flat["zz"][2], rel=1e-10)
    assert table["xz"][3, 1] == pytest.approx(flat["xz"][2], rel=1e-10)


@pytest.mark.parametrize(
    ("section", "says"),
    [
        ({}, "exactly one"),
        ({**EDGE, "disc": {"radius": 10, "core": 1}}, "exactly one"),
        ({"edge_block": {"width": 5, "height": 50}}, "ics.section"),
        ({"disc": {"radius": 10, "core": 0}}, "clamped"),
    ],
)
def test_a_section_that_is_none_is_refused(shared, section, says):
    with pytest.raises(InvalidArgument, match=says):
        shared.get_ic(STEEL, GRID, fem(section))


HEAD = np.stack([np.linspace(-34, 34, 69), np.linspace(-34, 34, 69) ** 2 / 600], axis=1)


def profile(points, **changes):
    return {"profile_section": {"kind": "rail", "profile": ProfilePoints(points), "depth": 40, "from": -5, **changes}}


def test_a_measured_profile_is_a_section(shared):
    """Uses a rail whose head is a parabola: its strips lie on it, and its coefficients are those of its formula."""
    grid = Grid.centred(9, 20, 4.5, 10)
    table = shared.get_ic(STEEL, grid, AnalyticIcs(body="longitudinally_uniform", section=profile(HEAD)))
    assert table.frames[:, 1] == pytest.approx(-(table.frames[:, 0] ** 2) / 600, abs=2e-4)
    assert table.frames[:, 2] == pytest.approx(np.arctan(table.frames[:, 0] / 300), abs=1e-3)
    listed = {"profile_section": {"kind": "rail", "profile": {"points": HEAD.tolist()}, "depth": 40, "from": -5}}
    assert np.array_equal(shared.get_ic(STEEL, grid, AnalyticIcs(body="longitudinally_uniform", section=listed)).array, table.array)
    built = shared.get_ic(STEEL, grid, fem(listed))
    assert 0 < built.evidence.section.error <= 1e-2
    assert built["zz"][10, 10, 0] / table["zz"][10, 10, 0] == pytest.approx(1, abs=0.1)
    assert shared.get_ic(STEEL, grid, fem(profile(HEAD))).key == built.key


def test_the_formula_of_a_wheel_is_its_rim(shared):
    wheel = {"profile_section": {"kind": "wheel", "profile": S1002(), "depth": 60}}
    grid = Grid.centred(5, 10, 5, 10)
    of_profile = shared.get_ic(STEEL, grid, AnalyticIcs(body="longitudinally_uniform", section=wheel))
    rim = shared.get_ic(STEEL, grid, AnalyticIcs(body="longitudinally_uniform", section={"rim_s1002": {}}))
    assert of_profile.frames == pytest.approx(rim.frames, abs=1e-9)


@pytest.mark.parametrize(
    ("section", "field", "says"),
    [
        (profile(HEAD[40:]), "profile_section.profile", r"from y = 6 to 34"),
        (profile(HEAD, depth=1), "profile_section.depth", r"\(y, z\) = \("),
        (profile(HEAD, **{"from": 30}), "section", r"\(y, z\) = \("),
        (profile([(-20, 0), (20, 0), (20, -10), (0, 10), (-5, 20)]), "profile_section.profile.points", r"cross.*\(-20, 0\)"),
        (profile(HEAD[:1]), "profile_section.profile", r"points"),
        (profile(np.zeros((4, 3))), "profile_section.profile.points", r"\[n, 2\]"),
    ],
)
def test_a_profile_that_is_none_is_refused_with_the_place(shared, section, field, says):
    with pytest.raises(InvalidArgument, match=says) as refused:
        shared.get_ic(STEEL, GRID, AnalyticIcs(body="longitudinally_uniform", section=section))
    assert field in refused.value.violations[0].field


@pytest.mark.parametrize(
    ("change", "field"),
    [({"depth": 0}, "depth"), ({"kind": "road"}, "kind"), ({"profile": {}}, "profile"), ({"profile": {"arc": {}}}, "profile")],
)
def test_a_profile_section_that_the_schema_does_not_know_is_refused(raw, change, field):
    section = {"kind": "rail", "profile": {"points": HEAD.tolist()}, "depth": 40, **change}
    params = {"material": {"G": 1, "nu": 0.3}, "grid": {"nx": 1, "ny": 4, "dx": 1, "dy": 1}}
    answer = raw.ask("ic.get", {**params, "ics": {"source": "analytic", "body": "longitudinally_uniform", "section": {"profile_section": section}}})
    assert answer.status == "INVALID_ARGUMENT"
    assert any(f"ics.section.profile_section.{field}" in named for named in answer.fields)


@pytest.mark.parametrize(
    ("corners", "says"),
    [
        ([(30, 0), (0, -20), (30, -20), (0, 0)], r"cross"),
        ([(5, 0), (5, -20), (0, -20), (0, 0)], r"corner"),
        ([(0, -20), (30, -20), (30, 0), (0, 0)], r"clockwise"),
    ],
)
def test_an_outline_that_is_none_is_refused_with_the_place_however_often(shared, corners, says):
    parts = [{"line": {"to": {"y": y, "z": z}}, "clamped": z == -20} for y, z in corners]
    section = {"outline": {"outside": {"start": {"y": 0, "z": 0}, "parts": parts}}}
    sphere = {"grid": GRID, "upper": RigidBody(), "gap": Paraboloid(50, 50), "Fn": 5000}
    for _ in range(3):  # a refused table is not put into quarantine
        with pytest.raises(InvalidArgument, match=says) as caught:
            shared.solve(**sphere, lower=STEEL, lower_ics=fem(section))
        assert "(y, z) = (" in caught.value.message
        assert "ics.section" in caught.value.violations[0].field


def test_a_solve_tells_of_a_bad_section_in_its_own_lengths(shared):
    parts = [{"line": {"to": {"y": y, "z": z}}, "clamped": z == -20} for y, z in [(-10, -20), (10, -20), (10, 0)]]
    section = {"outline": {"outside": {"start": {"y": -10, "z": 0}, "parts": parts}}}
    fine = Grid.centred(21, 20, 0.25 * 21, 0.25 * 20)
    with pytest.raises(InvalidArgument, match=r"ends at \(y, z\) = \(10, 0\), 20 mm from its start at \(y, z\) = \(-10, 0\)"):
        shared.solve(grid=fine, upper=RigidBody(), gap=Paraboloid(50, 50), Fn=500, lower=STEEL, lower_ics=fem(section))


def test_a_file_holds_the_table_its_strips_and_the_stated_errors(shared, tmp_path):
    pytest.importorskip("h5py")
    path = tmp_path / "edge.h5"
    path.write_bytes(shared.export_ic(STEEL, GRID, fem(EDGE)))
    table, expected = load_table(path), shared.get_ic(STEEL, GRID, fem(EDGE))
    assert np.array_equal(table.array, expected.array)
    assert table.frames == pytest.approx(expected.frames, abs=1e-9)
    assert table.evidence == expected.evidence
    assert (table.spec.material, table.spec.grid) == (STEEL, Grid(21, 20, 0.5, 0.5))


def test_an_exported_section_is_built_nowhere_else(shared, daemons):
    file = shared.export_ic(STEEL, Grid.centred(1, 20, 0.5, 10), fem(EDGE))
    expected = shared.get_ic(STEEL, GRID, fem(EDGE))
    other = daemons.start(builds={"program": "/bin/false"})
    with other.client() as client:
        imported = client.import_ic(file)
        assert imported.new
        assert (imported.ics.key, imported.ics.origin) == (expected.key, "file")
        assert imported.ics.evidence.section == expected.evidence.section
        assert "imported" in imported.ics.evidence.warnings[-1]
        assert imported.spec.ics.section["edge_block"]["width"] == 100
        table = client.get_ic(STEEL, GRID, fem(EDGE))
        assert np.array_equal(table.array, expected.array)
        assert [stored.key for stored in client.stored_ics()] == [expected.key]
        again = client.import_ic(file)
        assert (again.new, again.ics.origin) == (False, "disk")
        assert again.ics.evidence.warnings == imported.ics.evidence.warnings
    other.stop()
    with daemons.start(builds={"program": "/bin/false"}).client() as client:
        assert client.get_ic(STEEL, GRID, fem(EDGE)).origin == "disk"


def test_what_is_here_stays(shared):
    expected = shared.get_ic(STEEL, GRID, fem(EDGE))
    imported = shared.import_ic(shared.export_ic(STEEL, GRID, fem(EDGE)))
    assert not imported.new
    assert imported.ics.evidence == expected.evidence


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda file: b"", "not an IC file"),
        (lambda file: file[:300], "not an IC file"),
        (lambda file: file[:-1], "digest"),
        (lambda file: file[:2000] + bytes([file[2000] ^ 1]) + file[2001:], "digest"),
        (lambda file: b"contactd" * 1000, "not an IC file"),
    ],
)
def test_a_broken_file_is_refused_with_a_sentence(shared, change, says):
    file = shared.export_ic(STEEL, Grid.centred(2, 20, 1, 10), fem(EDGE))
    with pytest.raises(TableFileError, match=says):
        shared.import_ic(change(file))


def test_a_file_that_somebody_wrote_is_held_against_its_section(shared):
    h5py = pytest.importorskip("h5py")
    file = shared.export_ic(STEEL, Grid.centred(2, 20, 1, 10), fem(EDGE))
    content = io.BytesIO(file[512:])
    with h5py.File(content, "r+") as opened:
        opened["frames"][3, 0] += 0.5
    header = b"contactd ic table, format 1, sha256 of the bytes after this block: "
    digest = hashlib.sha256(content.getvalue()).hexdigest().encode()
    written = (header + digest + b"\n").ljust(512, b"\0") + content.getvalue()
    with pytest.raises(InvalidArgument, match="frames of strips that do not match the section"):
        shared.import_ic(written)


def test_a_closed_form_is_neither_kept_in_a_file_nor_imported(shared):
    with pytest.raises(InvalidArgument, match="faster to compute"):
        shared.export_ic(STEEL, GRID, AnalyticIcs(body="longitudinally_uniform", section=EDGE))
    with pytest.raises(InvalidArgument, match="analytic"):
        shared.import_ic(shared.export_ic(STEEL, GRID, AnalyticIcs()))
    with pytest.raises(InvalidArgument, match="hdf5"):
        shared.export_ic(STEEL, GRID, fem(EDGE), "contact")


def test_a_file_that_is_too_large_for_a_message_is_refused_before_its_table_is_made(shared):
    with pytest.raises(InvalidArgument, match="serves every nx"):
        shared.export_ic(STEEL, Grid.centred(200, 100, 100, 50), fem({"slab": {"thickness": 500, "width": 1000}}))
