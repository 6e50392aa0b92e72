"""Tests that mistakes of units, signs and sampling of a record are refused or warned of."""

from __future__ import annotations

import io

import numpy as np
import pytest

from contactd import ContactWarning, InvalidArgument
from contactd.roughness import Record, map_of, read_record, record_of

X = np.arange(1200.0)  # mm
R = 5 * np.sin(2 * np.pi * X / 47) + 0.5 * np.random.default_rng(4).standard_normal(len(X))  # um


def written(path, text: str):
    path.write_text(text)
    return path


def as_csv(x, r, heading: str = "x (m);r (um)") -> str:
    rows = "\n".join(f"{a:.6f};{b:.6f}".replace(".", ",") for a, b in zip(x, r))
    return f"{heading}\n{rows}\n"


@pytest.mark.parametrize(
    ("heading", "given"),
    [
        ("x (m);r (um)", {}),
        ("# x [m]; r [µm]", {}),
        ("Position in m;height_um", {}),
        ("x / m;r / µm", {}),
        ("distance;roughness", {"x_unit": "m", "height_unit": "um"}),
        ("x (m);roughness", {"height_unit": "um"}),
    ],
)
def test_units_of_text_are_read_or_stated(tmp_path, heading, given):
    record = read_record(written(tmp_path / "r.csv", as_csv(X / 1e3, R, heading)), **given)
    assert record.spacing == pytest.approx(1)
    np.testing.assert_allclose(record.heights[0], R / 1e3, atol=1e-9)


@pytest.mark.parametrize(
    ("heading", "given", "words"),
    [
        ("x;r", {}, "x_unit = None: the unit is neither in the file nor given"),
        ("x (m);r", {}, "height_unit = None"),
        ("x (m);r (dB re 1 um)", {}, "levels are not heights"),
        ("x (m);L_r (dB)", {}, "levels are not heights"),
        ("x (m);r (um)", {"height_unit": "mm"}, "height_unit = mm: r.csv states um"),
        ("x (m);r (bar)", {}, "height_unit = bar: the unit is not supported"),
        ("x (m);r (mm)", {}, "the rms slope"),
        ("x (mm);r (um)", {}, "x = places 0.001 mm apart|the rms slope"),
        ("x (cm);r (um)", {"columns": [0, 2]}, "columns = .0, 2.: r.csv has columns 0 to 1"),
    ],
)
def test_wrong_and_missing_units_are_refused(tmp_path, heading, given, words):
    with pytest.raises(InvalidArgument, match=words):
        read_record(written(tmp_path / "r.csv", as_csv(X / 1e3, R, heading)), **given)


def test_places_in_mm_stated_as_m_are_refused():
    with pytest.raises(InvalidArgument, match=r"1000 mm apart.*Check x_unit = m"):
        record_of(X, R, x_unit="m", height_unit="um")


def test_heights_in_mm_stated_as_um_give_a_warning():
    with pytest.warns(ContactWarning, match="Check both units"):
        record_of(X, R / 1e3 / 100, x_unit="mm", height_unit="um")


def test_wavelengths_instead_of_places_are_refused():
    waves = 400 / 10 ** (np.arange(22) / 10)
    with pytest.raises(InvalidArgument, match="these are wavelengths of a spectrum"):
        record_of(waves, np.linspace(17, -11, 22), x_unit="mm", height_unit="um")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda x, r: (np.where(x == 7, 6, x), r), "sample 8: places must increase"),
        (lambda x, r: (np.where(x > 500, x + 3, x), r), "samples are not uniform"),
        (lambda x, r: (np.where(x == 7, np.nan, x), r), "x = nan at sample 8"),
        (lambda x, r: (x, np.where(x == 9, np.nan, r)), "nan at sample 10 of line 1: 1 heights are not finite"),
        (lambda x, r: (x, np.ma.masked_less(r, -4)), "masked values"),
        (lambda x, r: (x, np.ones_like(r)), "no roughness"),
        (lambda x, r: (x, 1e-3 * x), "no roughness"),
        (lambda x, r: (x, r[:-1]), "1200 places: the lines have 1199 heights"),
        (lambda x, r: (x, np.stack([r, r])), "y = None: the record has 2 lines"),
        (lambda x, r: (x[:2], r[:2]), "increase or decrease throughout|at least 3 samples"),
        (lambda x, r: (0.0, r), "must lie between"),
    ],
)
def test_gaps_and_uneven_samples_are_refused(change, words):
    with pytest.raises(InvalidArgument, match=words):
        record_of(*change(X, R), x_unit="mm", height_unit="um")


