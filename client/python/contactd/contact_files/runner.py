"""Runs cases in order. A file is a history: a step starts from the end of the previous one. An error in a case
therefore affects its successors, but not other histories.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, get_args

from ..calls.answer_warnings import collected, give
from ..errors import InvalidArgument, StatusError, TableFileError, TimeoutExpired, invalid
from ..refusals import public
from ..transport.shared_client import shared_client
from ..values.generated.problem import ContactProblem, Estimate
from ..values.generated.result import Field
from ..values.generated.subsurface import StressBlock, SubsurfaceStress
from ..values.generated.wheel_rail.setup import WheelSurface
from ..values.wheel_rail.params import setup_params
from .answers.basic_results import BasicResult
from .answers.rail_results import RailResult
from .answers.subsurface import Body, Stresses
from .asked_client import AskedClient
from .case import Case
from .input_file import read
from .problems.basic import BasicContact, ReadCoefficients, State, goes_on
from .problems.features import MOST_ELEMENTS, Missing, missing
from .problems.mistakes import mistakes
from .problems.rails import Profiles, RailContact
from .problems.refusals import in_words_of
from .profile_files import ProfileFiles
from .solved_cases import SolvedCase, SolvedCases

__all__ = ["Outcome", "Runner", "Status", "chains_of", "checked", "run"]

Status = Literal["solved", "not converged", "read", "refused", "failed", "follows", "wrong"]
"""What became of a case: read and not to be computed (R = 2, 3); refused for what contactd does not have, or for numbers that
it does not take; failed at the service; one that follows from a case that was not computed; or one that the file, or one that
it names, has wrong."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """The outcome of a case, with a sentence about its limitations and the warnings of its answers."""

    case: Case
    status: Status
    sentence: str = ""
    result: BasicResult | RailResult | None = None
    seconds: float = 0.0
    warnings: tuple[str, ...] = ()

    @property
    def is_solved(self) -> bool:
        """True if there are numbers."""
        return self.result is not None


def chains_of(cases: Iterable[Case]) -> list[list[Case]]:
    """Returns chains of cases that must be run in sequence; chains are independent of each other. They are ordered by
    their last cases.
    """
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


def checked(cases: Iterable[Case], most_elements: int = MOST_ELEMENTS) -> list[Outcome]:
    """Returns the outcomes of a check without computation, in the order of the file. `most_elements` is the limit of
    the service (`client.info().limits.max_grid_elements`).
    """
    found: dict[int, Outcome] = {}
    for chain in chains_of(cases):
        broken: Case | None = None
        for case in chain:
            outcome = _refusal(case, broken, most_elements) or Outcome(case, "read")
            found[id(case)] = outcome
            broken = broken or (case if outcome.status != "read" else None)
    return [found[id(case)] for case in cases]


def _refusal(case: Case, broken: Case | None, most_elements: int) -> Outcome | None:
    if case.errors:
        return Outcome(case, "wrong", "; ".join(case.errors))
    if found := mistakes(case):
        return Outcome(case, "wrong", f"{'; '.join(found)}.")
    if names := missing(case, most_elements):
        return Outcome(case, "refused", f"contactd does not support: {', '.join(names)}.")
    if broken is not None and goes_on(case):
        return Outcome(case, "follows", f"It continues case {broken.number} in line {broken.line}, which is not computed.")
    return None


class Runner:
    """Runs cases with a client. Several threads may run different chains at the same time."""

    def __init__(self, client: AskedClient, profiles: Profiles, wheel_surface: WheelSurface = "exact") -> None:
        self._client = client
        self._profiles, self._wheel_surface = profiles, wheel_surface
        self._most_elements = client.info().limits.max_grid_elements
        self._coefficients: ReadCoefficients | None = getattr(profiles, "coefficients", None)

    def run(self, chain: Iterable[Case]) -> Iterator[Outcome]:
        """Returns the outcomes of the cases of a chain.

        Raises errors of the connection. Other errors are outcomes of their cases.
        """
        chain = list(chain)
        steps = _RailSteps(self._client) if len(chain) > 1 and chain[0].module == 1 else None
        try:
            yield from self._run(chain, steps)
        finally:
            if steps is not None:
                steps.close()

    def _run(self, chain: Iterable[Case], steps: _RailSteps | None) -> Iterator[Outcome]:
        broken: Case | None = None
        last: State | None = None
        before: State | None = None
        for case in chain:
            began = time.monotonic()
            outcome = _refusal(case, broken, self._most_elements)
            if outcome is None and case.digits["R"] in (2, 3):
                yield Outcome(case, "read", "It is read but not computed (R = 2, 3).")
                continue
            start = before if case.digits.get("P") == 3 else last
            if outcome is None:
                outcome = self._outcome(case, start if goes_on(case) else None, steps, began)
            if outcome.result is None:
                broken = broken or case
            elif isinstance(outcome.result, BasicResult):
                before, last = start if goes_on(case) else None, _state_of(outcome.result)
            yield outcome

    def _outcome(self, case: Case, start: State | None, steps: _RailSteps | None, began: float) -> Outcome:
        with collected() as sentences:
            outcome = self._computed(case, start, steps, began)
        return replace(outcome, warnings=tuple(sentences))

    def _computed(self, case: Case, start: State | None, steps: _RailSteps | None, began: float) -> Outcome:
        try:
            result = self._on_rails(case, steps) if case.module == 1 else self._basic(case, start)
        except Missing as error:
            return Outcome(case, "refused", f"contactd does not support: {error}.")
        except InvalidArgument as error:
            return Outcome(case, "refused", in_words_of(case, error))
        except (StatusError, TimeoutExpired) as error:
            return Outcome(case, "failed", str(error))
        except TableFileError as error:
            return Outcome(case, "wrong", f"{error}.")
        except OSError as error:
            return Outcome(case, "wrong", f"{error.filename or 'A file of this case'}: {error.strerror or error}.")
        is_complete = result.is_converged
        status: Status = "solved" if is_complete else "not converged"
        sentence = "" if is_complete else "A solver or a search missed its tolerance."
        return Outcome(case, status, sentence, result, time.monotonic() - began)

    def _basic(self, case: Case, start: State | None) -> BasicResult:
        contact = BasicContact.of(case, self._normal_force, start, self._coefficients)
        problem = contact.problem.replace(displacements=contact.problem.model is None)
        return BasicResult.of(contact, self._client.solve(problem), self._stresses)

    def _on_rails(self, case: Case, steps: _RailSteps | None) -> RailResult:
        contact = RailContact.of(case, self._profiles, self._wheel_surface)
        if steps is not None:
            return steps.solve(contact, self._stresses)
        solution = self._client.wheel_rail(contact.setup, replace(contact.state, displacements=contact.setup.model is None), gap=True)
        return RailResult.of(contact, solution, self._stresses)

    def _stresses(self, problem: ContactProblem, acting: Estimate, body: Body, block: StressBlock) -> SubsurfaceStress:
        stress: SubsurfaceStress = self._client.subsurface(problem, acting, body=body, block=block, displacements=True)
        return stress

    def _normal_force(self, problem: ContactProblem) -> float:
        return float(self._client.solve(problem, fields=[]).Fn)


class _RailSteps:
    """The steps of one chain of cases, in a session that the first one opens."""

    def __init__(self, client: AskedClient) -> None:
        self._client = client
        self._session: Any = None
        self._opened: object = None
        self._last: RailResult | None = None

    def solve(self, contact: RailContact, stresses: Stresses) -> RailResult:
        """Solves the next step, or repeats the last one (P = 3). Raises Missing if profiles, track or elements differ
        from those of the previous step.
        """
        common = setup_params(contact.setup.replace(friction=None))
        again = contact.case.digits["P"] == 3 and self._last is not None
        if self._session is None:
            self._session = self._client.wheel_rail_session(contact.setup, accept_unconverged=True)
            self._opened = common
        elif common != self._opened:
            raise Missing("a step that continues with other profiles, track, materials or elements")
        state = replace(contact.state, displacements=contact.setup.model is None)
        friction, fields = contact.setup.friction, get_args(Field)
        solution = self._session.step(state, friction=friction, fields=fields, gap=True, again=again)
        before = None
        if self._last is not None and goes_on(contact.case):
            before = self._last.before if again else self._last.patches
        self._last = RailResult.of(contact, solution, stresses, before)
        return self._last

    def close(self) -> None:
        """Ends the session."""
        if self._session is not None:
            self._session.close()
            self._session = None


def _state_of(result: BasicResult) -> State:
    solution = result.solution
    return State(
        result.contact.area.grid, solution.pressure, solution.traction_x, solution.traction_y, solution.yield_stress,
        solution.friction_coefficient, result.plastic,
    )  # fmt: skip


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
    is_text = isinstance(path, str) and "\n" in path
    place = Path("text") if is_text else Path(path)
    asked: AskedClient = shared_client() if client is None else client
    with collected():  # Warnings of reading are reported with the cases.
        file = read(path, asked)
    if not file.cases:
        raise invalid(os.fspath(place), f"has no cases. {' '.join(file.errors)}".strip())
    folders = [place.parent, *map(Path, allow_folders)]
    runner = Runner(asked, ProfileFiles(place.parent, asked, folders), wheel_surface)
    results = _results(runner, chains_of(file.cases), workers or os.cpu_count() or 1)
    cases = tuple(SolvedCase(results[id(case)]) for case in file.cases)
    give([*file.errors, *file.warnings, *(sentence for case in cases for sentence in _sentences_of(case))])
    return SolvedCases(cases, file.errors)


def _results(runner: Runner, chains: list[list[Case]], workers: int) -> dict[int, Outcome]:
    if workers == 1 or len(chains) == 1:
        return {id(one.case): one for chain in chains for one in runner.run(chain)}
    pool = ThreadPoolExecutor(min(workers, len(chains)))
    try:
        futures = [pool.submit(lambda chain: list(runner.run(chain)), chain) for chain in chains]
        return {id(one.case): one for future in futures for one in future.result()}
    finally:
        pool.shutdown(cancel_futures=True)


def _sentences_of(case: SolvedCase) -> list[str]:
    sentences = [*case.case.warnings, *case.warnings]
    if case.status not in ("solved", "read"):
        sentences.append(f"{case.status}: {case.sentence}")
    return [f"case {case.number}: {sentence}" for sentence in sentences]
