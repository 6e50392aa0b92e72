"""Checks the convergence of a wear study: the same distance with other states, elements, steps and smoothing, compared
with the finest.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from contactd import Client
from contactd.calls.answer_warnings import collected, give
from contactd.wear import Section, WearStudy, WeightedState, WornStep, evolve

__all__ = ["Settled", "settled", "variants"]

_ELEMENT = 0.5  #: Default of WheelRailSetup (mm).


@dataclass(frozen=True)
class Settled:
    """A variant of a study.

    Attributes:
        name: Name of the change.
        difference: Mean absolute difference of the depths from the finest, over the mean depth.
        area: Removed area over that of the finest.
        largest: Largest depth over that of the finest.
        steps: Number of steps.
        seconds: Wall-clock time (s).
    """

    name: str
    difference: float
    area: float
    largest: float
    steps: int
    seconds: float


def variants(study: WearStudy) -> dict[str, WearStudy]:
    """Returns studies by their difference from the given one; the first is the finest, with half the element size and
    steps.
    """
    setup = study.setup_params()
    dx, dy = float(setup.get("dx", _ELEMENT)), float(setup.get("dy", _ELEMENT))

    def sized(factor: float) -> dict[str, Any]:
        return {"setup": {**setup, "dx": factor * dx, "dy": factor * dy}}

    found = {
        "finest": replace(study, **sized(0.5), depth=0.5 * study.depth, smoothing="auto"),
        "as given": study,
        "elements twice as large": replace(study, **sized(2.0)),
        "elements half as large": replace(study, **sized(0.5)),
        "steps twice as deep": replace(study, depth=2 * study.depth),
        "steps half as deep": replace(study, depth=0.5 * study.depth),
    }
    for name, smoothing in (("smoothing auto", "auto"), ("exponential steps", "exponential_step"), ("not smoothed", 0.0)):
        if study.smoothing != smoothing:
            found[name] = replace(study, smoothing=smoothing)  # type: ignore[arg-type]
    for part, name in ((2, "half of the states"), (4, "a quarter of the states")):
        kept = _sample(study.states, part)
        if len(kept) < len(study.states):
            found[name] = replace(study, states=kept)
    return found


def _sample(states: Sequence[WeightedState], part: int) -> list[WeightedState]:
    """Returns one of every N states of each group at random, with the weight of the group."""
    chance = random.Random(1)
    found = []
    for name in dict.fromkeys(one.group for one in states):
        group = [one for one in states if one.group == name]
        kept = chance.sample(group, max(len(group) // part, 1))
        total, of_kept = sum(one.weight for one in group), sum(one.weight for one in kept)
        found += [replace(one, weight=one.weight * total / of_kept) for one in kept if of_kept > 0]
    return found


def settled(
    client: Client, study: WearStudy, workers: int, on_progress: Callable[[float, str], None], names: Sequence[str] | None = None
) -> Iterator[Settled]:
    """Yields each variant when it is complete; `names` selects some, in addition to the finest, which is first."""
    studies = {name: one for name, one in variants(study).items() if names is None or name in ("finest", *names)}
    finest: WornStep | None = None
    first: WornStep | None = None
    for i, (name, one) in enumerate(studies.items()):

        def tell(share: float, _: str, i: int = i, name: str = name) -> None:
            on_progress((i + share) / len(studies), name)

        began = time.monotonic()
        with collected() as sentences:
            steps = list(evolve(client, one, workers=workers, on_progress=tell))
        give(f"{name}: {sentence}" for sentence in sentences)
        seconds = time.monotonic() - began
        if finest is None or first is None:
            first, finest = steps[0], steps[-1]
        part = study.parts[0]
        new = Section(first.of(part).points, part)
        known, depths = new.depths_to(Section(finest.of(part).points, part)), new.depths_to(Section(steps[-1].of(part).points, part))
        mean = float(np.trapezoid(known, new.lengths))
        yield Settled(
            name, float(np.trapezoid(np.abs(depths - known), new.lengths)) / mean, steps[-1].of(part).area / finest.of(part).area,
            float(depths.max() / known.max()), steps[-1].number, seconds,
        )  # fmt: skip
