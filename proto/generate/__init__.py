"""Generates the code that follows from the fields declared in proto/schema. `./dev generate` writes it; git keeps it."""
