"""Large solves do not hold up small ones of other clients."""

from contactd import Friction, Grid, Rolling
from support.daemons import eventually
from support.problems import CATTANEO

LARGE = CATTANEO.replace(
    grid=Grid.centred(700, 700, 2.4, 2.4), friction=Friction(mu=0.4, rolling=Rolling(kind="steady", xi=1e-3))
)
SMALL = CATTANEO.replace(grid=Grid.centred(25, 25, 2.4, 2.4))


def test_small_solves_are_answered_while_large_ones_have_what_workers_they_may(daemons, background):
    daemon = daemons.start(workers=2)
    with daemon.client() as first, daemon.client() as second, daemon.client() as other:
        large = [background(client.solve, LARGE, timeout=600) for client in (first, second)]
        eventually(lambda: len([job for job in other.jobs() if job.kind == "solve"]) == 2)
        for _ in range(5):
            assert other.solve(SMALL).converged
        assert not any(solve.done() for solve in large)
        with daemon.raw() as raw:
            assert raw.ask("server.info").result["queue"]["solves_running"] == 1
        for job in other.jobs():
            other.cancel_job(job.job)
        for solve in large:
            assert solve.exception() is not None
