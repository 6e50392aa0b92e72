"""Files of the CONTACT program (docs/contact-files.md).

::

    from contactd import contact_files, local

    with local() as client:
        for case in contact_files.read("testbank.inp", client):
            print(case.number, case.digits["T"], case.values.get("FN"))
"""

from .case import Case, ContactFile
from .input_file import read
from .slice_list import read_slices

__all__ = ["Case", "ContactFile", "read", "read_slices"]
