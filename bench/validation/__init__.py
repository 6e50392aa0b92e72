"""Computes the public cases of the CONTACT program and compares its printed numbers with ours (`./dev validate`).

given.py finds the cases, and measure.py computes them. cases.csv and times.csv (table.py, times.py) hold the results.
Pictures (figures.py) and the page, whose template is validation.md.in, are made from these files alone (findings.py,
outputs.py). Only reasons.py contains the reasons for differences.
"""
