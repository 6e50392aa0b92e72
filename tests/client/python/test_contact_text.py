"""Tests the text for CONTACT: its layout, texts of other programs, and errors in invalid ones."""

import numpy as np
import pytest

from contactd import TableFileError, TableIcs, load_table, save_table
from support.tables import DX, DY, NX, NY, SIGNS, ic_table, made_up


def pair():
    return TableIcs(made_up(), DX, DY, 320)


def line_of(k, iy):
    """Returns the index of the line of an offset."""
    return 4 + (iy + NY - 1) * (NX + 2) + 2 + k


def write(tmp_path, lines):
    path = tmp_path / "table.txt"
    path.write_text("\n".join(lines) + "\n")
    return path


def test_the_text_is_laid_out_as_contact_reads_it():
    ics, lines = pair(), pair().to_contact_text().split("\n")
    assert lines[:3] == ["1 1", "0 312", "1 0"]
    assert [float(word) for word in lines[3].split()] == [NX, NY, DX, DY]
    assert len(lines) == 4 + (2 * NY - 1) * (NX + 2) + 1
    for iy in range(1 - NY, NY):
        assert all(lines[line_of(0, iy) - n].startswith("%") for n in (1, 2))
        for k in range(NX):
            values = [float(word) for word in lines[line_of(k, iy)].split()]
            assert values[:2] == [k, k * DX]
            columns = [(i, j) for i in (2, 0, 1) for j in (2, 0, 1)]
            expected = [320 * ics.array[i, j, abs(iy), k] * (SIGNS[i, j][1] if iy < 0 else 1) for i, j in columns]
            assert values[2:] == expected


@pytest.mark.parametrize("extent", [(1, 1), (1, 3), (4, 1), (4, 3)])
def test_a_text_is_read_back(tmp_path, extent):
    ics = TableIcs(made_up(nx=extent[0], ny=extent[1]), DX, DY, 320)
    save_table(tmp_path / "table.txt", ics)
    read = load_table(tmp_path / "table.txt")
    assert (read.dx, read.dy, read.G) == (DX, DY, 320)
    np.testing.assert_allclose(read.array, ics.array, rtol=3e-16, atol=0)


def test_the_text_of_one_body_is_that_of_two_such_bodies(tmp_path):
    table = ic_table()
    save_table(tmp_path / "table.txt", table)
    np.testing.assert_allclose(load_table(tmp_path / "table.txt").array, TableIcs.from_table(table).array, rtol=3e-16)


def test_a_text_cannot_be_written_without_a_modulus(tmp_path):
    with pytest.raises(ValueError, match="G is None"):
        save_table(tmp_path / "table.txt", TableIcs(made_up(), DX, DY))
    save_table(tmp_path / "table.txt", TableIcs(made_up(), DX, DY), G=7)
    assert load_table(tmp_path / "table.txt").G == 7
    assert not list(tmp_path.glob("*.part"))


def test_the_modulus_of_the_caller_wins(tmp_path):
    save_table(tmp_path / "table.txt", pair())
    np.testing.assert_allclose(load_table(tmp_path / "table.txt", G=160).array, 2 * pair().array, rtol=1e-15)


def fortran(line):
    return line if line.startswith("%") else line.replace("e", "D")


def bare(line):
    return "" if line.startswith("% offset") else line


@pytest.mark.parametrize(
    "change",
    [
        lambda lines: ["nmatrix iaconvex", *lines[1:]],
        lambda lines: [
            "   1    0    0 0 0 % nmatrix, iaconvex",
            "0 312 % order",
            "1 0 0 0",
            lines[3] + " 0 0",
            *lines[4:],
        ],
        lambda lines: ["% by hand", "", *lines],
        lambda lines: [fortran(line) for line in lines],
        lambda lines: [line + "\r" for line in lines],
        lambda lines: [line if line.startswith("%") else ", ".join(line.split()) for line in lines],
        lambda lines: [*lines, "", "% the end"],
        lambda lines: [bare(line) for line in lines],
    ],
    ids=["words", "more", "comments", "fortran", "windows", "commas", "end", "bare"],
)
def test_texts_of_others_are_read(tmp_path, change):
    lines = change(pair().to_contact_text().split("\n")[:-1])
    read = TableIcs.from_contact_text(write(tmp_path, lines), G=320)
    np.testing.assert_allclose(read.array, pair().array, rtol=3e-16, atol=0)


