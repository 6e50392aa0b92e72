"""Tests that the paper's bibliography contains all cited entries, that each entry states its publication, and that the
page on citing agrees."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).parents[2]
PAPER = (ROOT / "paper" / "paper.md").read_text()
ENTRIES = {key: (kind, body) for kind, key, body in re.findall(r"^@(\w+)\{(\w+),\n(.*?)^\}", (ROOT / "paper" / "paper.bib").read_text(), re.MULTILINE | re.DOTALL)}
#: Kind of entry: its required fields.
FIELDS = {
    "article": {"author", "title", "journal", "volume", "pages", "doi", "year"},
    "book": {"author", "title", "publisher", "address", "year"},
    "techreport": {"author", "title", "institution", "number", "year"},
    "software": {"author", "title", "version"},
}


def test_what_is_cited_is_there_and_what_is_there_is_cited():
    assert set(re.findall(r"@([a-z]+\d*)\b", PAPER.partition("---\n\n")[2])) == ENTRIES.keys()


@pytest.mark.parametrize("key", ENTRIES)
def test_an_entry_says_where_it_appeared(key):
    kind, body = ENTRIES[key]
    assert set(re.findall(r"^  (\w+) *=", body, re.MULTILINE)) >= FIELDS[kind]


def test_the_page_on_citing_names_the_works_of_the_bibliography():
    page = (ROOT / "docs" / "cite.md").read_text()
    for key in ("zhao2015", "kalker1990", "kalker1982", "johnson1985", "mfem"):
        _, body = ENTRIES[key]
        (title,) = re.findall(r"^  title *= \{(.*)\},", body, re.MULTILINE)
        assert re.sub("[{}]", "", title) in page
        (year,) = re.findall(r"^  year *= \{(\d+)\}", body, re.MULTILINE)
        assert year in page


def test_the_citation_file_can_be_read_and_names_the_method():
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    assert {"cff-version", "message", "title", "authors", "version", "license"} <= cited.keys()
    (method,) = cited["references"]
    assert [author["family-names"] for author in method["authors"]] == ["Zhao", "Vollebregt", "Oosterlee"]
    assert method["number"] in ENTRIES["zhao2015"][1]
