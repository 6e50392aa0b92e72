"""Tests contactctl dashboard: its requests, and its view of a daemon. test_dashboard_page.py tests the page."""

import threading

import pytest

from contactctl.dashboard.charts import latency_chart, throughput_chart
from contactctl.dashboard.view import AWAY, CONNECTING, Sample
from contactctl.dashboard.watcher import Watcher
from contactd import Client, NotFound
from support.daemons import eventually
from support.problems import CATTANEO, GRID, LONG, QUICK, STEEL


@pytest.fixture
def watcher(daemon):
    """Queries only when told to."""
    with daemon.client() as client:
        yield Watcher(client, interval=0.001)


def test_without_nicegui_it_says_what_to_install(ctl):
    folder = ctl.write_module("nicegui")
    ended = ctl.alone("dashboard", PYTHONPATH=f"{folder}:{ctl.environment['PYTHONPATH']}")
    assert ended.code == 2
    assert 'dashboard needs NiceGUI and matplotlib: pip install "contactd[dashboard]"' in ended.err


def test_it_shows_a_daemon_and_nothing_else(ctl):
    ended = ctl("dashboard", "--local")
    assert ended.code == 2
    assert "--local has none" in ended.err


@pytest.mark.parametrize("address", ["localhost", "127.1", "*", ""])
def test_it_listens_at_addresses_in_numbers(ctl, address):
    ended = ctl("dashboard", "--address", address)
    assert ended.code == 2
    assert f"--address is {address!r}; it must be" in ended.err


def test_a_look_finds_what_there_is(watcher, client):
    client.solve(CATTANEO)
    with client.session(CATTANEO):
        watcher.look()
        client.solve(CATTANEO)
        watcher.look()
    view = watcher.view
    assert view.state == "serving"
    assert view.is_there
    assert view.info.version
    assert len(view.sessions) == 1
    assert [solve.method for solve in view.solves] == ["contact.solve"] * 2
    assert view.config["recent_solves"]["count"] == 50
    (sample,) = view.samples
    assert sample.said["methods"]["contact.solve"]["per_second"] > 0
    assert 0 < sample.median <= sample.slow


def test_a_job_is_seen_and_cancelled(watcher, client, background):
    waiting = background(client.get_ic, STEEL, GRID, LONG)

    def job():
        watcher.look()
        return [job for job in watcher.view.jobs if job.fraction > 0]

    eventually(job)
    (running,) = watcher.view.jobs
    assert running.kind == "build"
    assert watcher.cancel(running.job)

    def nothing_runs():
        watcher.look()
        return not watcher.view.jobs

    eventually(nothing_runs, "the job is still there")
    assert not watcher.cancel(running.job)
    assert waiting.exception().name == "CANCELLED"


def test_tables_come_with_their_errors(watcher, client):
    client.get_ic(STEEL, GRID, QUICK)
    eventually(watcher.tables)
    (table,) = watcher.tables()
    assert table.bytes > 1000
    assert table.evidence.errors.zz.largest > 0
    watcher.look()
    assert watcher.view.store[0] == 1


def test_pressures_are_those_of_the_solve(watcher, client):
    solution = client.solve(CATTANEO)
    watcher.look()
    (patch,) = watcher.pressures(watcher.view.solves[0].number)
    assert patch.pressure == pytest.approx(solution.pressure, rel=1e-6)
    assert (patch.element_division == solution.element_division).all()
    with pytest.raises(NotFound):
        watcher.pressures(99)


def test_a_daemon_that_goes_away_is_told_of_until_it_is_back(daemons):
    daemon = daemons.start()
    with daemon.client(timeout=1) as client:
        watcher = Watcher(client, interval=0.001, patience=1)
        assert watcher.view.state == CONNECTING
        watcher.look()
        watcher.look()
        seen = watcher.view
        daemon.kill()
        watcher.look()
        assert watcher.view.state == AWAY
        assert watcher.view.why
        assert watcher.view.samples == seen.samples  # earlier data remain visible
        daemons.start()
        eventually(lambda: watcher.look() or watcher.view.is_there)
        watcher.look()
        watcher.look()
        assert len(watcher.view.samples) > len(seen.samples)
        assert all(sample.said["requests_per_second"] >= 0 for sample in watcher.view.samples)


def test_a_value_between_two_gaps_is_a_point_and_others_are_lines():
    medians = [0.1, None, 0.2, None, 0.3, 0.4, None, None, 0.5]
    samples = [Sample(float(at), {"methods": {}, "solves_per_second": 1.0}, median, None) for at, median in enumerate(medians)]
    half, slow = (line["data"] for line in latency_chart(samples)["series"])
    points = [point["value"] if isinstance(point, dict) else point for point in half]
    assert points == [[1000 * at, None if median is None else 1000 * median] for at, median in enumerate(medians)]
    assert [at for at, point in enumerate(half) if isinstance(point, dict) and point["symbol"] == "circle"] == [0, 2, 8]
    assert all(point == [1000 * at, None] for at, point in enumerate(slow))
    # A line has no symbols, except before it has two points.
    for count, symbols in ((1, 1), (2, 0), (9, 0)):
        for line in throughput_chart(samples[:count])["series"]:
            assert line["symbol"] == "none" and sum(isinstance(point, dict) for point in line["data"]) == symbols


def test_a_watcher_of_nobody_ends_when_it_is_told_to(tmp_path):
    with Client(f"ipc://{tmp_path}/nobody") as client, Watcher(client, interval=0.01, patience=0.1) as watcher:
        eventually(lambda: watcher.view.state == AWAY)
    assert not [thread for thread in threading.enumerate() if thread.name == "watcher"]
