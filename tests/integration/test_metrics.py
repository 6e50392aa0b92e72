"""Tests server.metrics, and the pages for monitoring by HTTP."""

import json
import re
import select
import shutil
import signal
import socket
import subprocess
import urllib.error
import urllib.request
from contextlib import ExitStack
from pathlib import Path

import pytest

from contactd import NotFound, SolverSettings
from support.daemons import BIN, Daemons, eventually
from support.metrics import metric, parse
from support.problems import CATTANEO, ENDLESS, GRID, QUICK, STEEL

HTTP = {"address": "127.0.0.1:0"}
OPERATIONS = Path(__file__).parents[2] / "docs" / "operations.md"
GRAFANA = Path(__file__).parents[2] / "configs" / "grafana.json"


@pytest.fixture(scope="module")
def http_daemon():
    """Provides one daemon for tests that do not affect each other, because an HTTP listener takes two seconds to
    end."""
    started = Daemons()
    try:
        yield started.start(http=HTTP)
    finally:
        started.finish()


def get(daemon, path):
    """Returns status and text of a page."""
    try:
        with urllib.request.urlopen(daemon.http + path, timeout=20) as page:
            return page.status, page.read().decode()
    except urllib.error.HTTPError as error:
        with error:
            return error.code, error.read().decode()


def test_requests_are_counted_by_method_and_status(daemon, client):
    client.solve(CATTANEO)
    with daemon.raw() as raw:
        assert raw.ask("contact.solve", {"grid": 1}).status == "INVALID_ARGUMENT"
    assert metric(client, "contactd_requests_total", method="contact.solve", status="OK") == 1
    assert metric(client, "contactd_requests_total", method="contact.solve", status="INVALID_ARGUMENT") == 1
    assert metric(client, "contactd_request_errors_total", reason="FIELD_INVALID") == 1


def test_solves_and_their_iterations_are_counted(client):
    solution = client.solve(CATTANEO)
    client.solve(CATTANEO.replace(normal=SolverSettings(tolerance=1e-300, max_iterations=1)))
    assert metric(client, "contactd_solves_total", converged="true") == 1
    assert metric(client, "contactd_solves_total", converged="false") == 1
    assert metric(client, "contactd_solver_iterations_total", solver="normal") == solution.evidence.normal.iterations + 1


def test_builds_and_tables_are_counted(client):
    client.get_ic(STEEL, GRID, QUICK)
    assert metric(client, "contactd_builds_total", outcome="finished") == 1
    assert metric(client, "contactd_build_seconds_total") > 0
    eventually(lambda: metric(client, "contactd_store_tables") == 1)
    assert metric(client, "contactd_store_bytes") > 1000
    assert metric(client, "contactd_cache_entries", cache="tables") == 1


def test_the_latencies_of_a_method_add_up(client):
    for _ in range(3):
        client.health()
    family = next(f for f in client.metrics() if f["name"] == "contactd_request_duration_seconds")
    sample = next(s for s in family["samples"] if s["labels"] == {"method": "server.health"})
    assert sample["count"] == 3
    counts = [bucket["count"] for bucket in sample["buckets"]]
    assert counts == sorted(counts)
    assert counts[-1] <= 3
    assert sample["sum"] > 0


def test_invented_methods_do_not_make_the_list_grow(daemon):
    with daemon.raw() as raw:
        for n in range(20):
            raw.ask(f"no.such{n}")
    with daemon.client() as client:
        assert metric(client, "contactd_requests_total", method="unknown", status="UNIMPLEMENTED") == 20
        assert "no.such" not in json.dumps(client.metrics())


def test_connections_are_those_of_living_clients(daemon, client):
    client.health()
    before = metric(client, "contactd_connections")
    with daemon.raw() as raw:
        raw.ask("server.health")
        eventually(lambda: metric(client, "contactd_connections") == before + 1)
    eventually(lambda: metric(client, "contactd_connections") == before)


def test_prometheus_reads_the_same_metrics(daemons):
    daemon = daemons.start(http=HTTP)
    with daemon.client() as client:
        client.solve(CATTANEO)
        client.solve(CATTANEO)
        status, page = get(daemon, "/metrics")
        over_the_wire = {family["name"]: family for family in client.metrics()}
    assert status == 200
    families = parse(page)
    assert {name: (f["type"], f["help"]) for name, f in families.items()} == {
        name: (f["type"], f["help"]) for name, f in over_the_wire.items()
    }
    assert families["contactd_solves_total"]["samples"]["contactd_solves_total", 'converged="true"'] == 2
    solves = 'method="contact.solve"'
    durations = families["contactd_request_duration_seconds"]["samples"]
    assert durations["contactd_request_duration_seconds_count", solves] == 2
    assert durations["contactd_request_duration_seconds_bucket", solves + ',le="+Inf"'] == 2


def test_names_follow_the_conventions(client):
    for family in client.metrics():
        assert re.fullmatch("(contactd|process)_[a-z_]+", family["name"])
        assert family["name"].endswith("_total") == (family["type"] == "counter"), family["name"]
        assert family["help"].endswith(".")


def test_the_documented_metrics_are_those_there_are(client):
    documented = re.findall(r"^\| `((?:contactd|process)_[a-z_]+)`", OPERATIONS.read_text(), re.MULTILINE)
    assert sorted(documented) == sorted(family["name"] for family in client.metrics())


