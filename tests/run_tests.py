"""Builds and runs C++ tests by ctest and Python tests by pytest: ./dev test [--all | --long] [NAME...] [-- OPTIONS].

  NAME      runs the files with NAME in their path below tests/: integration/test_jobs, core/contact, client/python, rolling;
            if there are none, the files with NAME in the name of a test
  --all     also runs slow tests. Without a NAME, it also builds everything that no test needs, fuzz targets, benchmarks and
            random problems, and fuzzes readers of messages under sanitizers
  --long    also runs long tests, and tests core and daemon again with FFTW's transforms. Without a NAME, ./dev then runs
            each command of tests/documented_commands.txt, so that a release is tested with all of them
  OPTIONS   are passed to pytest
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import IntEnum
from pathlib import Path

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parent
BUILD = ROOT / "build" / "development"
FFTW = ROOT / "build" / "fftw"
#: Programs that the Python tests run.
PROGRAMS = ("contactd", "contactd-ic", "contactd_local", "contactd_cntc", "contactd-cpp-example", "contactd-c-examples", "contactd-fmus", "congruence-drivers")
#: Fuzz targets: readers of untrusted bytes, under AddressSanitizer and UBSan, and commands that read untrusted files,
#ten seconds each.
FUZZING = ["./dev", "fuzz", "10", "request", "session", "reply", "array", "commands"]
#: Tests of a build with FFTW's transforms in addition to core: the daemon, contacts and wheels on rails.
WITH_FFTW = ("test_check_config", "test_solve", "test_sessions", "test_wheel_rail", "test_conformal")
#: No test needs them.
EXTRAS = ("fuzz", "benchmarks", "random_problems")
PROCESSORS = len(os.sched_getaffinity(0))
#: Memory that a process of Python tests, its daemons and their builders may need at a time.
BYTES_OF_A_WORKER = 2 << 30
NO_TEST_LEFT = 5


@dataclass(frozen=True)
class Source:
    """Describes a file with tests, by its path below tests/ without the extension."""

    path: str
    file: Path
    target: str | None  # target of a C++ program; empty for a Python file

    @property
    def names(self) -> str:
        """Returns the tests in the file, one per line."""
        pattern = r"^ *def (test_\w+)" if self.target is None else r'^TEST_CASE\((".*?")'
        return "\n".join(re.findall(pattern, self.file.read_text(), re.MULTILINE))


def python_tests() -> list[Source]:
    files = sorted(TESTS.rglob("test_*.py"))
    return [Source(str(file.relative_to(TESTS).with_suffix("")), file, None) for file in files]


def cpp_tests(listed: str) -> list[Source]:
    """`listed` contains the lines written by CMake: test, source and target."""
    found = {line.split("\t")[1]: line.split("\t")[2] for line in listed.splitlines()}
    return [Source(str(Path(source).with_suffix("")), TESTS / source, target) for source, target in found.items()]


def choose(tests: Sequence[Source], names: Iterable[str]) -> list[Source]:
    """Returns the files that the names select. Raises ValueError, listing valid names, for an unknown name."""
    chosen: set[Source] = set()
    for name in names:
        part = re.sub(r"\.(py|cpp|cmake)$", "", name.removeprefix("./").removeprefix("tests/")).rstrip("/").lower()
        found = {test for test in tests if part in test.path} or {test for test in tests if part in test.names.lower()}
        if not found:
            folders = ", ".join(sorted({test.path.rpartition("/")[0] for test in tests} - {""}))
            raise ValueError(f"no test has '{name}' in its path or its name; there are tests in {folders}")
        chosen |= found
    return [test for test in tests if test in chosen]


def workers() -> int:
    """Returns the number of parallel processes for Python tests: one more than processors, because they often wait,
    limited by the memory."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return max(1, min(PROCESSORS + 1, memory // BYTES_OF_A_WORKER))


class Effort(IntEnum):
    """Selects tests: fast ones; slow ones, too, as in CI; or long ones, as before a release."""

    QUICK = 0
    ALL = 1
    LONG = 2

    @property
    def left_out(self) -> list[str]:
        """Returns labels of ctest or marks of pytest."""
        return ["slow", "long"][self :]


def build_command(chosen: Sequence[Source] | None, effort: Effort) -> list[str]:
    command = ["cmake", "--build", "--preset", "development"]
    if jobs := os.environ.get("CONTACTD_JOBS"):
        command += ["-j", jobs]
    if chosen is not None:
        targets = {test.target for test in chosen if test.target}
        if any(test.target is None for test in chosen):
            targets |= set(PROGRAMS)
        return [*command, "--target", *sorted(targets)]
    return [*command, "--target", "all", *EXTRAS] if effort else command


