"""Runs functions in several processes."""

from __future__ import annotations

import os
import pickle
import traceback
from collections.abc import Callable
from typing import Any

from contactd import Client, ContactProblem, Grid, Material, Paraboloid

PROBLEM = ContactProblem(
    grid=Grid.centred(12, 12, 2.4, 2.4), upper=Material(G=200, nu=0.42), gap=Paraboloid(50, 50), approach=0.02
)


def in_fork(function: Callable[[], Any]) -> Any:
    """Returns the result of `function` in a forked process, or raises its exception."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        try:
            outcome = function()
        except BaseException as error:
            outcome = error
        try:
            with os.fdopen(writing, "wb") as pipe:
                pickle.dump(outcome, pipe)
        except BaseException:
            traceback.print_exc()
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        text = pipe.read()
    os.waitpid(child, 0)
    assert text, "the child sent nothing back"
    return pickle.loads(text)


def force_at(client: Client, approach: float) -> float:
    """Returns the normal force (N) of a small contact. It is defined here so that a spawned process can import it."""
    return client.solve(PROBLEM.replace(approach=approach)).Fn
