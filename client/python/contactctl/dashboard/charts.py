"""Rates and times of the last minutes, as options of ECharts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from .view import Sample

__all__ = ["latency_chart", "throughput_chart"]

_BLUE, _RED = "#1449b8", "#c8553d"
Pick = Callable[[Sample], float | None]


def throughput_chart(samples: Sequence[Sample]) -> dict[str, Any]:
    """Solves and requests a second."""
    lines: dict[str, tuple[str, Pick]] = {
        "requests": (_BLUE, lambda sample: sum(method["per_second"] for method in sample.said["methods"].values())),
        "solves": (_RED, lambda sample: sample.said["solves_per_second"]),
    }
    return _chart({"type": "value", "name": "a second", "min": 0}, lines, samples)


def latency_chart(samples: Sequence[Sample]) -> dict[str, Any]:
    """Times of answers (ms)."""
    lines: dict[str, tuple[str, Pick]] = {
        "half of the requests": (_BLUE, lambda sample: _milliseconds(sample.median)),
        "95 % of them": (_RED, lambda sample: _milliseconds(sample.slow)),
    }
    # From a tenth of a millisecond to the hour of a build.
    return _chart({"type": "log", "name": "ms"}, lines, samples)


def _milliseconds(seconds: float | None) -> float | None:
    return None if seconds is None else round(1000 * seconds, 3)


def _chart(axis: dict[str, Any], lines: dict[str, tuple[str, Pick]], samples: Sequence[Sample]) -> dict[str, Any]:
    def points(pick: Pick) -> list[list[float | None]]:
        return [[round(1000 * sample.at), pick(sample)] for sample in samples]

    return {
        "animation": False,
        "grid": {"left": 50, "right": 16, "top": 36, "bottom": 24},
        "legend": {"top": 0, "right": 10, "itemWidth": 16, "icon": "rect", "itemHeight": 3},
        "tooltip": {"trigger": "axis"},
        "xAxis": {"type": "time", "splitNumber": 4, "minInterval": 15_000},
        "yAxis": {**axis, "nameGap": 10},
        "series": [
            {"type": "line", "name": name, "showSymbol": len(samples) < 3, "color": colour, "lineStyle": {"width": 2}, "data": points(pick)}
            for name, (colour, pick) in lines.items()
        ],
    }
