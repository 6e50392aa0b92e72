"""Tests that large solves do not delay small ones of other clients."""

from contactd import Friction, Grid, Rolling
from support.daemons import eventually, resident
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
        with daemon.raw() as raw:  # the worker of the last small solve ends a moment after its answer was sent
            eventually(lambda: raw.ask("server.info").result["queue"]["solves_running"] == 1)
        for job in other.jobs():
            other.cancel_job(job.job)
        for solve in large:
            assert solve.exception() is not None


def test_large_steps_of_sessions_leave_a_worker_to_small_ones(daemons, background):
    daemon = daemons.start(workers=2, sessions={"max_bytes": 1 << 32})
    with daemon.client() as first, daemon.client() as second, daemon.client() as other:
        sessions = [client.session(LARGE) for client in (first, second)]
        small = other.session(SMALL)
        large = [background(session.step, timeout=600) for session in sessions]
        eventually(lambda: len([job for job in other.jobs() if job.kind == "step"]) == 2)
        for _ in range(5):
            assert small.step().converged
        assert not any(step.done() for step in large)
        for session in sessions:
            session.close()
        for step in large:
            assert step.exception() is not None


def test_memory_goes_back_to_the_system_after_a_burst(daemons):
    daemon = daemons.start(workers=2)
    with daemon.client() as client:
        client.solve(SMALL)
        before = resident(daemon)
        # Small solves have small operators, which are kept; answers are not.
        assert all(solution.converged for solution in client.solve_many([SMALL.replace(grid=Grid.centred(31, 31, 2.4, 2.4))] * 1000))
        taken = resident(daemon, "VmHWM") - before
        assert taken > 50 << 20, "no burst"
        eventually(lambda: resident(daemon) - before < taken / 10)
