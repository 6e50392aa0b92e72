"""Files of the CONTACT program."""

from __future__ import annotations

from dataclasses import replace

from ..values.answers import read
from ..values.generated.contact_files import ContactCase, ContactFile, ContactSlices
from .call import Answering, asks
from .caller import Caller

__all__ = ["ContactFileCalls"]


class ContactFileCalls(Caller):
    """The methods contact_file.* of the daemon."""

    @asks
    def read_contact_file(self, text: str, *, name: str = "text", timeout: float | None = None) -> Answering[ContactFile]:
        """Reads the cases of an input file of the CONTACT program from its `text`: control digits and all values that
        apply.

        Files named in the text are not opened. `name` is the name of the file in error messages. Errors of a case are
        in its `errors`. Use contactd.contact_files.read for a file on disk.
        """
        cases: list[ContactCase] = []
        first = 0
        while True:
            params = {"text": text, "name": name, "first": first}
            answer = yield from self.asked("contact_file.read", params, timeout=timeout)
            page = read(ContactFile, answer)
            cases.extend(page.cases)
            following = answer.get("next")
            if type(following) is not int or following <= first:
                return replace(page, cases=tuple(cases))
            first = following

    @asks
    def read_contact_slices(self, text: str, *, name: str = "text", timeout: float | None = None) -> Answering[ContactSlices]:
        """Reads a list of slices of the CONTACT program from its `text` (.slcs for rails, .slcw for wheels).

        Profiles named in the list are not opened; contactd.contact_files.read_slices reads them, too. `name` is the
        name of the file in error messages. Raises InvalidArgument with line and column of an error.
        """
        answer = yield from self.asked("contact_file.slices", {"text": text, "name": name}, timeout=timeout)
        return read(ContactSlices, answer)