def test_probes_say_alive_and_ready(http_daemon):
    eventually(lambda: get(http_daemon, "/readyz") == (200, "ready\n"))
    assert get(http_daemon, "/healthz") == (200, "alive\n")


def test_a_daemon_without_its_store_is_ready_and_its_metrics_show_it(daemons):
    daemon = daemons.start(http=HTTP)
    eventually(lambda: get(daemon, "/readyz")[0] == 200)
    assert "\ncontactd_store_usable 1\n" in get(daemon, "/metrics")[1]
    shutil.rmtree(daemon.store)
    assert "\ncontactd_store_usable 0\n" in get(daemon, "/metrics")[1]
    assert get(daemon, "/readyz") == (200, "ready\n")
    daemon.store.mkdir()
    assert "\ncontactd_store_usable 1\n" in get(daemon, "/metrics")[1]


def test_a_draining_daemon_is_alive_but_not_ready(daemons, background):
    daemon = daemons.start(http=HTTP, shutdown={"drain_seconds": 600})
    with daemon.client() as client:
        caller = background(client.solve, ENDLESS)
        eventually(lambda: any(job.state == "running" for job in client.jobs()))
        daemon.process.send_signal(signal.SIGTERM)
        eventually(lambda: get(daemon, "/readyz") == (503, "The daemon is shutting down.\n"))
        assert get(daemon, "/healthz")[0] == 200
        for job in client.jobs():
            client.cancel_job(job.job)
        assert caller.exception() is not None
    assert daemon.process.wait(20) == 0


@pytest.mark.parametrize("path", ["/", "/metrics/x", "/etc/passwd", "/../../etc/passwd", "/%2e%2e/"])
def test_other_pages_do_not_exist(http_daemon, path):
    assert get(http_daemon, path)[0] in (400, 404)


def test_nothing_can_be_sent_to_a_page(http_daemon):
    daemon = http_daemon
    request = urllib.request.Request(daemon.http + "/metrics", data=b"x", method="POST")
    with pytest.raises(urllib.error.HTTPError) as caught:
        urllib.request.urlopen(request, timeout=20)
    with caught.value as answer:
        assert answer.code in (404, 405)


def test_a_probe_that_sends_nothing_holds_nobody_up(http_daemon):
    daemon = http_daemon
    host, port = daemon.http.removeprefix("http://").split(":")
    with socket.create_connection((host, int(port))), daemon.client() as client:
        assert client.health() == "serving"
        assert get(daemon, "/healthz")[0] == 200


@pytest.mark.parametrize("begin", [b"", b"GET /healthz HTTP/1.1\r\nHost: x\r\n"], ids=["silent", "half a request"])
def test_two_hundred_half_open_connections_hold_no_probe_up(http_daemon, begin):
    host, port = http_daemon.http.removeprefix("http://").split(":")
    with ExitStack() as half_open:
        connections = [half_open.enter_context(socket.create_connection((host, int(port)))) for _ in range(200)]
        for connection in connections:
            connection.sendall(begin)
        assert get(http_daemon, "/healthz") == (200, "alive\n")
        # It is answered while they are connected, not after they have timed out one by one.
        still_open = [c for c in connections if not select.select([c], [], [], 0)[0]]
        assert len(still_open) > 100


def test_an_http_address_that_is_taken_ends_the_daemon_with_a_message(tmp_path):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        config = {
            "endpoint": f"ipc://{tmp_path}/s",
            "store": {"folder": str(tmp_path / "store")},
            "http": {"address": f"127.0.0.1:{taken.getsockname()[1]}"},
        }
        (tmp_path / "c.json").write_text(json.dumps(config))
        ended = subprocess.run(
            [BIN / "contactd", "--config", tmp_path / "c.json"], capture_output=True, text=True, timeout=30
        )
    assert ended.returncode == 1
    assert config["http"]["address"] in ended.stderr


def test_grafana_asks_for_metrics_and_labels_that_there_are(client):
    client.solve(CATTANEO)
    with pytest.raises(NotFound):
        client.cancel_job("build-99")  # so that there is a reason
    found = {family["name"]: family for family in client.metrics()}
    labels = {name: {"instance", *found[name]["samples"][0]["labels"]} for name in found}
    panels = json.loads(GRAFANA.read_text())["panels"]
    asked = set()
    for expression in (target["expr"] for panel in panels for target in panel["targets"]):
        for name, given in re.findall(r"\b((?:contactd|process)_\w+)\{([^}]*)\}", expression):
            base = name if name in found else name.removesuffix("_bucket")
            assert set(re.findall(r"(\w+)=", given)) <= labels[base], expression
            asked.add(base)
        grouped = [word for words in re.findall(r"by \(([^)]+)\)", expression) for word in words.split(", ")]
        assert set(grouped) <= {"le"}.union(*(labels[name] for name in asked)), expression
    assert asked <= set(found)
    assert len(asked) > 20


def test_panels_of_grafana_do_not_lie_on_each_other():
    panels = json.loads(GRAFANA.read_text())["panels"]
    covered = [
        (place["x"] + across, place["y"] + down)
        for place in (panel["gridPos"] for panel in panels) for across in range(place["w"]) for down in range(place["h"])
    ]  # fmt: skip
    assert len(set(covered)) == len(covered)
    assert max(across for across, _ in covered) < 24
    assert len({panel["id"] for panel in panels}) == len(panels)
