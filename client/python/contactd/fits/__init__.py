"""Parameters of friction from measured creep curves."""
