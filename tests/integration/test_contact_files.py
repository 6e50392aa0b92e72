"""Tests contact_file.*: cases of input files of the CONTACT program, read in pages, compared with its printed results,
and computed."""

import asyncio
import json
from collections import Counter
from pathlib import Path

import pytest

import contactd
from contactd import contact_files
from support.contact_prints import echoes, printed_cases

GIVEN = Path(__file__).parents[3] / "shared" / "contact"
BALL = """3 MODULE
200100 P-B-T-N-F-S
022020 L-D-C-M-Z-E
000001 H-G-I-A-O-W-R
999 20 25 1 1e-5   MAXGS, MAXIN, MAXNR, MAXOUT, EPS
1000. 0. 0. 0.     FN, CKSI, CETA, CPHI
0.3 0.3            FSTAT, FKIN
0.28 0.28 82000. 82000.
-3                 IPOTCN
20 20 1. 2. 1.2    MX, MY, AA, BB, SCALE
"""
NEXT = "3 MODULE\n200100\n100000\n101001\n{}. 0. 0. 0.\n"
END = "0 MODULE\n"


def test_a_text_is_read(shared):
    file = shared.read_contact_file(BALL + END, name="ball.inp")
    (case,) = file
    assert (case.number, case.line, case.module, case.reid) == (1, 2, 3, None)
    assert (case.values["FN"], case.values["MX"], case.values["AA"]) == (1000.0, 20, 1.0)
    assert case.friction == ({"FSTAT": 0.3, "FKIN": 0.3},)
    assert not (case.warnings or case.errors or file.warnings or file.errors)


def test_a_file_is_read_by_its_path(shared, tmp_path):
    path = tmp_path / "ball.inp"
    path.write_bytes("% Größe\r\n".encode("latin-1") + BALL.replace("\n", "\r\n").encode() + END.encode())
    (case,) = contact_files.read(path, shared)
    assert case.line == 3
    assert contact_files.read(BALL + END, shared)[0].values == case.values


def test_each_case_of_a_history_has_what_it_keeps(shared):
    text = BALL + "".join(NEXT.format(force) for force in range(1, 1000)) + END
    file = shared.read_contact_file(text)
    assert [case.number for case in file] == list(range(1, 1001))
    assert file[999].values["FN"] == 999
    assert file[999].values["AA"] == 1


