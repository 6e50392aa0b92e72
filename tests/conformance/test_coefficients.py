"""Tests influence coefficients: both ways to request them, provided coefficients, and failing builds."""

import shutil

import numpy as np
import pytest

from conformance.requests import LONG_BUILD, QUICK_BUILD, SOLVE, TABLE
from conformance.wire import (
    CANCELLED,
    FAILED_PRECONDITION,
    INTERNAL,
    INVALID_ARGUMENT,
    NOT_FOUND,
    OK,
    RESOURCE_EXHAUSTED,
)


@pytest.mark.parametrize("field", [{"preset": "paper-test2"}, {"mesh": "hex"}, {"order": 2}, {"solver": "direct"}], ids=str)
def test_an_accuracy_and_a_mesh_exclude_each_other(peer, field):
    reply = peer.ask("ic.get", {**TABLE, "ics": {"source": "fem", "accuracy": 1e-2, **field}})
    assert (reply.code, reply.reason) == (INVALID_ARGUMENT, "FIELD_INVALID")


def test_a_mesh_of_too_many_elements_is_refused(peer):
    ics = {"source": "fem", "mesh": "hex", "l_over_h": 32, "h_over_hs": 8}
    reply = peer.ask("ic.get", {**TABLE, "ics": ics})
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "FIELD_INVALID", ["ics"])


def test_a_closed_form_has_no_error_to_state(peer):
    result = peer.ask("ic.get", TABLE).result
    assert result["origin"] == "closed_form"
    assert set(result["evidence"]) == {"source", "version"}  # closed forms have no numerical errors


def test_coefficients_beyond_a_doubles_range_are_refused(peer):
    reply = peer.ask("ic.get", {**TABLE, "material": {"G": 5e-324, "nu": 0.3}})
    assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "FIELD_INVALID", ["material.G"])


def test_a_mesh_that_is_its_own_mirror_image_is_solved_for_two_loads(peer):
    evidence = peer.ask("ic.get", {**QUICK_BUILD, "grid": {"nx": 4, "ny": 4, "dx": 1, "dy": 1}}).result["evidence"]
    assert {case["load"] for case in evidence["load_cases"]} == {"x", "z"}
    assert evidence["errors"]["zz"]["largest"] > 0


def test_an_export_travels_in_the_answer(peer):
    reply = peer.ask("ic.export", {**TABLE, "format": "hdf5"})
    assert b"\x89HDF\r\n\x1a\n" in reply.array(reply.result["file"]).tobytes()
    assert peer.ask("ic.export", {**TABLE, "format": "contact"}).result["text"].count("\n") > 4 * 6


def test_what_a_file_holds_is_imported_and_wrong_numbers_are_refused(peer, start):
    exported = peer.ask("ic.export", {**QUICK_BUILD, "format": "contents"})
    attributes, datasets = exported.result["attributes"], exported.result["datasets"]
    table = exported.array(datasets["influence_coefficients"])
    with start(builds={"program": "/bin/false"}).peer() as other:
        wrong = {"attributes": attributes, "datasets": {"influence_coefficients": (1.5 * table).tolist()}}
        reply = other.ask("ic.import", wrong)
        assert (reply.code, reply.reason, reply.fields) == (INVALID_ARGUMENT, "FIELD_INVALID", ["datasets"])
        imported = other.ask("ic.import", {"attributes": attributes, "datasets": datasets}, *exported.frames).result
        assert (imported["new"], imported["ics"]["origin"]) == (True, "file")
        assert imported["ics"]["evidence"]["imported"]
        assert other.ask("ic.get", QUICK_BUILD).result["key"] == imported["ics"]["key"]


def test_what_needs_a_store_says_that_there_is_none_any_more(start):
    daemon = start()
    with daemon.peer() as peer:
        assert peer.ask("ic.list").result["tables"] == []
        store = daemon.folder / "store"
        shutil.rmtree(store)
        store.write_text("no folder")
        reply = peer.ask("ic.list")
        assert (reply.code, reply.reason) == (FAILED_PRECONDITION, "STORE_UNUSABLE")
        assert str(daemon.folder) not in reply.text
        assert peer.ask("contact.solve", SOLVE).code == OK  # closed forms need none
        store.unlink()


def test_a_builder_that_fails_is_reported(start):
    daemon = start(builds={"program": "/bin/false"})
    with daemon.peer() as peer:
        reply = peer.ask("ic.get", QUICK_BUILD)
        assert (reply.code, reply.reason) == (INTERNAL, "BUILD_FAILED")
        assert peer.ask("ic.get", TABLE).code == OK


def test_a_build_that_failed_again_and_again_is_not_tried_until_it_is_let_go(start):
    daemon = start(builds={"program": "/bin/false", "max_failures": 1})
    with daemon.peer() as peer:
        assert peer.ask("ic.get", QUICK_BUILD).reason == "BUILD_FAILED"
        reply = peer.ask("ic.get", QUICK_BUILD)
        assert (reply.code, reply.reason) == (FAILED_PRECONDITION, "BUILD_QUARANTINED")
        assert reply.details["retry_delay_ms"] > 0
        (entry,) = peer.ask("ic.list").result["quarantined"]
        assert peer.ask("ic.delete", {"key": entry["key"]}).result["failures"] is True
        assert peer.ask("ic.get", QUICK_BUILD).reason == "BUILD_FAILED"


