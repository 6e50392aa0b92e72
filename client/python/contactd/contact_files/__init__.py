"""Reads, computes and writes files of the CONTACT program (docs/contact-files.md).

::

    from contactd import contact_files

    cases = contact_files.run("testbank.inp")
    print(cases[0].forces, cases[0].patches[0].pressure)
    print(cases.compare("testbank.out"))

`read` reads cases without computing them::

    with contactd.local() as client:
        for case in contact_files.read("testbank.inp", client):
            print(case.number, case.digits["T"], case.values.get("FN"))
"""

from .case import Case, ContactFile
from .input_file import read
from .runner import run
from .slice_list import read_slices
from .solved_case import SolvedCase
from .solved_cases import CaseComparison, ComparedCase, SolvedCases

__all__ = [
    "Case",
    "CaseComparison",
    "ComparedCase",
    "ContactFile",
    "SolvedCase",
    "SolvedCases",
    "read",
    "read_slices",
    "run",
]
