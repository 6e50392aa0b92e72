"""Computes the public cases of the CONTACT program and puts its printed numbers beside ours (`./dev validate`).

Which cases there are is in given.py, what they are computed by in measure.py. cases.csv and times.csv (table.py,
times.py) hold what came out; pictures (figures.py) and the page, whose template is validation.md.in, are made from these
files alone (findings.py, outputs.py). Why cases differ is in reasons.py, and nowhere else.
"""
