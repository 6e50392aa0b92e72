"""Tests every exit code, each with a message on standard error and nothing on standard output."""

import json
import os
import shlex
import signal
import subprocess

import pytest

from contactd import Client
from support.daemons import eventually
from support.fake_server import FakeServer


def refused(ended, code, *words):
    """What scripts rely on."""
    assert ended.code == code, ended.err
    assert ended.out == ""
    for word in words:
        assert word in ended.err
    return True


def test_done_is_0(ctl):
    assert ctl("health").code == 0


@pytest.mark.parametrize("package", ["click", "typer"])
def test_without_a_package_of_its_extra_it_says_what_to_install(ctl, tmp_path, package):
    (tmp_path / f"{package}.py").write_text(f"raise ModuleNotFoundError(name={package!r})")
    environment = {**ctl.environment, "PYTHONPATH": os.pathsep.join([str(tmp_path), ctl.environment["PYTHONPATH"]])}
    ended = subprocess.run([*ctl.command, "--version"], env=environment, capture_output=True, text=True, check=False)
    assert (ended.returncode, ended.stdout) == (2, "")
    assert ended.stderr == f'contactctl: The command line needs {package}: pip install "contactd[cli]", or on Debian contactctl.\n'


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["bogus"], "No such command 'bogus'"),
        (["solv", "contact.yaml"], "No such command 'solv'. Did you mean solve?"),
        (["profile", "shwo", "a.prr"], "No such command 'shwo'. Did you mean show?"),
        (["solve", "contact.yaml", "--timeuot", "3"], "Did you mean --timeout?"),
        (["solve", "contact.yaml", "--fields", "presure"], "Did you mean pressure?"),
        (["compare", "contact.yaml", "--models", "fastism"], "Did you mean fastsim?"),
        (["ic"], "Missing command"),
        (["solve"], "Missing argument 'FILE'"),
        (["solve", "nowhere.yaml"], "nowhere.yaml cannot be read: No such file or directory"),
        (["solve", "contact.yaml", "-o", "a.doc"], "must end in .json, .h5, .png, .svg or .pdf"),
        (["solve", "contact.yaml", "-o", "nowhere/a.h5"], "there is no folder nowhere"),
        (["solve", "contact.yaml", "--fields", "pressures"], "'pressures' is not one of"),
        (["solve", "contact.yaml", "--set", "mu"], "must be PATH=VALUE"),
        (["solve", "contact.yaml", "--set", "a b=1"], "'a b' is not the path of a field"),
        (["solve", "contact.yaml", "--set", "approach.x=1"], "approach.x cannot be set"),
        (["solve", "contact.yaml", "--timeout", "0"], "0 is not in the range"),
        (["solve", "contact.yaml", "--folder", "tables"], "--folder requires --local"),
        (["ic", "build"], "Give a table"),
        (["ic", "build", "--E", "2e5"], "--E requires --nu"),
        (["ic", "export", "quick.json", "-o", "table.csv"], "must end in .h5, .npz or .txt"),
        (["ic", "import", "quick.json", "--store", "."], "is not a file of a store"),
        (["ic", "import", "missing.h5"], "cannot be read"),
        (["ic", "show", "nowhere.h5"], "nowhere.h5 cannot be read"),
        (["solve", "."], ". cannot be read: Is a directory"),
        (["solve", "contact.yaml", "-o", "folder.h5"], "folder.h5 is a folder"),
        (["study", "study.yaml", "--csv", "nowhere/a.csv"], "--csv nowhere/a.csv: there is no folder nowhere"),
        (["study", "study.yaml", "--rows", "folder.h5"], "folder.h5: Is a directory"),
        (["ic", "build", "wrong.json"], "material is 5; it must be an object"),
        (["ic", "build", "--E", "2e5", "--nu", "-1", "--nx", "3", "--dx", "1"], "--nu above -1"),
        (["ic", "delete", ""], "A key is empty"),
        (["keys", "new", "alice", "--to", "contact.yaml"], "contact.yaml: File exists"),
        (["session", "wide.yaml"], "wide.csv is not a CSV file: line 2 has a cell of"),
        (["cancel"], "Name the jobs to cancel, or give --all"),
        (["keys", "show", "contact.yaml"], "it is not a key file"),
        (["keys", "new", "../bob"], "cannot be the name of a file"),
        (["session", "contact.yaml"], "a history has open and steps"),
        (["study", "contact.yaml"], "a study has answers"),
        (["completion", "tcsh"], "'tcsh' is not one of"),
    ],
)
def test_what_cannot_be_used_is_2(ctl, words, sentence):
    (ctl.folder / "folder.h5").mkdir()
    ctl.write("study.yaml", "problem: contact.yaml\nvary: {friction.mu: [0.1]}\n")
    ctl.write("wrong.json", {"material": 5})
    ctl.write("wide.yaml", "open: {}\nsteps: wide.csv\n")
    ctl.write("wide.csv", "Fn\n" + 200_000 * "1")
    assert refused(ctl(*words), 2, sentence)


