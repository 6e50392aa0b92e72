"""Files of the CONTACT program."""

from __future__ import annotations

from dataclasses import replace

from ..values.answers import read
from ..values.contact_files import ContactCase, ContactFile, ContactSlices
from .call import Answering, asks
from .caller import Caller

__all__ = ["ContactFileCalls"]


class ContactFileCalls(Caller):
    """The methods contact_file.* of the daemon."""

    @asks
    def read_contact_file(self, text: str, *, name: str = "text", timeout: float | None = None) -> Answering[ContactFile]:
        """Cases of the `text` of an input file of the CONTACT program: control digits, and all values in force.

        Nothing that the file names is opened. `name` is that of the file, for refusals. What is wrong with a case is in
        its `errors`. contactd.contact_files.read reads a file on disk by this.
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
        """Slices of the `text` of a list of the CONTACT program (.slcs of rails, .slcw of wheels).

        Profiles that the list names are not opened: contactd.contact_files.read_slices reads them, too. `name` is that of
        the file, for refusals. Raises InvalidArgument with line and column of what does not fit.
        """
        answer = yield from self.asked("contact_file.slices", {"text": text, "name": name}, timeout=timeout)
        return read(ContactSlices, answer)
