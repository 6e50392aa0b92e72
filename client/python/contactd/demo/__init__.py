"""Solves and draws the Cattaneo problem, and compares it with its closed form: ``python -m contactd.demo``."""
