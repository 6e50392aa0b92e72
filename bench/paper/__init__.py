"""Computes the paper's section 3 again and writes docs/paper/: CSV files, pictures and the page (`./dev paper fem`)."""
