"""Tests the parts that build the documentation site, separately. They need no build."""

from __future__ import annotations

import importlib
import re
from pathlib import Path
from types import SimpleNamespace

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture
def part(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "docs" / "website"))
    return importlib.import_module


INDEX = """# Title

* [not a road](a.md)

## Use it

* [One](one.md#there): a page; see [two](two.md).
* [Notebook](more/three.ipynb)

## No list

Words.
"""


def test_roads_are_the_headings_with_lists_and_the_first_link_of_each_point(part):
    assert list(part("roads").roads(INDEX)) == [("Use it", ["one.md", "more/three.ipynb"])]


def test_a_page_is_named_by_its_place_in_the_repository(part):
    document = part("roads").document
    assert document("docs/index", "contact.md") == "docs/contact"
    assert document("docs/index", "../client/c/README.md") == "client/c/README"


def test_a_page_that_is_listed_nowhere_is_an_error_that_says_where_to_list_it(part, tmp_path):
    from sphinx.errors import ExtensionError

    (tmp_path / "index.md").write_text(INDEX)
    app = SimpleNamespace(config=SimpleNamespace(root_doc="index"))
    environment = SimpleNamespace(
        found_docs={"index", "README", "more/three", "forgotten"},
        doc2path=lambda name, base=True: tmp_path / f"{name}.md" if base else f"{name}.md",
    )
    with pytest.raises(ExtensionError, match=r"forgotten\.md: in no list of index\.md\. Add a point there that begins with a link"):
        part("roads").check_that_every_page_is_listed(app, environment, [])


CHART = """flowchart LR
    a(["people"]) <-->|"words"| b
    subgraph s ["a box"]
        b["one<br/>two"]
        b --> c[("files")]
    end
"""


def test_a_flow_chart_becomes_nodes_and_arrows(part):
    drawn = part("mermaid").dot(CHART)
    assert 'a [label="people", shape=box, style="rounded,filled"]' in drawn
    assert 'a -> b [label="words", dir=both]' in drawn
    assert r'b [label="one\ntwo", shape=box]' in drawn
    assert 'c [label="files", shape=cylinder]' in drawn
    assert drawn.count("{") == drawn.count("}") == 2
    assert part("mermaid").arrows(CHART) == ["a to b", "b to c"]


@pytest.mark.parametrize("line", ["sequenceDiagram", "flowchart LR\n a -.-> b", "flowchart LR\n a{choice}"])
def test_what_a_flow_chart_does_not_know_is_an_error_that_names_it(part, line):
    with pytest.raises(ValueError, match=re.escape(line.splitlines()[-1].strip())):
        part("mermaid").dot(line)


HEADER = """/* The head. */
#define X

/* --- some words ------------- */
/* Of both. */
API int one(void); /* behind */
API int two(void);

API int three(void);
/* --- more ------------- */
API int four(void);
enum { A = 0, B = 1 }; /* of four */
"""


def test_comments_of_the_c_header_are_marked_for_every_declaration_that_they_stand_over(part):
    marked = part("c_header").marked(HEADER.replace("API", "CONTACTD_API"))
    assert marked.startswith("/** @file The head. */\n")
    assert "/** Of both. */\nCONTACTD_API int one(void); /**< behind */\n/** Of both. */\nCONTACTD_API int two(void);" in marked
    assert marked.count("Of both") == 2
    assert "/** of four */\nenum { A = 0, B = 1 };" in marked
    assert [*re.findall("@name (.*)", marked)] == ["Some words", "More"]
    assert marked.count("@{") == marked.count("@}") == 2


def test_no_comment_of_the_c_header_is_lost(part):
    """Uses a style that the filter does not support."""
    marked = part("c_header").marked((ROOT / "client" / "c" / "include" / "contactd.h").read_text())
    assert marked.count("@name") > 5
    assert not re.findall(r"/\*(?!\*).*", marked)