ROW = line_of(1, 0)


@pytest.mark.parametrize(
    ("line", "text", "says"),
    [
        (0, "3 1", "line 1 announces 3 tables"),
        (0, "1", "line 1 contains too few numbers"),
        (0, "1 5", "line 1 names the convex body 5"),
        (1, "1 312", r"line 2 contains 1 where the column definition \(0 312\) must have 0"),
        (1, "0 123", "line 2 contains 123"),
        (2, "1 1", r"line 3 contains 1 where the symmetry \(1 0\) must have 0"),
        (3, "4 3 0.06", "line 4 contains too few numbers"),
        (3, "4 3 0.06 0", 'line 4 contains "0"; it must contain .* positive'),
        (3, "4.5 3 1 1", 'line 4 contains "4.5"'),
        (3, "0 3 1 1", "line 4 announces 0 x 3"),
        (3, "99999 99999 1 1", "line 4 announces 99999 x 99999"),
        (3, "400 300 1 1", "lines must follow, but there are 30"),
        (3, "4 2 0.06 0.11", "line 5 announces the y offset -2; by the extent in the header it must be -1"),
        (3, "4 3 0.0601 0.11", r"line 8 has x 0\.06; it must be ix dx, 0\.0601"),
        (3, "4 3 0.06 0.1101", r"line 5 has y -0\.22; by the element size in the header it must be -0\.2202"),
        (10, "% offset iy = -1, y = -0.11; sums over both bodies, times G = 3200", "line 11 gives the modulus 3200, .* 320"),
        (ROW, "1 0.06 1 2 3", f"line {ROW + 1} contains 5 numbers; it must contain eleven"),
        (ROW, "1 0.06 1 2 3 4 5 6 7 8 9 10", f"line {ROW + 1} contains 12 numbers"),
        (ROW, "1 0.06 1 2 3 4 5 6 7 8 nine", f'line {ROW + 1} contains "nine"; it must be a finite number'),
        (ROW, "1 0.06 1 2 3 4 5 6 7 8 nan", f'line {ROW + 1} contains "nan"'),
        (ROW, "1 0.06 1 2 3 4 5 6 7 8 1_0", f'line {ROW + 1} contains "1_0"'),
        (ROW, "1 0.06 1 2 3 4 5 6 7 8 1e999", f'line {ROW + 1} contains "1e999"'),
        (ROW, "1 0.06 1 2 3 4 5 6 7 8 ******", f'line {ROW + 1} contains "\\*\\*\\*\\*\\*\\*"'),
        (ROW, "2 0.06 1 2 3 4 5 6 7 8 9", f"line {ROW + 1} has ix 2"),
        (ROW, "1 0.12 1 2 3 4 5 6 7 8 9", f"line {ROW + 1} has x 0.12"),
        (ROW, "1 0.06 1 2 9 4 5 6 7 8 9", f"line {ROW + 1} has 9 for Czy; it must vanish at the y offset 0"),
        (line_of(0, 0), "0 0 1 9 0 0 1 0 0 0 1", f"line {line_of(0, 0) + 1} has 9 for Czx; .* vanish at ix = 0"),
        (line_of(1, 1), "1 0.06 1 2 9 4 5 6 7 8 9", f"line {line_of(1, 1) + 1} .* the value of line {line_of(1, -1) + 1} "),
        (ROW - 3, "0 0 1 2 3 4 5 6 7 8 9", f"line {ROW - 2} contains numbers; it must be one of the two comment lines"),
    ],
)  # fmt: skip
def test_a_broken_line_is_named(tmp_path, line, text, says):
    lines = pair().to_contact_text().split("\n")[:-1]
    lines[line] = text
    with pytest.raises(TableFileError, match=says) as caught:
        load_table(write(tmp_path, lines))
    assert str(caught.value).startswith(f"{tmp_path}/table.txt, ")


