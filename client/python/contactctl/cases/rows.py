"""Rows of the journal of a run, which contain everything that is written for each case."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from contactd import __version__
from contactd.contact_files.case import Case
from contactd.contact_files.out_file import lines_of
from contactd.contact_files.solved_case import SolvedCase

from ..codes import Code
from ..output import plain_json

__all__ = ["case_name", "code_of_status", "keys_of", "row_of", "row_values"]

_CODES = {"solved": Code.DONE, "read": Code.DONE, "not converged": Code.NOT_CONVERGED, "wrong": Code.USAGE, "failed": Code.FAILED}


def keys_of(chain: Sequence[Case], options: Mapping[str, Any]) -> list[str]:
    """Returns a key for each case of a chain: equal for the same preceding cases and the same options."""
    digest = hashlib.sha256(json.dumps([__version__, options], sort_keys=True).encode())
    keys = []
    for case in chain:
        digest.update(json.dumps(plain_json(asdict(case)), sort_keys=True).encode())
        keys.append(digest.hexdigest()[:32])
    return keys


def case_name(values: Mapping[str, Any]) -> str:
    """Names a case by its number and its line, because several result elements may have cases with the same number."""
    return f"{values['number']} (line {values['line']})"


def code_of_status(status: str) -> Code:
    """Returns the exit code of a command for a case."""
    return _CODES.get(status, Code.REFUSED)


def row_of(key: str, solved: SolvedCase) -> dict[str, Any]:
    """Returns the row of a case, whether or not it was computed."""
    answers: dict[str, Any] = {"status": solved.status, "sentence": solved.sentence, "lines": lines_of(solved)}
    if solved.warnings:
        answers["warnings"] = list(solved.warnings)
    if (compared := solved.compared) is not None:
        answers["numbers"] = plain_json(compared)
    code = int(code_of_status(solved.status))
    return {"key": key, "code": code, "values": row_values(solved.case), "answers": answers, "seconds": solved.answer.seconds}


def row_values(case: Case) -> dict[str, Any]:
    """Returns the identification of a case: its number, its result element and its contact problem."""
    return {"number": case.number, "line": case.line, "module": case.module, "reid": case.reid, "cpid": case.cpid}
