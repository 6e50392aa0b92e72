"""Tests the references for the errors of a table."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from contactd import AnalyticIcs, InternalError
from paper.sections.cases import FINEST
from paper.sections.measure import COMPONENTS, Solver

SPEC = {"kind": "table", "section": {"slab": {"thickness": 1, "width": 9}}, "columns": 2, "nu": 0.28, "accuracy": 1e-2}


class Table(dict):
    """Returns a table filled with 1 + accuracy, whose reciprocity is off by `defect`."""

    def __init__(self, accuracy, defect=0.0):
        super().__init__({name: np.full((2, 2), 1 + accuracy) for name in COMPONENTS})
        self.evidence = SimpleNamespace(section=SimpleNamespace(error=accuracy, reciprocity_defect=defect))


class FakeClient:
    """Records the requested accuracies."""

    def __init__(self, defect=0.0, refusal=None):
        self.asked, self._defect, self._refusal = [], defect, refusal

    def get_ic(self, material, grid, ics):
        if isinstance(ics, AnalyticIcs):
            return Table(0)
        self.asked.append(ics.accuracy)
        if ics.accuracy == FINEST and self._refusal:
            raise InternalError(self._refusal)
        return Table(ics.accuracy, self._defect)


def measured(client, monkeypatch):
    monkeypatch.setattr(Solver, "_processor_seconds", lambda self, spec: 2.0)
    return Solver(client, Path()).measure(SPEC)


def test_a_table_is_compared_with_the_finest_one(monkeypatch):
    found = measured(FakeClient(), monkeypatch)
    assert (found["finest_asked"], found["seconds"]) == (FINEST, 2.0)
    assert found["found"] == pytest.approx(1e-2 - FINEST)


def test_where_the_finest_is_refused_the_next_one_stands_in(monkeypatch):
    found = measured(FakeClient(refusal="The accuracy of 0.0001 was not reached"), monkeypatch)
    assert found["finest_asked"] == 1e-3
    assert found["found"] == pytest.approx(9e-3)


def test_a_defect_of_reciprocity_is_stated_and_refuses_no_accuracy(monkeypatch):
    found = measured(FakeClient(defect=0.02), monkeypatch)
    assert found["reciprocity"] == 0.01
    assert found["finest_asked"] == FINEST


def test_any_other_failure_ends_the_run(monkeypatch):
    with pytest.raises(InternalError, match="killed"):
        measured(FakeClient(refusal="The builder was killed."), monkeypatch)
