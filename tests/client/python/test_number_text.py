"""Tests numbers in text, as spreadsheets, programs and users write them."""

from __future__ import annotations

import pytest

from contactd.files.number_text import number_in, rows_of, table_of

POINTS = [[-30.0, 1.5], [0.0, 0.0], [30.0, 1.5]]


@pytest.mark.parametrize(
    "text",
    [
        "-30 1.5\n0 0\n30 1.5\n",
        "-30,1.5\r\n0,0\r\n30,1.5\r\n",
        "-30;1.5\n0;0\n30;1.5",
        "-30;1,5\n0;0\n30;1,5",
        "y;z\n-30,0; 1,5\n0; 0\n30; 1,5",
        "Y [mm]\tZ [mm]\n-30\t1,5\n0\t0\n30\t1,5",
        "-30, 1,5\n0, 0\n30, 1,5",
        "-30,0 1,5\n0,0 0,0\n30,0 1,5",
        "% rail\n! of yesterday\ny z # heading\n-30 1.5 % end\n0 0\n30 1.5 \"a remark\n",
        '"y","z"\n"-30","1.5"\n"0","0"\n"30","1.5"\n',
        "measured rail\nside left\n-3.0d1 .15D+1\n\n0 0\n+30 1.5e0\n",
    ],
)
def test_points_are_the_same_in_whatever_form_they_are_written(text):
    assert rows_of(text) == POINTS


def test_a_comma_between_two_numbers_parts_them():
    assert rows_of("1,2\n3,4") == [[1, 2], [3, 4]]
    assert rows_of("1,2,3\n4,5,6") == [[1, 2, 3], [4, 5, 6]]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("1 2\n3 x\n", "line 2 has 'x'"),
        ("y z\n1 2\ny z\n", "line 3 has 'y'"),
        ("1 2\n\n3\n", "line 3 has 1 numbers, but the first has 2"),
        ("1;;2\n", "line 1 has ''"),
        ("1,5 2\n3,5\n", "line 2 has 1 numbers"),
        ("nan 1\n", "line 1 has 'nan'"),
        ("1 inf\n", "line 1 has 'inf'"),
        ("1_000 2\n", "line 1 has '1_000'"),
        ("# nothing\n", "it has none"),
        ("", "it has none"),
    ],
)
def test_what_is_no_row_of_numbers_is_refused_with_its_line(text, sentence):
    with pytest.raises(ValueError, match=f"^{sentence}"):
        rows_of(text)


@pytest.mark.parametrize(("word", "value"), [("1", 1), ("-.5", -0.5), ("+1.", 1), ("1d-3", 1e-3), ("1D3", 1e3), ("e3", None), ("", None), ("1e", None), ("٣", None)])
def test_words_that_are_numbers(word, value):
    assert number_in(word) == value


@pytest.mark.parametrize(
    "text",
    [
        "Fn,friction.rolling.xi\n1.5,2\n,3\n",
        "Fn;friction.rolling.xi\r\n1,5;2\r\n;3\r\n",
        "# steps\nFn\tfriction.rolling.xi\n1,5\t2\n\t3\n",
        '"Fn", "friction.rolling.xi"\n"1.5", 2 ! first\n,3\n',
    ],
)
def test_a_table_has_cells_below_names(text):
    names, rows = table_of(text)
    assert names == ["Fn", "friction.rolling.xi"]
    assert [cells for _, cells in rows] == [["1.5", "2"], ["", "3"]]


def test_a_row_of_another_length_is_refused():
    with pytest.raises(ValueError, match="line 3 has 3 columns, but the first has 2"):
        table_of("a;b\n1;2\n1;2;3\n")


def test_a_table_names_each_column_once():
    with pytest.raises(ValueError, match="line 2 names Fn twice"):
        table_of("% steps\nFn, xi, Fn\n1, 2, 3\n")
    for headless in ("1, 1, 0.3\n2, 1, 0.3\n", "0,5;1\n0,6;2\n", "Fn, 3\n1, 2\n"):
        with pytest.raises(ValueError, match=r"line 1 has the number [0-9,.]+ instead of the name of a column; add a line with the names"):
            table_of(headless)
    with pytest.raises(ValueError, match="line 1 has no name for column 2"):
        table_of("Fn;;xi\n1;2;3\n")


def test_a_sign_of_comments_in_quotation_marks_belongs_to_the_cell():
    assert table_of('name, Fn # of today\n"5 % of, all!", 1 % one\n') == (["name", "Fn"], [(2, ["5 % of, all!", "1"])])
