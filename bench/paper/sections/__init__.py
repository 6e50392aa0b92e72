"""Computes the numbers and figures of docs/sections.md, about bodies given by their cross-section."""
