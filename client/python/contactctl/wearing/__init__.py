"""Reads wear studies from files, and solves and shares their states."""
