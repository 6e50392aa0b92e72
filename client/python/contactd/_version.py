"""The version of this package, and the mark of files that it writes, in one place."""

__version__ = "0.1.0"
MARK = "written by contactd"
