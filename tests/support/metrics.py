"""Reads metrics over the wire, and in the form for Prometheus."""

from __future__ import annotations

import re
from typing import Any

from contactd import Client

SAMPLE = re.compile(r'([a-z_]+)(?:\{((?:[a-z_]+="[^"]*",?)*)\})? (\S+)')


def metric(client: Client, name: str, **labels: str) -> float:
    """Returns the value of one sample of server.metrics, or zero if there is none with these labels."""
    for family in client.metrics():
        if family["name"] == name:
            return next((float(s["value"]) for s in family["samples"] if s["labels"] == labels), 0.0)
    raise AssertionError(f"no metric {name}")


def parse(page: str) -> dict[str, dict[str, Any]]:
    """Parses the text format of Prometheus: name -> type, help and samples (labels -> value). Fails for any other text."""
    families: dict[str, dict[str, Any]] = {}
    for line in page.splitlines():
        if line.startswith("# HELP "):
            name, words = line[7:].split(" ", 1)
            families[name] = {"help": words, "samples": {}}
        elif line.startswith("# TYPE "):
            name, kind = line[7:].split(" ")
            families[name]["type"] = kind
        else:
            found = SAMPLE.fullmatch(line)
            assert found, f"no sample: {line}"
            name, labels, value = found.groups()
            family = families.get(name) or families[re.sub("_(bucket|count|sum)$", "", name)]
            family["samples"][name, labels or ""] = float(value)
    return families
