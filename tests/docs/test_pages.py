"""Tests that the pages are readable as text and complete, and that their links have targets. Needs no daemon and no
build."""

import json
import re
from itertools import chain
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
CHANGELOG = ROOT / "CHANGELOG.md"  # an entry is one line with one sentence
FOLDERS_OF_PAGES = ("*.md", "client/*/*.md", "tests/*.md", "docs/*.md", "docs/developing/*.md", "docs/reference/*.md", "docs/reference/*/*.md")
WRITTEN = sorted(chain(*(ROOT.glob(pattern) for pattern in FOLDERS_OF_PAGES)))
NOTEBOOKS = sorted((ROOT / "docs" / "tutorials").glob("*.ipynb"))  # test_notebooks.py runs them
COMPUTED = sorted((ROOT / "docs" / "paper").glob("*.md"))  # by ./dev paper
LINE_LENGTH = 120  # lines are shorter
FOLDERS = ("bench", "client", "configs", "core", "docs", "engine", "packaging", "proto", "server", "tests")
GUIDES = ("CONTRIBUTING.md", "docs/architecture.md", "docs/developing/fields.md", "docs/developing/methods.md", "docs/developing/solvers.md", "tests/README.md")  # which name many
SOURCES = ("*.cpp", "*.hpp", "*.py", "*.json", "*.in", "*.txt", "*.service")


def named(pages):
    return [pytest.param(page, id=str(page.relative_to(ROOT))) for page in pages]


def prose(page):
    """Returns number and text of the lines that are neither code nor a row of a table."""
    fenced = False
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not (fenced or line.startswith(("    ", "|"))):
            yield number, line


def anchors(page):
    """Returns anchors of the headings, as on the web: lower case, hyphens for spaces, no other signs."""
    headings = [line.lstrip("#").strip().lower() for _, line in prose(page) if line.startswith("#")]
    return [re.sub(r"[^\w\- ]", "", heading).replace(" ", "-") for heading in headings]


def links(page):
    """Returns file and anchor of links within the repository, including those in tables."""
    text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    for target in re.findall(r"\]\(([^()\s]+)\)", text):
        if not re.match(r"\w+:", target):
            path, _, anchor = target.partition("#")
            yield (page.parent / path if path else page), anchor


@pytest.mark.parametrize("page", named(page for page in WRITTEN if page != CHANGELOG))
def test_lines_are_short(page):
    lines = [(number, line) for number, line in prose(page) if "://" not in line]
    assert lines
    assert not [(number, len(line)) for number, line in lines if len(line) >= LINE_LENGTH]


@pytest.mark.parametrize("page", named(WRITTEN + COMPUTED))
def test_links_lead_to_a_file_and_its_heading(page):
    for target, anchor in links(page):
        assert target.exists(), f"{target} is not there"
        assert not anchor or anchor in anchors(target), f"{target.name} has no heading #{anchor}"


@pytest.mark.parametrize("page", named(WRITTEN))
def test_no_two_headings_have_the_same_anchor(page):
    assert len(anchors(page)) == len(set(anchors(page)))


def test_every_page_is_in_a_list_of_the_index():
    index = ROOT / "docs" / "index.md"
    lists = [index, *(ROOT / "docs" / "reference").glob("*.md")]  # the reference has separate pages
    points = [page.parent / target for page in lists for target in re.findall(r"^\* \[[^\]]+\]\(([^)#]+)\)", page.read_text(), re.MULTILINE)]
    listed = {target.resolve() for target in points}
    assert len(listed) == len(points), "a page is listed once"
    missing = sorted(str(page.relative_to(ROOT)) for page in {*WRITTEN, *COMPUTED, *NOTEBOOKS} - listed - {index, ROOT / "README.md"})
    assert not missing, f"{', '.join(missing)}: add a point to a list of docs/index.md that begins with a link to it"


def test_the_readme_leads_to_the_roads():
    linked = {target.resolve() for target, _ in links(ROOT / "README.md")}
    assert {ROOT / "docs" / "index.md", ROOT / "docs" / "operations.md", ROOT / "CONTRIBUTING.md"} <= linked


def test_pages_that_sources_name_exist():
    files = list(chain(*((ROOT / folder).rglob(pattern) for folder in FOLDERS for pattern in SOURCES)))
    assert len(files) > 400
    for file in files:
        for name in re.findall(r"\bdocs/[\w/-]+\.md\b", file.read_text()):
            assert (ROOT / name).exists(), f"{file.relative_to(ROOT)} names {name}"


@pytest.mark.parametrize("page", named(page for page in WRITTEN if page != CHANGELOG))
def test_files_that_pages_name_exist(page):
    """Finds documented names by their paths, in which capitals represent any name; in guides and for C++ also by their
    names alone."""
    guide = str(page.relative_to(ROOT)) in GUIDES
    names = {re.sub("[A-Z]{4,}", "*", name) for name in re.findall(r"`([\w/.*-]+)`", page.read_text())}
    paths = {name for name in names if name.startswith(FOLDERS) and "/" in name}
    endings = "cpp|hpp|json|py|txt" if guide else "cpp|hpp"
    files = {name for name in names if re.fullmatch(rf"[\w*]+\.({endings})", name)} - {"compile_commands.json"}
    assert paths or not guide
    assert not [path for path in sorted(paths) if not list(ROOT.glob(path))]
    assert not [file for file in sorted(files) if not any(list((ROOT / folder).rglob(file)) for folder in FOLDERS)]


def test_the_page_of_the_cpp_client_states_the_problem_of_its_example():
    folder = ROOT / "client" / "cpp"

    def statements(path):
        return [line.split("//")[0].strip() for line in path.read_text().splitlines() if re.match(r" +(problem|shift)\.", line)]

    shown = statements(folder / "README.md")
    assert len(shown) > 5
    assert shown == statements(folder / "example" / "cattaneo.cpp")


def fields(schema, path=""):
    """Yields path and default of every field of a configuration."""
    for name, field in schema.get("properties", {}).items():
        if "properties" in field:
            yield from fields(field, f"{path}{name}.")
        else:
            yield path + name, field["default"]


def test_the_configuration_page_has_every_field_and_its_default():
    page = (ROOT / "docs" / "configuration.md").read_text()
    rows = dict(re.findall(r"^\| `([a-z_]\w*(?:\.\w+)*)` \| ([^|]*) \|", page, re.MULTILINE))
    defaults = dict(fields(json.loads((ROOT / "configs" / "schema.json").read_text())))
    assert rows.keys() == defaults.keys()
    del defaults["builds.environment"]  # a long list, of which the page shows the beginning
    for name, default in defaults.items():
        shown = rows[name].partition(":")[0] if default in ("", 0) else rows[name]
        word = default if isinstance(default, str) and default else json.dumps(default)
        assert shown.strip("`") == word, name
