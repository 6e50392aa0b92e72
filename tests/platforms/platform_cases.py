"""Runs the programs of tests/platforms, and compares their output: platform_cases.py run PROGRAMS FMUS LIBRARY FOLDER
[RUNNER], platform_cases.py python CASES FOLDER COMMAND..., or platform_cases.py compare FOLDER OTHER.

PROGRAMS is the folder of local-cases, creep-lines and fmu-host, FMUS the folder of the archives, and LIBRARY the
binary of the tested FMUs. FOLDER receives a file with the lines of each program. RUNNER runs programs of another
platform: wine64, or qemu-aarch64. COMMAND starts a Python with contactd and contactd_local, which reads cases from the
folder CASES. ./dev windows --test and ./dev arm64 --test do all of this, with the lines of this machine for
comparison.
"""

from __future__ import annotations

import argparse
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import xml.etree.ElementTree
import zipfile
from collections.abc import Iterator
from pathlib import Path

#: Folders that always exist on Windows.
STORE, BINARIES = "Tafeln für Räder", "FMU für Räder"
#: Arguments of the drivers of tests/congruence, and the files of their answers.
CONGRUENCE = {"congruence-c-local": "contacts.txt", "congruence-wheel-c-local": "wheels.txt"}
#: The same in the process of Python, with the cases of its own driver.
IN_PYTHON = {"python contacts.txt": "contacts", "python wheels.txt": "wheels"}
#: From here on a whole number of theirs is a digest, which changes with any last bit.
DIGESTS = 100_000
#: A radius above this limit (mm) belongs to a flat place, the inverse of a rounding error.
FLAT = 1e8
#: The largest relative difference of a number from the largest of its line; heights under a force are searched for.
BOUND, BOUND_OF_SEARCHES = 1e-9, 1e-8
FEWEST = {
    "creepages.txt": 3220,
    "local.txt": 100,
    "store.txt": 2,
    "fortran.txt": 2,
    "contacts.txt": 200,
    "wheels.txt": 60,
    "fmu contact 2.txt": 5,
    "fmu contact 3.txt": 5,
    "fmu wheel 2.txt": 5,
    "fmu wheel 3.txt": 5,
    "python contacts.txt": 200,
    "python wheels.txt": 60,
}
INPUTS = {
    "contact": {"load.Fn": 50e3, "gap.Rx": 460, "gap.Ry": 300, "motion.xi": 1e-3, "motion.phi": 2e-4},
    "wheel": {"mesh.dx": 0.5, "mesh.dy": 0.5, "position.y": 3.0, "velocity.pitch": -20e3 / 460, "velocity.x": 20e3},
}


def variables_of(archive: Path) -> tuple[str, dict[str, tuple[str, str, str]]]:
    """Returns the GUID, and reference, causality and type of each variable."""
    with zipfile.ZipFile(archive) as opened:
        root = xml.etree.ElementTree.fromstring(opened.read("modelDescription.xml"))
    listed = root.find("ModelVariables")
    assert listed is not None
    found = {}
    for one in listed:
        of = one.tag if one.tag != "ScalarVariable" else one[0].tag
        found[one.attrib["name"]] = (one.attrib["valueReference"], one.attrib.get("causality", "local"), of)
    return root.attrib.get("guid") or root.attrib["instantiationToken"], found


def arguments_of(archive: Path, kind: str, version: int) -> list[str]:
    guid, variables = variables_of(archive)
    inputs = [f"{variables[name][0]}={value!r}" for name, value in INPUTS[kind].items() if name in variables]
    outputs = [
        reference
        for reference, causality, of in variables.values()
        if causality == "output" and of in ("Real", "Float64")
    ]
    return [str(version), guid, "5", "0.001", *inputs, "--", *outputs]


def run(options: argparse.Namespace) -> None:
    folder = options.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    windows = "wine" in Path(options.runner or "").name
    ending = ".exe" if windows else ""

    def printed(name: str, program: str, *arguments: str, **environment: str) -> None:
        path = options.programs.resolve() / (program + ending)
        command = [*([options.runner] if options.runner else []), str(path), *arguments]
        ended = subprocess.run(command, capture_output=True, env={**os.environ, **environment}, check=False)
        (folder / name).write_bytes(ended.stdout.replace(b"\r\n", b"\n"))
        if ended.returncode != 0:
            sys.exit(
                f"{' '.join(command[:3])} ended with {ended.returncode}: {ended.stdout[-300:]!r} {ended.stderr[-600:]!r}"
            )

    printed("creepages.txt", "creep-lines")
    printed("local.txt", "local-cases")
    printed(
        "store.txt",
        "local-cases",
        "store",
        CONTACTD_STORE=windows_path(folder / STORE) if windows else str(folder / STORE),
    )
    printed("fortran.txt", "fortran-in-process", "local")
    if not options.runner:
        write_congruence(folder)
    for program, name in CONGRUENCE.items():
        told = cases_of(folder, name)
        printed(name, program, "local", windows_path(told) if windows else str(told))
    binaries = folder / BINARIES
    binaries.mkdir(exist_ok=True)
    library = shutil.copy(options.library, binaries)
    for kind in ("contact", "wheel"):
        for version in (2, 3):
            archive = options.fmus / f"contactd_{kind}_fmi{version}.fmu"
            place = windows_path(Path(library)) if windows else str(library)
            printed(f"fmu {kind} {version}.txt", "fmu-host", place, *arguments_of(archive, kind, version))


