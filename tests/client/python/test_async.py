"""Tests AsyncClient: the calls of Client in an event loop, many at a time, and abandoned calls."""

import asyncio
import gc
import inspect
import os
import pickle
import threading
import time
from pathlib import Path

import numpy as np
import pytest
import zmq.auth

import contactd
from contactd import (
    AnalyticIcs,
    AsyncClient,
    AsyncSession,
    Client,
    ConnectionFailed,
    ContactdError,
    ContactProblem,
    FemIcs,
    Friction,
    Grid,
    Material,
    NotFound,
    Paraboloid,
    ProtocolError,
    Session,
    TimeoutExpired,
    Unauthenticated,
)
from contactd.calls.call import asks
from support import answers
from support.fake_server import FakeServer
from support.processes import in_fork
from support.sessions import STEP, opened

GRID, STEEL = Grid(3, 2, 1, 1), Material(82000, 0.28)
PROBLEM = ContactProblem(grid=GRID, upper=STEEL, gap=Paraboloid(1, 1), approach=0.1)
#: Names that only one of the two needs.
OWN = {"__enter__", "__exit__", "__aenter__", "__aexit__"}


def serving(request):
    return [request.result({"state": "serving"})]


def run(script, act, tmp_path: Path, **options):
    """Returns the result of the coroutine function `act` with a client whose daemon follows `script`."""

    async def main(endpoint):
        async with AsyncClient(endpoint, **{"timeout": 5, **options}) as client:
            return await act(client)

    with FakeServer(tmp_path, script) as server:
        return asyncio.run(main(server.endpoint)), server.requests


def public(kind):
    return {name for name in dir(kind) if not name.startswith("_")} | OWN & set(dir(kind))


@pytest.mark.parametrize(("waits", "awaits"), [(Client, AsyncClient), (Session, AsyncSession)])
def test_both_clients_have_the_same_calls_with_the_same_arguments(waits, awaits):
    assert public(waits) - OWN == public(awaits) - OWN
    for name in public(waits) - OWN:
        one, other = inspect.getattr_static(waits, name), inspect.getattr_static(awaits, name)
        if isinstance(one, asks):
            assert one is other, "said once"
        elif callable(one) and name != "close":
            assert inspect.signature(one).parameters == inspect.signature(other).parameters, name


def test_help_shows_the_arguments_and_the_answer_of_a_call():
    assert str(inspect.signature(Client.health)) == "(self, *, timeout: 'float | None' = None) -> 'str'"
    assert Client.health.__doc__ == AsyncClient.health.__doc__ != None  # noqa: E711
    assert inspect.iscoroutinefunction(AsyncClient.health)
    assert not inspect.iscoroutinefunction(Client.health)


def test_calls_are_answered(tmp_path):
    def script(request):
        made = {"server.health": lambda: serving(request), "contact.solve": lambda: [request.result(*answers.solution(2, 3))],
                "contact.solve_many": lambda: [request.result(*answers.solutions((2, 3), {"code": 5, "message": "No."}))],
                "ic.get": lambda: [request.progress(), request.result(*answers.table(2, 3))],
                "job.cancel": lambda: [request.failure(5, "No such job.", reason="JOB_UNKNOWN")]}  # fmt: skip
        return made[request.method]()

    async def act(client):
        seen = []
        assert await client.health() == "serving"
        assert (await client.solve(PROBLEM)).Fn == 9.2
        assert (await client.solve(**vars(PROBLEM), fields=[])).pmax == 4.4
        one, other = await client.solve_many([PROBLEM, PROBLEM])
        assert one.Fn == 9.2
        assert isinstance(other, NotFound)
        table = await client.get_ic(STEEL, GRID, AnalyticIcs(), on_progress=seen.append)
        assert table.array.shape == (3, 3, 2, 3)
        assert [progress.stage for progress in seen] == ["pcg"]
        with pytest.raises(NotFound, match="No such job"):
            await client.cancel_job("build-1")

    run(script, act, tmp_path)


