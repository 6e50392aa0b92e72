"""Sends 300 random cases to the daemons of two commits, whose answers must have the same bytes.

    git worktree add build/before COMMIT && (cd build/before && ./dev build)
    ./dev build
    ./dev shell env PYTHONPATH=client/python:tests python3 -m equality \\
        --before build/before/build/development/bin --after build/development/bin

Both folders contain contactd and contactd-ic of one preset, because other compiler settings round differently. A case
is a contact problem, a session, a table or a bad request, and consists of one or more requests, made by a generator
with the seed of the case. Afterwards the later daemon gets the store of the earlier one, and its tables are requested
again: none may be built, and all must be the same. Durations and versions are not compared. Intended differences are
listed, with the reason, in tests/equality/differences.py (EXPLAINED), and printed separately. The exit status is 1 if
there are others.
"""

from __future__ import annotations

import argparse
import collections
import signal
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .cases import KINDS, STORED, cases
from .differences import EXPLAINED, Difference, differences
from .run import Played, Run, run

SHOWN = 30  # differences


def compare(before: list[Played], after: list[Played], passed_over: str = "") -> dict[str, list[Difference]]:
    """Returns the unexplained differences of each answer, by the case's number and kind and the request."""
    found: dict[str, list[Difference]] = {}
    for one, other in zip(before, after, strict=True):
        where = f"case {one.case.number}, {one.case.kind}"
        if one.methods != other.methods:
            found[where] = [Difference("requests", str(one.methods), str(other.methods))]
            continue
        for number, (answer, again) in enumerate(zip(one.answers, other.answers, strict=True), 1):
            unlike = [
                difference
                for difference in differences(answer, again)
                if not any(entry.holds(one.case.kind, difference.field) for entry in EXPLAINED)
                and (not passed_over or not difference.field.endswith(passed_over))
            ]
            if unlike:
                found[f"{where}, request {number} ({one.methods[number - 1]})"] = unlike
    return found


def explained(before: list[Played], after: list[Played]) -> collections.Counter[str]:
    """Counts the differences that each entry of the list explains."""
    return collections.Counter(
        entry.why
        for one, other in zip(before, after, strict=True)
        for answer, again in zip(one.answers, other.answers, strict=False)
        for difference in differences(answer, again)
        for entry in EXPLAINED
        if entry.holds(one.case.kind, difference.field)
    )


def print_summary(before: Run, after: Run) -> None:
    kinds = collections.Counter(one.case.kind for one in before.played)
    answers = collections.Counter[str]()
    for one in before.played:
        answers[one.case.kind] += len(one.answers)
    for kind in KINDS:
        print(f"{kind:28} {kinds[kind]:4} cases {answers[kind]:5} answers")
    for name, daemon in (("before", before), ("after", after)):
        statuses = ", ".join(f"{count} {status}" for status, count in daemon.statuses.most_common())
        print(f"{name}: {daemon.builds} tables built; {statuses}")
    for why, count in explained(before.played, after.played).items():
        print(f"{count} differences are meant: {why}")


def print_differences(title: str, found: dict[str, list[Difference]]) -> None:
    print(f"{title}: {len(found)} answers differ" if found else f"{title}: no difference")
    for where, unlike in list(found.items())[:SHOWN]:
        print(f"  {where}")
        for difference in unlike[:SHOWN]:
            print(f"    {difference}")
        if len(unlike) > SHOWN:
            print(f"    and {len(unlike) - SHOWN} more")
    if len(found) > SHOWN:
        print(f"  and {len(found) - SHOWN} more answers")


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="equality", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--before", type=Path, required=True, help="folder with the programs of the earlier commit")
    parser.add_argument("--after", type=Path, required=True, help="folder with those of the later one")
    parser.add_argument("--count", type=int, default=300, help="number of cases (default 300)")
    parser.add_argument("--seed", type=int, default=1, help="of all cases (default 1)")
    parser.add_argument(
        "--kind", choices=KINDS, action="append", metavar="KIND", help="only cases of this kind; may be repeated"
    )
    options = parser.parse_args(arguments)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    start = time.monotonic()
    chosen = [case for case in cases(options.count, options.seed) if not options.kind or case.kind in options.kind]
    with tempfile.TemporaryDirectory(prefix="equality-") as name, ThreadPoolExecutor(2) as threads:
        folder = Path(name)
        stop = threading.Event()
        both = [threads.submit(run, bin_ / "contactd", folder / name, chosen, stop)
                for name, bin_ in (("before", options.before), ("after", options.after))]  # fmt: skip
        try:
            before, after = (one.result() for one in both)
        finally:
            stop.set()  # if one failed or was interrupted, the other daemon ends too
        print_summary(before, after)
        found = compare(before.played, after.played)
        print_differences("the same requests", found)
        kept = [case for case in chosen if case.kind in STORED]
        again = run(options.after / "contactd", folder / "before", kept)
        tables = compare([one for one in before.played if one.case.kind in STORED], again.played, passed_over="origin")
        print_differences("with the store of before", tables)
        if again.builds:
            print(f"with the store of before: {again.builds} tables were built again")
    print(f"in {time.monotonic() - start:.0f} s")
    return 1 if found or tables or again.builds else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
