"""Implements calls for files of the CONTACT program."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from ..errors import invalid
from ..values.answers import read
from ..values.generated.contact_files import (
    ComputedCase,
    ComputedCases,
    ContactCase,
    ContactFile,
    ContactSlices,
    ConvertedCases,
)
from ..values.generated.wheel_rail.setup import WheelSurface
from ..values.solution import Fields, names_of
from ..values.step_solution import read_solution
from ..values.wheel_rail.solution import read_wheel_rail
from .call import Answering, asks
from .caller import Caller

__all__ = ["ContactFileCalls"]


class ContactFileCalls(Caller):
    """Calls the methods contact_file.* of the daemon."""

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
    def run_contact_file(
        self,
        text: str | None = None,
        *,
        run: str | None = None,
        name: str | None = None,
        files: Iterable[Mapping[str, str]] = (),
        cases: Iterable[int] | None = None,
        wheel_surface: WheelSurface | None = None,
        max_elements: int | None = None,
        seconds: float | None = None,
        arrays: bool = True,
        fields: Fields | None = None,
        timeout: float | None = None,
    ) -> Answering[ComputedCases]:
        """Computes the cases of an input file of the CONTACT program from its `text`: forces, patches and arrays by
        CONTACT's names.

        The call answers after `seconds` with the cases that are complete, at least one. If cases are left, the answer
        has the name of a `run`, which is the argument of the next call::

            part = client.run_contact_file(text)
            while part.run is not None:
                part = client.run_contact_file(run=part.run)

        `files` are the files that the cases name, as ``{"name": ..., "text": ...}``, or ``{"name": ..., "failure":
        ...}`` for a file that cannot be read. `cases` are the indices of the requested cases; None requests all.
        `arrays` includes the arrays of the patches, and `fields` names the arrays of the solutions as for `solve`. Use
        contactd.contact_files.run for a file on disk.
        """
        if (text is None) == (run is None):
            raise invalid("text", "must be given without run, and run without text")
        names = None if fields is None else names_of(fields)
        params = {"arrays": arrays, **_given(run=run, seconds=seconds, max_elements=max_elements, fields=names)}
        if text is not None:
            params |= {"text": text, **_of_file(name, files, cases, wheel_surface)}
        answer = yield from self.asked("contact_file.run", params, timeout=timeout)
        computed = answer.get("cases", ())
        solutions = [{key: one.pop(key) for key in ("contact", "wheelrail") if key in one} for one in computed]
        part = read(ComputedCases, answer)
        return replace(part, cases=tuple(map(_with_solution, part.cases, solutions, [names] * len(solutions))))

    @asks
    def convert_contact_file(
        self,
        text: str,
        *,
        name: str | None = None,
        files: Iterable[Mapping[str, str]] = (),
        cases: Iterable[int] | None = None,
        wheel_surface: WheelSurface | None = None,
        max_elements: int | None = None,
        timeout: float | None = None,
    ) -> Answering[ConvertedCases]:
        """Converts the cases of an input file of the CONTACT program to parameters of contact.solve and
        wheelrail.solve, without solving them. Arguments are those of `run_contact_file`.

        `call` accepts the parameters::

            (case,) = client.convert_contact_file(text).cases
            client.call("contact.solve", dict(case.contact))
        """
        params = {"text": text, **_of_file(name, files, cases, wheel_surface), **_given(max_elements=max_elements)}
        return read(ConvertedCases, (yield from self.asked("contact_file.convert", params, timeout=timeout)))

    @asks
    def read_contact_slices(self, text: str, *, name: str = "text", timeout: float | None = None) -> Answering[ContactSlices]:
        """Reads a list of slices of the CONTACT program from its `text` (.slcs for rails, .slcw for wheels).

        Profiles named in the list are not opened; contactd.contact_files.read_slices reads them, too. `name` is the
        name of the file in error messages. Raises InvalidArgument with line and column of an error.
        """
        answer = yield from self.asked("contact_file.slices", {"text": text, "name": name}, timeout=timeout)
        return read(ContactSlices, answer)


def _given(**params: Any) -> dict[str, Any]:
    return {name: value for name, value in params.items() if value is not None}


def _of_file(
    name: str | None, files: Iterable[Mapping[str, str]], cases: Iterable[int] | None, wheel_surface: str | None
) -> dict[str, Any]:
    listed = None if cases is None else list(cases)
    return _given(name=name, files=list(files), cases=listed, wheel_surface=wheel_surface)


def _with_solution(case: ComputedCase, solution: dict[str, Any], names: list[str] | None) -> ComputedCase:
    """Adds the solution, which lacks its grid on the wire."""
    if "contact" in solution:
        return replace(case, contact=read_solution(case.patches[0].grid, names, solution["contact"]))
    if "wheelrail" in solution:
        return replace(case, wheelrail=read_wheel_rail(names, True, solution["wheelrail"]))
    return case
