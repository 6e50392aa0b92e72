"""Fuzzes the commands that read untrusted files: contact, wear, study, conform, profile and roughness, with
damaged files, malicious names and signals.

    commands.py [SECONDS] [SEED] runs for this time (default 60); findings are stored in
    build/fuzz/found/commands-SEED-N

Each run has a folder of its own, and beside it one with secrets. A finding is a run that takes longer than it may, does not end
soon after a signal, ends with a traceback or a code that no page has, changes or tells a file beside its folder, writes over a
file that contactd has not written, runs a program, or leaves something in the temporary folder. Needs contactctl, and what it
solves with.
"""

from __future__ import annotations

import os
import random
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
LONGEST = 20.0  #: s, as of the other targets
LONGEST_END = 2.0  #: s from a signal
SLACK = 3.0  #: s, for a machine that does other things, too
LARGEST = 64 << 20  #: characters of a damaged file; repeated damage would make gigabytes
SECRET = b"SECRET-7a61f0"
FOREIGN = b"notes of somebody, 1, 2\n"
CODES = {0, 2, 3, 4, 5, 7, 8, 9}
OF_SIGNALS = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129}

CASE = """\
 3  MODULE
  203100
  022020
 0001201
   999  100  30  1  1e-6
 50000.  0.0005  0.0  0.0001
   0.3   0.3
   0.0   0.5   20000.
   0.28  0.28  82000.  82000.
    -3
    9   9  6.0  4.0  1.1
"""
RAIL_CASE = """\
 1 MODULE
 1203100
 0022033
 0001201
 100 30 5 1 1e-6
 0.3 0.3
 .28 .28 82000. 82000.
 1. 1. 1. 90d 8. 4.
 -1. 750. 0. 0.
 'rail.prr' -1 1000. 0.
 0. 0. 0. 0. 0. 0.
 1360. -70. 460.
 'wheel.txt' 0 1. 0. -1
 0. 0. 10000. 0. 0. 0.
 2000. 0. 0. 0. 0. -4.348
"""
FILES = {
    "cases.inp": CASE + RAIL_CASE + " 0 MODULE\n",
    "sliced.inp": RAIL_CASE.replace("rail.prr", "list.slcs") + " 0 MODULE\n",
    "list.slcs": "0 1\n2\n0 0 0\n1\n-500.0 'rail.txt'\n500.0 'rail.txt'\n",
    "rail.prr": "header.begin\n type = 0\nheader.end\nspline.begin\nunits.len.f = 1000\npoint.begin\n"
    + "".join(f" {y / 1e3} {y * y / 6e5}\n" for y in range(-35, 36)) + "point.end\nspline.end\n",
    "rail.txt": "".join(f"{y} {y * y / 600}\n" for y in range(-35, 36)),
    "wheel.txt": "".join(f"{y} {-0.025 * y}\n" for y in range(40, -41, -1)),
    "problem.yaml": "grid: {nx: 9, ny: 9, dx: 0.3, dy: 0.3}\nbodies: {upper: {G: 200, nu: 0.42}}\nics: {source: analytic}\n"
    "gap: {array: {$file: gap.csv}}\napproach: 0.02\n",
    "gap.csv": "".join(",".join(f"{(x * x + y * y) / 1e3}" for x in range(-4, 5)) + "\n" for y in range(-4, 5)),
    "study.yaml": "problem: problem.yaml\nvary: {approach: [0.01, 0.02]}\nanswers: [forces.Fn, pmax]\n",
    "wear.yaml": "setup: {dx: 1.5, dy: 1.5}\nstates: states.csv\nwears: wheel\nlaw: {name: mild, source: a test, body: lower, range: [0, 10], "
    "energy: {coefficient: 0.000675}}\nuntil: 10\nstep: {depth: 0.01}\n",
    "rail.csv": "x (mm);r (um)\n" + "".join(f"{x};{x * x % 11}\n" for x in range(1100)),
    "states.csv": "position.y, velocity.x, velocity.pitch, Fz, weight, group\n-1.5, 30000, -65.217, 80000, 0.4, straight\n"
    "1, 30000, -65.217, 80000, 0.4, straight\n",
    "run.csv": "distance (m); Yr (kN); Yl; Qr (kN); Ql (kN)\n" + "".join(f"{x},5; {20 + x % 7}; -4000; 60; 55\n" for x in range(20)),
    "RUIC519A.dat": "".join(f"{y} {0.05 * y - 2 * max(0, -30 - y)}\n" for y in range(-44, 41)),
    "SUIC519A.dat": "".join(f"{y} {-y * y / 600 - 5 * max(0, abs(y) - 30)}\n" for y in range(-34, 35)),
    "ben_E1.dat": "1 0.05\n2 0.05\n",
}  # fmt: skip
#: Words of a command, the files that it reads, and some that it writes.
COMMANDS = [
    (["contact", "check", "cases.inp"], ["cases.inp"], []),
    (["contact", "run", "cases.inp"], ["cases.inp", "rail.prr", "wheel.txt"], ["cases.out", "cases.out.rows", "cases.0001.mat"]),
    (["contact", "run", "sliced.inp", "--fresh"], ["sliced.inp", "list.slcs", "rail.txt"], ["sliced.out", "sliced.0001a.mat"]),
    (["contact", "convert", "cases.inp", "cases.py"], ["cases.inp", "rail.prr"], ["cases.py"]),
    (["study", "study.yaml", "--csv", "rows.csv"], ["study.yaml", "problem.yaml", "gap.csv"], ["study.yaml.rows", "rows.csv"]),
    (["roughness", "rail.csv", "--load", "5e4", "--csv", "levels.csv"], ["rail.csv"], ["levels.csv"]),
    (["wear", "wear.yaml", "--fresh", "--profiles", "worn"], ["wear.yaml", "states.csv"], ["wear.yaml.h5", "worn/wheel.prw"]),
    (["conform", "en14363", "run.csv", "--csv", "means.csv"], ["run.csv"], ["means.csv"]),
    (["conform", "en15302", ".", "--csv", "rows.csv"], ["RUIC519A.dat", "SUIC519A.dat", "ben_E1.dat"], ["rows.csv"]),
    (["profile", "convert", "rail.txt", "rail.ban", "--rail"], ["rail.txt"], ["rail.ban"]),
]
CHARACTERS = [" ", "\n", "\r\n", '"', "'", "1", ",", "\t", "{", "[", "- ", "#", "%", "\0", "\x1b[2J", "é", "&a ", "*a", ": "]
NAMES = ["../other/secret.txt", "OTHER/secret.txt", "link.txt", "/etc/passwd", "/dev/zero", "..\\other\\secret.txt", "'", "\n", "a\nimport os\n"]
NUMBERS = ["nan", "-inf", "1e308", "-1", "0", "999999999999", "1e-320", "0x10", "1" * 5000]


