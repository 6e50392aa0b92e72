"""Formats terminal output: sections, aligned rows, a progress bar. Colours and redrawing are used in a terminal
only."""

from __future__ import annotations

import os
import shutil
import sys
import time
from collections.abc import Sequence

from contactd import Progress

_COLOURS = {"bold": "1", "dim": "2", "green": "32", "red": "31", "blue": "34"}


def _is_terminal() -> bool:
    return sys.stdout.isatty() and os.environ.get("TERM") != "dumb"


def styled(text: str, *styles: str) -> str:
    if not _is_terminal() or "NO_COLOR" in os.environ:
        return text
    return f"\x1b[{';'.join(_COLOURS[style] for style in styles)}m{text}\x1b[0m"


def say(text: str = "") -> None:
    print(f"   {text}" if text else "", flush=True)


def section(number: int, title: str, *explanation: str) -> None:
    print(f"\n{styled(f'{number}  {title}', 'bold', 'blue')}", flush=True)
    for line in explanation:
        say(styled(line, "dim"))
    print()


def rows(pairs: Sequence[tuple[str, str]]) -> None:
    width = max(len(name) for name, _ in pairs)
    for name, value in pairs:
        say(f"{name:{width}}   {value}")


def table(head: Sequence[str], body: Sequence[Sequence[str]]) -> None:
    """Prints a table with the first column left-aligned and the others right-aligned, below a ruled head."""
    widths = [max(len(row[i]) for row in [head, *body]) for i in range(len(head))]

    def line(cells: Sequence[str]) -> str:
        first, *others = (f"{cell:{'<' if i == 0 else '>'}{widths[i]}}" for i, cell in enumerate(cells))
        return "   ".join([first, *others])

    rule = "─" if "utf" in (sys.stdout.encoding or "").lower() else "-"
    say(styled(line(head), "bold"))
    say(styled(rule * len(line(head)), "dim"))
    for row in body:
        say(line(row))


def verdict(passed: bool, text: str) -> None:
    word = styled("pass", "green") if passed else styled("FAIL", "bold", "red")
    say(f"{word}   {text}")


class ProgressBar:
    """Provides a callback for the client: one line that is redrawn; without a terminal, a line for each new stage."""

    def __init__(self) -> None:
        self._stage = ""
        self._started = time.monotonic()
        self._drawn = False

    def __enter__(self) -> ProgressBar:
        return self

    def __exit__(self, *exception: object) -> None:
        if self._drawn:
            print("\r\x1b[K", end="", flush=True)

    def __call__(self, progress: Progress) -> None:
        if _is_terminal():
            self._draw(progress)
        elif progress.stage and progress.stage != self._stage:
            say(f"{100 * progress.fraction:3.0f} %  {progress.stage}")
        self._stage = progress.stage

    def _draw(self, progress: Progress) -> None:
        full, empty = ("█", "░") if "utf" in (sys.stdout.encoding or "").lower() else ("#", "-")
        filled = round(28 * progress.fraction)
        bar = styled(full * filled, "green") + styled(empty * (28 - filled), "dim")
        detail = f"{100 * progress.fraction:3.0f} % {time.monotonic() - self._started:4.0f} s  {progress.stage}"
        if progress.seconds_left is not None:
            detail += f", about {progress.seconds_left:.0f} s to go"
        if progress.iteration:
            detail += f", iteration {progress.iteration}, residual {progress.residual:.0e}"
        room = max(10, shutil.get_terminal_size().columns - 33)
        print(f"\r   {bar} {detail[:room]}\x1b[K", end="", flush=True)
        self._drawn = True
