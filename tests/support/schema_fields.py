"""Returns the names of all fields that the schemas declare."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

SCHEMAS = Path(__file__).parents[2] / "proto" / "schema"


def declared(node: Any) -> set[str]:
    """Returns the names of all fields in a document."""
    if isinstance(node, list):
        return set().union(*map(declared, node))
    if not isinstance(node, dict):
        return set()
    own = node.get("properties")
    return (set(own) if isinstance(own, dict) else set()).union(*map(declared, node.values()))


FIELDS = set().union(*(declared(json.loads(path.read_text())) for path in SCHEMAS.glob("*.json")))
