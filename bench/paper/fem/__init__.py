"""Computes section 3 of the paper: influence coefficients by finite elements, beside the closed form."""