def run_python(options: argparse.Namespace) -> None:
    folder = options.folder.resolve()
    windows = any("wine" in Path(word).name for word in options.command)
    tests = Path(__file__).parents[1]

    def place(path: Path) -> str:
        return windows_path(path) if windows else str(path)

    parts = [place(tests), *filter(None, [os.environ.get("PYTHONPATH")])]
    environment = {**os.environ, "PYTHONPATH": (";" if windows else ":").join(parts), "PYTHONDONTWRITEBYTECODE": "1"}
    for name, kind in IN_PYTHON.items():
        told = cases_of(options.cases.resolve(), name)
        command = [*options.command, place(tests / "platforms" / "python_lines.py"), kind, place(told)]
        ended = subprocess.run(command, capture_output=True, env=environment, check=False)
        (folder / name).write_bytes(ended.stdout)
        if ended.returncode != 0:
            sys.exit(f"{' '.join(command)} ended with {ended.returncode}: {ended.stdout[-300:]!r} {ended.stderr[-900:]!r}")


def cases_of(folder: Path, name: str) -> Path:
    return folder / f"cases of {name}"


def write_congruence(folder: Path) -> None:
    """Returns the cases of all interfaces, in the words of those by path."""
    sys.path.insert(0, str(Path(__file__).parents[1]))
    from congruence.cases import write as write_words
    from congruence.paths import write_paths
    from congruence.wheel_cases import EVERYWHERE, write

    write_paths(cases_of(folder, "contacts.txt"))
    write(cases_of(folder, "wheels.txt"), EVERYWHERE)
    write_words(cases_of(folder, "python contacts.txt"))
    write(cases_of(folder, "python wheels.txt"), EVERYWHERE)


def windows_path(path: Path) -> str:
    """Returns the path of a file of the machine in Wine."""
    return "Z:" + str(path).replace("/", "\\")


def compare(options: argparse.Namespace) -> None:
    failed = False
    for name, fewest in FEWEST.items():
        here, there = (
            (folder / name).read_text(encoding="utf-8").splitlines() for folder in (options.folder, options.other)
        )
        largest = {"numbers": 0.0, "searches": 0.0}
        wrong = [] if len(here) >= fewest else [f"{len(here)} lines; there must be {fewest}"]
        if len(here) != len(there):
            wrong.append(f"{len(here)} lines and {len(there)}")
        for one, other in zip(here, there):
            if one.startswith("text"):
                # This machine builds the table that the other one reads.
                wrong += [] if one.replace("built", "disk") == other else [f"{one!r} is {other!r}"]
                continue
            kind = "searches" if "wheel" in one or "wheel" in name else "numbers"
            numbers, others = (list(numbers_of(line, name in CONGRUENCE.values() or name in IN_PYTHON)) for line in (one, other))
            if words_of(one) != words_of(other):
                wrong.append(f"{one[:160]!r} is {other[:160]!r}")
                continue
            scale = max(map(abs, filter(math.isfinite, numbers)), default=1.0) or 1.0
            if len(numbers) != len(others):
                wrong.append(f"{one!r} is {other!r}")
                continue
            difference = max(
                (
                    abs(a - b) / scale
                    for a, b in zip(numbers, others)
                    if a != b and not (math.isnan(a) and math.isnan(b))
                ),
                default=0.0,
            )
            largest[kind] = max(largest[kind], difference)
            if not difference <= (BOUND if kind == "numbers" else BOUND_OF_SEARCHES):
                wrong.append(f"differs by {difference:.2g}: {one[:160]}")
        print(
            f"{name}: {len(here)} lines, largest difference {max(largest.values()):.2g}"
            + (f", {len(wrong)} WRONG" if wrong else "")
        )
        for sentence in wrong[:5]:
            print(f"    {sentence}")
        failed |= bool(wrong)
    sys.exit(1 if failed else 0)


def numbers_of(line: str, of_congruence: bool) -> Iterator[float]:
    for word in line.split()[1:]:
        if not of_congruence:
            if is_number(word):
                yield float(word)
        elif re.fullmatch("[0-9A-F]{16}", word):
            (number,) = struct.unpack(">d", bytes.fromhex(word))
            yield math.inf if abs(number) > FLAT else number
        elif word.isdecimal() and int(word) < DIGESTS:
            yield float(word)


def words_of(line: str) -> list[str]:
    """Returns lines without numbers: names, refusals with reasons, and missing things."""
    first, *others = line.split() or [""]
    return [first, *(word for word in others if not is_number(word) and not re.fullmatch("[0-9A-F]{16}", word))]


def is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="platform_cases", description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    does = parser.add_subparsers(dest="does", required=True)
    running, in_python, comparing = (does.add_parser(name) for name in ("run", "python", "compare"))
    for name in ("programs", "fmus", "library", "folder"):
        running.add_argument(name, type=Path)
    running.add_argument("runner", nargs="?")
    for name in ("cases", "folder"):
        in_python.add_argument(name, type=Path)
    in_python.add_argument("command", nargs=argparse.REMAINDER)
    comparing.add_argument("folder", type=Path)
    comparing.add_argument("other", type=Path)
    options = parser.parse_args()
    {"run": run, "python": run_python, "compare": compare}[options.does](options)


if __name__ == "__main__":
    main()
