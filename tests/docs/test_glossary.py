"""Tests that the glossary is sorted, that its wire names exist, and that it contains the terms that experts look
for."""

import json
import re
from pathlib import Path

import pytest

from support.contact_terms import CONTACT_TERMS
from support.field_words import everyday

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "glossary.md").read_text()
TERMS = [[cell.strip() for cell in row.split("|")] for row in re.findall(r"^\|( \*\*.+)\|$", PAGE, re.MULTILINE)]
METHODS = {path.name.removesuffix(".params.json") for path in (ROOT / "proto" / "schema").glob("*.params.json")}
PAGES = {page.name: set(re.findall(r"\w+", page.read_text().lower())) for page in (ROOT / "docs").glob("*.md")}
EXPECTED = [
    "dissimilar", "stopping criterion", "massless flexible rail", "third body", "Dirichlet", "small strain", "quasi-static",
    "linear elasticity", "outer (Panagiotopoulos) iterations", "tangent stiffness", "simplified contact models",
    "falling friction", "creepage", "rigid slip", "creep force", "adhesion", "slip area", "potential contact area",
    "influence coefficients", "FASTSIM", "NORM", "TANG", "KPEC", "ANALYN", "modified FASTSIM",
]  # fmt: skip


def words_of_the_wire():
    """Returns names and values that the schemas declare."""
    found = set()

    def visit(schema):
        if isinstance(schema, dict):
            found.update(schema.get("properties", {}))
            found.update(word for word in schema.get("enum", []) if isinstance(word, str))
            for part in schema.values():
                visit(part)
        elif isinstance(schema, list):
            for part in schema:
                visit(part)

    for path in (ROOT / "proto" / "schema").glob("*.json"):
        visit(json.loads(path.read_text()))
    return found


def test_terms_are_sorted_and_have_a_sentence():
    names = [re.findall(r"\*\*(.+?)\*\*", cells[0])[0].lower() for cells in TERMS]
    assert len(names) > 100
    assert names == sorted(set(names))
    assert not [cells for cells in TERMS if not cells[2].endswith(".")]


def test_names_of_the_wire_are_those_of_the_schemas():
    known = words_of_the_wire() | {"session", "*"} | {part for method in METHODS for part in method.split(".")}
    names = {name for cells in TERMS for name in re.findall(r"`([^`]+)`", cells[1])}
    assert len(names) > 60
    unknown = {name for name in names for part in name.split(".") if part and not part.isdigit() and part not in known}
    assert not unknown - {"ics.source", "state.rail"}, unknown


@pytest.mark.parametrize("term", EXPECTED)
def test_a_term_of_the_field_has_an_entry(term):
    assert any(term.lower() in cells[0].replace("*", "").lower() for cells in TERMS)


@pytest.mark.parametrize("term", CONTACT_TERMS)
def test_a_term_of_contact_is_on_a_page(term):
    """The site's search requires it (test_site.py)."""
    words = set(re.findall(r"\w+", term.lower()))
    assert any(words <= on_page for on_page in PAGES.values())


#: Excludes the changelog, whose released entries do not change.
WRITTEN_HERE = [page for folder in ("", "docs/", "docs/developing/", "docs/paper/", "client/*/") for page in ROOT.glob(f"{folder}*.md") if page.name != "CHANGELOG.md"]
#: Expressions that pages quote, with reasons.
NAMED = {
    "CONTRIBUTING.md": ["bodies that differ"],  # an example of a forbidden expression
    "wheel-rail.md": ["bears? (?:its|their) force"],  # a warning
}


@pytest.mark.parametrize("page", WRITTEN_HERE, ids=lambda page: str(page.relative_to(ROOT)))
def test_pages_have_the_words_of_the_field(page):
    """Excludes code, and text that ./dev docs writes from the schemas."""
    text = page.read_text().partition("<!-- The rest is written by ./dev docs")[0]
    text = re.sub(r"^```.*?^```|`[^`\n]*`", "", text, flags=re.MULTILINE | re.DOTALL)
    found = everyday(text)
    assert not set(found) - set(NAMED.get(page.name, [])), found
