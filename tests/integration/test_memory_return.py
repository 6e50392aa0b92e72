"""Tests that memory of requests is returned to the system when the daemon is idle."""

import time

import pytest

from contactd import Grid
from support.daemons import eventually, resident
from support.problems import CATTANEO

CASE = """\
 3  MODULE
  203100
  100000
 0101201
 50000.  0.0020  0.0  0.0001
"""
MEBIBYTE = 1 << 20


@pytest.mark.parametrize("text", [CASE * (16 * MEBIBYTE // len(CASE) - 1), "\n" * (16 * MEBIBYTE - 100)], ids=["cases", "blank lines"])
def test_a_large_file_of_cases_leaves_little_behind(daemons, text):
    """16 MiB of text left 80 to 130 MiB at the ends of the arenas of threads."""
    daemon = daemons.start()
    with daemon.client() as client:
        client.read_contact_file(" 0  MODULE\n")
        before = resident(daemon)
        for _ in range(3):
            client.call("contact_file.read", {"text": text, "name": "large.inp"})
        eventually(lambda: resident(daemon) < before + 50 * MEBIBYTE, f"it keeps {(resident(daemon) - before) >> 20} MiB")


@pytest.mark.slow  # operators are kept for a minute
@pytest.mark.timeout(150)
def test_operators_beyond_their_budget_go_after_a_minute(daemons):
    daemon = daemons.start(store={"influence_budget_bytes": 1 << 20})
    with daemon.client() as client:
        problem = CATTANEO.replace(grid=Grid.centred(400, 400, 2.4, 2.4))
        client.solve(problem, fields=[])
        time.sleep(50)  # the memory of the solve itself was returned
        operators = kept(client)
        assert operators > 30 * MEBIBYTE
        before = resident(daemon)
        eventually(lambda: resident(daemon) < before - 0.3 * operators, "it keeps its operators", seconds=30)
        assert kept(client) == 0


def kept(client):
    """Bytes of operators."""
    (metric,) = [one for one in client.metrics() if one["name"] == "contactd_cache_bytes"]
    (value,) = [sample["value"] for sample in metric["samples"] if sample["labels"] == {"cache": "influences"}]
    return value
