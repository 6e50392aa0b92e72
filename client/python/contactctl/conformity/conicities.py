"""Compares computed conicities with a benchmark."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from contactd import Client

from .benchmark import COMBINATIONS, CONTACT_DISTANCE, Benchmark, bounds

__all__ = ["Curve", "Row", "compared", "curves_of"]

_MOST_AMPLITUDES = 100  #: of one request
_SPACING = 0.05  #: Distance of the amplitudes of a drawn curve (mm).


@dataclass(frozen=True)
class Row:
    """A conicity, and whether it conforms.

    Attributes:
        combination: Name of the combination.
        wheels: Its wheels.
        amplitude: Amplitude (mm).
        conicity: Computed value; None if the wheelset does not oscillate.
        reference: Value of the benchmark.
        low, high: Limits of the conicity.
        is_inside: Whether it lies within them.
    """

    combination: str
    wheels: str
    amplitude: float
    conicity: float | None
    reference: float
    low: float
    high: float
    is_inside: bool


@dataclass(frozen=True)
class Curve:
    """Conicities of a combination at close amplitudes (mm)."""

    amplitudes: Sequence[float]
    conicities: Sequence[float | None]


def compared(client: Client, benchmark: Benchmark, on_progress: Callable[[float, str], None]) -> list[Row]:
    """Computes the conicities of a benchmark. `on_progress` receives the fraction done and the current combination."""
    rows = []
    for done, (name, values) in enumerate(benchmark.values.items()):
        on_progress(done / len(benchmark.values), name)
        computed = _conicities(client, benchmark, name, [amplitude for amplitude, _ in values])
        for (amplitude, reference), conicity in zip(values, computed):
            low, high = bounds(reference)
            is_inside = conicity is not None and low <= conicity <= high
            rows.append(Row(name, COMBINATIONS[name].title, amplitude, conicity, reference, low, high, is_inside))
    return rows


def curves_of(client: Client, benchmark: Benchmark, on_progress: Callable[[float, str], None]) -> dict[str, Curve]:
    """Computes the curves of a picture over the range of the amplitudes."""
    curves = {}
    for done, (name, values) in enumerate(benchmark.values.items()):
        on_progress(done / len(benchmark.values), name)
        low, high = min(values)[0], max(values)[0]
        count = max(1, round((high - low) / _SPACING))
        amplitudes = [low + (high - low) * k / count for k in range(count + 1)]
        curves[name] = Curve(amplitudes, _conicities(client, benchmark, name, amplitudes))
    return curves


def _conicities(client: Client, benchmark: Benchmark, name: str, amplitudes: Sequence[float]) -> list[float | None]:
    right, left = benchmark.setups(name)
    found: list[float | None] = []
    for first in range(0, len(amplitudes), _MOST_AMPLITUDES):
        part = amplitudes[first : first + _MOST_AMPLITUDES]
        answer = client.equivalent_conicity(right, part, left=left, contact_distance=CONTACT_DISTANCE)
        found += [conicity.integrated for conicity in answer]
    return found
