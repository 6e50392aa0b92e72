"""Computes cases of the CONTACT program's input files in threads, with a journal, comparisons and output files."""
