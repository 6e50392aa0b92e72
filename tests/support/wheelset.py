"""Imports the modules of client/python/examples/wheelset and bogie, which are not packages, and the package that they
share."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest

EXAMPLES = Path(__file__).parents[2] / "client" / "python" / "examples"
EXAMPLE, BOGIE = EXAMPLES / "wheelset", EXAMPLES / "bogie"
RAILWAY = ("motion", "track", "wheels")
NAMES = ("vehicle", "runge_kutta", "contact", "runs")
BOGIE_NAMES = ("vehicle", "line", "equations", "rolling", "runs", "energy")


@pytest.fixture
def wheelset(monkeypatch: pytest.MonkeyPatch) -> Iterator[SimpleNamespace]:
    """Yields modules by their names; `module` imports one more."""
    yield from _modules(monkeypatch, EXAMPLE, NAMES)


@pytest.fixture
def bogie(monkeypatch: pytest.MonkeyPatch) -> Iterator[SimpleNamespace]:
    """Does the same as `wheelset` for the bogie."""
    yield from _modules(monkeypatch, BOGIE, BOGIE_NAMES)


def _modules(monkeypatch: pytest.MonkeyPatch, folder: Path, names: tuple[str, ...]) -> Iterator[SimpleNamespace]:
    monkeypatch.syspath_prepend(EXAMPLES)
    monkeypatch.syspath_prepend(folder)
    before = set(sys.modules)
    found = {name: importlib.import_module(f"railway.{name}") for name in RAILWAY}
    found |= {name: importlib.import_module(name) for name in names}
    yield SimpleNamespace(found, railway=importlib.import_module("railway.stability"), module=importlib.import_module)
    for name in set(sys.modules) - before:
        if str(getattr(sys.modules[name], "__file__", None)).startswith(str(EXAMPLES)):
            sys.modules.pop(name)
