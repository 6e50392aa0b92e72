"""Tests that the documentation site builds without a warning and is complete. This is slow, because it builds the
site."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest
from sphinx.search.en import SearchEnglish

import contactd
from support.browser import Browser
from support.contact_terms import CONTACT_TERMS
from support.daemons import BIN, eventually

from .site_pages import Site, code_colours, contrast, luminance

ROOT = Path(__file__).parents[2]
READABLE = 4.5  # WCAG 2, level AA

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]  # builds the site with its notebooks


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Site:
    folder = tmp_path_factory.mktemp("site") / "docs"
    command = [sys.executable, str(ROOT / "docs" / "website"), "--bin", str(BIN), "--output", str(folder)]
    built = subprocess.run(command, env=os.environ, capture_output=True, text=True)
    assert built.returncode == 0, built.stderr + built.stdout
    assert "WARNING" not in built.stderr
    return Site(folder)


def test_every_page_of_the_index_is_there(site):
    index = (ROOT / "docs" / "index.md").read_text()
    listed = re.findall(r"^\* \[[^\]]+\]\(([^)#]+)\)", index, re.MULTILINE)
    assert len(listed) > 25
    for page in listed:
        assert (site.folder / "docs" / page).resolve().with_suffix(".html") in site.pages, page


def test_links_lead_somewhere_without_a_network(site):
    assert not site.broken()
    assert sum(len(page.links) for page in site.pages.values()) > 5000


def test_nothing_is_loaded_from_the_network(site):
    loaded = {source for page in site.pages.values() for source in page.loaded}
    assert not [source for source in loaded if re.match(r"(\w+:)?//", source)]
    for file in site.folder.rglob("*.css"):
        assert not re.findall(r"(?:url\(|@import)\s*[\"']?(?:https?:)?//", file.read_text()), file


def test_scripts_run_in_pages_that_are_opened_as_files(site):
    for path in site.pages:
        assert 'type="module"' not in path.read_text(), path
    scripts = [site.folder / "_static" / "scripts" / name for name in ("gumshoe-patched.js", "furo.js")]
    assert not [script for script in scripts if re.search(r"^(import|export) ", script.read_text(), re.MULTILINE)]
    loaded = [Path(source.partition("?")[0]).name for source in site.pages[site.folder / "README.html"].loaded]
    assert loaded.index("gumshoe-patched.js") < loaded.index("furo.js")


def test_every_page_has_a_language_a_title_of_its_own_and_one_heading(site):
    pages = list(site.documents())
    assert {page.language for page in pages} == {"en"}
    titles = [page.titles[0] for page in pages if page.path.stem != "README" or page.path.parent != site.folder]
    assert len(set(titles)) == len(titles)
    assert not [page.path for page in pages if len(page.headings) != 1]


def test_no_page_has_an_anchor_twice(site):
    assert not [page.path for page in site.documents() if len(page.ids) > len(set(page.ids))]


def test_every_picture_has_words_in_its_place(site):
    images = [image for page in site.documents() for image in page.images]
    assert len(images) > 20
    assert not [source for source, words in images if len(words) < 5]


def test_notebooks_are_shown_with_their_pictures(site):
    for name, pictures in (("wheelset", 3), ("layer", 2)):
        page = site.pages[site.folder / "docs" / "tutorials" / f"{name}.html"]
        assert len(page.images) == pictures


def test_every_public_name_of_python_c_and_cpp_is_in_the_reference(site):
    inventory = (site.folder / "objects.inv").read_bytes().split(b"\n", 4)[4]
    names = {line.split(" ")[0] for line in zlib.decompress(inventory).decode().splitlines()}
    assert not {f"contactd.{name}" for name in contactd.__all__ if name != "__version__"} - names
    header = (ROOT / "client" / "c" / "include" / "contactd.h").read_text()
    functions = set(re.findall(r"^CONTACTD_API [^(]*?(contactd_\w+)\(", header, re.MULTILINE))
    words = set(re.findall(r"\b(CONTACTD_\w+) = \d", header))
    assert len(functions) > 40 and len(words) > 20
    assert not functions - names
    assert not words - {name.rpartition(".")[2] for name in names}  # anchors of enums without a name
    structs = re.findall(r"^(?:struct|class) (\w+) (?:final )?[:{]", _headers_of_types(), re.MULTILINE)
    assert len(structs) > 60
    assert not {"contactd::client::Client::solve", *(f"contactd::{name}" for name in structs)} - names


def _headers_of_types() -> str:
    names = re.findall(r"include/(contactd/\w+\.hpp)", (ROOT / "core" / "CMakeLists.txt").read_text())
    return "\n".join((ROOT / "core" / "include" / name).read_text() for name in names)


def test_the_wire_is_there_as_files(site):
    schemas = {path.name for path in (ROOT / "proto" / "schema").glob("*.json")}
    assert {path.name for path in (site.folder / "schema").iterdir()} == schemas
    methods = {method["name"] for method in json.loads((site.folder / "openrpc.json").read_text())["methods"]}
    assert {f"{name}.params.json" for name in methods} <= schemas


@pytest.fixture(scope="module")
def pages_with(site: Site) -> Callable[[str], set[str]]:
    """Returns the pages that the site's search finds for a stem."""
    index = json.loads((site.folder / "searchindex.js").read_text().removeprefix("Search.setIndex(").removesuffix(")"))

    def pages(stem: str) -> set[str]:
        found = [index[kind].get(stem, []) for kind in ("terms", "titleterms")]
        return {index["docnames"][number] for numbers in found for number in (numbers if isinstance(numbers, list) else [numbers])}

    return pages


