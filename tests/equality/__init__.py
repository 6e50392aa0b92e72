"""Sends the same requests to the daemons of two commits, and compares their answers byte by byte (python3 -m equality
--help)."""
