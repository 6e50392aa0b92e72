"""What follows from the fields that proto/schema declares is written by `./dev generate`, and kept in git."""
