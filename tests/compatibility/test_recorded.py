"""What released versions sent, answered and wrote is served, answered alike and read: docs/compatibility.md."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from compatibility.exchanges import RECORDED, asked, differences, read, whole
from contactd import ContactSolution, FemIcs, Grid, Material
from integration.conftest import daemons, shared_daemon  # noqa: F401
from support.raw import RawClient

VERSIONS = sorted(path for path in RECORDED.iterdir() if path.is_dir())


@pytest.fixture(params=VERSIONS, ids=lambda path: path.name)
def version(request) -> Path:
    """Each version that has been recorded."""
    return request.param


def test_requests_of_old_clients_are_answered_as_they_were(version, shared_daemon):  # noqa: F811
    session = ""
    wrong = []
    with RawClient(shared_daemon.endpoint) as raw:
        for old in read(version / "exchanges.gz"):
            request = json.loads(json.dumps(old.request))
            if "session" in request["params"]:
                request["params"]["session"] = session
            new = asked(raw, request, old.sent)
            where = f"{request['id']} {request['method']}"
            assert new.answer["status"]["code"] == old.answer["status"]["code"], (where, new.answer["status"])
            assert new.answer["contactd"] == old.answer["contactd"]
            if request["method"] == "session.open":
                session = new.answer["result"]["session"]
            if request["method"] == "server.info":
                assert set(old.answer["result"]["protocol_versions"]) <= set(new.answer["result"]["protocol_versions"])
                continue
            if old.answer["status"]["code"] != 0:
                new_reason, old_reason = (one.answer["status"]["details"]["reason"] for one in (new, old))
                assert new_reason == old_reason
                continue
            old_result, new_result = (whole(one.answer["result"], one.received) for one in (old, new))
            wrong += [f"{where}: {difference}" for difference in differences(old_result, new_result)]
    assert not wrong


def test_tables_of_old_stores_are_found(version, daemons):  # noqa: F811
    kept = json.loads((version / "values.json").read_text())
    with daemons.start() as daemon:
        store = Path(daemon.config["store"]["folder"])
        store.mkdir(parents=True, exist_ok=True)
        for file in (version / "store").iterdir():
            shutil.copy(file, store)
        with daemon.client() as client:
            table = client.get_ic(Material(G=82000, nu=0.28), Grid(3, 3, 0.8, 0.8), FemIcs("paper-test1", L_over_h=20))
            assert client.info().counters["builds_started"] == 0
    assert table.origin == "disk"
    assert table["zz"].tolist() == kept["zz"]


def test_saved_solutions_of_old_clients_are_loaded(version):
    pytest.importorskip("h5py")
    kept = json.loads((version / "values.json").read_text())
    solution = ContactSolution.load(version / "solution.h5")
    assert (solution.pmax, solution.Fx) == (kept["pmax"], kept["Fx"])
