"""Tests which tests ./dev test NAME... selects, builds and runs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import run_tests
from run_tests import Effort, Source, build_command, choose, cpp_command, cpp_tests, python_command, python_tests
from support.slowness import SLOWER

LISTED = """core/contact/test_rolling\tcore/contact/test_rolling.cpp\ttest_core
core/contact/test_rolling (slow)\tcore/contact/test_rolling.cpp\ttest_core
core/fem/test_shells\tcore/fem/test_shells.cpp\ttest_fem
client/cpp/check_links\tclient/cpp/check_links.cmake\tcontactd-cpp-example
"""
CRASH = """import ctypes, time, pytest
@pytest.mark.parametrize("k", range(300))
def test_one(k):
    time.sleep(0.02)
    if k == 37:
        ctypes.string_at(0)
"""
BEGUN = """import os, pytest
def begun(request):
    with open("begun", "a") as file:
        file.write(f"{request.node.originalname} {os.getpid()}\\n")
"""
ORDER = f"""{BEGUN}
@pytest.mark.parametrize("k", range(40))
def test_quick(k, request):
    begun(request)
@pytest.mark.slow  # for this test
def test_slow(request):
    begun(request)
"""
SHARED = f"""{BEGUN}
@pytest.fixture(scope="module")
def made():
    return 1
@pytest.mark.parametrize("k", range(10))
def test_shared(k, made, request):
    begun(request)
"""
ALL = cpp_tests(LISTED) + python_tests()


def paths(*names: str) -> set[str]:
    return {test.path for test in choose(ALL, names)}


def test_every_python_file_of_tests_is_known():
    assert {test.file for test in python_tests()} >= {Path(__file__), run_tests.TESTS / "integration" / "test_jobs.py"}


@pytest.mark.parametrize("name", ["integration/test_jobs", "tests/integration/test_jobs.py", "./tests/integration/test_jobs.py", "test_jobs"])
def test_a_file_is_named_as_it_is_typed_or_completed(name):
    assert paths(name) == {"integration/test_jobs"}


@pytest.mark.parametrize("name", ["core/contact", "tests/core/contact/"])
def test_a_folder_stands_for_what_is_in_it(name):
    assert paths(name) == {"core/contact/test_rolling"}


def test_a_word_chooses_of_both_languages():
    assert {"client/cpp/check_links", "client/python/test_arrays"} <= paths("client")
    assert paths("rolling", "test_jobs") == {"client/python/test_rolling_wheel", "core/contact/test_rolling", "integration/test_jobs"}


def test_a_word_that_no_path_has_chooses_by_the_names_of_tests():
    assert paths("a_word_that_no_path_has") == {"packaging/test_run_tests"}


def test_an_unknown_name_is_told_what_there_is():
    with pytest.raises(ValueError, match=r"'nonsuch' .*; there are tests in .*core/contact, .*integration"):
        choose(ALL, ["test_jobs", "non" + "such"])


def test_a_part_builds_what_it_needs():
    assert build_command(choose(ALL, ["core/contact"]), Effort.QUICK)[-2:] == ["--target", "test_core"]
    assert set(run_tests.PROGRAMS) < set(build_command(choose(ALL, ["test_jobs"]), Effort.QUICK))


def test_a_process_that_crashes_ends_the_run(tmp_path):
    tests = tmp_path / "test_crash.py"
    tests.write_text(CRASH)
    command = [*python_command(None, Effort.LONG, ["-p", "no:cacheprovider"])[:-1], str(tests)]
    ended = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=50 * SLOWER)
    assert ended.returncode != 0
    assert "test_one[37]" in ended.stdout + ended.stderr


def test_slow_tests_begin_first_and_a_file_that_shares_stays_together(tmp_path):
    (tmp_path / "test_order.py").write_text(ORDER)
    (tmp_path / "test_shared.py").write_text(SHARED)
    command = [sys.executable, "-m", "pytest", "-n", "2", "--dist", "loadgroup", "-p", "no:cacheprovider", "-p", "support.scheduling"]
    ended = subprocess.run(
        [*command, "-W", "ignore::pytest.PytestUnknownMarkWarning", tmp_path],
        cwd=tmp_path, env=os.environ | {"PYTHONPATH": str(run_tests.TESTS)}, capture_output=True, text=True, timeout=50 * SLOWER,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stdout + ended.stderr
    begun = [line.split() for line in (tmp_path / "begun").read_text().splitlines()]
    of_slow = next(process for name, process in begun if name == "test_slow")
    assert next(name for name, process in begun if process == of_slow) == "test_slow"  # whichever process starts first
    assert len({process for name, process in begun if name.startswith("test_shared")}) == 1


def test_what_no_test_needs_is_built_with_all():
    assert build_command(None, Effort.QUICK)[-1] == "development"
    assert build_command(None, Effort.ALL)[-4:] == ["all", "fuzz", "benchmarks", "random_problems"]


@pytest.mark.parametrize(("arguments", "fuzzes"), [(["--all"], True), (["--long"], True), ([], False), (["--all", "packaging"], False)])
def test_all_ends_with_fuzzing_of_messages_in_short_form(monkeypatch, tmp_path, arguments, fuzzes):
    called = []
    (tmp_path / "tests.txt").write_text(LISTED)
    monkeypatch.setattr(run_tests, "BUILD", tmp_path)
    monkeypatch.setattr(run_tests.Run, "part", lambda run, name, command, fine=(0,), build=None: called.append(name) or True)
    assert run_tests.main(arguments) == 0
    assert (called[-1] == "fuzzing") == fuzzes
    for target in run_tests.FUZZING[3:]:
        assert [ending for ending in ("cpp", "py") if (run_tests.TESTS / "fuzz" / f"{target}.{ending}").exists()]


def test_slow_and_long_tests_are_left_out_unless_they_are_wanted():
    assert cpp_command(None, Effort.QUICK)[-1] == "^(slow|long|fuzz)$"
    assert cpp_command(None, Effort.ALL)[-1] == "^(long)$"
    assert "--label-exclude" not in cpp_command(None, Effort.LONG)
    assert ["-m", "not slow and not long"] == python_command(None, Effort.QUICK, [])[3:5]
    assert ["-m", "not long"] == python_command(None, Effort.ALL, [])[5:7]
    assert "-m" not in python_command(None, Effort.LONG, [])[3:]
    rolling = choose(ALL, ["core/contact"])
    assert cpp_command(rolling, Effort.QUICK)[-1] == "^(core/contact/test_rolling)$"
    assert cpp_command(rolling, Effort.ALL)[-1] == r"^(core/contact/test_rolling)( \(slow\))?$"
    assert cpp_command(rolling, Effort.LONG)[-1] == r"^(core/contact/test_rolling)( \((slow|long)\))?$"


def test_one_file_runs_in_one_process_and_options_go_to_pytest():
    (file,) = choose(ALL, ["test_jobs"])
    command = python_command([file], Effort.ALL, ["-k", "cancel"])
    assert "-n" not in command
    assert command[-3:] == ["-k", "cancel", str(file.file)]


def test_names_of_tests_are_read_from_the_source(tmp_path):
    source = tmp_path / "test_x.cpp"
    source.write_text('TEST_CASE("a body is rigid", "[x]") {}\n')
    assert Source("x", source, "test_x").names == '"a body is rigid"'
