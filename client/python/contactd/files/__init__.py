"""Reads and writes files of values: problems and solutions, tables of influence coefficients."""
