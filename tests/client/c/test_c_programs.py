"""Tests programs in C: the one on the page is compiled unchanged, and no memory is lost."""

from __future__ import annotations

import re

import pytest

from support.c_programs import LIBRARY, ROOT, STRICT, needs, octave, run
from support.daemons import BIN


def test_the_program_on_the_page_rolls(shared_daemon, tmp_path):
    program, *_ = re.findall(r"^```c\n(.*?)^```", (ROOT / "docs" / "c.md").read_text(), re.MULTILINE | re.DOTALL)
    source = tmp_path / "first.c"
    source.write_text(program)
    include = ROOT / "client" / "c" / "include"
    made = run("cc", *STRICT, f"-I{include}", source, f"-L{LIBRARY}", "-lcontactd", "-o", tmp_path / "first")
    assert made.returncode == 0, made.stderr

    ended = run(tmp_path / "first", shared_daemon.endpoint)

    assert ended.returncode == 0, ended.stderr
    forces = [float(force) for force in re.findall(r"Fx (-\d+\.\d) N", ended.stdout)]
    assert len(forces) == 3
    assert 0 > forces[0] > forces[1] > forces[2] >= -0.3 * 50e3


def test_the_example_says_that_nobody_listens(tmp_path):
    ended = run(BIN / "contactd-c-example", f"ipc://{tmp_path}/nobody")
    assert ended.returncode == 1
    assert ended.stderr.startswith("UNAVAILABLE: No daemon is listening at ")


def numbers(text: str) -> list[float]:
    """Returns numbers of the steps that an example prints."""
    return [float(number) for number in re.findall(r"(?<=F[nx]) +(-?\d\S+)(?= N)", text)]


@needs("gfortran")
def test_the_example_in_fortran_is_that_in_c(shared_daemon):
    ended = run(BIN / "contactd-fortran-example", shared_daemon.endpoint)
    assert ended.returncode == 0, ended.stderr
    expected = numbers(run(BIN / "contactd-c-example", shared_daemon.endpoint).stdout)
    assert len(expected) == 4
    assert numbers(ended.stdout) == pytest.approx(expected, rel=1e-7)  # limited by the printed digits


@needs("gfortran")
def test_the_example_in_fortran_tells_what_went_wrong(tmp_path):
    ended = run(BIN / "contactd-fortran-example", "nowhere")
    assert ended.returncode == 1
    assert ended.stdout.startswith('INVALID_ARGUMENT: where is "nowhere"; it must be')


def test_the_module_in_fortran_has_every_function_and_enumerator_of_the_header():
    header = (ROOT / "client" / "c" / "include" / "contactd.h").read_text()
    sources = [path.read_text() for path in (ROOT / "client" / "c" / "fortran").glob("contactd*.f90")]
    fortran = re.sub(r"!.*", "", "\n".join(sources)).lower()

    functions = {name.lower() for name in re.findall(r"CONTACTD_API [^(]*?(contactd_\w+)\(", header)}
    assert len(functions) > 40
    assert functions - set(re.findall(r"function (contactd_\w+)\(", fortran)) == set()
    enumerators = {name.lower(): value for name, value in re.findall(r"\b(CONTACTD_\w+) = (\d+)", header)}
    assert enumerators == dict(re.findall(r"\b(contactd_\w+) = (\d+)", fortran))


@needs("octave-cli")
@pytest.mark.timeout(120)
def test_the_example_in_octave_is_that_in_c(shared_daemon):
    ended = octave(f"cattaneo('{shared_daemon.endpoint}');")
    assert ended.returncode == 0, ended.stderr
    expected = numbers(run(BIN / "contactd-c-example", shared_daemon.endpoint).stdout)
    assert len(expected) == 4
    assert numbers(ended.stdout) == expected


@needs("octave-cli")
@pytest.mark.timeout(120)
@pytest.mark.parametrize(
    ("call", "error", "sentence"),
    [
        ("contactd('open', 'nowhere')", "contactd:INVALID_ARGUMENT", "where is \"nowhere\"; it must be"),
        ("contactd('step', uint64(7))", "contactd:INVALID_ARGUMENT", "contact is not a valid handle"),
        ("contactd('step', 7)", "contactd:arguments", "Argument 2 must be a handle that 'open' or 'new' returned."),
        ("contactd('step')", "contactd:arguments", "Argument 2 is missing."),
        ("contactd()", "contactd:arguments", "must be the name of a function"),
        ("contactd('jump', uint64(7))", "contactd:arguments", "There is no function 'jump'."),
        ("contactd('set', uint64(7))", "contactd:arguments", "Argument 3 is missing."),
        ("contactd('set', uint64(7), 'Fn', 'quick')", "contactd:arguments", "Argument 4 must be a number."),
        ("contactd('restore', uint64(7), 0.5)", "contactd:arguments", "Argument 3 must be a whole number."),
        ("contactd('set_array', uint64(7), 'gap.array', 'a')", "contactd:arguments", "Argument 4 must be an array of doubles."),
        ("contactd('get_array', uint64(7), 'pressure', -1, 3)", "contactd:INVALID_ARGUMENT", "is not a valid handle"),
    ],
)
def test_octave_tells_what_went_wrong(call, error, sentence):
    ended = octave(f"try, {call}; catch problem, disp(problem.identifier), disp(problem.message), end")
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.splitlines()[0] == error
    assert sentence in ended.stdout


def test_octave_has_every_function_of_the_header():
    header = (ROOT / "client" / "c" / "include" / "contactd.h").read_text()
    source = "".join(path.read_text() for path in (ROOT / "client" / "c" / "matlab").glob("contactd_mex*.[ch]"))
    functions = set(re.findall(r"CONTACTD_API [^(]*?contactd_(\w+)\((?:contactd_(?!any_)|const char)", header))
    called = set(re.findall(r"CALL\((\w+),", source)) | set(re.findall(r"contactd_(\w+)\(c?", source))
    assert len(functions) > 35
    assert functions - called == set()


def test_in_process_the_example_prints_what_it_prints_with_a_daemon(shared_daemon):
    expected = run(BIN / "contactd-c-example", shared_daemon.endpoint).stdout
    for place in ("local", shared_daemon.endpoint):
        ended = run(BIN / "contactd-c-local-example", place)
        assert ended.returncode == 0, ended.stderr
        assert ended.stdout == expected
    ended = run(BIN / "contactd-c-example", "local")
    assert ended.returncode == 1
    assert "link libcontactd-local" in ended.stderr


@needs("valgrind")
@pytest.mark.timeout(120)
@pytest.mark.parametrize("place", ["daemon", "local"])
def test_the_example_reads_and_leaves_no_memory_that_is_not_its_own(shared_daemon, place):
    program, where = {
        "daemon": ("contactd-c-example", shared_daemon.endpoint),
        "local": ("contactd-c-local-example", "local"),
    }[place]
    ended = run(
        "valgrind", "--quiet", "--leak-check=full", "--errors-for-leak-kinds=definite,possible", "--error-exitcode=9",
        BIN / program, where,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    assert "step 2" in ended.stdout