@pytest.mark.parametrize("levels", [60, 600, 60_000])
def test_what_is_nested_too_deeply_is_2(ctl, levels):
    for name in ("deep.json", "deep.yaml"):
        ctl.write(name, '{"approach": ' + levels * "[" + levels * "]" + "}")
        assert refused(ctl("solve", name), 2, "is nested too deeply")


@pytest.mark.parametrize(("forbidden", "name"), [("folder", "folder/new.json"), ("folder/old.json", "folder/old.json")])
def test_what_must_not_be_written_is_2_before_anything_is_solved(lonely, monkeypatch, forbidden, name):
    (lonely.folder / "folder").mkdir()
    lonely.write("folder/old.json", "{}")
    lonely.write("study.yaml", "problem: contact.yaml\nvary: {friction.mu: [0.1]}\n")
    (lonely.folder / forbidden).chmod(0o555)
    # It also fails for root, who has all permissions.
    monkeypatch.setattr(os, "access", lambda path, mode: mode != os.W_OK or bool(os.stat(path).st_mode & 0o200))
    assert refused(lonely("solve", "contact.yaml", "-o", name), 2, f"--output {name} cannot be written: permission is denied")
    assert refused(lonely("study", "study.yaml", "--csv", name), 2, f"--csv {name} cannot be written")
    (lonely.folder / forbidden).chmod(0o755)


def test_no_daemon_is_3(lonely):
    assert refused(lonely("info"), 3, "No daemon answers at ipc://", "contactctl --local")
    assert refused(lonely("info", "-e", "nonsense"), 3, "is not a valid endpoint")


def test_another_service_is_3(lonely):
    with FakeServer(lonely.folder, lambda request: [[b"hello"]]) as server:
        assert refused(lonely("health", "-e", server.endpoint), 3, "is not JSON")


def test_a_daemon_that_ends_is_3(lonely):
    with FakeServer(lonely.folder, lambda request: [request.failure(14, "The daemon is ending.", reason="STOPPING")]) as server:
        assert refused(lonely("solve", "contact.yaml", "-e", server.endpoint), 3, "The daemon is ending. (UNAVAILABLE, STOPPING)")


def test_what_the_daemon_refuses_is_4_and_names_the_field(ctl):
    assert refused(ctl("solve", "contact.yaml", "--set", "bodies.upper.nu=0.7"), 4, "bodies.upper.nu", "FIELD_INVALID")
    assert refused(ctl("solve", "contact.yaml", "--set", "grid.nx=-1", "--set", "approach=[]", "--json"), 4, "grid.nx:", "approach:")
    assert refused(ctl("ic", "show", "abc"), 4, "No table and no failed build")
    assert ctl("ic", "delete", "abc").code == 4
    assert ctl("cancel", "build-99").code == 4


def test_numbers_that_are_not_finite_name_their_field(ctl):
    ctl.write("nan.yaml", (ctl.folder / "contact.yaml").read_text().replace("2e-2", ".nan"))
    assert refused(ctl("solve", "nan.yaml"), 4, "approach is nan; it must be finite")
    ctl.write("nan.json", '{"approach": NaN}')
    assert refused(ctl("solve", "nan.json"), 2, "NaN is not a valid number")


def test_no_convergence_is_5_with_the_answer(ctl):
    ended = ctl("solve", "contact.yaml", "--set", "settings.tangential={\"max_iterations\": 1}", "--json")
    assert ended.code == 5
    assert ended.json["converged"] is False
    assert "missed its tolerance" in ended.err


def test_a_step_that_did_not_converge_is_5_with_the_steps_before(ctl):
    step = {"Fn": 10, "friction": {"rigid_shift": [0.008, 0]}}
    opening = {"grid": {"nx": 20, "ny": 20, "dx": 0.12, "dy": 0.12}, "bodies": {"upper": {"G": 200, "nu": 0.42}},
               "gap": {"paraboloid": {"Rx": 50, "Ry": 50}}, "ics": {"source": "analytic"}, "friction": {"mu": 0.4, "rigid_shift": [0, 0]},
               "settings": {"tangential": {"max_iterations": 1}}}  # fmt: skip
    still = {"Fn": 10, "friction": {"rigid_shift": [0, 0]}}
    ctl.write("history.json", {"open": opening, "steps": [still, step]})
    ended = ctl("session", "history.json", "--json")
    assert ended.code == 5
    assert [found["step"] for found in ended.json["steps"]] == [1]
    assert ctl("session", "history.json", "--accept-unconverged").code == 0
    with Client(ctl.endpoint) as client:
        assert not client.sessions()


def test_a_timeout_is_7_and_says_what_becomes_of_the_build(own):
    assert refused(own("solve", "endless.json", "--timeout", "0.5"), 7)
    ended = own("ic", "build", "long.json", "--timeout", "3")
    assert refused(ended, 7, "contactctl cancel build-")
    assert own("jobs", "--json").json["jobs"], "it goes on"
    assert own("cancel", "--all").code == 0