@pytest.mark.slow  # checks half a million numbers against the schema of the answer
def test_cases_that_repeat_large_lists_come_in_pages(shared, raw):
    elements = 300 * 300
    gap = ("0 " * 40 + "\n") * (elements // 40)
    large = BALL.replace("-3                 IPOTCN\n20 20 1. 2. 1.2", f"1\n300 300 -1. -1. .01 .01\n9 1\n{gap}%")
    text = large + NEXT.format(5) * 6 + END
    assert raw.ask("contact_file.read", {"text": text}).envelope["result"]["next"] == 5
    file = shared.read_contact_file(text)
    assert [case.number for case in file] == list(range(1, 8))
    assert all(len(case.values["GAP"]) == elements for case in file)


def test_mistakes_are_told_by_case(shared):
    file = shared.read_contact_file(BALL.replace("0.28 0.28", "0.28 abc") + NEXT.format(5) + BALL + END)
    assert 'line 8, column 6, has "abc" where POISS2' in file[0].errors[0]
    assert "keeps data of case 1" in file[1].errors[0]
    assert not file[2].errors


def test_another_programs_file_says_so(shared):
    file = shared.read_contact_file("header.begin\nheader.end\n")
    assert len(file) == 0
    assert "where the number of a MODULE is expected" in file.errors[0]


def test_what_is_no_text_is_refused_by_the_name_of_the_file(shared):
    with pytest.raises(contactd.InvalidArgument, match=r"ball\.inp"):
        shared.read_contact_file("3 MODULE\0", name="ball.inp")


#: Heights that the program changed by a massless flexible rail before it printed them.
NOT_ECHOED = {
    ("testbank/testbank.inp", 36, "Z_WS"): ("2.0855", "2.0884"),
    ("testbank/testbank.inp", 37, "Z_WS"): ("2.0685", "2.0884"),
}


@pytest.fixture(scope="module")
def given():
    if not GIVEN.exists():
        pytest.skip(f"there is no {GIVEN}")
    files = json.loads((GIVEN / "cases_given.json").read_text())["files"]
    return [file for file in files if (GIVEN / file["file"]).exists()]


def test_digits_of_the_public_cases_are_those_that_are_known(shared, given):
    cases = 0
    for file in given:
        read = contact_files.read(GIVEN / file["file"], shared)
        assert not read.errors
        assert len(read) == len(file["cases"]), file["file"]
        begins = True  # has a separate module line; for others the previous line applies
        for case, known in zip(read, file["cases"], strict=True):
            assert not case.errors, (file["file"], case.number, case.errors)
            assert (case.number, case.module) == (known["case"], known["module"])
            assert case.line == known["line"] or (not begins and case.line > known["line"]), (file["file"], case.number)
            digits = {name: digit for name, digit in case.digits.items() if name != "W2"}
            assert digits == known["digits"], (file["file"], case.number)
            begins = case.digits["R"] % 2 == 1
            cases += 1
    assert cases == 852


def test_public_cases_are_echoed_as_the_program_printed_them(shared, given):
    compared, differ = Counter(), {}
    for file in given:
        read = contact_files.read(GIVEN / file["file"], shared)
        printed = list(printed_cases((GIVEN / file["reference"]).read_text(errors="replace")))
        assert [case.number for case in printed] == [case.number for case in read], file["file"]
        for case, shown in zip(read, printed, strict=True):
            for echo in echoes(case, shown):
                compared[echo.name] += 1
                if echo.printed != echo.expected:
                    differ[file["file"], case.number, echo.name] = (echo.printed, echo.expected)
    assert differ == NOT_ECHOED
    assert compared.total() == 26881


def test_a_run_continues_in_further_calls_with_the_same_answers(shared):
    text = BALL + NEXT.format(500) + NEXT.format(800) + END
    whole = shared.run_contact_file(text, fields=[])
    assert [case.status for case in whole.cases] == ["solved"] * 3 and whole.run is None
    parts = [shared.run_contact_file(text, seconds=1e-9, fields=[])]
    while parts[-1].run is not None:
        parts.append(shared.run_contact_file(run=parts[-1].run, seconds=1e-9, fields=[]))
    assert [len(part.cases) for part in parts] == [1, 1, 1, 0]
    for one, other in zip(whole.cases, (case for part in parts for case in part.cases), strict=True):
        assert one.numbers == other.numbers
    with pytest.raises(contactd.NotFound):
        shared.run_contact_file(run=parts[0].run)
    with pytest.raises(contactd.InvalidArgument, match="without run"):
        shared.run_contact_file(text, run="x")


def test_chosen_cases_and_arrays_are_returned(shared):
    text = BALL + NEXT.format(500) + END
    (case,) = shared.run_contact_file(text, cases=[1], fields="pressure").cases
    assert case.numbers["FN"] == pytest.approx(500)
    assert case.patches[0].arrays["PN"].shape == case.contact.pressure.shape == (20, 20)
    assert not hasattr(case.contact, "traction_x") and case.contact.grid == case.patches[0].grid
    (bare,) = shared.run_contact_file(text, cases=[1], arrays=False).cases
    assert bare.patches[0].arrays is None and isinstance(bare.contact, contactd.ContactSolution)


def test_the_asynchronous_client_runs_and_converts_files(shared):
    async def both():
        async with contactd.AsyncClient(shared.endpoint) as client:
            return await client.run_contact_file(BALL + END), await client.convert_contact_file(BALL + END)

    computed, converted = asyncio.run(both())
    assert computed.cases[0].contact.Fn == pytest.approx(1000)
    assert shared.call("contact.solve", dict(converted.cases[0].contact))["pmax"] == computed.cases[0].contact.pmax
