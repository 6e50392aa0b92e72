"""Filters contactd.h for doxygen: marks its ordinary comments as documentation.

    c_header.py FILE

* ``/* --- words --- */`` begins a group of that name. A comment after it, followed by a blank line, describes the
* group. * A comment above declarations belongs to all of them, up to a blank line or the next comment. * A comment
* after a declaration belongs to it. For an enum in one line it is moved above, as doxygen requires.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator

GROUP = re.compile(r"(?m)^/\* --- (.*?) -+ \*/\n(?:/\*(?!\*)((?:(?!\*/).)*)\*/\n(?=\n))?", re.DOTALL)


def marked(header: str) -> str:
    head, _, rest = header.partition("*/\n")
    return "".join([head.replace("/*", "/** @file", 1), "*/\n", *_parts(GROUP.sub(_group, rest))])


def _group(found: re.Match[str]) -> str:
    description = f" *{found[2].rstrip()}\n" if found[2] else ""
    return f"/** @name {found[1].capitalize()}\n{description} * @{{ */\n"


def _parts(text: str) -> Iterator[str]:
    """Yields code, and each comment that begins a line."""
    above, opened = "", False
    for part in re.split(r"(?m)(^/\*.*?\*/\n)", text, flags=re.DOTALL):
        if part.startswith("/** @name"):
            yield "/** @} */\n" if opened else ""
            yield part
            above, opened = "", True
        elif part.startswith("/*"):
            above = part if part.startswith("/**") else part.replace("/*", "/**", 1)
        else:
            yield _documented(part, above)
            above = ""
    yield "/** @} */\n" if opened else ""


def _documented(code: str, above: str) -> str:
    """Returns the code with `above` before each of its declarations, and with marked comments after them."""
    code = re.sub(r"(?m)^(enum \{.*\};) +/\*(.*?)\*/$", r"/**\2*/\n\1", code)
    over, blank, rest = code.partition("\n\n")
    if above:
        over = re.sub(r"(?m)^(?=CONTACTD_API|enum|typedef)", lambda _: above, over)
    return re.sub(r"(?<=\S)( +)/\*(?!\*)", r"\1/**<", over) + blank + re.sub(r"(?<=\S)( +)/\*(?!\*)", r"\1/**<", rest)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        sys.stdout.write(marked(file.read()))
