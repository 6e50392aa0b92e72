"""Solves a parameter study: its plan, its rows, and their solution.

`plan` reads the file, `journal` stores rows so that a crash never loses or duplicates one, `solving` solves a case, and
`here` and `by_dask` run many. `shares` divides a study among independent processes, and `hdf5` writes all rows as
arrays to one file.
"""
