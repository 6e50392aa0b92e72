"""The same requests at the daemons of two commits, and their answers compared byte by byte (python3 -m equality --help)."""
