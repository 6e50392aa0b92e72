"""Applies the theme's dark colours on systems in dark mode. In Debian's style sheet only the button selects them: a
page that follows the system stays light, except for its code."""

from __future__ import annotations

import re
from pathlib import Path

__all__ = ["dark_colours", "of_the_theme"]

#: The theme's style sheet includes the basic one of Sphinx, which its package locates.
STYLE = "theme/furo/static/styles/furo.css"


def dark_colours(style: str) -> dict[str, str]:
    """Returns names, without their hyphens, and values. Raises ValueError if the style sheet has none."""
    block = re.search(r'body\[data-theme="dark"\] \{([^}]*--color[^}]*)\}', style)
    colours = dict(re.findall(r"--([\w-]+):\s*([^;]+);", block[1])) if block else {}
    if "color-background-primary" not in colours:
        raise ValueError(f"{STYLE} has its dark colours elsewhere; see whether it still needs theme_colours")
    return colours


def of_the_theme() -> dict[str, str]:
    import furo

    return dark_colours((Path(furo.__file__).parent / STYLE).read_text())
