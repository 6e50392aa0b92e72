"""Runs cases of an input file with a client. A file is a history: a step starts from the end of the previous one. An
error in a case therefore affects its successors, but not other histories.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from math import prod
from pathlib import Path
from typing import Any

from ..calls.answer_warnings import collected, give
from ..errors import ProtocolError, StatusError, TimeoutExpired, invalid
from ..refusals import public
from ..transport.shared_client import shared_client
from ..values.generated.contact_files import CaseStatus, ComputedCase, ComputedCases, ConvertedCase
from ..values.generated.wheel_rail.setup import WheelSurface
from ..values.solution import Fields
from .asked_client import AskedClient
from .case import Case
from .input_file import name_and_text
from .named_files import NamedFiles
from .solved_case import SolvedCase
from .solved_cases import SolvedCases

__all__ = ["Runner", "chains_of", "goes_on", "requests_of", "run"]

_ANEW = 2  #: P
_SHIFT, _TRANSIENT = 1, 2  #: T
_USUAL_ELEMENTS, _USUAL_PATCH = 40_000, 10_000
_POINTS_OF_ELEMENT = 10  #: The service accepts so many points of subsurface blocks for each element.
_MOST_REQUESTS, _MOST_BYTES = 256, 1 << 28  #: Of requests, each of which has the text.
_CONVERTED = 100  #: Number of cases in one answer with parameters.


def goes_on(case: Case) -> bool:
    """Returns whether a case starts from the end of an earlier one. A case without digits, which could not be read,
    does not.
    """
    return case.digits.get("P") != _ANEW and case.digits.get("T") in (_SHIFT, _TRANSIENT)


def chains_of(cases: Iterable[Case]) -> list[list[Case]]:
    """Returns chains of cases that must be run in sequence; chains are independent of each other."""
    open_chains: dict[object, list[Case]] = {}
    chains: list[list[Case]] = []
    for case in cases:
        memory = (case.module, case.reid, case.cpid)
        chain = open_chains.get(memory)
        if chain is None or not goes_on(case):
            open_chains[memory] = chain = []
            chains.append(chain)
        chain.append(case)
    return chains


def requests_of(chains: Sequence[list[Case]], text: str) -> list[list[Case]]:
    """Returns the cases of each request. The service reads the text of every request, so that there are not too many."""
    most = max(1, min(_MOST_REQUESTS, _MOST_BYTES // max(1, len(text))))
    count = max(1, -(-len(chains) // most))
    groups = (chains[first : first + count] for first in range(0, len(chains), count))
    return [[case for chain in group for case in chain] for group in groups]


class Runner:
    """Runs `cases` of a `text` with a client. Several threads may run different cases at the same time.

    `fields` are the arrays of the solutions; None requests all. After `seconds`, the service answers with the cases that
    are complete.
    """

    def __init__(
        self, client: AskedClient, text: str, cases: Sequence[Case], files: NamedFiles, wheel_surface: WheelSurface = "exact",
        *, name: str = "text", fields: Fields | None = None, seconds: float | None = None,
    ) -> None:  # fmt: skip
        self._client, self._text, self._name, self._files = client, text, name or "text", files
        self._wheel_surface, self._fields, self._seconds = wheel_surface, fields, seconds
        self._index = {id(case): index for index, case in enumerate(cases)}
        self._cases = cases
        self._most_elements = client.info().limits.max_grid_elements

    def run(self, cases: Iterable[Case]) -> Iterator[SolvedCase]:
        """Returns the outcomes of complete chains of cases.

        Raises errors of the connection. Other errors are outcomes of their cases.
        """
        left = self._in_order(cases)
        while left:
            done = 0
            try:
                for part in self._parts(left):
                    for answer in part.cases:
                        yield SolvedCase(left[done], answer)
                        done += 1
                if done < len(left):
                    raise ProtocolError(f"The answers lack {len(left) - done} cases.")
                return
            except (StatusError, TimeoutExpired) as error:
                failed, rest = left[done], left[done + 1 :]
                yield _without_results(failed, "failed", str(error))
                left = []
                for chain in chains_of(rest):
                    if goes_on(chain[0]):
                        yield from (_following(case, failed) for case in chain)
                    else:
                        left += chain
                left = self._in_order(left)

    def _in_order(self, cases: Iterable[Case]) -> list[Case]:
        return sorted(cases, key=lambda case: self._index[id(case)])

    def _parts(self, cases: list[Case]) -> Iterator[ComputedCases]:
        common: dict[str, Any] = {"seconds": self._seconds, "fields": self._fields, "max_elements": self._elements_of(cases)}
        with collected():  # The caller names the cases.
            part = self._client.run_contact_file(self._text, **self._input(cases), **common)
        yield part
        while part.run is not None:
            with collected():
                part = self._client.run_contact_file(run=part.run, **common)
            yield part

    def converted(self, cases: Sequence[Case]) -> Iterator[ConvertedCase]:
        """Returns the parameters of each case."""
        for first in range(0, len(cases), _CONVERTED):
            some = list(cases[first : first + _CONVERTED])
            most = self._elements_of(some)
            yield from self._client.convert_contact_file(self._text, **self._input(some), max_elements=most).cases

    def checked(self, cases: Sequence[Case]) -> list[SolvedCase]:
        """Returns the outcomes of a check without computation, in the order of the file."""
        found = {id(case): _without_results(case, one.status, one.sentence) for case, one in zip(cases, self.converted(cases))}
        for chain in chains_of(cases):
            broken: Case | None = None
            for case in chain:
                if broken is not None and goes_on(case) and found[id(case)].status == "read":
                    found[id(case)] = _following(case, broken)
                elif found[id(case)].status != "read":
                    broken = broken or case
        return [found[id(case)] for case in cases]

    def _input(self, cases: list[Case]) -> dict[str, Any]:
        return {
            "name": self._name, "files": self._files.contents(cases), "cases": [self._index[id(case)] for case in cases],
            "wheel_surface": self._wheel_surface,
        }  # fmt: skip

    def _elements_of(self, cases: Iterable[Case]) -> int:
        """Returns the number of elements that the service must accept."""
        return int(min(self._most_elements, max([_USUAL_ELEMENTS, *map(_elements_of_case, cases)])))


def _elements_of_case(case: Case) -> int:
    """Returns a number of elements that permits the contact of a case and its subsurface blocks."""
    elements: int = case.values.get("MX", 0) * case.values.get("MY", 0) or case.values.get("NPOT_MAX", 0)
    points = 0
    for block in case.subsurface if case.digits.get("S", 0) >= 1 else ():
        axes = [len(block[axis]) for axis in ("X", "Y", "IX", "IY") if axis in block]
        points += (prod(axes) if axes else min(elements, _USUAL_PATCH)) * len(block["Z"])
    return max(elements, -(-points // _POINTS_OF_ELEMENT))


def _without_results(case: Case, status: CaseStatus, sentence: str) -> SolvedCase:
    answer = ComputedCase(case.number, case.line, case.module, status, sentence, (), 0.0, {}, (), case.reid, case.cpid)
    return SolvedCase(case, answer)


def _following(case: Case, broken: Case) -> SolvedCase:
    return _without_results(case, "follows", f"It continues case {broken.number} in line {broken.line}, which is not computed.")


@public
def run(
    path: str | os.PathLike[str],
    client: AskedClient | None = None,
    *,
    allow_folders: Iterable[str | os.PathLike[str]] = (),
    wheel_surface: WheelSurface = "exact",
    workers: int | None = None,
) -> SolvedCases:
    """Computes all cases of an input file (.inp), or of its text: a string with a line break is a text::

        cases = contact_files.run("testbank.inp")
        print(cases[0].forces, cases[0].patches[0].pressure)
        print(cases.compare("testbank.out"))

    `client` solves the cases; None: contactd.default_client(). Files named in the input are opened if they are in its
    folder, below it, or in `allow_folders`. Wheel surfaces are ``"exact"`` (splines), or ``"bilinear"`` as in CONTACT.
    Independent histories are computed in `workers` threads; None: one per processor.

    A case that contactd does not compute has no solution. Its `status` and `sentence` contain the reason, and a
    ContactWarning names it, in addition to the warnings of the answers. Raises OSError for a file that cannot be read,
    and InvalidArgument for one without cases.
    """
    name, text = name_and_text(path)
    folder = Path(".") if text is path else Path(path).parent
    asked: AskedClient = shared_client() if client is None else client
    with collected():  # Warnings of reading are reported with the cases.
        file = asked.read_contact_file(text, name=name)
    if not file.cases:
        raise invalid(name if text is path else os.fspath(path), f"has no cases. {' '.join(file.errors)}".strip())
    files = NamedFiles(folder, [folder, *map(Path, allow_folders)])
    runner = Runner(asked, text, file.cases, files, wheel_surface, name=name)
    found = _results(runner, requests_of(chains_of(file.cases), text), workers or os.cpu_count() or 1)
    cases = tuple(found[id(case)] for case in file.cases)
    give([*file.errors, *file.warnings, *(sentence for case in cases for sentence in _sentences_of(case))])
    return SolvedCases(cases, file.errors)


def _results(runner: Runner, requests: list[list[Case]], workers: int) -> dict[int, SolvedCase]:
    if workers == 1 or len(requests) == 1:
        return {id(one.case): one for cases in requests for one in runner.run(cases)}
    pool = ThreadPoolExecutor(min(workers, len(requests)))
    try:
        futures = [pool.submit(lambda cases: list(runner.run(cases)), cases) for cases in requests]
        return {id(one.case): one for future in futures for one in future.result()}
    finally:
        pool.shutdown(cancel_futures=True)


def _sentences_of(case: SolvedCase) -> list[str]:
    sentences = [*case.case.warnings, *case.warnings]
    if case.status not in ("solved", "read"):
        sentences.append(f"{case.status}: {case.sentence}")
    return [f"case {case.number}: {sentence}" for sentence in sentences]
