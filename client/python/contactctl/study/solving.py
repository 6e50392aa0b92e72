"""Solves one case of a study: returns a row, or ends the study."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from contactd import (
    Cancelled,
    Client,
    ConnectionFailed,
    Progress,
    StatusError,
    TimeoutExpired,
    Unauthenticated,
    Unavailable,
)
from contactd.calls.answer_warnings import collected
from contactd.refusals import did_you_mean

from ..codes import Code, Ended, code_of
from ..output import plain_json
from ..paths import get
from .answers import may_answer

__all__ = ["row_of"]

TRIES = 5  #: Retries after 0.5, 1, 2 and 4 s if the daemon is not reachable or full.

ProgressCallback = Callable[[Progress], None]


def row_of(
    client: Client, method: str, params: dict[str, Any], varying: Sequence[str], answers: Sequence[str],
    on_progress: ProgressCallback | None = None,
) -> dict[str, Any]:
    """Returns the row without its key and values: the exit `code`, `answers` or an `error`, and `warnings` if any.

    Raises Cancelled, and errors of the connection, which do not depend on the case. Raises Ended for a varied field or
    an answer that is invalid in all rows.
    """
    began = time.monotonic()
    try:
        with collected() as sentences:
            answer = _asked(client, method, params, on_progress)
    except (Cancelled, Unauthenticated, Unavailable):
        raise
    except (StatusError, TimeoutExpired) as error:
        _check_names(error, varying)
        return {"code": int(code_of(error)), "error": str(error), "seconds": time.monotonic() - began}
    code = Code.DONE if answer["converged"] else Code.NOT_CONVERGED
    found = {path: plain_json(get(answer, path)) for path in answers}
    if unknown := [path for path, value in found.items() if value is None and not may_answer(method, path)]:
        meant = did_you_mean(unknown[0], _paths_in(answer))
        raise Ended(Code.USAGE, f"answers has {', '.join(unknown)}, which the answer does not have; it has {', '.join(sorted(answer))}.{meant}")
    row = {"code": int(code), "answers": found, "seconds": time.monotonic() - began}
    return {**row, "warnings": sentences} if sentences else row


def _paths_in(answer: dict[str, Any], path: str = "") -> Iterator[str]:
    for name, value in answer.items():
        yield f"{path}{name}"
        if isinstance(value, dict):
            yield from _paths_in(value, f"{path}{name}.")


def _check_names(error: StatusError | TimeoutExpired, varying: Sequence[str]) -> None:
    """Raises Ended if a varied field is unknown: all rows would be refused."""
    for violation in error.violations if isinstance(error, StatusError) else ():
        if violation.field in varying and violation.description.startswith("is not a field of"):
            raise Ended(Code.USAGE, f"vary has {violation.field}, which {violation.description}.")


def _asked(client: Client, method: str, params: dict[str, Any], on_progress: ProgressCallback | None) -> dict[str, Any]:
    for attempt in range(TRIES - 1):
        try:
            return client.call(method, params, on_progress=on_progress)
        except (ConnectionFailed, Unavailable):
            time.sleep(0.5 * 2**attempt)
        except StatusError as error:
            if error.reason not in ("QUEUE_FULL", "RATE_LIMITED", "TOO_MANY_OPEN"):
                raise
            time.sleep(max(error.retry_delay, 0.5 * 2**attempt))
    return client.call(method, params, on_progress=on_progress)
