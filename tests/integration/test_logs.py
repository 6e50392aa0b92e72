"""Tests the log: one line per event, as text or JSON, for any text that clients send."""

import json
import re
import signal

import pytest

from contactd import FemIcs
from support.daemons import eventually
from support.problems import CATTANEO_PARAMS, GRID, STEEL

NASTY = 'x" status=OK\n2026-01-01T00:00:00.000 error forged\r\x1b[31m\x85 \u2028"}'


def requests_in(daemon):
    """Returns lines of requests, as objects."""
    return [line for line in map(json.loads, daemon.log.splitlines()) if line["message"] == "request"]


def test_a_line_of_json_has_time_level_message_and_fields(daemons):
    daemon = daemons.start(log={"format": "json"})
    with daemon.raw() as raw:
        raw.ask("server.health", id="a-7")
    eventually(lambda: requests_in(daemon))
    (line,) = requests_in(daemon)
    assert line["time"].endswith("Z")
    assert (line["level"], line["id"], line["method"], line["status"]) == ("info", "a-7", "server.health", "OK")
    assert line["ms"] >= 0
    assert line["client"]


def test_the_end_of_a_build_says_how_long_it_took_and_how_good_it_is(daemons):
    daemon = daemons.start()
    with daemon.client() as client:
        client.get_ic(STEEL, GRID, FemIcs("paper-test2", L_over_h=40))
        client.get_ic(STEEL, GRID, FemIcs(accuracy=1e-2))
    by_iterations, by_factor = (line for line in daemon.log.splitlines() if " finished after " in line)
    assert re.search(r"finished after \d+\.\d\d s: \d+ unknowns, solver amg_pcg, iterations z \d+ x \d+; errors xx", by_iterations)
    assert "L_over_h is 40; the paper advises at least 80" in by_iterations
    assert re.search(r"unknowns, solver direct; errors xx \d\.\de-03, yy \d\.\de-03, zz \d\.\de-03$", by_factor)


def test_every_line_of_a_daemons_life_is_json(daemons):
    daemon = daemons.start(log={"format": "json", "level": "trace"})
    with daemon.client() as client:
        client.health()
    assert daemon.stop() == 0
    messages = [json.loads(line)["message"] for line in daemon.log.splitlines()]
    assert any("listens at" in message for message in messages)
    assert messages[-1] == "ended"


@pytest.mark.parametrize("form", ["text", "json"])
def test_an_id_cannot_forge_a_line_or_a_field(daemons, form):
    daemon = daemons.start(log={"format": form})
    with daemon.raw() as raw:
        raw.ask("server.health", id=NASTY)
        raw.ask(NASTY, id="2")
    eventually(lambda: daemon.log.count("server.health") == 1 and daemon.log.count("UNIMPLEMENTED") == 1)
    lines = [line for line in daemon.log.splitlines() if "request" in line]
    assert len(lines) == 2
    assert all(" " <= character < "\x7f" for line in lines for character in line)
    if form == "json":
        assert [json.loads(line)["id"] for line in lines] == [NASTY, "2"]
        assert json.loads(lines[1])["method"] == NASTY
    else:
        assert 'id="x\\" status=OK\\n2026' in lines[0]


def test_parameters_and_metadata_stay_out_of_the_log(daemons):
    daemon = daemons.start(log={"level": "trace"})
    with daemon.raw() as raw:
        assert raw.ask("contact.solve", CATTANEO_PARAMS | {"approach": 0.0212345}, metadata={"x": "hush"}).status == "OK"
    assert daemon.stop() == 0
    assert "contact.solve" in daemon.log
    assert "0.0212345" not in daemon.log
    assert "hush" not in daemon.log


def test_sighup_opens_the_log_file_again(daemons):
    path = daemons.folder / "daemon" / "contactd.log"
    moved = daemons.folder / "moved" / "contactd.log"
    moved.parent.mkdir()
    daemon = daemons.start(log={"file": str(path)})
    with daemon.client() as client:
        client.health()
        path.rename(moved)
        daemon.process.send_signal(signal.SIGHUP)
        eventually(lambda: path.exists() and "reopened" in path.read_text())
        client.health()
        eventually(lambda: path.read_text().count("server.health") == 1)
    assert moved.read_text().count("server.health") == 1


def test_a_log_file_that_cannot_be_opened_again_is_kept(daemons):
    folder = daemons.folder / "logs"
    folder.mkdir()
    daemon = daemons.start(log={"file": str(folder / "contactd.log")})
    moved = daemons.folder / "moved"
    folder.rename(moved)
    folder.write_text("")  # where the folder was
    with daemon.client() as client:
        daemon.process.send_signal(signal.SIGHUP)
        eventually(lambda: "the old one stays open" in (moved / "contactd.log").read_text())
        client.health()
        eventually(lambda: "server.health" in (moved / "contactd.log").read_text())
    folder.unlink()
