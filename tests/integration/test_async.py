"""Tests AsyncClient with a real daemon: many simultaneous calls, equal answers, and cancelled tasks."""

import asyncio
import threading

import pytest

from contactd import AsyncClient, Client, NotFound
from support.daemons import eventually
from support.processes import PROBLEM
from support.sessions import ENDLESS

APPROACHES = [0.005 + 1e-5 * n for n in range(1000)]


def test_a_thousand_outstanding_calls_have_the_answers_of_a_thousand_problems(shared_daemon):
    async def ask():
        async with AsyncClient(shared_daemon.endpoint) as client:
            return await asyncio.gather(*(client.solve(PROBLEM.replace(approach=a), fields=[]) for a in APPROACHES))

    with Client(shared_daemon.endpoint) as client:
        expected = client.solve_many([PROBLEM.replace(approach=a) for a in APPROACHES], fields=[])
    assert [solution.Fn for solution in asyncio.run(ask())] == [solution.Fn for solution in expected]


def test_a_task_that_is_cancelled_ends_its_solve_in_the_daemon(shared_daemon, shared):
    async def ask():
        async with AsyncClient(shared_daemon.endpoint) as client:
            task = asyncio.create_task(client.solve(PROBLEM.replace(friction=ENDLESS)))
            while not await client.jobs():
                await asyncio.sleep(0.01)
            task.cancel()
            with pytest.raises(asyncio.CancelledError):
                await task
            return await client.health()

    assert asyncio.run(ask()) == "serving"
    eventually(lambda: not shared.jobs(), "the solve goes on")


def test_sessions_of_one_loop_take_their_steps_side_by_side(shared_daemon):
    async def forces(client, approach):
        async with await client.session(PROBLEM.replace(approach=approach)) as session:
            found = [(await session.step(approach=approach + 1e-3 * n)).Fn for n in range(3)]
            state = await session.save()
            await session.step(approach=approach)
            await session.restore(state)
            joined = await client.join_session(session.name)
            assert joined.step_number == 3
            await session.forget(state)
            with pytest.raises(NotFound):
                await session.restore(state)
            return found

    async def ask():
        async with AsyncClient(shared_daemon.endpoint) as client:
            found = await asyncio.gather(*(forces(client, 0.005 + 0.001 * n) for n in range(8)))
            assert not await client.sessions()
            return found

    found = asyncio.run(ask())
    assert found[0][1] == found[1][0]
    assert found[7] == sorted(found[7])


def test_a_hundred_threads_share_a_client(shared_daemon):
    found: dict[int, float] = {}

    def ask(n):
        found[n] = client.solve(PROBLEM.replace(approach=APPROACHES[n]), fields=[]).Fn

    with Client(shared_daemon.endpoint) as client:
        threads = [threading.Thread(target=ask, args=(n,)) for n in range(100)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        expected = client.solve_many([PROBLEM.replace(approach=a) for a in APPROACHES[:100]], fields=[])
    assert [found[n] for n in range(100)] == [solution.Fn for solution in expected]
