"""Tests files of users: their meaning, and messages about invalid ones."""

import click
import numpy as np
import pytest

from contactctl.files import read_object
from contactctl.output import number, plain_json, size, span
from contactctl.paths import changed, get, put


@pytest.fixture
def file(tmp_path):
    """Writes a file and returns its path."""

    def write(name, text):
        (tmp_path / name).write_text(text)
        return str(tmp_path / name)

    return write


def test_numbers_of_yaml_are_numbers(file):
    found = read_object(file("a.yaml", "a: 1e-3\nb: -2\nc: +.5\nd: 1.\ne: 007\nf: 1E5"))
    assert found == {"a": 1e-3, "b": -2, "c": 0.5, "d": 1.0, "e": 7, "f": 1e5}
    assert [type(found[name]) for name in "abe"] == [float, int, int]


def test_words_of_yaml_stay_words(file):
    found = read_object(file("a.yaml", "a: no\nb: 12:30\nc: 2026-01-01\nd: true\ne: null\ny: 1\n"))
    assert found == {"a": "no", "b": "12:30", "c": "2026-01-01", "d": True, "e": None, "y": 1}


def test_anchors_save_writing(file):
    found = read_object(file("a.yaml", "steel: &steel {G: 82000, nu: 0.28}\nupper: *steel\nlower: {<<: *steel, nu: 0.3}\n"))
    assert (found["upper"], found["lower"]) == ({"G": 82000, "nu": 0.28}, {"G": 82000, "nu": 0.3})


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("a.json", "{", "is not valid JSON: .*line 1"),
        ("a.json", '{"a": 1, "a": 2}', "the field a is given twice"),
        ("a.json", '{"a": Infinity}', "Infinity is not a valid number"),
        ("a.json", "[1, 2]", "contains a list; it must contain an object"),
        ("a.yaml", "a: 1\na: 2\n", "the field a is given twice"),
        ("a.yaml", "a: [1, 2\nb: 3\n", "is not valid YAML: .*line 2"),
        ("a.yaml", "a: 1\nb: \x07\n", r"is not valid YAML: line 2 has the character .\\x07., which YAML does not allow"),
        ("a.yaml", "1: 2\n", "a field is called 1"),
        ("a.yaml", "", "contains nothing"),
        ("a.yaml", "a: !!python/object/apply:os.getcwd []\n", "could not determine a constructor"),
        ("a.json", "[" * 100_000, "nested too deeply|is not valid JSON"),
        ("a.yaml", "a: {$file: nowhere.npy}\n", "names .*nowhere.npy, which cannot be read"),
        ("a.yaml", "a: {$file: a.yaml}\n", "which contains no array of numbers"),
        ("a.yaml", "a: {$file: empty.npy}\n", "names .*empty.npy, which contains no array of numbers"),
        ("a.yaml", "a: {$file: archive.npy}\n", "it is an archive of arrays"),
    ],
)
def test_what_means_nothing_is_refused_with_its_place(tmp_path, file, name, text, sentence):
    (tmp_path / "empty.npy").touch()
    with (tmp_path / "archive.npy").open("wb") as archive:
        np.savez(archive, a=1)
    with pytest.raises(click.UsageError, match=sentence):
        read_object(file(name, text))


def test_arrays_of_objects_are_refused(tmp_path, file):
    np.save(tmp_path / "evil.npy", np.array([{}], dtype=object), allow_pickle=True)
    with pytest.raises(click.UsageError, match="which contains no array of numbers"):
        read_object(file("a.yaml", "a: {$file: evil.npy}\n"))


@pytest.mark.parametrize("path", ["", "a..b", "a[-1]", "a[" + "1" * 5000 + "]", "a[١]"])
def test_what_is_no_path_is_refused(path):
    with pytest.raises(click.UsageError, match="is not the path of a field"):
        put({}, path, 1)


def test_paths_lead_into_objects_and_lists():
    document = {"ics": {"layers": [{"G": 1}, {"G": 2}]}}
    put(document, "ics.layers[1].G", 3)
    put(document, "friction.rolling.xi", 1e-3)
    assert get(document, "ics.layers[1].G") == 3
    assert document["friction"] == {"rolling": {"xi": 1e-3}}
    assert get(document, "ics.layers[2].G") is None


def test_changes_leave_what_was_read_as_it_was():
    array = np.zeros(3)
    document = {"a": {"b": 1}, "gap": {"array": array}}
    found = changed(document, ["a.b=2", "model=hertz", "a.c=[1, null]"])
    assert found["a"] == {"b": 2, "c": [1, None]}
    assert (found["model"], document["a"], found["gap"]["array"] is array) == ("hertz", {"b": 1}, True)


@pytest.mark.parametrize(
    ("seconds", "shown"), [(2.5e-5, "0.025 ms"), (0.25, "250 ms"), (1, "1 s"), (119, "119 s"), (600, "10 min"), (9000, "2.5 h")]
)
def test_times_have_the_unit_that_suits_them(seconds, shown):
    assert span(seconds) == shown


@pytest.mark.parametrize(("count", "shown"), [(999, "999 bytes"), (7200, "7.2 kB"), (64.8e6, "64.8 MB"), (5e12, "5 TB")])
def test_bytes_have_the_unit_that_suits_them(count, shown):
    assert size(count) == shown


def test_values_are_shown_with_six_digits():
    assert [number(value) for value in (1 / 3, -0.0, 7, True, False, None)] == ["0.333333", "0", "7", "yes", "NO", "-"]


def test_what_is_not_finite_is_null_in_json():
    assert plain_json({"a": float("nan"), "b": np.array([1.0, np.inf]), "c": np.float64(2)}) == {"a": None, "b": [1.0, None], "c": 2.0}


@pytest.mark.parametrize(("heading", "factor"), [("# Value units: m", 1e3), ("# z [µm]", 1e-3), ("# rows from below", 1)])
def test_heights_of_a_file_are_in_mm_by_the_unit_of_its_heading(file, heading, factor):
    file("heights.txt", f"# Channel: Topography\n# Width: 3.00 mm\n{heading}\n1.5e-4 1e-4\n1e-4 5e-5\n")
    found = read_object(file("a.yaml", "gap: {array: {$file: heights.txt}}\n"))["gap"]["array"]
    np.testing.assert_allclose(found, factor * np.array([[1.5e-4, 1e-4], [1e-4, 5e-5]]), rtol=1e-15)


def test_heights_in_a_unit_of_no_length_are_refused_with_their_file(file):
    file("heights.txt", "# Value units: V\n1 2\n")
    with pytest.raises(click.UsageError, match="heights.txt, .*its heading states the unit 'V'"):
        read_object(file("a.yaml", "gap: {array: {$file: heights.txt}}\n"))