def test_the_store_is_listed_page_by_page(tmp_path):
    def script(request):
        table = {"key": request.params.get("after", "first"), "nx": 1, "ny": 1, "bytes": 1}
        return [request.result({"tables": [table], **({} if "after" in request.params else {"next": "second"})})]

    async def act(client):
        return [table.key async for table in client.stored_ics()]

    assert run(script, act, tmp_path)[0] == ["first", "second"]


def test_a_session_takes_its_steps(tmp_path):
    numbers, go_on = [], threading.Event()

    def script(request):
        if request.method == "session.open":
            return [request.result(opened())]
        if request.method == "session.step":
            if request.params["step"] == 4:
                go_on.wait(5)
            numbers.append(request.params["step"])
            return [request.result({**STEP, "step": request.params["step"]})]
        if request.method == "session.step_many":
            return [request.result({"steps": [{"status": {"code": 0, "name": "OK", "message": ""}, "result": {**STEP, "step": 3}}]})]
        return [request.result({"step": 0})]

    async def act(client):
        async with await client.session(grid=GRID, upper=STEEL, gap=Paraboloid(1, 1)) as session:
            assert isinstance(session, AsyncSession)
            assert [(await session.step(Fn=1)).step for _ in range(2)] == [1, 2]
            assert [answer.step for answer in await client.step_many([(session, {"Fn": 1})])] == [3]
            first, second = asyncio.create_task(session.step()), asyncio.create_task(session.step())
            with pytest.raises(ContactdError, match="one step at a time"):
                await second
            go_on.set()
            assert (await first).step == 4

    _, requests = run(script, act, tmp_path)
    assert numbers == [1, 2, 4]
    assert requests[-1].method == "session.close"


def test_a_thousand_calls_wait_at_once_and_the_daemon_has_a_few_of_them(tmp_path):
    waiting, most = [], 0

    def script(request):
        nonlocal most
        waiting.append(request)
        most = max(most, len(waiting))
        if len(waiting) < 20:
            return []
        held, waiting[:] = list(waiting), []  # all at once, the last one first
        return [one.result({"number": one.params["number"]}) for one in reversed(held)]

    async def act(client):
        return await asyncio.gather(*(client.call("contact.solve", {"number": n}) for n in range(1000)))

    found, requests = run(script, act, tmp_path, outstanding=20)
    assert [answer["number"] for answer in found] == list(range(1000))
    assert most == 20
    assert len(requests) == 1000


def test_what_is_answered_at_once_overtakes_what_waits_for_its_turn(tmp_path):
    async def act(client):
        held = [asyncio.create_task(client.call("contact.solve", {})) for _ in range(3)]
        await asyncio.sleep(0)
        state = await client.health()
        for task in held:
            task.cancel()
        await asyncio.wait(held)
        return state, [task.cancelled() for task in held]

    script = {"server.health": serving}
    found, requests = run(lambda request: script.get(request.method, lambda _: [])(request), act, tmp_path, outstanding=1)
    assert found == ("serving", [True] * 3)
    assert {one.method for one in requests[:2]} == {"contact.solve", "server.health"}


def cancelled(server, count=1):
    deadline = time.monotonic() + 10
    while time.monotonic() < deadline:
        if len(found := [one.params["id"] for one in server.requests if one.method == "request.cancel"]) >= count:
            return found
        time.sleep(0.005)
    return []


@pytest.mark.parametrize("how", ["a task", "a timeout", "a callback"])
def test_what_is_given_up_is_cancelled_and_the_client_goes_on(tmp_path, how):
    class Enough(Exception):
        pass

    def stop(progress):
        if how == "a callback":
            raise Enough
        progress_seen.set()

    def script(request):
        return serving(request) if request.method == "server.health" else [request.progress()]

    progress_seen = asyncio.Event()

    async def act(endpoint):
        async with AsyncClient(endpoint) as client:
            call = client.get_ic(STEEL, GRID, AnalyticIcs(), on_progress=stop, timeout=0.2 if how == "a timeout" else 20)
            if how == "a task":
                task = asyncio.create_task(call)
                await progress_seen.wait()
                task.cancel()
                with pytest.raises(asyncio.CancelledError):
                    await task
            else:
                with pytest.raises(TimeoutExpired if how == "a timeout" else Enough):
                    await call
            return await client.health()

    with FakeServer(tmp_path, script) as server:
        assert asyncio.run(act(server.endpoint)) == "serving"
        assert cancelled(server) == [server.requests[0].id]