@dataclass(frozen=True)
class Run:
    """Describes a command in a folder, with the signal that it gets, if any, and the time."""

    words: list[str]
    foreign: list[str]
    sent: signal.Signals | None
    after: float


def damaged(text: str, chance: random.Random) -> str:
    """Returns the text after random damage, including malicious changes."""
    for _ in range(chance.choice([1, 1, 2, 4])):
        text = text[:LARGEST]
        lines = text.split("\n")
        line = chance.randrange(len(lines))
        words = lines[line].split(" ")
        word = chance.randrange(len(words))
        match chance.randrange(8):
            case 0:
                at = chance.randrange(len(text) + 1)
                text = text[:at] + chance.choice(CHARACTERS) * 2 ** chance.randrange(21) + text[at:]
                continue
            case 1:
                text = chance.choice(CHARACTERS) * (1 << 20)
                continue
            case 2:
                del lines[line]
            case 3:
                lines[line:line] = [lines[line]] * 2 ** chance.randrange(12)
            case 4:
                words[word] = chance.choice(NUMBERS)
            case 5:
                words[word] = chance.choice(NAMES)
            case 6:
                words[word] = f"'{chance.choice(NAMES)}'"
            case 7:
                text = text[: chance.randrange(len(text) + 1)]
                continue
        lines[line : line + 1] = [" ".join(words)] if line < len(lines) and lines[line].split(" ") != words else lines[line : line + 1]
        text = "\n".join(lines)
    return text[:LARGEST]


def prepared(place: Path, chance: random.Random) -> Run:
    """Makes the folders of a run."""
    own, other = place / "own", place / "other"
    for folder in (own, other, place / "tmp", own / "worn"):
        folder.mkdir(parents=True)
    (other / "secret.txt").write_bytes(b"0 0\n" + SECRET + b"\n1 1\n")
    (other / "notes.txt").write_bytes(FOREIGN)
    (own / "link.txt").symlink_to(other / "secret.txt")
    words, read, written = chance.choice(COMMANDS)
    for name, text in FILES.items():
        (own / name).write_text(text)
    for name in chance.sample(read, chance.randint(0, len(read))):
        content = damaged(FILES[name], chance).replace("OTHER", str(other))
        if name == "wear.yaml" and chance.random() < 0.3:
            content = content.replace("states: states.csv", "dynamics: {program: [touch, ../other/ran]}")
        (own / name).write_text(content, errors="surrogateescape")
    foreign = []
    for name in written:
        match chance.randrange(8):
            case 0:
                (own / name).write_bytes(FOREIGN)
                foreign.append(name)
            case 1:
                (own / name).symlink_to(other / "notes.txt")
            case 2:
                (own / name).symlink_to(other / "nowhere.txt")
    sent = chance.choice([None, None, *OF_SIGNALS])
    return Run(words, foreign, sent, chance.uniform(0.05, 2.0))