def test_a_comment_behind_the_name_of_a_group_describes_the_group(part):
    group = "/* --- words ---- */\n/* About all.\n *\n * More. */\n"
    marked = part("c_header").marked(f"/* Head. */\n{group}\n/** @brief One. */\nCONTACTD_API int one(void);\n")
    assert "/** @name Words\n * About all.\n *\n * More.\n * @{ */\n" in marked
    assert "/** @brief One. */\nCONTACTD_API int one(void);" in marked


def test_the_c_header_documents_each_parameter_and_the_answer_of_each_function():
    header = (ROOT / "client" / "c" / "include" / "contactd.h").read_text()
    functions = re.findall(r"(?:(/\*\*(?:(?!\*/).)*)\*/\n)?CONTACTD_API [^(]*?(contactd_\w+)\(([^;]*)\);", header, re.DOTALL)
    assert len(functions) > 40
    for comment, name, parameters in functions:
        assert "@brief" in comment, name
        assert "@return" in comment, name
        declared = re.findall(r"(\w+)\s*(?:,|$)", parameters.replace("void)", "")) if parameters != "void" else []
        assert re.findall(r"@param(?:\[out\])? (\w+)", comment) == declared, name


def test_the_types_that_clients_meet_are_those_that_cmake_installs(part):
    headers = part("headers").public_headers()
    assert {"contactd/client/client.hpp", "contactd/contact.hpp", "contactd/grid.hpp"} <= set(headers)
    assert "contactd/solve_wheel_rail.hpp" not in headers
    assert all(part("headers").path_of(header).exists() for header in headers)


def test_a_script_of_the_theme_that_is_another_one_is_told(part):
    plain = part("theme_scripts").plain
    assert plain('import * as Gumshoe from "./gumshoe-patched.js";\nvar header;\n') == "var header;\n"
    with pytest.raises(ValueError, match="check whether theme_scripts is still needed"):
        plain("var header;\n")


def test_kinds_of_members_have_no_anchors_of_one_name(part):
    nodes = pytest.importorskip("docutils.nodes")
    title = nodes.rubric("", "Public Functions", classes=["breathe-sectiondef-title"], ids=["breathe-section-title-public-functions"])
    other = nodes.rubric("", "Notes", ids=["notes"])
    document = nodes.container("", title, other)
    part("reference").without_names_that_are_there_twice(None, document)
    assert (title["ids"], other["ids"]) == ([], ["notes"])


STYLE = """@media not print {
  body[data-theme="dark"] {
    --color-background-primary: #131416;
    --color-api-keyword: var(--color-foreground-secondary); }
    html body[data-theme="dark"] .only-light {
      display: none !important; } }
"""


def test_dark_colours_are_those_of_the_theme(part):
    colours = part("theme_colours").dark_colours(STYLE)
    assert colours == {"color-background-primary": "#131416", "color-api-keyword": "var(--color-foreground-secondary)"}
    with pytest.raises(ValueError, match="see whether it still needs theme_colours"):
        part("theme_colours").dark_colours("body { --color-background-primary: white; }")


def test_every_module_and_header_is_on_one_page_of_the_reference(part):
    pages = [path.read_text() for path in (ROOT / "docs" / "reference").rglob("*.md")]
    assert part("reference").missing(pages) == []
    assert part("reference").missing([*pages, "<!-- headers: contactd/grid.hpp contactd/none.hpp -->\n"]) == [
        "contactd/grid.hpp",
        "contactd/none.hpp",
    ]
    assert "client" in part("reference").missing([page for page in pages if "modules: client" not in page])


def test_a_page_of_the_reference_has_what_its_last_line_names(part):
    source = ["# Grids\n\n<!-- modules: values.generated.grid -->\n"]
    part("reference").write(None, "docs/reference/python/grids", source)
    assert ".. autoclass:: Grid\n" in source[0]
    assert "<!--" not in source[0]


def test_what_is_like_an_array_has_its_name_in_signatures(part):
    nested = "~numpy._typing._nested_sequence._NestedSequence"
    types = f"frames: ~collections.abc.Buffer | ~numpy._SupportsArray[~numpy.dtype[~typing.Any]] | {nested}[x] | bool | {nested}[bool | int | str], direction: float"
    assert part("reference").named(types) == "frames: ArrayLike, direction: float"
    assert part("reference").named(None) is None
