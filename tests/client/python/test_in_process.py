"""Tests contactd.local() with the engine in process: its answers, and the requirements on a library in a process."""

from __future__ import annotations

import gc  # noqa: F401 - for the programs below
import logging
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import contactd
from contactd import (
    Cancelled,
    ConnectionFailed,
    ContactProblem,
    DaemonFailed,
    DeadlineExceeded,
    Friction,
    Grid,
    InvalidArgument,
    MissingExtra,
    NotFound,
    Paraboloid,
    Rolling,
    Unavailable,
)
from contactd.local import InProcessClient
from support.daemons import BIN
from support.problems import CATTANEO, ENDLESS, GRID, QUICK, STEEL
from support.processes import in_fork
from support.slowness import SLOWER

ROLLING = ContactProblem(
    grid=Grid.centred(25, 25, 14, 14),
    upper=STEEL,
    gap=Paraboloid(Rx=460, Ry=300),
    Fn=50e3,
    friction=Friction(mu=0.3, rolling=Rolling(xi=1e-3)),
)
QUICKLY = ROLLING.replace(model="fastsim")


@pytest.fixture
def client():
    with contactd.local(in_process=True, config={"workers": 1}) as opened:
        yield opened


@pytest.fixture
def not_installed(monkeypatch):
    monkeypatch.setitem(sys.modules, "contactd_local", None)


def threads() -> int:
    """Counts the threads of this process, including those that are not Python's."""
    return len(os.listdir("/proc/self/task"))


# --- which of the two ------------------------------------------------------------------------------------------------


def test_where_the_extension_is_installed_no_daemon_is_started(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with contactd.local() as client:
        assert isinstance(client, InProcessClient)
        assert client.endpoint == "local"
        assert client.solve(QUICKLY).converged


@pytest.mark.usefixtures("not_installed")
def test_where_it_is_not_installed_a_private_daemon_is(monkeypatch):
    monkeypatch.setenv("PATH", str(BIN))
    with contactd.local() as client:
        assert client.endpoint.startswith("ipc://")
        assert client.solve(QUICKLY).converged
    with pytest.raises(MissingExtra, match="Solving in process needs contactd_local"), contactd.local(in_process=True):
        pass


def test_an_extension_that_cannot_be_loaded_is_no_reason_for_something_else(monkeypatch, tmp_path):
    (tmp_path / "contactd_local.py").write_text("import a_library_that_is_missing")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "contactd_local", raising=False)
    with pytest.raises(DaemonFailed, match=r"cannot be loaded: No module named 'a_library"), contactd.local():
        pass


@pytest.mark.parametrize("section", ["endpoint", "security", "methods", "log", "http", "shutdown"])
def test_what_only_a_daemon_has_takes_a_daemon(monkeypatch, section):
    monkeypatch.setenv("PATH", str(BIN))
    config = {section: "ipc:///nowhere/socket" if section == "endpoint" else {"no such": 1}}
    with pytest.raises(DaemonFailed, match="ended with status"), contactd.local(config=config):
        pass
    with pytest.raises(TypeError, match=f"config contains {section}"), contactd.local(config=config, in_process=True):
        pass


@pytest.mark.parametrize("options", [{"program": BIN / "contactd"}, {"in_process": True}], ids=["daemon", "in process"])
def test_it_is_a_client_that_is_closed_once_or_twice(options):
    client = contactd.local(**options)
    assert client.solve(QUICKLY).converged
    client.close()
    assert client.is_closed
    client.close()
    with pytest.raises(contactd.ContactdError):
        client.solve(QUICKLY)


def test_a_daemon_ends_with_the_client_that_has_it_and_not_with_its_copies():
    client = contactd.local(BIN / "contactd")
    with pickle.loads(pickle.dumps(client)) as copy:
        assert type(copy) is contactd.Client
        assert copy.solve(QUICKLY).converged
    assert client.solve(QUICKLY).converged
    folder = Path(client.endpoint.removeprefix("ipc://")).parent
    assert folder.exists()
    client.close()
    assert not folder.exists()


def test_a_program_that_is_named_is_started():
    with contactd.local(BIN / "contactd") as client:
        assert client.endpoint.startswith("ipc://")
    with pytest.raises(TypeError, match="program is 'contactd', a daemon"), contactd.local("contactd", in_process=True):
        pass


def test_a_configuration_that_cannot_be_used_is_refused_by_its_field():
    with pytest.raises(DaemonFailed, match=r"workers is 0"), contactd.local(config={"workers": 0}):
        pass
    with pytest.raises(DaemonFailed, match=r"wrokers"), contactd.local(config={"wrokers": 1}):
        pass


def test_a_configuration_that_is_none_is_refused():
    for in_process in (True, False):
        with pytest.raises(TypeError, match=r"config is \['workers'\]; it must be a mapping"), contactd.local(config=["workers"], in_process=in_process):
            pass