def test_decreasing_places_are_the_same_record():
    one, other = (record_of(x, r, x_unit="mm", height_unit="um") for x, r in ((X, R), (X[::-1], R[::-1])))
    np.testing.assert_array_equal(one.heights, other.heights)
    assert one.start == other.start


def test_a_record_upside_down_is_noticed_by_its_spikes():
    dirty = np.array(R)
    dirty[[200, 500, 900]] += 60
    up = record_of(X, dirty, x_unit="mm", height_unit="um")
    with pytest.warns(ContactWarning, match="3 narrow spikes point downwards and none upwards"):
        record_of(X, -dirty, x_unit="mm", height_unit="um")
    with pytest.warns(ContactWarning), pytest.raises(AssertionError):
        np.testing.assert_array_equal(record_of(X, -dirty, x_unit="mm", height_unit="um").heights, up.heights)
    np.testing.assert_array_equal(record_of(X, -dirty, x_unit="mm", height_unit="um", upside_down=True).heights, up.heights)


def test_arrays_in_files_of_numpy(tmp_path):
    np.save(tmp_path / "a.npy", np.stack([X, R, R], axis=1))
    np.save(tmp_path / "b.npy", R)
    np.savez(tmp_path / "c.npz", spacing=1.0, heights=np.stack([R, R]), y=[-5, 5], x_unit="mm", height_unit="um")
    units = {"x_unit": "mm", "height_unit": "um"}
    a = read_record(tmp_path / "a.npy", y=[-5, 5], **units)
    b = read_record(tmp_path / "b.npy", spacing=1, **units)
    c = read_record(tmp_path / "c.npz")
    np.testing.assert_array_equal(a.heights, c.heights)
    np.testing.assert_array_equal(a.heights[:1], b.heights)
    with pytest.raises(InvalidArgument, match="has one column"):
        read_record(tmp_path / "b.npy", **units)
    with pytest.raises(InvalidArgument, match="x_unit = None"):
        read_record(tmp_path / "a.npy", y=[-5, 5])


@pytest.mark.parametrize("content", [b"", b"PK\3\4", b"\x93NUMPY\1\0", b"\0" * 100, b"x (m);r (um)\n0;1\n1;b\n"])
@pytest.mark.parametrize("name", ["r.csv", "r.npy", "r.npz"])
def test_damaged_files_are_refused(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InvalidArgument, match="path = "):
        read_record(tmp_path / name, x_unit="m", height_unit="um")


def test_an_archive_of_objects_is_never_unpickled(tmp_path):
    packed = io.BytesIO()
    np.savez(packed, heights=np.array([{}], dtype=object))
    (tmp_path / "r.npz").write_bytes(packed.getvalue())
    with pytest.raises(InvalidArgument, match="not an archive of arrays"):
        read_record(tmp_path / "r.npz", x_unit="m", height_unit="um")


class Topography:
    """A map with the interface of the package SurfaceTopography."""

    unit = "µm"

    def positions_and_heights(self):
        x, y = np.meshgrid(500.0 * np.arange(40), 250.0 * np.arange(30), indexing="ij")
        return x, y, 3 * np.sin(x / 5000) * np.cos(y / 2000)


def test_maps_have_the_unit_that_they_state():
    found = map_of(Topography())
    assert found.spacing == pytest.approx(0.5)
    assert found.heights.shape == (30, 40)
    assert np.ptp(found.y) == pytest.approx(29 * 0.25)
    with pytest.raises(InvalidArgument, match="unit = mm: the map states µm"):
        map_of(Topography(), unit="mm")


def test_records_are_read_only_copies():
    given = np.array(R)
    record = Record(1.0, given)
    given[0] = 99
    assert record.heights[0, 0] == R[0]
    with pytest.raises(ValueError, match="read-only"):
        record.heights[0, 0] = 0