def test_a_build_that_fails_is_8(daemons, own):
    small = daemons.start("small", builds={"max_memory_bytes": 1_000_000})
    assert refused(own("ic", "build", "long.json", "-e", small.endpoint), 8, "BUILD_OUT_OF_MEMORY")


@pytest.mark.parametrize(("sent", "code"), [(signal.SIGHUP, 129), (signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_who_interrupts_a_build_ends_it(own, sent, code):
    with own.start("ic", "build", "long.json") as building, Client(own.endpoint) as client:
        eventually(client.jobs)
        building.send_signal(sent)
        out, err = building.communicate(timeout=30)
        assert (building.returncode, out) == (code, "")
        assert "is cancelled." in err
        assert "Traceback" not in err
        eventually(lambda: not client.jobs())
        assert client.info().counters["builds_finished"] == 0


def test_who_interrupts_leaves_the_build_of_another(own):
    with own.start("ic", "build", "long.json") as first, Client(own.endpoint) as client:
        eventually(client.jobs)
        with own.start("ic", "build", "long.json") as second:
            eventually(lambda: client.jobs()[0].callers == 2)
            second.send_signal(signal.SIGINT)
            assert "is cancelled" not in second.communicate(timeout=30)[1]
        assert client.jobs()[0].callers == 1
        first.send_signal(signal.SIGINT)
        first.communicate(timeout=30)
        eventually(lambda: not client.jobs())


def test_who_interrupts_a_solve_ends_it(own):
    with own.start("solve", "endless.json", "--json") as solving, Client(own.endpoint) as client:
        eventually(client.jobs)
        solving.send_signal(signal.SIGINT)
        assert solving.communicate(timeout=30) == ("", "")
        assert solving.returncode == 130
        eventually(lambda: not client.jobs())


def test_who_interrupts_a_history_closes_its_session(own):
    endless = {"rolling": {"kind": "transient", "xi": 1e-3, "steps": 100_000}}
    opening = {"grid": {"nx": 160, "ny": 160, "dx": 0.015, "dy": 0.015}, "bodies": {"upper": {"G": 200, "nu": 0.42}},
               "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 50, "Ry": 50}}, "friction": {"mu": 0.4, "rolling": {}}}  # fmt: skip
    own.write("history.json", {"open": opening, "steps": [{"approach": 0.02}, {"approach": 0.02, "friction": endless}]})
    with own.start("session", "history.json", "--json") as replaying, Client(own.endpoint) as client:
        eventually(lambda: any(session.step == 1 and session.idle_seconds == 0 for session in client.sessions()))
        replaying.send_signal(signal.SIGINT)
        out, _ = replaying.communicate(timeout=30)
        assert replaying.returncode == 130
        assert [step["step"] for step in json.loads(out)["steps"]] == [1], "what was solved is told"
        eventually(lambda: not client.sessions())


def test_a_disk_that_is_full_is_1(ctl):
    with open("/dev/full", "w") as full:
        ended = ctl.start("info", stdout=full)
        _, err = ended.communicate(timeout=30)
    assert (ended.returncode, err) == (1, "contactctl: No space left on device.\n")


@pytest.mark.parametrize("words", [["--help"], ["--version"], ["ic", "--help"], ["completion", "bash"], ["health"]])
def test_help_that_cannot_be_written_is_an_end_in_order(ctl, words):
    for stdout, code, said in (("/dev/full", 1, "contactctl: No space left on device.\n"), (None, 141, "")):
        with open(stdout, "w") if stdout else _unread_pipe() as out, ctl.start(*words, stdout=out) as ended:
            assert ended.communicate(timeout=30)[1] == said
        assert ended.returncode == code


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_a_reader_that_has_enough_ends_the_command(ctl, unbuffered):
    ctl.environment["PYTHONUNBUFFERED"] = unbuffered
    large = ("--set", "grid.nx=200", "--set", "grid.ny=200", "--json", "--fields", "all")
    with ctl.start("solve", "contact.yaml", *large) as ended:
        assert ended.stdout.read(1) == "{"
        ended.stdout.close()
        assert ended.stderr.read() == ""
    assert ended.returncode == 141


def _unread_pipe():
    reading, writing = os.pipe()
    os.close(reading)
    return os.fdopen(writing, "w")


@pytest.mark.parametrize("closed", ["0<&-", "1>&-", "2>&-", "0<&- 1>&- 2>&-"])
def test_streams_that_are_closed_are_missed_by_nobody(ctl, closed):
    command = shlex.join([*ctl.command, "health"])
    ended = subprocess.run(["bash", "-c", f"{command} {closed}"], env=ctl.environment, capture_output=True, text=True, timeout=30)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert ended.stdout == ("" if "1>" in closed else "serving\n")


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_command_in_a_program_leaves_its_signals_as_they_were(ctl, number):
    before = signal.getsignal(number)
    assert ctl("info").code == 0
    assert signal.getsignal(number) is before