def test_a_folder_that_cannot_be_used_is_named(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(DaemonFailed, match="/file/store cannot be created or read"), contactd.local(in_process=True, folder=tmp_path / "file"):
        pass


# --- the same answers ------------------------------------------------------------------------------------------------


def test_it_says_what_it_is(client):
    assert repr(client).startswith("<Client of local:")
    info = client.info()
    assert info.version == contactd.__version__
    assert "ducc0" in info.libraries
    assert "zeromq" not in info.libraries
    assert client.health() == "serving"
    assert client.metrics()
    assert client.describe()["info"]


def test_tables_by_finite_elements_are_built_and_kept_in_the_folder(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", f"{BIN}:{os.environ['PATH']}")
    with contactd.local(in_process=True, folder=tmp_path) as client:
        first = client.get_ic(STEEL, GRID, QUICK)
        assert first.origin == "built"
    assert len(list((tmp_path / "store").glob("*.h5"))) == 1
    with contactd.local(in_process=True, folder=tmp_path) as client:
        again = client.get_ic(STEEL, GRID, QUICK)
        assert again.origin == "disk"
        assert np.array_equal(first.array, again.array)


def test_without_a_builder_only_tables_that_must_be_built_are_refused(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with contactd.local(in_process=True) as client:
        with pytest.raises(contactd.StatusError, match="contactd-ic"):
            client.get_ic(STEEL, GRID, QUICK)
        assert client.solve(CATTANEO).converged


def test_a_folder_of_its_own_goes_with_the_block(client):
    kept = Path(client._connections._temporary)
    assert kept.is_dir()
    client.close()
    assert not kept.exists()


def test_arrays_and_forces_are_there_to_the_last_bit_again(client):
    first, second = client.solve(ROLLING), client.solve(ROLLING)
    assert first.pressure.shape == (25, 25)
    assert np.array_equal(first.traction_x, second.traction_x)
    assert client.solve(ROLLING, fields=[]).Fx == first.Fx


def test_threads_that_spin_answer_the_same(client):
    with contactd.local(in_process=True, config={"spin_microseconds": 500}) as spinning:
        assert spinning.solve(ROLLING).Fx == client.solve(ROLLING).Fx
        with pytest.raises(DeadlineExceeded):
            spinning.solve(ENDLESS, timeout=0.05)


# --- several at once -------------------------------------------------------------------------------------------------


def test_several_engines_live_side_by_side():
    with contactd.local(in_process=True) as one, contactd.local(in_process=True) as other:
        session = one.session(ROLLING)
        with pytest.raises(NotFound):
            other.join_session(session.name)
        assert one.solve(ROLLING).Fx == other.solve(ROLLING).Fx
        one.close()
        assert other.solve(QUICKLY).converged


def test_many_threads_ask_at_once(client, background):
    expected = client.solve(ROLLING).Fx
    answers = [background(client.solve, problem) for problem in [ROLLING, QUICKLY] * 20]
    assert {answer.result().Fx for answer in answers[::2]} == {expected}
    assert len({answer.result().Fx for answer in answers[1::2]}) == 1


def test_steps_of_many_sessions_are_taken_together(client):
    sessions = [client.session(ROLLING) for _ in range(4)]
    steps = client.step_many([(session, {"Fn": 4e4 + 1e3 * i}) for i, session in enumerate(sessions)])
    assert [step.converged for step in steps] == [True] * 4
    assert len({step.Fx for step in steps}) == 4


def test_a_callback_hears_of_progress_and_may_ask(client):
    heard = []

    def on_progress(progress):
        heard.append(client.health())
        if len(heard) == 3:
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        client.solve(ENDLESS, on_progress=on_progress)
    assert heard == ["serving"] * 3
    assert client.solve(CATTANEO).converged  # by the only worker


# --- the end of a call -----------------------------------------------------------------------------------------------


def test_a_call_ends_at_its_timeout(client):
    with pytest.raises(DeadlineExceeded, match="within 100 ms"):
        client.solve(ENDLESS, timeout=0.1)
    assert client.solve(CATTANEO).converged


def test_a_job_that_is_cancelled_ends_its_call(client, background):
    answer = background(client.solve, ENDLESS)
    while not (jobs := client.jobs()):
        time.sleep(0.01)
    client.cancel_job(jobs[0].job)
    with pytest.raises(Cancelled):
        answer.result()


def test_ctrl_c_ends_the_solve(client):
    def interrupt():
        while not client.jobs():
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        client.solve(ENDLESS)
    thread.join()
    assert client.solve(CATTANEO).converged  # by the only worker
    assert client.jobs() == ()


def test_what_is_wrong_names_its_field(client):
    with pytest.raises(InvalidArgument) as refused:
        client.solve(ROLLING.replace(Fn=-1))
    assert refused.value.reason == "FIELD_INVALID"
    assert [violation.field for violation in refused.value.violations] == ["Fn"]


def test_closing_ends_the_calls_of_other_threads(client, background):
    answer = background(client.solve, ENDLESS)
    while not client.jobs():
        time.sleep(0.01)
    client.close()
    with pytest.raises(Unavailable):
        answer.result()
    with pytest.raises(ConnectionFailed, match="closed"):
        client.health()
    client.close()


def test_who_watches_hears_of_the_end(client, background):
    states = []
    last = background(client.watch_health, states.append)
    while not states:
        time.sleep(0.01)
    client.close()
    assert last.result() == "stopping"
    assert states == ["serving", "stopping"]


# --- processes -------------------------------------------------------------------------------------------------------


def answer_in_fork(client):
    try:
        return client.health()
    except ConnectionFailed as error:
        return str(error)


@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_a_forked_process_is_told_to_open_its_own(client):
    session = client.session(ROLLING)
    assert client.solve(ROLLING).converged  # by a thread that does not exist in the child
    told = in_fork(lambda: answer_in_fork(client))
    assert told == (
        f"This client solves in process {os.getpid()}, from which this one was forked; open another here: contactd.local()."
    )
    assert session.step(Fn=4e4).converged


@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_a_callback_that_forks_returns_in_both(client):
    told = []

    def on_progress(_):
        if not told:
            told.append(in_fork(lambda: answer_in_fork(client)))
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        client.solve(ENDLESS, on_progress=on_progress)
    assert "from which this one was forked" in told[0]
    assert client.solve(CATTANEO).converged


def solved_in_its_own():
    with contactd.local(in_process=True) as client:
        return client.solve(ROLLING).Fx


@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_a_forked_process_solves_with_its_own(client):
    assert in_fork(solved_in_its_own) == client.solve(ROLLING).Fx


@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_a_forked_process_leaves_the_folder_of_its_parent(client):
    in_fork(client.close)
    assert Path(client._connections._temporary).is_dir()
    assert client.health() == "serving"


def test_it_cannot_be_pickled(client):
    with pytest.raises(TypeError, match="solves in process cannot be pickled"):
        pickle.dumps(client)


def run(program: str, **options) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", f"import contactd\nfrom test_in_process import *\n{program}"],
        env={**environment, "PYTHONPATH": f"{Path(__file__).parent}:{environment['PYTHONPATH']}"},
        capture_output=True, text=True, timeout=50 * SLOWER, **options,
    )  # fmt: skip


@pytest.mark.parametrize(
    "program",
    [
        # a client that is never closed, with a session and its threads
        "client = contactd.local(in_process=True)\n"
        "session = client.session(ROLLING); session.step(Fn=4e4)",
        # a thread that still waits
        "client = contactd.local(in_process=True)\n"
        "threading.Thread(target=lambda: client.solve(ENDLESS), daemon=True).start()\n"
        "while not client.jobs(): time.sleep(0.01)",
        # the end within the block
        "with contactd.local(in_process=True) as client:\n    client.solve(ROLLING)\n    sys.exit()",
    ],
    ids=["session", "thread", "exit"],
)
def test_the_interpreter_ends_whatever_is_open(program, tmp_path):
    ended = run(program, cwd=tmp_path)
    assert (ended.returncode, ended.stdout) == (0, ""), ended.stderr
    assert "Fatal" not in ended.stderr


def test_the_interpreter_ends_while_threads_ask(tmp_path):
    """About one in ten returns from a call after the interpreter has ended, so it ends a dozen times."""
    program = """
client = contactd.local(in_process=True)
def ask():
    while True:
        client.health()
for _ in range(4):
    threading.Thread(target=ask, daemon=True).start()
time.sleep(0.05)
"""
    for _ in range(12):
        ended = run(program, cwd=tmp_path)
        assert (ended.returncode, ended.stdout) == (0, ""), ended.stderr



def test_a_program_that_is_interrupted_ends(tmp_path):
    ended = run(
        "threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        "with contactd.local(in_process=True) as client:\n    client.solve(ENDLESS)",
        cwd=tmp_path,
    )
    assert ended.returncode == -signal.SIGINT, ended.stderr
    assert ended.stderr.rstrip().endswith("KeyboardInterrupt")


# --- beside the answers ----------------------------------------------------------------------------------------------


def test_threads_start_when_they_are_wanted_and_end_with_who_holds_them(tmp_path):
    ended = run(
        "client = contactd.local(in_process=True)\n"
        "opened = threads()\n"
        "client.solve(QUICKLY)\n"
        "quick = threads()\n"
        "client.solve(ROLLING)\n"
        "full = threads()\n"
        "del client\n"
        "gc.collect()\n"
        "print(quick - opened, full - quick, threads())",
        cwd=tmp_path,
    )
    assert (ended.stdout, ended.returncode) == ("0 1 1\n", 0), ended.stderr


def test_the_log_goes_to_a_logger(caplog, monkeypatch):
    monkeypatch.setenv("PATH", "")
    with caplog.at_level(logging.INFO, "contactd.local"), contactd.local(in_process=True):
        pass
    assert [(record.levelname, record.name) for record in caplog.records] == [("WARNING", "contactd.local")]
    assert "contactd-ic" in caplog.text
