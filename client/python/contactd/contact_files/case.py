"""A case of an input file."""

from ..values.contact_files import ContactCase as Case
from ..values.contact_files import ContactFile

__all__ = ["Case", "ContactFile"]
