"""Tests answers that are too large for a message: they are refused before the work, with a suggestion."""

import numpy as np
import pytest

from conformance.requests import LONG_BUILD, SOLVE, TABLE
from conformance.wire import INVALID_ARGUMENT, OK, Daemon

NX, NY = 20, 16
GRID = {"nx": NX, "ny": NY, "dx": 0.8, "dy": 0.8}
WHOLE = {**TABLE, "grid": GRID}
NAMES = [i + j for i in "xyz" for j in "xyz"]
FRAME = 8 * NX * 9 * 3  # three rows of all components


@pytest.fixture(scope="module")
def small():
    daemon = Daemon({"limits": {"max_frame_bytes": FRAME}})
    yield daemon
    daemon.finish()


@pytest.fixture
def guest(small):
    with small.peer() as connected:
        yield connected


@pytest.fixture(scope="module")
def table(shared):
    """Returns the whole table, from a daemon without such limits."""
    with shared.peer() as connected:
        reply = connected.ask("ic.get", WHOLE)
        return reply.array(reply.result["table"])


@pytest.mark.parametrize("params", [WHOLE, {**LONG_BUILD, "grid": GRID}], ids=["closed form", "build"])
def test_a_table_that_is_too_large_is_refused_before_it_is_made(guest, params):
    reply = guest.ask("ic.get", params)
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "ANSWER_TOO_LARGE", ["rows"])
    assert '{"first": 0, "count": 3}' in reply.text
    assert guest.ask("job.list").result["jobs"] == []


def test_rows_make_up_the_table(guest, table):
    parts, keys = [], set()
    for first in range(0, NY, 3):
        rows = {"first": first, "count": min(3, NY - first)}
        reply = guest.ask("ic.get", {**WHOLE, "rows": rows})
        assert reply.result["rows"] == rows
        keys.add(reply.result["key"])
        parts.append(reply.array(reply.result["table"]))
    assert (np.concatenate(parts, axis=2) == table).all()
    assert len(keys) == 1


def test_components_make_up_the_table(guest, table):
    for names in (["zz"], ["zx", "xz"], ["yy"]):
        reply = guest.ask("ic.get", {**WHOLE, "components": names, "rows": {"first": 2, "count": 10}})
        assert reply.result["components"] == names
        expected = [table[divmod(NAMES.index(name), 3)][2:12] for name in names]
        assert (reply.array(reply.result["table"]) == expected).all()


@pytest.mark.parametrize(
    ("rows", "field"),
    [
        ({"first": NY, "count": 1}, "rows.first"),
        ({"first": NY - 2, "count": 3}, "rows.count"),
        ({"first": 0, "count": 0}, "rows.count"),
        ({"first": -1, "count": 1}, "rows.first"),
        ({"first": 0}, "rows.count"),
    ],
)
def test_rows_that_do_not_exist_are_named(peer, rows, field):
    reply = peer.ask("ic.get", {**WHOLE, "rows": rows})
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "FIELD_INVALID", [field])


def test_components_are_known_words(peer):
    reply = peer.ask("ic.get", {**WHOLE, "components": ["zz", "zw"]})
    assert (reply.reason, reply.fields) == ("FIELD_INVALID", ["components[1]"])


def test_lists_that_are_too_large_are_refused_as_well(guest):
    reply = guest.ask("ic.get", WHOLE, arrays="list")
    assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "ANSWER_TOO_LARGE")
    rows = {**WHOLE, "rows": {"first": 0, "count": 1}, "components": ["zz"]}
    assert guest.ask("ic.get", rows, arrays="list").code == OK


def test_solutions_that_are_too_large_are_refused_before_they_are_solved(guest):
    before = guest.ask("server.info").result["counters"]["solves"]
    large = {**SOLVE, "grid": {"nx": 80, "ny": 80, "dx": 0.03, "dy": 0.03}}
    for method, params in [("contact.solve", large), ("contact.solve_many", {"problems": [SOLVE, large]})]:
        reply = guest.ask(method, params)
        assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "ANSWER_TOO_LARGE")
    assert guest.ask("server.info").result["counters"]["solves"] == before
    assert guest.ask("contact.solve", SOLVE).code == OK
