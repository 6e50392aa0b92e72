"""Wear studies: files that describe them, and the solution and sharing of their states."""
