"""Tests how programs of bench/ that use ZeroMQ read answers."""

import json

import pytest

from session_steps import answered


class Socket:
    """Provides messages to be received."""

    def __init__(self, *envelopes):
        self._messages = [[json.dumps(envelope).encode(), b"frame"] for envelope in envelopes]

    def recv_multipart(self):
        return self._messages.pop(0)


def test_an_answer_is_what_comes_behind_the_progress():
    answer = {"status": {"code": 0}, "result": {"Fn": 1}}
    assert answered(Socket({"progress": {"fraction": 0.5}}, {"progress": {"fraction": 1}}, answer))[0] == answer


def test_an_answer_that_fails_ends_the_run():
    with pytest.raises(AssertionError, match="too large"):
        answered(Socket({"status": {"code": 3, "message": "too large"}}))
