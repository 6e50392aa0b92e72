"""The modules of client/python/examples/wheelset, which are no package: a program's."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest

EXAMPLE = Path(__file__).parents[2] / "client" / "python" / "examples" / "wheelset"
NAMES = ("vehicle", "track", "runge_kutta", "contact", "stability", "runs")


@pytest.fixture
def wheelset(monkeypatch: pytest.MonkeyPatch) -> Iterator[SimpleNamespace]:
    """Its modules by their names; `module` imports one more."""
    monkeypatch.syspath_prepend(EXAMPLE)
    before = set(sys.modules)
    yield SimpleNamespace({name: importlib.import_module(name) for name in NAMES}, module=importlib.import_module)
    for name in {*NAMES, "multibody", "pictures"} - before:
        sys.modules.pop(name, None)
