"""Regenerates docs/paper: the figures of the paper's section 3, their numbers, and a page that compares.

    ./dev paper fem [--only fig5,fig8] [--fresh]

Results are kept in build/paper/results.jsonl as soon as they are there: a run that was interrupted, or repeated, goes
on from them. The page is written from the CSV files when all of them are there.
"""

from __future__ import annotations

import argparse
import signal
import sys
from pathlib import Path

from .cases import PARTS
from .measure import Builder, BuildFailed
from .outputs import write_part, write_page
from .run import compute
from .store import ResultStore, StoreInUse


def say(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def parts_of(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    for name in names:
        if name not in PARTS:
            raise argparse.ArgumentTypeError(f"'{name}' is no part; there are {', '.join(PARTS)}")
    return names


def arguments_of(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./dev paper", description=__doc__.splitlines()[0])
    parser.add_argument("what", choices=["fem"], help="which of the paper's sections: fem is section 3")
    parser.add_argument("--bin", type=Path, required=True, help="folder with contactd-ic")
    parser.add_argument("--output", type=Path, default=Path("docs/paper"), help="default: docs/paper")
    parser.add_argument("--store", type=Path, default=Path("build/paper"), help="finished computations; build/paper")
    parser.add_argument("--only", type=parts_of, default=list(PARTS), metavar="PART,...", help=", ".join(PARTS))
    parser.add_argument("--fresh", action="store_true", help="forget all finished computations first")
    return parser.parse_args(words)


def main(words: list[str] | None = None) -> int:
    arguments = arguments_of(words)
    path = arguments.store / "results.jsonl"
    for number in (signal.SIGINT, signal.SIGTERM):  # in the background of a script SIGINT would be ignored
        signal.signal(number, signal.default_int_handler)
    builder = Builder(arguments.bin / "contactd-ic")
    try:
        with ResultStore(path, builder.version(), builder.digest(), arguments.fresh) as store:
            cases = [case for name in arguments.only for case in PARTS[name]()]
            compute(cases, store, builder.measure, say)
            for name in arguments.only:
                write_part(name, PARTS[name](), store, arguments.output, say)
            write_page(arguments.output, builder.version(), say)
    except (BuildFailed, StoreInUse, OSError) as error:
        say(f"paper: {error}")
        return 1
    except KeyboardInterrupt:
        say(f"paper: interrupted; finished computations are in {path}, and the same command goes on from there")
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
