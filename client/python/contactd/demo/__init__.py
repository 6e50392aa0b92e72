"""The Cattaneo problem beside its closed form, solved and drawn: ``python -m contactd.demo``."""
