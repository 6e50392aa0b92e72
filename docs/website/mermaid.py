"""Draws the Mermaid flow charts of pages with Graphviz. Code-hosting pages draw them directly. Only the features that
docs/operations.md uses are supported; anything else is an error. Charts are drawn from top to bottom regardless of
their direction, because pages are narrow.

    flowchart LR
    subgraph name ["title"]           end
    name["box"]   name(["stadium"])   name[("store")]
    a --> b       a -->|"label"| b    a <-->|"label"| b
"""

from __future__ import annotations

import re
from typing import Any

from docutils import nodes
from docutils.parsers.rst import Directive

SHAPES = {"([": 'shape=box, style="rounded,filled"', "[(": "shape=cylinder", "[": "shape=box"}
NODE = r'(\w+)(?:(\(\[|\[\(|\[)"([^"]*)"(?:\]\)|\)\]|\]))?'
ARROW = re.compile(rf'{NODE} (<?)-->(?:\|"([^"]*)"\|)? {NODE}')
GROUP = re.compile(r'subgraph (\w+) \["([^"]*)"\]')


def dot(chart: str) -> str:
    """Returns the chart in Graphviz's language. Raises ValueError naming a line that is not understood."""
    first, *lines = [line.strip() for line in chart.strip().splitlines()]
    if first not in ("flowchart LR", "flowchart TB"):
        raise ValueError(f"'{first}' is not 'flowchart LR' or 'flowchart TB'")
    found = [
        'digraph { rankdir=TB; bgcolor=transparent; fontname="sans-serif"; fontsize=11; compound=true; nodesep=0.35',
        'node [fontname="sans-serif", fontsize=10, style=filled, fillcolor="#f2f5f9", color="#50617a"]',
        'edge [fontname="sans-serif", fontsize=9, color="#50617a"]',
    ]
    for line in filter(None, lines):
        found += statements(line)
    return "\n".join([*found, "}"])


def statements(line: str) -> list[str]:
    if line == "end":
        return ["}"]
    if group := GROUP.fullmatch(line):
        return [f'subgraph cluster_{group[1]} {{ label="{group[2]}"; color="#50617a"; style=rounded']
    if arrow := ARROW.fullmatch(line):
        start, shape, text, both, label, end, end_shape, end_text = arrow.groups()
        ends = [drawn(start, shape, text), drawn(end, end_shape, end_text)]
        style = f'label="{broken(label or "")}"' + (", dir=both" if both else "")
        return [*filter(None, ends), f"{start} -> {end} [{style}]"]
    if node := re.fullmatch(NODE, line):
        return [drawn(*node.groups())]
    raise ValueError(f"docs/website/mermaid.py cannot draw '{line}'")


def drawn(name: str, shape: str | None, text: str | None) -> str:
    return f'{name} [label="{(text or name).replace("<br/>", chr(92) + "n")}", {SHAPES[shape]}]' if shape else ""


def broken(label: str) -> str:
    """Wraps text to lines of about twenty characters."""
    return re.sub(r"(.{14,}?) ", r"\1\\n", label)


class Mermaid(Directive):
    has_content = True

    def run(self) -> list[nodes.Node]:
        from sphinx.ext.graphviz import graphviz

        try:
            code = dot("\n".join(self.content))
        except ValueError as error:
            raise self.error(str(error)) from error
        chart = graphviz()
        chart["code"], chart["options"] = code, {}
        chart["alt"] = "A flow chart: " + "; ".join(arrows("\n".join(self.content)))
        return [nodes.container("", chart, classes=["chart"])]


def arrows(chart: str) -> list[str]:
    """Returns the text of the chart, for readers who cannot see it."""
    return [f"{found[1]} to {found[6]}" for found in map(ARROW.search, chart.splitlines()) if found]


def setup(app: Any) -> dict[str, Any]:
    app.setup_extension("sphinx.ext.graphviz")
    app.add_directive("mermaid", Mermaid)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
