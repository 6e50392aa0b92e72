"""Writes tables and pictures to files."""
