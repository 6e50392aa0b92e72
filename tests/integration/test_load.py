"""Runs short versions of ./dev load and ./dev load random: random messages, small and large, and good and faulty
clients at the same time."""

import pytest

from contactd.transport.programs import laid_over
from load import large_load, load, random_messages
from load.workload import SMALL


def statuses_with(outcome, word):
    return sum(count for name, count in outcome.statuses.items() if word in name)


def test_every_random_message_gets_one_status(daemons):
    daemon = daemons.start(**random_messages.CONFIG)
    outcome = random_messages.run(daemon, count=2000, seed=20)
    assert outcome.statuses["OK"] > 50
    assert outcome.statuses["INVALID_ARGUMENT FIELD_INVALID"] > 200
    assert outcome.statuses["INVALID_ARGUMENT ARRAY_INVALID"] > 10
    growth = outcome.memory[-1] - outcome.memory[len(outcome.memory) // 2]
    assert growth < 20 << 20, f"memory grew by {growth} bytes in the second half"


@pytest.mark.slow  # sends 300 large messages, which take seconds each
@pytest.mark.timeout(300)
@pytest.mark.xdist_group("alone")  # runs in sequence with tests of test_bounds that measure times
def test_random_messages_with_large_grids_keep_a_daemon_within_its_bounds(daemons):
    less = {"limits": {"max_work_bytes": 1 << 30}}
    daemon = daemons.start(**laid_over(large_load.CONFIG, less))
    report = large_load.run(daemon, seconds=15, seed=20, at_least=300)
    assert report.watched.most <= report.bound, "\n".join(report.lines())
    assert len(report.watched.latencies_ms) > 100, "health is not answered meanwhile"
    assert statuses_with(report.outcome, "OK") > 20
    assert statuses_with(report.outcome, "DEADLINE_PASSED") > 5


@pytest.mark.parametrize("endpoint", ["tcp://127.0.0.1:*", None], ids=["tcp", "ipc"])
def test_every_request_is_answered_once_and_rightly_beside_bad_clients(daemons, endpoint):
    config = {"limits": {"max_outbox_bytes": 1 << 20}, **({"endpoint": endpoint} if endpoint else {})}
    daemon = daemons.start(**config)
    found = load.run(daemon, number=20, seconds=3, processes=2, in_threads=True)
    assert found["problems"] == []
    assert found["sent"] == found["answered"]
    assert found["latency_ms"]["with bad citizens"][SMALL]["count"] > 10
    assert all(sent > 0 for sent in found["bad_citizens_sent"].values())
