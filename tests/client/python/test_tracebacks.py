"""Tests tracebacks: they show the line of the call and the message, and no frames of this package."""

import os
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

import contactd
from contactd.refusals import public
from support.daemons import BIN

PACKAGE = Path(contactd.__file__).parent
BEGIN = """
import asyncio, os, numpy as np
from contactd import *
from contactd.wheel_rail import *
import contactd
grid, steel, ball = Grid(5, 5, 0.1, 0.1), Material(G=82000, nu=0.28), Paraboloid(50, 50)
nobody = "ipc:///nowhere/socket"
"""


def shown(tmp_path, code, **environment):
    """Returns files of the frames of the traceback that ends a program, the line of the last one, and the last line of
    all."""
    script = tmp_path / "user.py"
    script.write_text(BEGIN + textwrap.dedent(code))
    paths = os.pathsep.join([str(PACKAGE.parent), str(BIN.parent / "lib" / "python")])
    environment = {**os.environ, "PYTHONPATH": paths, "USER_BIN": str(BIN), **environment}
    ended = subprocess.run([sys.executable, script], capture_output=True, text=True, env=environment, timeout=60, check=False)
    assert ended.returncode == 1, ended.stderr
    frames = re.findall(r'^ +File "([^"]+)", line \d+, in .*(?:\n    (.*))?', ended.stderr, re.MULTILINE)
    assert ended.stderr.count("Traceback") == 1 or environment.get("CONTACTD_TRACEBACK"), ended.stderr
    return [file for file, _ in frames], frames[-1][1].strip(), ended.stderr.strip().splitlines()[-1]


def ours(files):
    """A dataclass's own __init__ is in no file."""
    return [file for file in files if file == "<string>" or Path(file).is_relative_to(PACKAGE)]


