"""Represents a case of an input file."""

from ..values.generated.contact_files import ContactCase as Case
from ..values.generated.contact_files import ContactFile

__all__ = ["Case", "ContactFile"]
