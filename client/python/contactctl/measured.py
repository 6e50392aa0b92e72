"""Evaluates the metrics of the daemon (docs/operations.md): at one time, and their changes between two times."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, field
from typing import Any

__all__ = ["Reading", "difference", "quantile"]

Labels = tuple[tuple[str, str], ...]
_DURATION = "contactd_request_duration_seconds"
#: Methods of observers, which are not work of users.
_LOOKS = {
    "health.watch", "job.list", "server.config", "server.health", "server.info", "server.metrics", "session.list",
    "solves.pressures", "solves.recent",
}  # fmt: skip


@dataclass(frozen=True)
class Reading:
    """Holds values by metric and labels; for histograms their counts and sums.

    Attributes:
        at: Time of the reading (s, monotonic).
        values: Values of counters and gauges.
        histograms: Counts and sums.
        buckets: Upper bounds of histograms, and the number of observations up to each.
    """

    at: float
    values: dict[tuple[str, Labels], float] = field(default_factory=dict)
    histograms: dict[tuple[str, Labels], tuple[int, float]] = field(default_factory=dict)
    buckets: dict[tuple[str, Labels], dict[float, int]] = field(default_factory=dict)

    @staticmethod
    def of(metrics: list[dict[str, Any]]) -> Reading:
        """Reads the answer of server.metrics."""
        reading = Reading(time.monotonic())
        for metric in metrics:
            for sample in metric["samples"]:
                key = metric["name"], tuple(sorted(sample["labels"].items()))
                if "value" in sample:
                    reading.values[key] = sample["value"]
                else:
                    reading.histograms[key] = sample["count"], sample["sum"]
                    bounds = {bucket["le"]: bucket["count"] for bucket in sample["buckets"]}
                    reading.buckets[key] = {**bounds, math.inf: sample["count"]}
        return reading

    def value(self, name: str, **labels: str) -> float:
        """Returns the value of one metric, summed over unspecified labels; 0 if there is none."""
        given = set(labels.items())
        return sum(value for (found, have), value in self.values.items() if found == name and given <= set(have))


def difference(before: Reading, now: Reading) -> dict[str, Any]:
    """Returns the rates between two readings, and values at the second."""
    elapsed = now.at - before.at

    def rate(name: str) -> float:
        return max(0.0, now.value(name) - before.value(name)) / elapsed

    return {
        "seconds": elapsed,
        "uptime_seconds": now.value("contactd_uptime_seconds"),
        "requests_per_second": rate("contactd_requests_total"),
        "solves_per_second": rate("contactd_solves_total"),
        "open_requests": now.value("contactd_open_requests"),
        "solves_waiting": now.value("contactd_queue_length", queue="solves"),
        "builds_waiting": now.value("contactd_queue_length", queue="builds"),
        "builds_running": now.value("contactd_builds_running"),
        "workers": now.value("contactd_workers"),
        "workers_busy": now.value("contactd_workers_busy"),
        "connections": now.value("contactd_connections"),
        "sessions": now.value("contactd_sessions"),
        "session_bytes": now.value("contactd_session_bytes"),
        "tables": now.value("contactd_cache_entries", cache="tables"),
        "store_tables": now.value("contactd_store_tables"),
        "store_bytes": now.value("contactd_store_bytes"),
        "resident_bytes": now.value("process_resident_memory_bytes"),
        "processors": rate("process_cpu_seconds_total"),
        "methods": _methods(before, now, elapsed),
    }


def _methods(before: Reading, now: Reading, elapsed: float) -> dict[str, dict[str, float]]:
    """Returns the methods requested in between, without those of observers."""
    found = {}
    for key, (count, total) in now.histograms.items():
        earlier_count, earlier_total = before.histograms.get(key, (0, 0.0))
        new = count - earlier_count
        if new > 0 and _is_work(key):
            found[dict(key[1])["method"]] = {"per_second": new / elapsed, "mean_seconds": (total - earlier_total) / new}
    return dict(sorted(found.items()))


def _is_work(key: tuple[str, Labels]) -> bool:
    name, labels = key
    return name == _DURATION and dict(labels)["method"] not in _LOOKS


def quantile(before: Reading, now: Reading, part: float) -> float | None:
    """Returns the time (s) in which this fraction of the requests between the two readings was answered, for all
    methods except those of observers; None without requests. It is interpolated in the histogram, and at most its last
    bound.
    """
    counts: dict[float, int] = {}
    for key, buckets in now.buckets.items():
        if _is_work(key):
            earlier = before.buckets.get(key, {})
            for bound, count in buckets.items():
                counts[bound] = counts.get(bound, 0) + count - earlier.get(bound, 0)
    requested = part * counts.get(math.inf, 0)
    if requested <= 0:
        return None
    below, reached = 0.0, 0
    for bound, count in sorted(counts.items()):
        if count >= requested:
            return below if bound == math.inf else below + (bound - below) * (requested - reached) / (count - reached)
        below, reached = bound, count
    return below
