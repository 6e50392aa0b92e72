"""Text that goes into a line of a file, such as a comment, whatever it holds."""

from __future__ import annotations

__all__ = ["one_line", "printable"]


def one_line(text: str) -> str:
    """The text with what ends lines, what terminals obey, and what is no character in UTF-8 as Python writes it in literals."""
    return "".join(character if character.isprintable() else ascii(character)[1:-1] for character in text)


def printable(text: str) -> str:
    """The same of a text of several lines."""
    return text if text.isprintable() else "\n".join(map(one_line, text.split("\n")))
