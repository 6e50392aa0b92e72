"""Studies of wear: files that describe them, and how their states are solved and shared."""
