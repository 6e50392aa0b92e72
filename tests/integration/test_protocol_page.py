"""Tests that docs/protocol.md agrees with the schemas."""

import importlib.util
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"


def test_the_reference_is_the_one_that_the_schemas_make(shared):
    specification = importlib.util.spec_from_file_location("protocol_reference", DOCS / "protocol_reference.py")
    reference = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(reference)
    current = (DOCS / "protocol.md").read_text()
    assert reference.page(shared.describe(), current) == current, "run ./dev docs"
