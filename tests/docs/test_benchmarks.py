"""docs/benchmarks.md collects figures of other pages, which programs write: they are the same there."""

import re
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "benchmarks.md").read_text()


@pytest.mark.parametrize(
    ("page", "stated", "collected"),
    [
        ("validation", r"Of (\d+) cases that are computed (\d+) agree and (\d+) differ",
         r"(\d+) of its public cases \| (\d+) agree within printing tolerances, (\d+) differ"),
        ("validation", r"contactd takes (1/[\d.]+) of the printed time", r"\[(1/[\d.]+)\]\(validation.md#by-family\)"),
        ("validation", r"For (\d+) of them no independent result", r"\* For (\d+) of the cases that differ"),
    ],
    ids=["cases", "times", "undecided"],
)  # fmt: skip
def test_figures_are_those_of_the_page_that_they_are_from(page, stated, collected):
    on_page, here = re.search(stated, (DOCS / f"{page}.md").read_text()), re.search(collected, PAGE)
    assert on_page is not None
    assert here is not None
    assert here.groups() == on_page.groups()
