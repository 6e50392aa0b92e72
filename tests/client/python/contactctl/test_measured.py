"""Tests rates and quantiles from two readings of the metrics."""

import pytest

from contactctl.measured import Reading, difference, quantile


def histogram(method, *counts):
    """Returns observations up to 1, 2 and 4 s, and all of them."""
    *bounded, count = counts
    buckets = [{"le": bound, "count": number} for bound, number in zip((1.0, 2.0, 4.0), bounded)]
    sample = {"labels": {"method": method}, "count": count, "sum": 2.0 * count, "buckets": buckets}
    return {"name": "contactd_request_duration_seconds", "samples": [sample]}


NOTHING = Reading(0.0)


def reading(*metrics):
    return Reading.of(list(metrics))


def test_half_of_the_requests_are_quicker_than_the_median():
    now = reading(histogram("contact.solve", 0, 10, 10, 10))
    assert quantile(NOTHING, now, 0.5) == pytest.approx(1.5)


def test_quantiles_are_of_what_came_between_the_readings():
    before = reading(histogram("contact.solve", 1000, 1000, 1000, 1000))
    now = reading(histogram("contact.solve", 1000, 1000, 1004, 1004))
    assert quantile(before, now, 0.5) == pytest.approx(3.0)
    assert quantile(now, now, 0.5) is None


def test_methods_count_together_and_looks_do_not():
    now = reading(histogram("contact.solve", 4, 4, 4, 4), histogram("ic.get", 0, 4, 4, 4), histogram("job.list", 0, 0, 99, 99))
    assert quantile(NOTHING, now, 0.5) == pytest.approx(1.0)
    assert quantile(NOTHING, now, 0.95) == pytest.approx(1.9)


def test_beyond_the_last_bound_nothing_more_is_known():
    assert quantile(NOTHING, reading(histogram("ic.get", 0, 0, 0, 3)), 0.5) == 4.0


def test_rates_are_of_the_methods_that_were_asked_for():
    now = reading(histogram("contact.solve", 4, 4, 4, 4), histogram("server.health", 5, 5, 5, 5))
    said = difference(Reading(now.at - 2.0), now)
    assert said["methods"] == {"contact.solve": {"per_second": 2.0, "mean_seconds": 2.0}}
