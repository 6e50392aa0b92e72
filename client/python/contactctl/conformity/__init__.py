"""Checks against standards: the benchmark of EN 15302, and quantities of a run by EN 14363."""
