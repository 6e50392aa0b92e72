"""Tests the cases through contactctl: each history of the Python driver, replayed from a file, has the same answers to
the last bit, and refusals name the same field and have an exit code."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import pytest

import contactd
from congruence.cases import CASES
from congruence.driver import answers
from contactctl.app import run
from contactctl.codes import Code, code_of
from contactctl.output import plain_json
from contactd.transport.frames import decode
from integration.conftest import shared_daemon  # noqa: F401

#: Calls that histories do not support.
BEYOND = {"session.save", "session.restore", "session.forget"}
#: Calls that Python refuses to send, also from a file.
REFUSED_HERE = {"an-approach-that-is-no-number"}


class Recording(contactd.Client):
    """Records messages to the daemon and its answers."""

    def __init__(self, endpoint: str) -> None:
        super().__init__(endpoint)
        self.calls: list[tuple[str, dict[str, Any], Any]] = []

    def _exchange(self, *said: Any) -> Any:
        envelope, frames = (said[0], said[1]) if len(said) > 1 else (said[0].envelope, said[0].frames)
        asked = envelope["method"], plain_json(decode(envelope["params"], frames))
        try:
            reply = super()._exchange(*said)
        except contactd.StatusError as error:
            self.calls.append((*asked, error))
            raise
        self.calls.append((*asked, plain_json(decode(reply.result, reply.frames))))
        return reply


@pytest.fixture(scope="module")
def recorded(shared_daemon: Any, tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[tuple[str, dict[str, Any], Any]]]:  # noqa: F811
    """Returns the calls of each session, by cases, without those that Python refuses before sending."""
    folder, found = tmp_path_factory.mktemp("cases"), {}
    with Recording(shared_daemon.endpoint) as client:
        for name, text in CASES.items():
            (folder / name).write_text("\n".join([f"case {name}", *text.split(";")]) + "\n")
            client.calls.clear()
            list(answers(client, folder / name))
            found[name] = [call for call in client.calls if call[0] not in ("server.info", "session.close", "ic.get")]
    return found


def history(calls: list[tuple[str, dict[str, Any], Any]]) -> Iterator[tuple[str, dict[str, Any], Any]]:
    """Returns the calls up to a failure, or to a call that histories do not support."""
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
    if not recorded[name]:
        assert name in REFUSED_HERE
        return
    (_, opening, opened), *steps = history(recorded[name])
    said = [{key: value for key, value in params.items() if key not in ("session", "step")} for _, params, _ in steps]
    file = tmp_path / "history.json"
    file.write_text(json.dumps({"open": opening, "steps": said or [{}]}))
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run(["session", str(file), "--json", "--endpoint", shared_daemon.endpoint])
    told = [opened, *(answer for _, _, answer in steps)]
    failed = told[-1] if isinstance(told[-1], contactd.StatusError) else None
    assert code == (Code.DONE if failed is None else code_of(failed))
    solved = [answer for answer in told[1:] if answer is not failed]
    found = json.loads(out.getvalue())["steps"] if out.getvalue() else []
    assert without_times(found)[: len(solved)] == without_times(solved)
    if failed is not None:
        assert len(found) == len(solved)
        assert all(violation.field in err.getvalue() for violation in failed.violations)


def test_most_cases_are_histories(recorded: Any) -> None:
    whole = [name for name, calls in recorded.items() if len(list(history(calls))) == len(calls)]
    assert len(whole) > 0.9 * len(CASES)
