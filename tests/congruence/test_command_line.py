"""The cases through contactctl: each history that Python takes, replayed from a file, has the same answers to the last bit, and
what is refused is refused with the same field and an exit code."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import pytest

import contactd
from congruence.cases import CASES, write
from congruence.driver import answers
from contactctl.app import run
from contactctl.codes import Code, code_of
from contactctl.output import plain_json
from integration.conftest import shared_daemon  # noqa: F401

#: What a history has no words for.
BEYOND = {"session.save", "session.restore", "session.forget"}


class Recording(contactd.Client):
    """A client that keeps what it asks, and what it is told, by cases."""

    def __init__(self, endpoint: str) -> None:
        super().__init__(endpoint)
        self.calls: list[list[tuple[str, dict[str, Any], Any]]] = []

    def call(self, method: str, params: dict[str, Any] | None = None, **options: Any) -> dict[str, Any]:
        if method == "session.open":
            self.calls.append([])
        if method in ("session.close", "server.info"):
            return super().call(method, params, **options)
        try:
            result = super().call(method, params, **options)
            self.calls[-1].append((method, dict(params or {}), plain_json(result)))
            return result
        except contactd.StatusError as error:
            self.calls[-1].append((method, dict(params or {}), error))
            raise


@pytest.fixture(scope="module")
def recorded(shared_daemon: Any, tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[tuple[str, dict[str, Any], Any]]]:  # noqa: F811
    with Recording(shared_daemon.endpoint) as client:
        list(answers(client, write(tmp_path_factory.mktemp("cases") / "cases.txt")))
        return dict(zip(CASES, client.calls, strict=True))


def history(calls: list[tuple[str, dict[str, Any], Any]]) -> Iterator[tuple[str, dict[str, Any], Any]]:
    """Up to what fails, or what a history has no words for."""
    for method, params, answer in calls:
        if method in BEYOND or params.get("again"):
            return
        yield method, params, answer
        if isinstance(answer, contactd.StatusError):
            return


def without_times(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: without_times(member) for name, member in value.items() if name != "seconds"}
    return [without_times(member) for member in value] if isinstance(value, list) else value


@pytest.mark.parametrize("name", CASES)
def test_a_history_from_a_file_is_answered_alike(recorded: Any, shared_daemon: Any, tmp_path: Path, name: str) -> None:  # noqa: F811
    (_, opening, opened), *steps = history(recorded[name])
    said = [{key: value for key, value in params.items() if key not in ("session", "step")} for _, params, _ in steps]
    file = tmp_path / "history.json"
    file.write_text(json.dumps({"open": as_written(opening), "steps": [as_written(step) for step in said] or [{}]}))
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run(["session", str(file), "--json", "--endpoint", shared_daemon.endpoint])
    told = [opened, *(answer for _, _, answer in steps)]
    failed = told[-1] if isinstance(told[-1], contactd.StatusError) else None
    if any(word in file.read_text() for word in ("Infinity", "NaN")):  # which JSON has no word for
        assert failed is not None
        assert (code, out.getvalue()) == (Code.USAGE, "")
        assert "every number must be finite" in err.getvalue()
        return
    assert code == (Code.DONE if failed is None else code_of(failed))
    solved = [answer for answer in told[1:] if answer is not failed]
    found = json.loads(out.getvalue())["steps"] if out.getvalue() else []
    assert without_times(found)[: len(solved)] == without_times(solved)
    if failed is not None:
        assert len(found) == len(solved)
        assert all(violation.field in err.getvalue() for violation in failed.violations)


def as_written(value: Any) -> Any:
    """As Python writes it, numbers that are not finite included."""
    return json.loads(json.dumps(value, default=lambda array: array.tolist()))


def test_most_cases_are_histories(recorded: Any) -> None:
    whole = [name for name, calls in recorded.items() if len(list(history(calls))) == len(calls)]
    assert len(whole) > 0.9 * len(CASES)
