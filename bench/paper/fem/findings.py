"""Checks the paper's statements with our numbers: values for the page, and verdicts computed from the rows.

Every function takes the rows of all parts and returns (values, verdicts); a verdict is True where we agree.
"""

from __future__ import annotations

from ..finding import Found, Rows, merge
from . import findings_discussion, findings_mesh1, findings_mesh2, findings_solver, tables

FUNCTIONS = (
    findings_mesh1.elements_and_origin,
    findings_mesh1.truncation,
    findings_mesh1.tests_of_mesh1,
    findings_mesh1.cost,
    findings_mesh1.finer_grids,
    findings_solver.incomplete,
    findings_solver.table1,
    findings_mesh2.mesh2,
    findings_discussion.table3,
    findings_discussion.orders,
    findings_discussion.finer_grids,
    findings_discussion.components,
    findings_discussion.other_conclusions,
    tables.beyond,
)


def find(rows: Rows) -> Found:
    return merge(function(rows) for function in FUNCTIONS)
