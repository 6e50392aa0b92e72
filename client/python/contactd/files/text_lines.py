"""Converts any text to a line of a file, such as a comment."""

from __future__ import annotations

__all__ = ["one_line", "printable"]


def one_line(text: str) -> str:
    """Returns the text with line breaks, control characters and invalid UTF-8 escaped as in Python literals."""
    return "".join(character if character.isprintable() else ascii(character)[1:-1] for character in text)


def printable(text: str) -> str:
    """Returns the same for a text of several lines."""
    return text if text.isprintable() else "\n".join(map(one_line, text.split("\n")))
