"""server.health answers while everything else is busy."""

import time

from support.daemons import eventually
from support.problems import ENDLESS, GRID, LONG, STEEL


def test_health_answers_while_a_build_and_two_large_solves_run(daemon, client, background):
    work = [background(client.get_ic, STEEL, GRID, LONG)]
    eventually(client.jobs)  # the solves take all workers, behind which a build would not even begin
    work += [background(client.solve, ENDLESS) for _ in range(2)]
    eventually(lambda: sum(job.state == "running" for job in client.jobs()) == 3)
    latencies = []
    for _ in range(50):
        start = time.perf_counter()
        assert client.health() == "serving"
        latencies.append(1000 * (time.perf_counter() - start))
    assert not any(future.done() for future in work)
    print(f"health beside three jobs: median {sorted(latencies)[25]:.2f} ms, largest {max(latencies):.2f} ms")
    for job in client.jobs():
        client.cancel_job(job.job)
    for future in work:
        assert future.exception() is not None