def test_a_wait_for_a_build_that_ends_says_that_the_build_goes_on(tmp_path):
    async def act(client):
        with pytest.raises(TimeoutExpired, match=r"as job build-1\. jobs\(\) reports"):
            await client.get_ic(STEEL, GRID, FemIcs(), timeout=0.2)

    run(lambda request: [request.progress()] if request.method == "ic.get" else [], act, tmp_path)


def test_nobody_listens_at_the_endpoint(tmp_path):
    async def act():
        async with AsyncClient(f"ipc://{tmp_path}/nobody", connect_timeout=0.1) as client:
            outcomes = await asyncio.gather(*(client.health() for _ in range(3)), return_exceptions=True)
            with pytest.raises(ConnectionFailed, match="No daemon answers"):
                await client.health(timeout=0.05)
        with pytest.raises(ConnectionFailed, match="closed"):
            await client.health()
        return outcomes

    outcomes = asyncio.run(act())
    assert [type(error) for error in outcomes] == [ConnectionFailed] * 3
    assert all(str(error).startswith(f"No daemon answers at ipc://{tmp_path}/nobody. ") for error in outcomes)


def test_a_daemon_that_goes_away_is_told_and_one_that_comes_back_answers(tmp_path):
    asked = threading.Event()

    def script(request):
        asked.set()
        return []

    async def act():
        with FakeServer(tmp_path, script) as server:
            client = AsyncClient(server.endpoint, timeout=20)
            call = asyncio.create_task(client.health())
            await asyncio.to_thread(asked.wait, 5)
        with pytest.raises(ConnectionFailed, match=r"disconnected during server\.health"):
            await call
        with FakeServer(tmp_path, serving):
            assert await client.health() == "serving"
            await client.close()

    asyncio.run(act())


def test_an_answer_that_nobody_can_read_ends_the_calls(tmp_path):
    async def act(client):
        return await asyncio.gather(client.health(), client.info(), return_exceptions=True)

    found, _ = run(lambda request: [[b"rubbish"]] if request.method == "server.info" else [], act, tmp_path)
    assert [type(error) for error in found] == [ProtocolError] * 2


def test_closing_ends_what_runs(tmp_path):
    async def act(client):
        task = asyncio.create_task(client.health())
        await asyncio.sleep(0.05)
        await client.close()
        with pytest.raises(ConnectionFailed, match="was closed"):
            await task

    run(lambda request: [], act, tmp_path)


def test_nothing_runs_while_nothing_happens(tmp_path):
    """The loop turns once per message, not continuously."""
    turns = 0

    async def act(client):
        nonlocal turns
        loop, selector = asyncio.get_running_loop(), asyncio.get_running_loop()._selector
        select = selector.select

        def counted(timeout=None):
            nonlocal turns
            turns += 1
            return select(timeout)

        await client.health()
        selector.select = counted
        with pytest.raises(TimeoutExpired):
            await client.describe(timeout=0.3)
        selector.select = select
        return loop

    run(lambda request: serving(request) if request.method == "server.health" else [], act, tmp_path)
    assert turns < 20


def test_a_client_leaves_no_task_no_socket_and_no_descriptor(tmp_path):
    async def act(client):
        await asyncio.gather(*(client.health() for _ in range(20)))
        assert asyncio.all_tasks() == {asyncio.current_task()}

    def descriptors():
        gc.collect()
        return len(os.listdir("/proc/self/fd"))

    run(serving, act, tmp_path)
    before = descriptors()
    for n in range(5):
        (folder := tmp_path / str(n)).mkdir()
        run(serving, act, folder)
    assert descriptors() <= before


def test_a_client_serves_one_event_loop_after_the_other(tmp_path):
    with FakeServer(tmp_path, serving) as server:
        client = AsyncClient(server.endpoint, timeout=5)
        assert [asyncio.run(client.health()) for _ in range(3)] == ["serving"] * 3
        asyncio.run(client.close())


