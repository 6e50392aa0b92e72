"""Tests how long calls wait, and their messages after a timeout."""

import pickle

import pytest

from contactd import (
    AnalyticIcs,
    Client,
    ContactProblem,
    DeadlineExceeded,
    FemIcs,
    Grid,
    Material,
    NotFound,
    Paraboloid,
    Progress,
    TimeoutExpired,
)
from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetState
from support import answers
from support.fake_server import FakeServer

GRID, STEEL = Grid(3, 2, 1, 1), Material(82000, 0.28)


def problem(ics):
    return ContactProblem(grid=GRID, upper=STEEL, ics=ics, gap=Paraboloid(1, 1), approach=0.1)


def session(ics):
    return lambda client: client.session(grid=GRID, upper=STEEL, ics=ics)


CALLS = {
    "get_ic": lambda ics: lambda client: client.get_ic(STEEL, GRID, ics),
    "export_ic": lambda ics: lambda client: client.export_ic(STEEL, GRID, ics),
    "solve": lambda ics: lambda client: client.solve(problem(ics)),
    "solve_many": lambda ics: lambda client: client.solve_many([problem(AnalyticIcs()), problem(ics)]),
    "session": session,
}


def waits(tmp_path, act, **options):
    """Returns the timeout (s) that a call sends, regardless of the result."""
    with FakeServer(tmp_path, lambda request: [request.failure(5, "No.")]) as server:
        with Client(server.endpoint, **options) as client, pytest.raises(Exception, match="No"):
            act(client)
        return server.requests[0].envelope["timeout_ms"] / 1000


@pytest.mark.parametrize("call", CALLS)
def test_what_may_build_waits_an_hour_and_all_else_a_minute(tmp_path, call):
    assert waits(tmp_path, CALLS[call](FemIcs())) == 3600
    assert waits(tmp_path, CALLS[call](AnalyticIcs())) == 60
    assert waits(tmp_path, CALLS[call](FemIcs()), timeout=2, build_timeout=7) == 7


WHEELS = {
    "wheel_rail": lambda setup: lambda client: client.wheel_rail(setup, WheelRailState()),
    "wheelset": lambda setup: lambda client: client.wheelset(setup, WheelsetState(Fz_left=1e4, Fz_right=1e4)),
    "the left wheel": lambda left: lambda client: client.wheelset(WheelRailSetup(), WheelsetState(Fz_left=1e4, Fz_right=1e4), left=left),
}


@pytest.mark.parametrize("call", WHEELS)
def test_wheels_on_rails_wait_for_builds_with_sections_only(tmp_path, call):
    assert waits(tmp_path, WHEELS[call](WheelRailSetup(conformal="fem"))) == 3600
    assert waits(tmp_path, WHEELS[call](WheelRailSetup(conformal="rotated"))) == 60
    assert waits(tmp_path, WHEELS[call](WheelRailSetup(conformal="fem", model="fastsim"))) == 60
    assert waits(tmp_path, lambda client: client.wheel_rail_geometry(WheelRailSetup(conformal="fem"), [WheelRailState()])) == 60


@pytest.mark.parametrize(("conformal", "seconds"), [("fem", 3600), ("rotated", 60)])
def test_steps_of_wheels_wait_as_long_as_their_session_needs(tmp_path, conformal, seconds):
    def script(request):
        told = {"session": "s" * 20, "lease_seconds": 60, "bytes": 0, "step": 0, "ics": {}}
        return [request.result(told) if request.method == "session.open" else request.failure(5, "No.")]

    with FakeServer(tmp_path, script) as server, Client(server.endpoint) as client:
        wheel = client.wheel_rail_session(WheelRailSetup(conformal=conformal))
        for act in (lambda: wheel.step(WheelRailState()), lambda: client.step_many([(wheel, {"state": WheelRailState()})])):
            with pytest.raises(NotFound):
                act()
    methods = {request.method: request.envelope["timeout_ms"] / 1000 for request in server.requests}
    assert methods == {"session.open": 60, "session.step": seconds, "session.step_many": seconds}


def test_a_quick_model_builds_nothing(tmp_path):
    assert waits(tmp_path, lambda client: client.solve(problem(FemIcs()).replace(model="hertz"))) == 60


def test_none_is_the_longest_time_there_is(tmp_path):
    assert waits(tmp_path, Client.health, timeout=None) == 86_400
    assert waits(tmp_path, Client.health, timeout=3) == 3


