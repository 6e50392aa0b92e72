"""Runs the loop of wear: contacts in all states on the current profiles, their wear, and a step of the profiles."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from ..calls.answer_warnings import collected, give, sentences_in
from ..errors import InvalidArgument, invalid
from .contributions import Contributions, fatigue_of
from .part_step import PartStep, common_distance
from .placed import StudyPlace, WheelRailClient
from .section import Section
from .steps import WornStep
from .study import WearStudy

__all__ = ["Solve", "by_threads", "evolve", "next_step", "place_of"]

Requests = Sequence[dict[str, Any]]
#: A function that solves all requests of wheelrail.solve, reports progress, and returns the answers in order.
Solve = Callable[[Requests, Callable[[int], None]], list[dict[str, Any]]]

_MOST_NAMED = 5  #: Largest number of states named in a sentence.
_FEW = 0.1  #: of the states
_OFF_TREAD = ("climbs on its flange", "rolls on the end of its tread")  #: the words of answers' warnings
_MOST_BY_FEW = 0.9  #: Largest fraction of the area removed by few states without a warning.


def evolve(
    client: WheelRailClient,
    study: WearStudy,
    steps: Sequence[WornStep] | None = None,
    *,
    workers: int = 2,
    solve: Solve | None = None,
    on_progress: Callable[[float, str], None] | None = None,
) -> Iterator[WornStep]:
    """Yields the steps up to the study's end. With the `steps` of an earlier run, continues after the last one as if
    there had been no interruption; otherwise the first step is the new section.

    Sends `workers` requests at a time, or calls `solve` with all requests. `on_progress` receives the completed
    fraction and a sentence. Warnings of a step are in its `warnings`, and are also given as a ContactWarning. Raises
    InvalidArgument naming the state, such as ``states[3]``, whose contact cannot be solved or is beyond the section's
    end.
    """
    place = place_of(client, study)
    done = list(steps or ())
    if not done:
        done.append(_new(study, place))
        yield done[0]
    first, last = done[0], done[-1]
    carry_out = by_threads(client, workers, study) if solve is None else solve
    while last.distance < study.until:
        share = last.distance / study.until

        def tell(part: int, share: float = share, number: int = last.number + 1) -> None:
            if on_progress is not None:
                on_progress(share, f"step {number}: {part} of {len(study.collective)} states")

        requests = study.params(place.profiles({part: last.of(part).points for part in study.parts}))
        last = next_step(first, last, study, place, carry_out(requests, tell))
        give(f"step {last.number}: {sentence}" for sentence in last.all_warnings)
        yield last


def place_of(client: WheelRailClient, study: WearStudy) -> StudyPlace:
    """Returns the positions of the new profiles."""
    return StudyPlace(client.placed_profiles(study.setup), study.setup_params())


def _new(study: WearStudy, place: StudyPlace) -> WornStep:
    points = {part: Section.of(place.points[part], part, study.spacing).points for part in study.parts}
    made = [WornStep(0, 0.0, points[part], np.zeros(0), np.zeros(0)) for part in study.parts]
    return made[0] if len(made) == 1 else made[0].beside(made[1])


def by_threads(client: WheelRailClient, workers: int, study: WearStudy) -> Solve:
    """Solves with this number of simultaneous requests of a client."""

    def solve(requests: Requests, tell: Callable[[int], None]) -> list[dict[str, Any]]:
        """Returns the answers of all states in order, whichever ends first."""

        def ask(i: int) -> dict[str, Any]:
            try:
                with collected():  # The step gives the warnings, with the state.
                    return dict(client.call("wheelrail.solve", requests[i]))
            except InvalidArgument as error:
                raise invalid(f"states[{study.given_index(i)}]", f"cannot be solved: {error.message.removesuffix('.')}") from error

        found = []
        with ThreadPoolExecutor(workers) as pool:
            try:
                for answer in pool.map(ask, range(len(requests))):
                    found.append(answer)
                    tell(len(found))
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                raise
        return found

    return solve


def next_step(first: WornStep, last: WornStep, study: WearStudy, place: StudyPlace, answers: Sequence[dict[str, Any]]) -> WornStep:
    """Returns the step after `last` from the answers of all states on its profiles; `first` contains the new
    sections.
    """
    wear = {part: Contributions.of(answers, Section(last.of(part).points, part), study, place, part) for part in study.parts}
    if not any(one.areas.sum() > 0 for one in wear.values()):
        raise invalid("states", "cause no wear: none of their contacts slips, or the law is zero there")
    parts = {part: PartStep(one.rates.sum(axis=0), one.size, one.contacts, place.modulus, study.depth, study.smoothing) for part, one in wear.items()}
    distance, ended_by = common_distance(parts, study.until - last.distance, study.distance)
    T_gamma = T_gamma_with_spin = pmax = 0.0
    warnings = [*_warnings_of(study, answers), *_off_tread(answers, study)]
    for share, answer in zip(study.shares, answers):
        for patch in answer.get("patches", ()):
            reported = patch["solution"].get("wear", {})
            T_gamma += share * reported.get("T_gamma", 0.0)
            T_gamma_with_spin += share * reported.get("T_gamma_with_spin", 0.0)
            pmax = max(pmax, patch["solution"]["pmax"])
    reached = study.until if math.isclose(last.distance + distance, study.until, rel_tol=1e-12) else last.distance + distance
    made = []
    for part, step in parts.items():
        before, new = last.of(part), Section(first.of(part).points, part)
        depths, smoothing, flags = step.taken(distance)
        area = float(depths.sum() * wear[part].size)
        section = Section(before.points, part)
        worn = section.worn(np.interp(section.lengths, wear[part].centres, depths), area) if area > 0 else section
        worn = worn.resampled(study.spacing)
        made.append(
            WornStep(
                last.number + 1, reached, worn.points, wear[part].edges, depths, before.area + area, new.area_above(worn), T_gamma,
                T_gamma_with_spin, pmax, step.pressure, smoothing, wear[part].by_groups(study, distance), tuple(warnings + flags), ended_by,
                fatigue_of(answers, wear[part], study, distance),
            )
        )  # fmt: skip
        if _is_carried_by_few(wear[part].areas):
            sentence = f"A tenth of the states carry more than {_MOST_BY_FEW:.0%} of the wear of the step: use more states."
            made[-1] = made[-1].warned(sentence)
    return made[0] if len(made) == 1 else made[0].beside(made[1])


def _warnings_of(study: WearStudy, answers: Sequence[dict[str, Any]]) -> list[str]:
    """Returns the warnings of the answers, each sentence once, with its states."""
    found: dict[str, list[int]] = {}
    for i, answer in enumerate(answers):
        sentences = list(sentences_in("wheelrail.solve", answer))
        if not answer["converged"]:
            sentences.append("The solution did not converge.")
        for sentence in sentences:
            states = found.setdefault(sentence, [])
            if study.given_index(i) not in states:  # The mirrored state is equivalent.
                states.append(study.given_index(i))
    return [f"{_listed(states)}: {sentence}" for sentence, states in found.items()]


def _listed(states: Sequence[int]) -> str:
    more = f" and {len(states) - _MOST_NAMED} more" if len(states) > _MOST_NAMED else ""
    return f"{', '.join(f'states[{i}]' for i in states[:_MOST_NAMED])}{more}"


def _off_tread(answers: Sequence[dict[str, Any]], study: WearStudy) -> list[str]:
    """Counts the states whose wheel climbs, and those whose wheel rolls on its end, according to the warnings. Returns
    a sentence for each.
    """
    sentences = []
    for words in _OFF_TREAD:
        off = [i for i, answer in enumerate(answers) if any(words in one for one in answer.get("warnings", ()))]
        if off:
            states = sorted({study.given_index(i) for i in off})
            share = sum(study.shares[i] for i in off)
            sentences.append(
                f"The wheel {words} in {len(states)} of {len(study.states)} states, {share:.2g} of all by weight: {_listed(states)}. Check their positions, or omit them."
            )
    return sentences


def _is_carried_by_few(areas: Any) -> bool:
    few = max(int(_FEW * len(areas)), 1)
    total = float(areas.sum())
    return len(areas) >= 10 and total > 0 and float(np.sort(areas)[-few:].sum()) > _MOST_BY_FEW * total


