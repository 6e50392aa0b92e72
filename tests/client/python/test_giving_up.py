"""Tests that a client cancels abandoned requests, and joins answers received in parts."""

import time

import numpy as np
import pytest

from contactd import AnalyticIcs, Grid, Material, NotFound, ProtocolError, TimeoutExpired, __version__
from support import answers

STEEL = Material(G=82000, nu=0.28)


def cancelled(server):
    deadline = time.monotonic() + 10
    while time.monotonic() < deadline:
        if found := [request.params["id"] for request in server.requests if request.method == "request.cancel"]:
            return found
        time.sleep(0.005)
    return []


def test_a_call_that_times_out_is_cancelled(fake):
    server, client = fake(lambda request: [])
    with pytest.raises(TimeoutExpired):
        client.health(timeout=0.05)
    assert cancelled(server) == [server.requests[0].id]


def test_a_call_whose_progress_callback_raises_is_cancelled(fake):
    class Enough(Exception):
        pass

    def stop(progress):
        raise Enough

    server, client = fake(lambda request: [request.progress()] if request.method == "ic.get" else [])
    with pytest.raises(Enough):
        client.get_ic(STEEL, Grid(2, 2, 1, 1), AnalyticIcs(), on_progress=stop)
    assert cancelled(server) == [server.requests[0].id]


def test_a_call_that_was_answered_is_not_cancelled(fake):
    server, client = fake(lambda request: [request.failure(5, "No such job.", reason="JOB_UNKNOWN")])
    for _ in range(2):
        with pytest.raises(NotFound, match="No such job"):
            client.cancel_job("build-1")
    assert [request.method for request in server.requests] == ["job.cancel"] * 2


def test_requests_name_the_client(fake):
    server, client = fake(lambda request: [request.result({"state": "serving"})])
    client.health()
    assert server.requests[0].envelope["metadata"] == {"client": f"contactd-python {__version__}"}


@pytest.mark.parametrize(("version", "side"), [(2, "client"), (0, "daemon")])
def test_another_version_is_named_with_the_side_to_upgrade(fake, version, side):
    def script(request):
        return [[request.message(contactd=version, status={"code": 0, "name": "OK", "message": ""}, result={})]]

    _, client = fake(script)
    with pytest.raises(ProtocolError, match=f"version {version} of the protocol.*upgrade the {side}"):
        client.health()


def test_the_states_of_the_daemon_are_watched(fake):
    def script(request):
        states = [request.progress(stage="watch", fraction=0, state=state) for state in ("serving", "serving", "stopping")]
        return [*states, request.result({"state": "stopping"})]

    _, client = fake(script)
    seen = []
    assert client.watch_health(seen.append) == "stopping"
    assert seen == ["serving", "stopping"]


@pytest.mark.parametrize("most", [8 * 5 * 9 * 2, 8 * 5 * 4, 8 * 5, 8 * 5 * 9 * 7 - 1])
def test_a_table_that_is_too_large_is_fetched_in_pieces(fake, most):
    grid = Grid(5, 7, 1, 1)
    whole, bytes_of_it = answers.table(grid.ny, grid.nx)
    table = np.frombuffer(bytes_of_it).reshape(9, grid.ny, grid.nx)
    names = [i + j for i in "xyz" for j in "xyz"]
    limits = {**answers.INFO["limits"], "max_frame_bytes": most}

    def script(request):
        if request.method == "server.info":
            return [request.result({**answers.INFO, "limits": limits})]
        if "components" not in request.params:
            return [request.failure(3, "rows make a table of too many bytes", reason="ANSWER_TOO_LARGE")]
        components = [names.index(name) for name in request.params["components"]]
        first, count = request.params["rows"]["first"], request.params["rows"]["count"]
        part = np.ascontiguousarray(table[components, first : first + count])
        assert part.nbytes <= most
        return [request.result({**whole, "table": answers.array(1, part.shape)}, part.tobytes())]

    _, client = fake(script)
    assert (client.get_ic(STEEL, grid, AnalyticIcs()).array == table.reshape(3, 3, 7, 5)).all()


def test_parts_of_different_tables_are_refused(fake):
    count = iter(range(100))

    def script(request):
        if request.method == "server.info":
            return [request.result({**answers.INFO, "limits": {**answers.INFO["limits"], "max_frame_bytes": 8 * 5}})]
        if "components" not in request.params:
            return [request.failure(3, "rows make a table of too many bytes", reason="ANSWER_TOO_LARGE")]
        result, _ = answers.table(7, 5)
        part = answers.array(1, (1, 1, 5))
        return [request.result({**result, "key": str(next(count)), "table": part}, bytes(40))]

    _, client = fake(script)
    with pytest.raises(ProtocolError, match="different tables"):
        client.get_ic(STEEL, Grid(5, 7, 1, 1), AnalyticIcs())
