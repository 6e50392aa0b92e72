"""A sweep over the parameters of a problem: its plan, its rows, and who solves them.

`plan` reads the file, `journal` keeps rows so that no moment of a crash loses or doubles one, `solving` makes a row of a case,
`here` and `by_dask` are the two ways to run many. `shares` parts a study among processes that know nothing of each other, and
`hdf5` writes all rows as one file of arrays.
"""
