"""Fits parameters of friction to measured creep curves."""