def cpp_command(chosen: Sequence[Source] | None, effort: Effort) -> list[str]:
    command = ["ctest", "--preset", "development", "-j", str(PROCESSORS)]
    if chosen is None:
        labels = [*effort.left_out, *([] if effort else ["fuzz"])]
        return [*command, "--label-exclude", f"^({'|'.join(labels)})$"] if labels else command
    paths = "|".join(re.escape(test.path) for test in chosen if test.target)
    suffix = ["", r"( \(slow\))?", r"( \((slow|long)\))?"][effort]
    return [*command, "--no-tests=ignore", "--tests-regex", f"^({paths}){suffix}$"]


def python_command(chosen: Sequence[Source] | None, effort: Effort, options: Sequence[str]) -> list[str]:
    files = [str(TESTS)] if chosen is None else [str(test.file) for test in chosen if test.target is None]
    # Times are shown when all tests run.
    command = [sys.executable, "-m", "pytest", *(["--durations", "25"] if effort else [])]
    if effort.left_out:
        command += ["-m", " and ".join(f"not {mark}" for mark in effort.left_out)]
    if (processes := workers() if chosen is None else min(workers(), len(files))) > 1:
        # A crashed process ends the run; pytest-xdist would otherwise start another one, and then wait forever.
        command += ["-n", str(processes), "--dist", "loadgroup", "--max-worker-restart", "0"]
    return [*command, *options, *files]


class Run:
    """Runs the parts, and records their times and failures."""

    def __init__(self) -> None:
        self.took: list[str] = []
        self.failed: list[str] = []

    def part(self, name: str, command: Sequence[str], fine: Iterable[int] = (0,), build: Path = BUILD) -> bool:
        print(f"\033[1m==>\033[0m {name}", file=sys.stderr, flush=True)
        start = time.monotonic()
        status = subprocess.run(command, cwd=ROOT, env={**os.environ, "CONTACTD_BIN": str(build / "bin")}).returncode
        self.took.append(f"{name} {time.monotonic() - start:.0f} s")
        if status not in fine:
            self.failed.append(name)
        return status in fine


def run_with_fftw(run: Run) -> None:
    """Runs the tests of core and daemon with the programs that have FFTW's transforms."""
    files = [str(TESTS / "integration" / f"{name}.py") for name in WITH_FFTW]
    run.part("C++ tests with FFTW", ["ctest", "--preset", "fftw", "-j", str(PROCESSORS), "-R", "^(core|engine|verification|server)/", "-LE", "^(slow|long|fuzz)$"])
    run.part("Python tests with FFTW", [sys.executable, "-m", "pytest", "-m", "not slow and not long", *files], build=FFTW)


def main(arguments: Sequence[str]) -> int:
    own, options = list(arguments), []
    if "--" in own:
        own, options = own[: own.index("--")], own[own.index("--") + 1 :]
    effort = Effort.LONG if "--long" in own else Effort.ALL if "--all" in own else Effort.QUICK
    names = [word for word in own if word not in ("--all", "--long")]
    if any(name.startswith("-") for name in names):
        print(__doc__)
        return 0 if {"-h", "--help"} & set(names) else 2
    tests = cpp_tests((BUILD / "tests.txt").read_text()) + python_tests()
    try:
        chosen = choose(tests, names) if names else None
    except ValueError as error:
        print(f"dev: {error}", file=sys.stderr)
        return 2
    run = Run()
    # Long tests compare the answers of both builds.
    with_fftw = chosen is None and effort is Effort.LONG and run.part("build with FFTW", ["./dev", "build", "fftw"])
    if run.part("build", build_command(chosen, effort)):
        if chosen is None or any(test.target for test in chosen):
            run.part("C++ tests", cpp_command(chosen, effort))
        if chosen is None or any(test.target is None for test in chosen):
            fine = (0,) if chosen is None else (0, NO_TEST_LEFT)  # all named tests are excluded
            run.part("Python tests", python_command(chosen, effort, options), fine)
        if with_fftw:
            run_with_fftw(run)
        if chosen is None and effort:
            run.part("fuzzing", FUZZING)
    print(f"\033[1m==>\033[0m {', '.join(run.took)}", file=sys.stderr)
    if run.failed:
        print(f"dev: failed: {', '.join(run.failed)}", file=sys.stderr)
    return 1 if run.failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
