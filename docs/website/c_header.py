"""A filter of doxygen: contactd.h has ordinary comments, for those who read it; doxygen wants them marked.

    c_header.py FILE

* ``/* --- words --- */`` begins a group of that name.
* What stands above declarations belongs to all of them, up to a blank line or the next comment.
* What stands behind one belongs to it. Of an enum in one line it is put above, where doxygen takes it.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator

GROUP = re.compile(r"/\* --- (.*?) -+ \*/")
COMMENT = re.compile(r"/\*(.*?)\*/", re.DOTALL)


def marked(header: str) -> str:
    head, _, rest = header.partition("*/\n")
    return "".join([head.replace("/*", "/** @file", 1), "*/\n", *_parts(rest)])


def _parts(text: str) -> Iterator[str]:
    """Line by line, a comment of several lines at once."""
    above, opened = "", False
    for part in re.split(r"(?m)(^/\*.*?\*/\n)", text, flags=re.DOTALL):
        if group := GROUP.match(part):
            yield "/** @} */\n" if opened else ""
            yield f"/** @name {group[1].capitalize()}\n * @{{ */\n"
            above, opened = "", True
        elif part.startswith("/*"):
            above = part.replace("/*", "/**", 1)
        else:
            yield _documented(part, above)
            above = ""
    yield "/** @} */\n" if opened else ""


def _documented(code: str, above: str) -> str:
    """`above` before each of the statements that it stands over, and the comments behind them marked."""
    code = re.sub(r"(?m)^(enum \{.*\};) +/\*(.*?)\*/$", r"/**\2*/\n\1", code)
    over, blank, rest = code.partition("\n\n")
    if above:
        over = re.sub(r"(?m)^(?=CONTACTD_API|enum|typedef)", lambda _: above, over)
    return re.sub(r"(?<=\S)( +)/\*(?!\*)", r"\1/**<", over) + blank + re.sub(r"(?<=\S)( +)/\*(?!\*)", r"\1/**<", rest)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        sys.stdout.write(marked(file.read()))
