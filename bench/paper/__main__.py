"""Regenerates docs/paper: the figures of a section of the paper, or of bodies given by their cross-section, their
numbers, and a page with the comparison.

    ./dev paper fem [--only fig5,fig8] [--fresh]
    ./dev paper contact [--only fig9] [--fresh]
    ./dev paper sections [--only edges] [--fresh]

Each result is saved at once in build/paper/<section>.jsonl. An interrupted or repeated run continues from these
results. The page is written from the CSV files when they are complete.
"""

from __future__ import annotations

import argparse
import signal
import subprocess
import sys
from pathlib import Path

from contactd import ContactdError

from . import programs
from .contact.section import SECTION as CONTACT
from .fem.section import SECTION as FEM
from .outputs import write_page, write_part
from .run import compute
from .section import ComputationFailed, Section
from .sections.section import SECTION as SECTIONS_OF_BODIES
from .store import ResultStore, StoreInUse

SECTIONS = {section.name: section for section in (FEM, CONTACT, SECTIONS_OF_BODIES)}


def say(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def parts_of(section: Section, text: str | None) -> list[str]:
    """Returns the named parts, separated by commas, or all of them without names."""
    if text is None:
        return list(section.parts)
    names = [name.strip() for name in text.split(",")]
    for name in names:
        if name not in section.parts:
            raise ValueError(f"'{name}' is not a part of {section.name}; the parts are {', '.join(section.parts)}")
    return names


def arguments_of(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./dev paper", description=(__doc__ or "").splitlines()[0])
    meanings = " and ".join(f"{s.name} is section {s.number}" for s in SECTIONS.values() if s.number is not None)
    parser.add_argument("section", choices=list(SECTIONS), metavar="SECTION", help=f"of the paper: {meanings}; sections is about docs/sections.md")
    parser.add_argument("--bin", type=Path, required=True, help="folder with contactd and contactd-ic")
    parser.add_argument("--output", type=Path, default=Path("docs/paper"), help="default: docs/paper")
    parser.add_argument("--store", type=Path, default=Path("build/paper"), help="default: build/paper")
    parts = "; ".join(f"{section.name}: {', '.join(section.parts)}" for section in SECTIONS.values())
    parser.add_argument("--only", metavar="PART,...", help=f"default: all parts of the section. {parts}")
    parser.add_argument("--fresh", action="store_true", help="discard the section's finished computations first")
    arguments = parser.parse_args(words)
    arguments.section = SECTIONS[arguments.section]
    try:
        arguments.only = parts_of(arguments.section, arguments.only)
    except ValueError as error:
        parser.error(str(error))
    return arguments


def main(words: list[str] | None = None) -> int:
    arguments = arguments_of(words)
    section: Section = arguments.section
    path = arguments.store / f"{section.name}.jsonl"
    for number in (signal.SIGINT, signal.SIGTERM):  # in the background of a script SIGINT would be ignored
        signal.signal(number, signal.default_int_handler)
    try:
        version, digest = programs.version(arguments.bin), programs.digest(arguments.bin)
        with ResultStore(path, version, digest, arguments.fresh) as store:
            cases = [case for name in arguments.only for case in section.parts[name]()]
            compute(cases, store, section, section.solver(arguments.bin), say)
            for name in arguments.only:
                write_part(section, name, store, arguments.output, say)
            write_page(section, arguments.output, version, say)
    except (ComputationFailed, ContactdError, StoreInUse, OSError, subprocess.CalledProcessError) as error:
        say(f"paper: {error}")
        return 1
    except KeyboardInterrupt:
        say(f"paper: interrupted; finished computations are in {path}; repeat the command to continue")
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
