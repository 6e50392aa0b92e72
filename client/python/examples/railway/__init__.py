"""Parts that the examples with wheels on rails share: motion, track, who solves the wheels, stability."""
