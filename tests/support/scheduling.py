"""Assigns tests to the processes of pytest-xdist. Tests that share a fixture of their file run in one process. Slow
tests start first, so that at the end no process runs alone."""

from __future__ import annotations

from typing import Any

import pytest

SLOW = " (slow)"


def is_slow(item: pytest.Item) -> bool:
    return any(item.get_closest_marker(mark) is not None for mark in ("slow", "long"))


def shares_a_module(item: pytest.Item) -> bool:
    fixtures = item._fixtureinfo.name2fixturedefs.values() if isinstance(item, pytest.Function) else ()
    return any(found[-1].scope == "module" for found in fixtures)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Puts tests that share something of a module's scope, and each slow one, into a group. Names of groups mark slow
    ones."""
    groups: dict[str, list[pytest.Item]] = {}
    for number, item in enumerate(items):
        if (given := item.get_closest_marker("xdist_group")) is not None:
            name = given.args[0]
        elif shares_a_module(item):
            name = item.path.relative_to(config.rootpath).as_posix() if item.path.is_relative_to(config.rootpath) else item.path.stem
        elif is_slow(item):
            name = str(number)
        else:
            continue
        groups.setdefault(name, []).append(item)
    for name, members in groups.items():
        slow = any(is_slow(item) for item in members)
        for item in members:
            item.add_marker(pytest.mark.xdist_group(name + SLOW * slow), append=False)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Returns the groups by their number of tests, like pytest-xdist, but with slow ones first."""
    if config.getvalue("dist") != "loadgroup":
        return None
    from xdist.scheduler import LoadGroupScheduling

    class SlowFirst(LoadGroupScheduling):
        def _assign_work_unit(self, node: Any) -> None:
            slow = next((scope for scope in self.workqueue if scope.endswith(SLOW)), None)
            if slow is not None:
                self.workqueue.move_to_end(slow, last=False)
            super()._assign_work_unit(node)

    return SlowFirst(config, log)