def test_a_client_of_a_running_loop_is_refused_in_another(tmp_path):
    with FakeServer(tmp_path, serving) as server:

        async def act():
            async with AsyncClient(server.endpoint, timeout=5) as client:
                await client.health()
                with pytest.raises(ContactdError, match="in another running event loop"):
                    await asyncio.to_thread(lambda: asyncio.run(client.health()))
                return await client.health()

        assert asyncio.run(act()) == "serving"


@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_a_forked_process_and_a_pickle_connect_anew(tmp_path):
    with FakeServer(tmp_path, serving) as server:
        client = AsyncClient(server.endpoint, timeout=5, outstanding=3)
        assert asyncio.run(client.health()) == "serving"
        assert in_fork(lambda: asyncio.run(client.health())) == "serving"
        arrived = pickle.loads(pickle.dumps(client))
        assert (arrived.endpoint, arrived.timeout, arrived.outstanding) == (server.endpoint, 5, 3)
        for one in (arrived, client):
            assert asyncio.run(one.health()) == "serving"
            asyncio.run(one.close())
        assert "AsyncClient of" in repr(client)
        assert "closed" in repr(client)


@pytest.mark.parametrize(("value", "error"), [("x", TypeError), (True, TypeError), (0, ValueError), (-3, ValueError)])
def test_a_number_of_calls_that_is_none_is_named_with_what_is_right(value, error):
    with pytest.raises(error, match=r"^outstanding is .*; it must be a whole number of calls, 1 or more"):
        AsyncClient("ipc:///nowhere", outstanding=value)


def test_arrays_too_large_are_refused_before_they_are_sent(tmp_path):
    async def act(client):
        gap = np.zeros((40, 40))
        problem = ContactProblem(grid=Grid(40, 40, 1, 1), upper=STEEL, gap=gap, approach=1, friction=Friction(0.3, rigid_shift=(0, 0)))
        with pytest.raises(contactd.InvalidArgument, match="has 1600 numbers, but the daemon accepts at most 1000"):
            await client.solve(problem)

    _, requests = run(lambda request: [request.result(answers.INFO)], act, tmp_path)
    assert [request.method for request in requests] == ["server.info"]


def test_a_daemon_without_encryption_is_told_and_asked_again(tmp_path):
    zmq.auth.create_certificates(tmp_path, "daemon")
    _, own = zmq.auth.create_certificates(tmp_path, "alice")
    os.chmod(own, 0o600)

    async def act(endpoint):
        async with AsyncClient(endpoint, server_key=tmp_path / "daemon.key", own_key=own, timeout=20) as client:
            for _ in range(2):  # on a new socket, because a refused one never connects again
                outcomes = await asyncio.gather(client.health(), client.info(), return_exceptions=True)
                assert [type(error) for error in outcomes] == [Unauthenticated] * 2, outcomes
                assert all("the daemon does not use encryption" in str(error) for error in outcomes)

    with FakeServer(tmp_path, serving) as server:
        asyncio.run(act(server.endpoint))


@pytest.mark.parametrize("endpoint", ["nonsense", "tcp://", "http://x:1"])
def test_what_is_no_endpoint_is_named(endpoint):
    async def act():
        async with AsyncClient(endpoint) as client:
            await client.health()

    with pytest.raises(ConnectionFailed, match="is not a valid endpoint"):
        asyncio.run(act())


def test_a_call_that_is_cancelled_before_it_is_sent_leaves_no_trace(tmp_path):
    async def act():
        async with AsyncClient(f"ipc://{tmp_path}/fake", connect_timeout=20) as client:
            tasks = [asyncio.create_task(call) for call in (client.health(), client.solve(PROBLEM))]
            await asyncio.sleep(0)
            for task in tasks:
                task.cancel()
            await asyncio.wait(tasks)
            with FakeServer(tmp_path, serving) as server:
                assert await client.health() == "serving"
                return [request.method for request in server.requests]

    assert asyncio.run(act()) == ["server.health"]
