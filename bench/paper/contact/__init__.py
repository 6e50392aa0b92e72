"""Computes section 4 of the paper: the Cattaneo problem with computed influence coefficients."""
