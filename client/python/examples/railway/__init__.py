"""Contains common parts of the wheel-rail examples: motion, track, solvers of the wheels, stability."""