def started(run: Run, place: Path, main: Callable[[list[str]], None]) -> int:
    """Forks the process of the command, which has all modules loaded."""
    process = os.fork()
    if process:
        return process
    os.setsid()
    os.chdir(place / "own")
    os.environ["TMPDIR"] = tempfile.tempdir = str(place / "tmp")
    for descriptor, name in ((1, "out"), (2, "err")):
        os.dup2(os.open(place / name, os.O_WRONLY | os.O_CREAT, 0o600), descriptor)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    sys.stdout, sys.stderr = open(1, "w", closefd=False), open(2, "w", closefd=False)
    try:
        main(run.words)
    except SystemExit as ended:
        sys.stdout.flush()
        code = ended.code if isinstance(ended.code, int) else 1
        os._exit(code)
    except BaseException:
        sys.__excepthook__(*sys.exc_info())
        sys.stderr.flush()
    os._exit(1)


def ended(process: int, seconds: float) -> int | None:
    """Returns the code with which it ends within this time, negative for a signal; None if it does not end."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        found, status = os.waitpid(process, os.WNOHANG)
        if found:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.01)
    return None


def findings(run: Run, place: Path, main: Callable[[list[str]], None]) -> list[str]:
    """Runs the command, and checks its effects."""
    process, sent = started(run, place, main), run.sent
    code = ended(process, LONGEST if sent is None else run.after)
    found = [] if code is not None or sent is not None else [f"takes longer than {LONGEST:g} s"]
    if code is None:
        sent = sent or signal.SIGTERM
        os.kill(process, sent)
        code = ended(process, LONGEST_END + SLACK)
        if code is None:
            found.append(f"does not end within {LONGEST_END:g} s of {sent.name}")
            os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)
        elif code not in (*CODES, OF_SIGNALS[sent], -sent, -signal.SIGKILL):
            found.append(f"ends with {code} after {sent.name}")
    elif code not in CODES:
        found.append(f"ends with {code}")
    return found + traces(run, place, was_killed=code is None or code < 0)


def traces(run: Run, place: Path, was_killed: bool) -> list[str]:
    """Returns forbidden traces of a run."""
    own, other = place / "own", place / "other"
    found = []
    if b"Traceback" in (place / "err").read_bytes():
        found.append("has a traceback")
    if sorted(path.name for path in other.iterdir()) != ["notes.txt", "secret.txt"] or (other / "notes.txt").read_bytes() != FOREIGN:
        found.append("changes what lies beside its folder")
    found += [f"writes over {name}" for name in run.foreign if (own / name).read_bytes() != FOREIGN]
    reported = [place / "out", place / "err", *(path for path in own.rglob("*") if path.is_file() and not path.is_symlink())]
    found += [f"tells a secret in {path.name}" for path in reported if SECRET in path.read_bytes()]
    if not was_killed and any((place / "tmp").iterdir()):
        found.append(f"leaves {next((place / 'tmp').iterdir()).name} in the temporary folder")
    return found


def fuzz(seconds: float, seed: int, kept: Path | None = None, most: int = 1_000_000) -> list[str]:
    """Returns the findings within this time and number of runs; the folder of each is kept."""
    from contactctl import app  # noqa: F401  # loaded once, for all
    from contactctl.main import main

    os.environ.pop("CONTACTD_ENDPOINT", None)
    began, found, number = time.monotonic(), [], 0
    while number < most and time.monotonic() - began < seconds:
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder)
            run = prepared(place, random.Random(f"{seed}-{number}"))
            for finding in findings(run, place, main):
                found.append(f"commands-{seed}-{number}: contactctl {' '.join(run.words)} {finding}")
                if kept is not None:
                    left = kept / f"commands-{seed}-{number}"
                    shutil.rmtree(left, ignore_errors=True)
                    shutil.copytree(place, left, symlinks=True)
        number += 1
    print(f"commands: {number} runs in {time.monotonic() - began:.0f} s", file=sys.stderr)
    return found


if __name__ == "__main__":
    sys.path[:0] = [str(ROOT / "client" / "python"), str(ROOT / "build" / "development" / "lib" / "python")]
    os.environ["PATH"] = f"{ROOT / 'build' / 'development' / 'bin'}:{os.environ['PATH']}"
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else random.randrange(10**6)
    sentences = fuzz(seconds, seed, ROOT / "build" / "fuzz" / "found")
    print("\n".join(sentences))
    sys.exit(1 if sentences else 0)
