"""Runs the programs of tests/windows, and compares what they print: platform_cases.py run PROGRAMS FMUS LIBRARY FOLDER [WINE],
or platform_cases.py compare FOLDER OTHER.

PROGRAMS is the folder of local-cases, creep-lines and fmu-host, FMUS that of the archives, LIBRARY the binary of FMUs that they
are tried with. Lines come into FOLDER, a file for each program. ./dev windows --test does all of it, on Linux and under Wine.
"""

from __future__ import annotations

import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree
import zipfile
from pathlib import Path

#: Folders that Windows has in plenty.
STORE, BINARIES = "Tafeln für Räder", "FMU für Räder"
#: The largest relative difference of a number from the largest of its line; heights under a force are searched for.
BOUND, BOUND_OF_SEARCHES = 1e-9, 1e-8
FEWEST = {"creepages.txt": 3220, "local.txt": 100, "store.txt": 2, "fmu contact 2.txt": 5, "fmu contact 3.txt": 5, "fmu wheel 2.txt": 5, "fmu wheel 3.txt": 5}
INPUTS = {
    "contact": {"load.Fn": 50e3, "gap.Rx": 460, "gap.Ry": 300, "motion.xi": 1e-3, "motion.phi": 2e-4},
    "wheel": {"mesh.dx": 0.5, "mesh.dy": 0.5, "position.y": 3.0, "velocity.pitch": -20e3 / 460, "velocity.x": 20e3},
}


def variables_of(archive: Path) -> tuple[str, dict[str, tuple[str, str, str]]]:
    """The GUID, and of each variable reference, causality and type."""
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
    outputs = [reference for reference, causality, of in variables.values() if causality == "output" and of in ("Real", "Float64")]
    return [str(version), guid, "5", "0.001", *inputs, "--", *outputs]


def run(options: argparse.Namespace) -> None:
    folder = options.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    ending = ".exe" if options.wine else ""

    def printed(name: str, program: str, *arguments: str, **environment: str) -> None:
        path = options.programs.resolve() / (program + ending)
        command = [*([options.wine] if options.wine else []), str(path), *arguments]
        ended = subprocess.run(command, capture_output=True, env={**os.environ, **environment}, check=False)
        (folder / name).write_bytes(ended.stdout.replace(b"\r\n", b"\n"))
        if ended.returncode != 0:
            sys.exit(f"{' '.join(command[:3])} ended with {ended.returncode}: {ended.stdout[-300:]!r} {ended.stderr[-600:]!r}")

    printed("creepages.txt", "creep-lines")
    printed("local.txt", "local-cases")
    printed("store.txt", "local-cases", "store", CONTACTD_STORE=str(folder / STORE) if not options.wine else windows_path(folder / STORE))
    binaries = folder / BINARIES
    binaries.mkdir(exist_ok=True)
    library = shutil.copy(options.library, binaries)
    for kind in ("contact", "wheel"):
        for version in (2, 3):
            archive = options.fmus / f"contactd_{kind}_fmi{version}.fmu"
            place = windows_path(Path(library)) if options.wine else str(library)
            printed(f"fmu {kind} {version}.txt", "fmu-host", place, *arguments_of(archive, kind, version))


def windows_path(path: Path) -> str:
    """As Wine has the files of the machine."""
    return "Z:" + str(path).replace("/", "\\")


def compare(options: argparse.Namespace) -> None:
    failed = False
    for name, fewest in FEWEST.items():
        here, there = ((folder / name).read_text(encoding="utf-8").splitlines() for folder in (options.folder, options.other))
        largest = {"numbers": 0.0, "searches": 0.0}
        wrong = [] if len(here) >= fewest else [f"{len(here)} lines; there must be {fewest}"]
        if len(here) != len(there):
            wrong.append(f"{len(here)} lines and {len(there)}")
        for one, other in zip(here, there):
            if one.startswith("text"):
                # Linux builds the table that Windows finds.
                wrong += [] if one.replace("built", "disk") == other else [f"{one!r} is {other!r}"]
                continue
            kind = "searches" if "wheel" in one or "wheel" in name else "numbers"
            numbers, others = ([float(word) for word in re.findall(r"(?<=\s)[-+.\deinfa]+(?=\s|$)", line) if is_number(word)] for line in (one, other))
            scale = max(map(abs, filter(math.isfinite, numbers)), default=1.0) or 1.0
            if len(numbers) != len(others):
                wrong.append(f"{one!r} is {other!r}")
                continue
            difference = max((abs(a - b) / scale for a, b in zip(numbers, others) if a != b), default=0.0)
            largest[kind] = max(largest[kind], difference)
            if not difference <= (BOUND if kind == "numbers" else BOUND_OF_SEARCHES):
                wrong.append(f"differs by {difference:.2g}: {one[:160]}")
        print(f"{name}: {len(here)} lines, largest difference {max(largest.values()):.2g}" + (f", {len(wrong)} WRONG" if wrong else ""))
        for sentence in wrong[:5]:
            print(f"    {sentence}")
        failed |= bool(wrong)
    sys.exit(1 if failed else 0)


def is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def main() -> None:
    parser = argparse.ArgumentParser(prog="platform_cases", description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    does = parser.add_subparsers(dest="does", required=True)
    running, comparing = does.add_parser("run"), does.add_parser("compare")
    for name in ("programs", "fmus", "library", "folder"):
        running.add_argument(name, type=Path)
    running.add_argument("wine", nargs="?")
    comparing.add_argument("folder", type=Path)
    comparing.add_argument("other", type=Path)
    options = parser.parse_args()
    run(options) if options.does == "run" else compare(options)


if __name__ == "__main__":
    main()
