"""Tests verdicts in the text of a page, and the requirements on all sections."""

import re
from pathlib import Path

import pytest

import paper
from paper.__main__ import SECTIONS
from paper.page import DOUBT, fill


def test_a_verdict_is_the_computed_one():
    text, surprises = fill("[[agrees a]] x {{n}} [[differs b]]", {"n": "3"}, {"a": True, "b": False})
    assert (text, surprises) == ("**Agrees.** x 3 **Differs.**", [])


def test_a_verdict_that_the_text_was_not_written_for_is_marked():
    text, surprises = fill("[[agrees a]]", {}, {"a": False})
    assert text == f"**Differs.** {DOUBT}"
    assert surprises == ["a"]


def test_a_question_is_answered_with_yes_or_no():
    assert fill("[[yes a]] [[no b]]", {}, {"a": True, "b": False}) == ("**Yes.** **No.**", [])
    assert fill("[[yes a]]", {}, {"a": False})[0].startswith("**No.**")


def test_sections_do_not_write_each_others_files():
    names = [name for section in SECTIONS.values() for name in (section.name, *section.parts)]
    names += [table.name for section in SECTIONS.values() for table in section.tables.values()]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("name", SECTIONS)
def test_every_section_has_a_page_to_fill(name):
    text = Path(paper.__file__).with_name(f"{name}.md.in").read_text()
    assert "{{version}}" in text
    assert re.search(r"\[\[(agrees|differs|yes|no) \w+\]\]", text)
