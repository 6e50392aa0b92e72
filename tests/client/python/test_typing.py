"""What type checkers know of the calls whose answers depend on what was asked for."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[3]
#: Lines to ignore are wrong: mypy complains of the ignoring where it finds nothing to ignore.
CALLS = """
from typing import assert_type
import numpy as np, numpy.typing as npt
from contactd import *
Floats = npt.NDArray[np.float64]
def calls(client: Client, problem: ContactProblem, session: Session) -> None:
    assert_type(client.solve(problem), ContactSolution)
    assert_type(client.solve(problem).pressure, Floats)
    assert_type(client.solve(problem, fields=[]), PartialSolution)
    assert_type(client.solve(problem, fields="pressure").pressure, Floats | None)
    assert_type(client.solve_many([problem]), list[ContactSolution | StatusError])
    assert_type(client.solve_many([problem], fields=("slip_x",)), list[PartialSolution | StatusError])
    assert_type(client.step_many([(session, {"Fn": 1, "xi": 2, "again": True})]), list[StepSolution | StatusError])
    client.solve(problem, fields="pressures")  # type: ignore[arg-type]
    client.solve(problem, fields="pressure").pressure.sum()  # type: ignore[union-attr]
    client.step_many([(session, {"Fm": 1})])  # type: ignore[typeddict-unknown-key]
    client.step_many([(session, {"Fn": "much"})])  # type: ignore[typeddict-item]
    session.step(fields=["pressures"])  # type: ignore[list-item]
"""


def test_calls_have_the_types_of_their_answers_and_wrong_ones_are_told():
    command = [sys.executable, "-m", "mypy", "--cache-dir", ROOT / "build" / "mypy", "-c", CALLS]
    checked = subprocess.run(command, cwd=ROOT / "client" / "python", capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout + checked.stderr
