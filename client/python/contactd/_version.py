"""Defines the version of this package and the identification of the files that it writes."""

__version__ = "0.1.0"
MARK = "written by contactd"