CALLS = {
    "a client that cannot be made": 'Client(nobody, timeout="long")',
    "no daemon": "Client(nobody, connect_timeout=0.1).info()",
    "no daemon to solve": "Client(nobody, connect_timeout=0.1).solve(grid=grid, upper=steel, gap=ball, approach=0.01)",
    "a wrong keyword": "Client(nobody).solve(grid=grid, upper=steel, gap=ball, aproach=0.01)",
    "a wrong keyword of a call": "Client(nobody).info(timeot=1)",
    "a wrong type": "Client(nobody).solve(grid=3, upper=steel, gap=ball, approach=0.01)",
    "an array that is not finite": "Client(nobody).solve(grid=grid, upper=steel, gap=np.full((5, 5), np.nan), approach=0.01)",
    "many problems": "Client(nobody).solve_many([1])",
    "steps of many": "Client(nobody).step_many([(1, {})])",
    "a session": "Client(nobody).session(grid=grid, uper=steel)",
    "a wheel": "Client(nobody).wheel_rail(WheelRailSetup(), 3)",
    "tables that are listed": "next(Client(nobody, connect_timeout=0.1).stored_ics())",
    "a client with a coroutine": "AsyncClient(nobody, outstanding=0)",
    "a coroutine": "asyncio.run(AsyncClient(nobody, connect_timeout=0.1).info())",
    "a refused coroutine": "asyncio.run(AsyncClient(nobody).solve(grid=3, upper=steel, gap=ball, approach=0.01))",
    "a local client": "local(config=3)",
    "a program that is not there": 'LocalDaemon("/nowhere/contactd")',
    "a daemon that refuses": 'LocalDaemon(os.environ["USER_BIN"] + "/contactd", config={"wrokers": 1})',
    "a problem": "ContactProblem(grid=grid, upper=steel, gap=ball)",
    "a changed problem": "ContactProblem(grid=grid, upper=steel, gap=ball, Fn=1).replace(grid=3)",
    "a material": "Material(E=-1, nu=0.3)",
    "layers": "LayeredBody([1], steel)",
    "closed forms": "AnalyticIcs(line_contact=3)",
    "a table": "TableIcs(np.zeros((2, 2, 2)), 1, 1)",
    "a text that is not there": 'TableIcs.from_contact_text("nowhere.txt")',
    "a file that is not there": 'load("nowhere.h5")',
    "a table that is not there": 'load_table("nowhere.npz")',
    "a dictionary": 'from_dict({"a": [{"type": "Wheel"}]})',
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_a_refusal_shows_the_line_of_the_user(tmp_path, call):
    files, line, _ = shown(tmp_path, call)
    assert len(ours(files)) <= 1
    if "asyncio" not in call and not ours(files):
        assert files == [str(tmp_path / "user.py")]
        assert line == call


def test_what_the_engine_refuses_shows_the_line_of_the_user(tmp_path):
    call = "client.solve(grid=Grid(5, 5, -0.1, 0.1), upper=steel, gap=ball, approach=0.01)"
    files, line, sentence = shown(tmp_path, f"with contactd.local(in_process=True) as client:\n    {call}")
    assert files == [str(tmp_path / "user.py")]
    assert line == call
    assert sentence.startswith("contactd.errors.InvalidArgument: grid.dx ")


SESSIONS = """
    with LocalDaemon(os.environ["USER_BIN"] + "/contactd", config={"workers": 1}) as daemon:
        with daemon.client() as client, client.session(grid=grid, upper=steel, gap=ball) as session:
            session.step(Fn=-1)
"""
AWAITED = """
    async def main(daemon):
        async with AsyncClient(daemon.endpoint) as client:
            async with await client.session(grid=grid, upper=steel, gap=ball) as session:
                await session.step(Fn=-1)
    with LocalDaemon(os.environ["USER_BIN"] + "/contactd", config={"workers": 1}) as daemon:
        asyncio.run(main(daemon))
"""


@pytest.mark.parametrize(("code", "line"), [(SESSIONS, "session.step(Fn=-1)"), (AWAITED, "await session.step(Fn=-1)")], ids=["waits", "awaits"])
def test_what_a_daemon_refuses_shows_the_line_of_the_user(tmp_path, code, line):
    files, last, sentence = shown(tmp_path, code)
    assert not ours(files)
    assert last == line
    assert sentence.startswith("contactd.errors.InvalidArgument: Fn ")


def test_a_callback_of_the_user_stays_in_the_traceback(tmp_path):
    code = """
    def broken(state):
        raise ValueError("mine")
    with contactd.local(in_process=True) as client:
        client.watch_health(broken)
    """
    files, line, sentence = shown(tmp_path, code)
    assert files == [str(tmp_path / "user.py")] * 2
    assert (line, sentence) == ('raise ValueError("mine")', "ValueError: mine")


def test_developers_see_everything(tmp_path):
    files, *_ = shown(tmp_path, CALLS["a wrong type"], CONTACTD_TRACEBACK="full")
    assert len(ours(files)) > 3


INSIDE = """
@public
def call(error, cause):
    try:
        raise KeyError("inner")
    except KeyError as inner:
        if cause:
            raise error from inner
        raise error
"""


@pytest.mark.parametrize("cause", [True, False])
@pytest.mark.parametrize("kind", [contactd.InternalError, AssertionError])
def test_defects_are_shown_whole_with_their_causes(kind, cause):
    error = kind("This should not be.")
    frames = traceback_of(error, cause)
    assert frames[-1] == "call"
    assert len(frames) > 2
    assert isinstance(error.__context__, KeyError)
    assert error.__suppress_context__ is cause


@pytest.mark.parametrize("cause", [True, False])
def test_a_cause_that_is_named_stays_and_what_was_handled_meanwhile_does_not(cause):
    error = contactd.DaemonFailed("It does not start.")
    assert traceback_of(error, cause) == ["traceback_of"]
    assert error.__suppress_context__
    assert (error.__cause__ is not None) is cause


def traceback_of(error, cause):
    """Returns the functions in the traceback of an exception of a function of the package."""
    module = {"__name__": "contactd.inside", "public": public}
    exec(INSIDE, module)
    with pytest.raises(type(error)) as caught:
        module["call"](error, cause)
    return [frame.name for frame in caught.traceback]
