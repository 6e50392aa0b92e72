"""Computes sections 3 and 4 of the paper again (`./dev paper fem`, `./dev paper contact`) and writes docs/paper/.

A section (section.py) is a folder here: its cases as plain data, a solver, pictures, and findings for its page, whose
template is <section>.md.in. The rest is common: results are stored as they come (run.py, store.py), become CSV files
(rows.py), and pictures and page are made from these files alone (outputs.py, page.py).
"""
