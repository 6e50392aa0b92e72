"""Fills numbers and verdicts from the rows of the CSV files into the page's template, bench/paper/<section>.md.in.

{{name}} is a number or a text of the section's findings. [[agrees name]] or [[differs name]] is the expected verdict
of a finding, and is replaced by the actual one ([[yes name]] and [[no name]] likewise). If the two differ, the text
next to it was written for another outcome, and the page reports that.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from .finding import Rows
from .section import Section

WORDS = {"agrees": True, "differs": False, "yes": True, "no": False}
DOUBT = "*(These numbers contradict the text next to them.)*"


def render(section: Section, rows: Rows, version: str) -> tuple[str, list[str]]:
    """Returns the page, and the names of the verdicts that contradict its template."""
    values, verdicts = section.find(rows)
    template = Path(__file__).with_name(f"{section.name}.md.in").read_text()
    return fill(template, {**values, "version": version}, verdicts)


def fill(template: str, values: Mapping[str, str], verdicts: Mapping[str, bool]) -> tuple[str, list[str]]:
    surprises: list[str] = []

    def verdict(match: re.Match[str]) -> str:
        word, name = match.groups()
        if verdicts[name] == WORDS[word]:
            return f"**{word.capitalize()}.**"
        word = {"agrees": "differs", "differs": "agrees", "yes": "no", "no": "yes"}[word]
        surprises.append(name)
        return f"**{word.capitalize()}.** {DOUBT}"

    text = re.sub(r"\[\[(agrees|differs|yes|no) (\w+)\]\]", verdict, template)
    text = re.sub(r"\{\{(\w+)\}\}", lambda match: values[match.group(1)], text)
    return text, surprises
