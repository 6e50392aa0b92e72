"""Configures the documentation site. It contains all pages of the repository at their own paths, so that their links
also hold here.

    ./dev docs           (python3 docs/website --bin build/development/bin)

CONTACTD_SITE_WORK is the folder in which __main__.py has put doxygen's output and the files next to the pages.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
WORK = Path(os.environ["CONTACTD_SITE_WORK"])
sys.path.insert(0, str(FOLDER))

from theme_colours import of_the_theme  # noqa: E402  beside this file

project = "contactd"
version = release = re.findall(
    r"^project\(contactd VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE
)[0]
copyright = ""
html_show_copyright = html_show_sphinx = False

extensions = [
    "myst_nb", "breathe", "sphinx.ext.autodoc", "sphinx.ext.graphviz", "sphinx.ext.napoleon", "roads", "mermaid", "reference",
    "theme_scripts",
]  # fmt: skip
root_doc = "docs/index"
include_patterns = [
    "*.md", "docs/*.md", "docs/developing/*.md", "docs/paper/*.md", "docs/reference/*.md", "docs/reference/*/*.md",
    "docs/tutorials/*.ipynb", "client/*/README.md", "tests/README.md",
]  # fmt: skip
exclude_patterns = ["build", ".git", "**/.*"]
suppress_warnings: list[str] = []  # none: warnings are errors

# Pages.
myst_heading_anchors = 4
myst_fence_as_directive = ["mermaid"]
default_role = "literal"  # of `names` in docstrings
highlight_language = "none"  # of code without a language

# Notebooks.
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_ipywidgets_js: dict[str, str] = {}  # nothing from the network
nb_merge_streams = True

# Python.
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_class_signature = "separated"
# Methods of values are inherited; methods of the classes named here are well known.
_ORDINARY = "Exception, dict, tuple, object, Generic, Protocol"
autodoc_default_options = {"members": True, "show-inheritance": True, "inherited-members": _ORDINARY}
napoleon_numpy_docstring = False
napoleon_use_ivar = True
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 100

# C and C++.
breathe_projects = {"c": str(WORK / "c/xml"), "cpp": str(WORK / "cpp/xml")}
breathe_default_project = "cpp"
breathe_domain_by_extension = {"h": "c", "hpp": "cpp"}
breathe_show_include = False
breathe_show_enumvalue_initializer = True
c_id_attributes = ["CONTACTD_API"]
cpp_maximum_signature_line_length = c_maximum_signature_line_length = 100

# HTML.
html_theme = "furo"
pygments_style, pygments_dark_style = "default", "github-dark"  # provides sufficient contrast for letters
html_title = f"contactd {version}"
html_short_title = "contactd"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = ["copy.js"]
templates_path = ["templates"]
html_additional_pages = {"index": "redirect.html"}
html_extra_path = [str(WORK / "beside")]
html_copy_source = False
html_theme_options = {"sidebar_hide_name": False, "dark_css_variables": of_the_theme()}
graphviz_output_format = "svg"


def shorten_classes(app: object, page: str, template: str, context: dict[str, object], doctree: object) -> None:
    """Reduces the classes of literal text to the one that the theme formats."""
    if isinstance(body := context.get("body"), str):
        context["body"] = body.replace('class="docutils literal notranslate"', 'class="literal"')


def setup(app: Any) -> None:
    app.connect("html-page-context", shorten_classes)