def test_the_search_knows_words_of_pages_headers_and_docstrings(pages_with):
    assert {"docs/profiles", "docs/wheel-rail", "docs/tutorials/wheelset", "docs/reference/python/wheel-rail"} <= pages_with("conic")
    assert "docs/architecture" in pages_with("cholmod")
    assert {"docs/reference/c", "docs/reference/cpp/client", "docs/reference/python/clients"} <= pages_with("cancel")
    assert not pages_with("unobtainium")


def test_the_search_finds_the_terms_of_contact(pages_with):
    """Searches for pages of the manual that contain all of the typed words."""
    english = SearchEnglish({})

    def is_found(term: str) -> bool:
        words = [word for word in english.split(term.lower()) if word not in english.stopwords]
        return any(page.startswith("docs/") for page in set.intersection(*(pages_with(english.stem(word)) for word in words)))

    assert not [term for term in CONTACT_TERMS if not is_found(term)]


@pytest.mark.parametrize("selector", [".highlight", 'body[data-theme="dark"] .highlight'], ids=["light", "dark"])
def test_letters_of_code_stand_out(site, selector):
    ground, letters = code_colours((site.folder / "_static" / "pygments.css").read_text(), selector)
    assert len(letters) > 30
    assert min(contrast(letter, ground) for letter in letters) >= READABLE


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_letters_of_the_pages_stand_out(site, theme):
    style = (site.folder / "_static" / "styles" / "furo.css").read_text()
    light, _, dark = style.partition('body[data-theme="dark"] {')
    block = dark.partition("}")[0] if theme == "dark" else light
    colours = dict(re.findall(r"--color-([\w-]+): ?(#[0-9a-f]+|white|black)\b", block))
    letters = ("foreground-primary", "foreground-secondary", "foreground-muted", "brand-primary", "brand-content", "problematic")
    grounds = ("background-primary", "background-secondary")
    pairs = {(letter, ground): contrast(colours[letter], colours[ground]) for letter in letters for ground in grounds}
    assert min(pairs.values()) >= READABLE, pairs


def test_the_version_is_in_sight_and_in_titles(site):
    found = re.search(r"^project\(contactd VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
    assert found
    for page in site.documents():
        assert f'<span class="sidebar-brand-text">contactd {found[1]}</span>' in page.path.read_text(), page.path
        assert page.titles[0].endswith(f"contactd {found[1]}"), page.path


def test_no_page_is_as_long_as_the_whole_reference(site):
    """Limits the bytes of a page; with all of Python, or of C++, on one page it was ten times as large."""
    assert not [page.path for page in site.documents() if page.path.stat().st_size > 700_000]


def _open(browser: Browser, page: Path) -> None:
    browser.open(page.as_uri())
    here = json.dumps(page.as_uri())
    eventually(lambda: browser.evaluate(f"document.readyState == 'complete' && location.href == {here}"))


def _colours(browser: Browser, selector: str) -> tuple[str, str]:
    """Returns background and text colours, as #rrggbb."""
    style = f"getComputedStyle(document.querySelector({json.dumps(selector)}))"
    found = browser.evaluate(f"[{style}.backgroundColor, {style}.color]")
    ground, letters = (
        f"#{''.join(f'{int(part):02x}' for part in re.findall(r'[0-9]+', colour)[:3])}" for colour in found
    )
    return ground, letters


def test_pages_are_dark_where_the_system_is(site, tmp_path):
    with Browser(tmp_path) as browser:
        browser.open("about:blank")
        for scheme in ("light", "dark"):
            browser.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for name in ("docs/index", "docs/cookbook", "docs/reference/python/problems"):
                _open(browser, site.folder / f"{name}.html")
                for selector in ("body", ".sidebar-drawer", "div.highlight"):
                    ground, letters = _colours(browser, selector)
                    assert (luminance(ground) < 0.1) == (scheme == "dark"), (scheme, name, selector, ground)
                    assert contrast(ground, letters) >= READABLE, (scheme, name, selector)
        assert browser.problems == []


def test_every_block_of_code_has_a_button_that_copies_it(site, tmp_path):
    with Browser(tmp_path) as browser:
        _open(browser, site.folder / "docs" / "cookbook.html")
        assert browser.evaluate("document.querySelectorAll('div.highlight > .copy-code').length") == len(
            re.findall('<div class="highlight">', (site.folder / "docs" / "cookbook.html").read_text())
        )
        shell = "document.createElement('pre')"
        lines = "$ contactctl info\\nthe answer\\n$ contactctl health\\n"
        assert (
            browser.evaluate(f"copied(Object.assign({shell}, {{textContent: '{lines}'}}))")
            == "contactctl info\ncontactctl health"
        )
        browser.click(".copy-code")
        browser.wait_for("Copied", ".copy-code")
        assert browser.problems == []


def test_no_page_is_cut_off_at_its_right_or_light_in_the_dark_and_every_picture_is_there(site, tmp_path):
    look = """({
        cut: document.documentElement.scrollWidth - document.documentElement.clientWidth,
        missing: [...document.images].filter(image => image.naturalWidth == 0).map(image => image.src),
    })"""
    with Browser(tmp_path) as browser:
        for page in site.documents():
            _open(browser, page.path)
            for width in (390, 1100, 1330, 1700):  # width of a phone; above it, the contents of page and site appear
                browser.resize(width, 900)
                assert browser.evaluate(look) == {"cut": 0, "missing": []}, (page.path, width)
            browser.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
            assert luminance(_colours(browser, "body")[0]) < 0.1, page.path
            browser.send("Emulation.setEmulatedMedia", features=[])
        assert browser.problems == []
