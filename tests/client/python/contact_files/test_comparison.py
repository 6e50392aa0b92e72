"""Tests printed numbers read from .out files, and differences from them."""

from __future__ import annotations

import pytest

from contactctl.cases.comparing import compared_rows
from contactd.contact_files.comparison import Compared, case_differences, matched
from contactd.contact_files.out_reader import PrintedCase, printed_cases

PRINTED = """\
 Case     7, result element   3
 some flow trace   1.0

 TOTAL FORCES, TORSIONAL MOMENT, ELASTIC ENERGY, FRICTIONAL POWER
     FN          FX          FY          MZ         ELAST.EN.   FRIC.POWER
     1.067E+05      -9112.       0.000       0.000       3.294      -29.67
     FN/G       CREEP X     FY/FSTAT/FN  APPROACH     PMAX
         1.301   4.000E-04       0.000   7.651E-02       640.7

    NPOT   NCON   NADH  NSLIP  INORM  ITANG
    2112   1384   1182    202      1      1

 Case     8 for contact problem  2 on result element  4
     FX(TR)      FY(TR)      FZ(TR)      FX(WS)      FY(WS)      FZ(WS)
      0.2783      -36.24      10000.      0.2783      -36.24      10000.
 ----- DATA FOR CONTACT PATCH  1 (PREV  1,  2) -----
     XCP(TR)     YCP(TR)     ZCP(TR)    DELTCP(TR)   YCP(R)      ZCP(R)
      0.0000   -751.8726      0.1252      0.0290      8.6600      0.1252
     FN          FX          FS          MN         ELAST.EN.   FRIC.POWER
         9997.      0.2783       253.6       4605.   6.042E-02     -0.4677
 ----- DATA FOR CONTACT PATCH  2 -----
     FN          FX          FS          MN         ELAST.EN.   FRIC.POWER
         1000.       0.000       0.000       0.000       0.000       *****
"""


def test_cases_and_patches_are_read_by_their_labels() -> None:
    first, second = printed_cases(PRINTED)
    assert (first.number, first.reid, first.line) == (7, 3, 1)
    assert first.numbers == {
        "FN": 106700.0, "FX": -9112.0, "FY": 0.0, "MZ": 0.0, "ELAST.EN.": 3.294, "FRIC": -29.67, "FN/G": 1.301,
        "CREEP X": 4e-4, "FY/FSTAT/FN": 0.0, "APPROACH": 7.651e-2, "PMAX": 640.7, "NPOT": 2112, "NCON": 1384, "NADH": 1182,
        "NSLIP": 202, "INORM": 1, "ITANG": 1,
    }  # fmt: skip
    assert (second.number, second.reid, second.cpid) == (8, 4, 2)
    assert first.cpid is None
    assert second.numbers["FZ(WS)"] == 10000
    assert [patch["FN"] for patch in second.patches] == [9997, 1000]
    assert second.patches[0]["DELTCP(TR)"] == 0.029


@pytest.mark.parametrize(
    ("name", "inside", "outside"),
    [
        ("FX", -9112 + 16.9, -9112 + 17.1), ("FY", 16.9, 17.1), ("CREEP X", 4e-4 * 1.0004, 4e-4 * 1.0006),
        ("APPROACH", 7.651e-2 * 0.9996, 7.651e-2 * 0.9994), ("PMAX", 640.7 * 1.003, 640.7 * 1.005), ("NADH", 1185, 1186),
    ],
)  # fmt: skip
def test_a_number_out_of_tolerance_is_told(name: str, inside: float, outside: float) -> None:
    printed, _ = printed_cases(PRINTED)
    bound = 34000.0
    assert case_differences(Compared({**printed.numbers, name: inside}, bound), printed) == []
    (sentences,) = case_differences(Compared({**printed.numbers, name: outside}, bound), printed)
    assert sentences.startswith(f"{name} ")


def test_another_number_of_patches_is_told() -> None:
    _, printed = printed_cases(PRINTED)
    assert case_differences(Compared(printed.numbers, 3000.0, printed.patches, [3000, 300]), printed) == []
    sentences = case_differences(Compared(printed.numbers, 3000.0, printed.patches[:1], [3000]), printed)
    assert sentences == ["1 patches, printed 2"]
    moved = [{**printed.patches[0], "YCP(TR)": -751.85}, printed.patches[1]]
    (told_of_place,) = case_differences(Compared(printed.numbers, 3000.0, moved, [3000, 300]), printed)
    assert told_of_place.startswith("patch 1: YCP(TR) ")


def test_a_number_that_is_none_is_out_of_tolerance() -> None:
    printed, _ = printed_cases(PRINTED)
    assert len(case_differences(Compared({**printed.numbers, "FX": float("nan")}, 1.0), printed)) == 1


def test_cases_of_contact_problems_that_number_alike_are_compared_with_their_own() -> None:
    printed = printed_cases(
        " Case     1 for contact problem  1 on result element  4\n     FN\n     100.\n"
        " Case     1 for contact problem  2 on result element  4\n     FN\n     200.\n"
    )

    def row(cpid: int, force: float) -> dict[str, object]:
        return {"values": {"number": 1, "reid": 4, "cpid": cpid}, "answers": {"numbers": {"numbers": {"FN": force}, "bound": 0.0}}}

    assert compared_rows([row(2, 200.0), row(1, 100.0)], printed) == [[], []]
    assert compared_rows([row(3, 200.0)], printed) == [["the file for comparison does not contain it"]]


def test_a_printed_case_is_taken_once_and_by_its_result_element():
    first, second, other = PrintedCase(1, None, 1), PrintedCase(1, None, 9), PrintedCase(1, 4, 20, cpid=2)
    cases = [(1, None, None), (1, 4, 2), (1, None, None), (1, None, None), (1, 4, 1)]
    assert matched(cases, [first, second, other]) == [first, other, second, None, None]
