"""Repeats the computations of sections 3 and 4 of the paper (`./dev paper fem`, `./dev paper contact`) and writes
docs/paper/.

Each section (section.py) has a folder with its cases as plain data, a solver, pictures, and findings for its page,
whose template is <section>.md.in. The other modules are common to all sections. Results are stored as they arrive
(run.py, store.py) and written as CSV files (rows.py). Pictures and page are made from these files alone (outputs.py,
page.py).
"""