def test_what_follows_the_last_offset_is_no_table(tmp_path):
    lines = pair().to_contact_text().split("\n")[:-1]
    with pytest.raises(TableFileError, match=f"line {len(lines) + 1} follows the last y offset"):
        load_table(write(tmp_path, [*lines, lines[-1]]))


@pytest.mark.parametrize("rounded", ["0.1", "0.06", "6e-2", "0.06000001", ".6D-1"])
def test_coordinates_of_few_digits_are_those_of_the_header(tmp_path, rounded):
    lines = pair().to_contact_text().split("\n")[:-1]
    lines[ROW] = lines[ROW].replace(lines[ROW].split()[1], rounded)
    np.testing.assert_allclose(TableIcs.from_contact_text(write(tmp_path, lines)).array, pair().array, rtol=3e-16)


def test_three_digit_exponents_without_a_letter_are_read(tmp_path):
    lines = TableIcs(made_up(nx=1, ny=1), DX, DY, 320).to_contact_text().split("\n")[:-1]
    lines[6] = "0 0.0 1.5 1.0-120 0 0 2.5+000 0 0 0 .5D+1"
    read = TableIcs.from_contact_text(write(tmp_path, lines), G=1)
    assert [read[name][0, 0] for name in ("zz", "xx", "yy")] == [1.5, 2.5, 5]


@pytest.mark.parametrize("G", [1, 256])
def test_a_modulus_that_is_a_power_of_two_costs_no_bit(tmp_path, G):
    save_table(tmp_path / "table.txt", TableIcs(made_up(), DX, DY, G))
    np.testing.assert_array_equal(load_table(tmp_path / "table.txt").array, made_up())


def test_opposite_offsets_may_differ_as_much_as_one_allows(tmp_path):
    lines = pair().to_contact_text().split("\n")[:-1]
    words = lines[line_of(2, -1)].split()
    words[2] = str(float(words[2]) * 1.01)
    lines[line_of(2, -1)] = " ".join(words)
    path = write(tmp_path, lines)
    with pytest.raises(TableFileError, match="for Czz; it must be the value of line"):
        TableIcs.from_contact_text(path)
    read = TableIcs.from_contact_text(path, tolerance=0.1)
    assert read["zz"][1, 2] == pytest.approx(1.005 * pair()["zz"][1, 2], rel=1e-12)


@pytest.mark.parametrize("length", [0, 3, 12, 500, 4000])
def test_a_text_that_ends_too_soon(tmp_path, length):
    path = tmp_path / "table.txt"
    path.write_text(pair().to_contact_text()[:length])
    with pytest.raises(TableFileError, match=r"line \d+ "):
        load_table(path)


def test_a_file_that_is_no_text(tmp_path):
    path = tmp_path / "table.txt"
    path.write_bytes(bytes(range(256)) * 20)
    with pytest.raises(TableFileError):
        load_table(path)


def test_a_text_that_does_not_tell_its_modulus(tmp_path):
    path = write(tmp_path, [bare(line) for line in pair().to_contact_text().split("\n")[:-1]])
    with pytest.raises(TableFileError, match="G is missing"):
        load_table(path)
    with pytest.raises(ValueError, match="G is -1; it must be positive"):
        load_table(path, G=-1)


def test_damaged_texts_are_read_or_refused(tmp_path):
    whole, random = pair().to_contact_text(), np.random.default_rng(20240229)
    letters, refused = "0123456789.eED+-% ,\n\r\t*\xff", 0
    path = tmp_path / "table.txt"
    for _ in range(500):
        text = whole
        for _ in range(random.integers(1, 4)):
            at = int(random.integers(len(text) if random.integers(2) else 40))
            if random.integers(2):
                text = text[:at] + text[at + int(random.integers(1, 31)) :]
            else:
                text = text[:at] + letters[random.integers(len(letters))] + text[at:]
        path.write_text(text, encoding="latin-1")
        try:
            assert load_table(path).array.shape[:2] == (3, 3)
        except TableFileError:
            refused += 1
    assert refused > 200