def test_a_build_without_memory_says_so(start):
    daemon = start(builds={"max_memory_bytes": 700_000_000})
    with daemon.peer() as peer:
        reply = peer.ask("ic.get", {**LONG_BUILD, "ics": {**LONG_BUILD["ics"], "solver": "amg_pcg"}})
        assert (reply.code, reply.reason) == (RESOURCE_EXHAUSTED, "BUILD_OUT_OF_MEMORY")


def test_a_build_says_how_many_seconds_are_left(start, tmp_path):
    builder = tmp_path / "builder"
    builder.write_text("#!/bin/sh\necho '{\"stage\": \"factorisation\", \"fraction\": 0.3, \"seconds_left\": 12.5}'\nexit 1\n")
    builder.chmod(0o755)
    with start(builds={"program": str(builder)}).peer() as peer:
        peer.send("ic.get", QUICK_BUILD)
        seen = []
        while (message := peer.message()).is_progress:
            seen.append(message.progress)
    assert [progress.get("seconds_left") for progress in seen if progress["stage"] == "factorisation"] == [12.5]
    assert all("seconds_left" not in progress for progress in seen if progress["stage"] != "factorisation")


def test_tables_are_listed_page_by_page_and_deleted_by_key(start):
    daemon = start()
    with daemon.peer() as peer:
        for nu in (0.1, 0.2):
            assert peer.ask("ic.get", {**QUICK_BUILD, "material": {"G": 1, "nu": nu}}).code == OK
        first = peer.ask("ic.list", {"limit": 1}).result
        second = peer.ask("ic.list", {"limit": 1, "after": first["next"]}).result
        assert "next" not in second
        keys = {page["tables"][0]["key"] for page in (first, second)}
        assert (len(keys), first["count"]) == (2, 2)
        for key in keys:
            assert peer.ask("ic.delete", {"key": key}).result["tables"] == 1
        reply = peer.ask("ic.delete", {"key": key})
        assert (reply.code, reply.reason) == (NOT_FOUND, "IC_UNKNOWN")
        assert peer.ask("ic.list").result["tables"] == []


def test_a_cancelled_job_ends_for_all_who_wait(shared, peer):
    with shared.peer() as other:
        params = {**LONG_BUILD, "grid": {"nx": 3, "ny": 3, "dx": 1, "dy": 1}}
        peer.send("ic.get", params)
        other.send("ic.get", params)
        job = peer.message().progress["job"]
        assert other.message().progress["job"] == job
        with shared.peer() as third:
            assert third.ask("job.cancel", {"job": job}).result == {"job": job}
        for waiting in (peer, other):
            reply = waiting.reply()
            assert (reply.code, reply.reason) == (CANCELLED, "JOB_CANCELLED")


# --- coefficients of one's own ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def pair(shared):
    """Returns coefficients of a pair of equal bodies, by the closed form: shape [3, 3, ny, nx]."""
    material = SOLVE["bodies"]["upper"]
    with shared.peer() as connected:
        reply = connected.ask("ic.get", {"material": material, "grid": SOLVE["grid"], "ics": SOLVE["ics"]})
        one = reply.array(reply.result["table"])
    sign = np.ones((3, 3, 1, 1))
    sign[[0, 1, 2, 2], [2, 2, 0, 1]] = 0  # equal bodies have vanishing differences
    return 2 * one * sign


def given(table, **fields):
    reference = {"$array": {"frame": 1, "dtype": "<f8", "shape": list(table.shape)}}
    ics = {"source": "table", "table": reference, "dx": SOLVE["grid"]["dx"], "dy": SOLVE["grid"]["dy"], **fields}
    return {**{name: value for name, value in SOLVE.items() if name != "bodies"}, "ics": ics}, table.tobytes()


def test_coefficients_of_ones_own_stand_for_the_bodies(peer, pair):
    expected = peer.ask("contact.solve", SOLVE).result
    result = peer.ask("contact.solve", *given(pair)).result
    assert result["forces"]["Fn"] == pytest.approx(expected["forces"]["Fn"])
    assert result["evidence"]["ics"]["pair"]["origin"] == "given"
    params, frame = given(pair)
    with_bodies = peer.ask("contact.solve", {**params, "bodies": {"upper": {"G": 1, "nu": 0}}}, frame).result
    assert with_bodies["forces"] == result["forces"]


def changed(table, at, value):
    table = table.copy()
    table[at] = value
    return table


@pytest.mark.parametrize(
    ("change", "fields"),
    [
        (lambda pair: pair[:, :, :-1].copy(), {}),
        (lambda pair: pair, {"dx": SOLVE["grid"]["dx"] * (1 + 1e-5)}),
        (lambda pair: changed(pair, (2, 2, 1, 1), np.nan), {}),
        (lambda pair: changed(pair, (0, 0, 0, 0), -1.0), {}),
        (lambda pair: changed(pair, (2, 2, 3, 3), 2 * pair[2, 2, 0, 0]), {}),
    ],
    ids=["too few rows", "another element size", "not finite", "negative", "not largest at the first offset"],
)
def test_coefficients_that_cannot_be_are_refused(peer, pair, change, fields):
    reply = peer.ask("contact.solve", *given(change(pair), **fields))
    assert reply.code == INVALID_ARGUMENT
    assert reply.fields[0].startswith("ics.")