@pytest.mark.parametrize("name", ["timeout", "build_timeout", "connect_timeout"])
@pytest.mark.parametrize(
    ("value", "error"),
    [("x", TypeError), ("5", TypeError), (True, TypeError), ([1], TypeError), (0, ValueError), (-1, ValueError),
     (1e9, ValueError), (float("nan"), ValueError), (float("inf"), ValueError)],
)  # fmt: skip
def test_a_time_that_is_none_is_named_with_what_is_right(name, value, error):
    with pytest.raises(error, match=rf"^{name} is .*; it must be a number of seconds, more than 0 and at most 86400"):
        Client("ipc:///nowhere", **{name: value})


def test_a_time_of_one_call_is_checked_too(tmp_path):
    with Client("ipc:///nowhere") as client, pytest.raises(TypeError, match="timeout is 'x'; it must be a number"):
        client.health(timeout="x")


@pytest.mark.parametrize("refused", [False, True], ids=["no answer", "the daemon's refusal"])
@pytest.mark.parametrize("job", ["build-3", ""])
def test_a_wait_for_a_build_that_ends_says_that_the_build_goes_on(tmp_path, refused, job):
    def script(request):
        going = [request.progress(job=job)] if job else []
        return [*going, request.failure(4, "Too late.")] if refused else going

    with FakeServer(tmp_path, script) as server, Client(server.endpoint) as client:
        with pytest.raises(DeadlineExceeded if refused else TimeoutExpired) as caught:
            client.get_ic(STEEL, GRID, FemIcs(), timeout=0.2)
    text = str(caught.value)
    assert f"as job {job}. jobs() reports its progress, cancel_job('{job}') ends it" in text if job else "The build that it waited for" in text
    assert "continues in the daemon" in text
    assert "repeating the call joins it" in text


def test_a_wait_for_anything_else_says_nothing_of_builds(tmp_path):
    with FakeServer(tmp_path, lambda request: []) as server, Client(server.endpoint) as client:
        with pytest.raises(TimeoutExpired) as caught:
            client.get_ic(STEEL, GRID, AnalyticIcs(), timeout=0.05)
    assert "build" not in str(caught.value)


def test_progress_tells_the_time_to_go_and_the_memory(tmp_path):
    def script(request):
        return [
            request.progress(stage="assembly", fraction=0.1),
            request.progress(stage="factorisation", fraction=0.4, seconds_left=12.3, memory_bytes=870_000_000),
            request.result(*answers.table(2, 3)),
        ]

    seen = []
    with FakeServer(tmp_path, script) as server, Client(server.endpoint) as client:
        client.get_ic(STEEL, GRID, FemIcs(), on_progress=seen.append)
    assert [progress.seconds_left for progress in seen] == [None, 12.3]
    assert [progress.memory_bytes for progress in seen] == [None, 870_000_000]
    assert [str(progress) for progress in seen] == ["assembly 10 %", "factorisation 40 %, about 12 s to go, about 870 MB of memory"]


@pytest.mark.parametrize(("seconds", "words"), [(0.4, "0 s"), (119, "119 s"), (150, "2 min"), (9000, "2.5 h")])
def test_the_time_to_go_is_said_in_a_unit_that_fits(seconds, words):
    assert str(Progress("pcg", 0.5, seconds_left=seconds)) == f"pcg 50 %, about {words} to go"


def test_progress_shows_iterations_and_states():
    assert str(Progress("pcg", 0.5, iteration=7, residual=1.2e-4)) == "pcg 50 %, iteration 7, residual 1.2e-04"
    assert str(Progress("watch", 0, state="stopping")) == "the daemon is stopping"


@pytest.mark.parametrize(
    ("value", "error"),
    [("x", TypeError), (True, TypeError), (None, TypeError), (-1e-6, ValueError), (1.5, ValueError), (float("nan"), ValueError)],
)  # fmt: skip
def test_a_spin_that_is_none_is_named_with_what_is_right(value, error):
    with pytest.raises(error, match=r"^spin is .*; it must be a number of seconds from 0, the default, to 1"):
        Client("ipc:///nowhere", spin=value)


@pytest.mark.parametrize("spin", [0, 1e-4, 1])
def test_an_answer_is_found_awake_and_asleep(tmp_path, spin):
    with FakeServer(tmp_path, lambda request: [request.result({"state": "serving"})]) as server:
        with Client(server.endpoint, spin=spin) as client:
            assert [client.health() for _ in range(5)] == ["serving"] * 5
            with pickle.loads(pickle.dumps(client)) as other:
                assert other.spin == spin
