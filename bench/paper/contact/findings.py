"""Checks the statements of section 4 with our numbers: values for the page, and verdicts from the rows."""

from __future__ import annotations

from ..finding import Found, Rows, merge
from . import findings_bilinear, findings_compared, findings_normal, findings_tangential, sources

FUNCTIONS = (
    findings_normal.analytic,
    findings_normal.mesh1,
    findings_normal.larger_blocks,
    findings_normal.mesh2,
    findings_bilinear.bilinear,
    findings_compared.finest_grid,
    findings_compared.all_grids,
    findings_tangential.reference,
    findings_tangential.share_of_bound,
    findings_tangential.against_L,
    findings_tangential.analytic,
    sources.sources,
)


def find(rows: Rows) -> Found:
    return merge(function(rows) for function in FUNCTIONS)
