"""Turns the theme's script into a plain one. Debian provides it as a module. Browsers block modules on pages opened as
files, and the module uses its library in a way that caused an error on every page."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

__all__ = ["plain", "setup"]

SCRIPT, LIBRARY = "scripts/furo.js", "scripts/gumshoe-patched.js"


def plain(script: str) -> str:
    """Removes the import of the library, which defines a global name if it is loaded before. Raises ValueError if
    there is no import."""
    found, count = re.subn(r'^import \* as Gumshoe from "\./gumshoe-patched\.js";\n', "", script)
    if not count:
        raise ValueError(f"{SCRIPT} of the theme does not import its library; check whether theme_scripts is still needed")
    return found


def _load_library(app: Any) -> None:
    app.add_js_file(LIBRARY, priority=199)  # the theme's has 200


def _load_plainly(_app: Any, _page: str, _template: str, context: dict[str, Any], _doctree: Any) -> None:
    for script in context["script_files"]:
        if SCRIPT in str(getattr(script, "filename", script)):
            script.attributes.pop("type", None)


def _make_plain(app: Any, error: Exception | None) -> None:
    if error is None and app.builder.format == "html":
        script = Path(app.outdir) / "_static" / SCRIPT
        script.write_text(plain(script.read_text()))


def setup(app: Any) -> dict[str, Any]:
    app.connect("builder-inited", _load_library)
    app.connect("html-page-context", _load_plainly)
    app.connect("build-finished", _make_plain)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
