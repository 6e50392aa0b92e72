"""Tables and pictures that commands write to files."""
