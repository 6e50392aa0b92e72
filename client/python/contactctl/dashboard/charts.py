"""Draws rates and times of the last minutes, as ECharts options."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from .view import Sample

__all__ = ["latency_chart", "throughput_chart"]

_BLUE, _RED = "#2f6fe4", "#c8553d"  #: These and the other colours are visible on white and dark backgrounds.
_TEXT, _LINES = "#7d7d88", "rgba(128, 128, 128, 0.25)"
_DOT = 5  #: Pixels.
Pick = Callable[[Sample], float | None]


def throughput_chart(samples: Sequence[Sample]) -> dict[str, Any]:
    """Returns a chart of solves and requests per second."""
    lines: dict[str, tuple[str, Pick]] = {
        "requests": (_BLUE, lambda sample: sum(method["per_second"] for method in sample.said["methods"].values())),
        "solves": (_RED, lambda sample: sample.said["solves_per_second"]),
    }
    return _chart({"type": "value", "name": "a second", "min": 0}, lines, samples)


def latency_chart(samples: Sequence[Sample]) -> dict[str, Any]:
    """Returns a chart of response times (ms)."""
    lines: dict[str, tuple[str, Pick]] = {
        "half of the requests": (_BLUE, lambda sample: _milliseconds(sample.median)),
        "95 % of them": (_RED, lambda sample: _milliseconds(sample.slow)),
    }
    # The axis goes from a tenth of a millisecond to the hour of a build.
    return _chart({"type": "log", "name": "ms"}, lines, samples)


def _milliseconds(seconds: float | None) -> float | None:
    return None if seconds is None else round(1000 * seconds, 3)


def _chart(axis: dict[str, Any], lines: dict[str, tuple[str, Pick]], samples: Sequence[Sample]) -> dict[str, Any]:
    label, split = {"color": _TEXT}, {"lineStyle": {"color": _LINES}}
    return {
        "animation": False,
        "grid": {"left": 50, "right": 16, "top": 36, "bottom": 24},
        "legend": {"top": 0, "right": 10, "itemWidth": 16, "icon": "rect", "itemHeight": 3, "textStyle": label},
        "tooltip": {"trigger": "axis"},
        "xAxis": {"type": "time", "splitNumber": 4, "minInterval": 15_000, "axisLabel": label},
        "yAxis": {**axis, "nameGap": 10, "nameTextStyle": label, "axisLabel": label, "splitLine": split},
        "series": [
            {"type": "line", "name": name, "symbol": "none", "color": colour, "lineStyle": {"width": 2}, "data": _points(samples, pick)}
            for name, (colour, pick) in lines.items()
        ],
    }


def _points(samples: Sequence[Sample], pick: Pick) -> list[Any]:
    """Returns times and values. A value between two gaps has no line, so it gets a symbol, unlike others."""
    values = [pick(sample) for sample in samples]
    points: list[Any] = []
    for i, (sample, value) in enumerate(zip(samples, values)):
        point = [round(1000 * sample.at), value]
        is_alone = value is not None and all(other is None for other in (*values[max(i - 1, 0) : i], *values[i + 1 : i + 2]))
        points.append({"value": point, "symbol": "circle", "symbolSize": _DOT} if is_alone else point)
    return points
