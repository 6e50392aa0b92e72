"""Tests server.describe and server.info, and the answers of every method against their schemas."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from jsonschema import Draft7Validator

from contactd import AnalyticIcs, Client, Grid, InvalidArgument
from support import schemas
from support.daemons import BIN
from support.problems import CATTANEO, CATTANEO_PARAMS, GRID, QUICK, STEEL

REPOSITORY = Path(__file__).parents[2]
ANALYTIC_TABLE = {
    "material": {"G": 82000, "nu": 0.28},
    "grid": {"nx": 6, "ny": 6, "dx": 0.8, "dy": 0.8},
    "ics": {"source": "analytic"},
}
SUBSURFACE_PARAMS = {
    "grid": {"nx": 2, "ny": 1, "dx": 1, "dy": 1},
    "nu": 0.3,
    "pressure": [[1, 2]],
    "block": {"x": [0, 1], "y": [0], "z": [0, -1]},
}

WHEEL_RAIL = {"friction": {"mu": 0.3}, "dx": 1, "dy": 1}
ROLLING = {"velocity": {"x": 2000, "pitch": -4.348}, "Fz": 10000}


@pytest.mark.parametrize("arrays", ["frame", "list"])
@pytest.mark.parametrize(
    ("method", "params"),
    [
        ("server.info", {}),
        ("server.health", {}),
        ("server.describe", {}),
        ("ic.get", ANALYTIC_TABLE),
        ("ic.get", {**ANALYTIC_TABLE, "ics": {"source": "fem", "preset": "paper-test2", "order": 1, "L_over_h": 40}}),
        ("ic.export", {**ANALYTIC_TABLE, "format": "hdf5"}),
        ("ic.export", {**ANALYTIC_TABLE, "format": "contact"}),
        ("contact.solve", CATTANEO_PARAMS),
        ("contact.solve", {name: CATTANEO_PARAMS[name] for name in CATTANEO_PARAMS if name != "friction"}),
        ("contact.subsurface", SUBSURFACE_PARAMS),
        ("wheelrail.solve", {"setup": WHEEL_RAIL, "state": ROLLING, "gap": True}),
        ("wheelrail.geometry", {"setup": WHEEL_RAIL, "states": [ROLLING]}),
        ("job.list", {}),
    ],
    ids=lambda part: part if isinstance(part, str) else "",
)
def test_every_answer_is_as_its_schema_says(raw, method, params, arrays):
    # `raw` checks each answer against its schema.
    assert raw.ask(method, params, arrays=arrays).status == "OK"


def test_the_description_holds_every_method_and_every_schema(shared):
    document = shared.describe()
    assert re.match(r"1\.\d+\.\d+", document["openrpc"])
    assert sorted(method["name"] for method in document["methods"]) == schemas.method_names()
    for method in document["methods"]:
        for content in [*method["params"], method["result"]]:
            Draft7Validator.check_schema(content["schema"])
            assert "definitions.json" not in json.dumps(content), "a reference that leads nowhere"


def test_an_answer_repeats_the_id_it_was_asked_under(raw):
    name = raw.send("server.health")
    assert raw.receive().envelope["id"] == name


def test_metadata_are_the_clients_own_business(raw):
    assert raw.ask("server.health", metadata={"wheel": 3, "side": "left"}).status == "OK"


def test_requests_are_answered_as_they_get_ready_not_in_turn(raw, shared):
    solve = raw.send("contact.solve", {**CATTANEO_PARAMS, "grid": {"nx": 320, "ny": 320, "dx": 0.0075, "dy": 0.0075}})
    health = raw.send("server.health")
    assert [raw.receive().envelope["id"] for _ in range(2)] == [health, solve]


def test_closed_form_tables_are_exact_and_need_no_build(client):
    table = client.get_ic(STEEL, GRID, AnalyticIcs())
    assert table.origin == "closed_form"
    # Uses A_zz(0) of a square of side h: (1 - nu) h / (2 pi G) * 8 ln(1 + sqrt 2) / 2.
    assert table["zz"][0, 0] == pytest.approx(
        0.72 * 0.8 / (2 * 3.141592653589793 * 82000) * 3.525494348078172, rel=1e-12
    )
    assert client.info().counters["builds_started"] == 0


def test_evidence_says_what_made_a_table(shared):
    evidence = shared.get_ic(STEEL, GRID, QUICK).evidence
    assert evidence.source == "fem"
    assert evidence.processes == 1
    assert evidence.elements > 0
    assert evidence.dofs > 0
    # With square elements the load along y is the mirror image of the load along x.
    assert {"x", "z"} <= {case.load for case in evidence.load_cases} <= {"x", "y", "z"}
    for case in evidence.load_cases:
        assert case.converged
        assert 0 < case.residual <= 1e-8
    assert set(evidence.seconds) == {"assembly", "setup", "solve", "total"}
    assert abs(evidence.errors.zz.origin) <= abs(evidence.errors.zz.largest) < 1


def test_counters_count(daemon):
    with Client(daemon.endpoint) as client:
        before = client.info().counters
        client.solve(CATTANEO)
        with pytest.raises(InvalidArgument, match=r"grid\.nx"):
            client.get_ic(STEEL, Grid(0, 1, 1, 1), AnalyticIcs())
        after = client.info().counters
    assert after["solves"] == before["solves"] + 1
    assert after["requests_failed"] == before["requests_failed"] + 1
    assert after["requests"] == before["requests"] + 3


@pytest.mark.parametrize("example", ["cattaneo.py", "ic_table.py", "layers.py", "cosimulation.py"])
def test_the_examples_of_the_client_run(shared_daemon, example):
    path = REPOSITORY / "client" / "python" / "examples" / example
    ended = subprocess.run(
        [sys.executable, path, shared_daemon.endpoint],
        capture_output=True, text=True, timeout=60, env={"PYTHONPATH": str(REPOSITORY / "client" / "python")},
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    assert re.search(
        {
            "cattaneo.py": r"Fz 9\.1973\d+ N, Fx -3\.2221",
            "ic_table.py": r"\d+ elements",
            "layers.py": r"half-space, nu 0\.5 .*(?s:.)*0\.5 mm on steel, nu 0\.5",
            "cosimulation.py": r"[1-9]\d* taken back.*(?s:.)*lost in friction \+ -?0\.\d+",
        }[example],
        ended.stdout,
    )


def test_the_version_is_printed():
    ended = subprocess.run([BIN / "contactd", "--version"], capture_output=True, text=True, timeout=30)
    assert re.match(r"contactd \d+\.\d+\.\d+", ended.stdout)
