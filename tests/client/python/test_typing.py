"""Types of calls and their answers for type checkers."""

import inspect
import subprocess
import sys
from pathlib import Path

import pytest

from contactd import Client, ContactProblem
from contactd.client import ClientOptions
from contactd.values.generated.problem import ProblemFields
from contactd.values.generated.wheel_rail.setup import WheelRailFields
from contactd.wheel_rail import WheelRailSetup

ROOT = Path(__file__).parents[3]
#: Ignored lines must contain errors, because mypy reports unused ignores.
CALLS = """
from typing import assert_type
import numpy as np, numpy.typing as npt
from contactd import *
from contactd import contact_files, wheel_rail
from contactd.wheel_rail import WheelRailSetup, WheelRailSolution, WheelRailState
Floats = npt.NDArray[np.float64]
def calls(client: Client, problem: ContactProblem, session: Session) -> None:
    assert_type(client.solve(problem), ContactSolution)
    assert_type(client.solve(problem).pressure, Floats)
    assert_type(client.solve(problem, fields=[]), ContactSolution)
    assert_type(client.solve(problem, fields="pressure").pressure, Floats)
    assert_type(client.solve(problem).slip_x, Floats | None)
    assert_type(client.solve_many([problem]), list[ContactSolution | StatusError])
    assert_type(client.solve_many([problem], fields=("slip_x",)), list[ContactSolution | StatusError])
    assert_type(client.step_many([(session, {"Fn": 1, "xi": 2, "again": True})]), list[StepSolution | StatusError])
    assert_type(client.solve(Paraboloid(50, 50), steel, Fn=100), ContactSolution)
    assert_type(client.solve(Paraboloid(50, 50), steel, RigidBody(), Fn=100, fields=[]), ContactSolution)
    assert_type(solve(Paraboloid(50, 50), steel, Fn=100), ContactSolution)
    assert_type(solve(problem, fields="pressure"), ContactSolution)
    assert_type(creep_curve(problem, xi=[0, 1e-3]), CreepCurve)
    assert_type(client.creep_curve(Paraboloid(1, 2), steel, Fn=1, friction=Friction(0.3), xi=0.1).Fx, Floats)
    assert_type(default_client(), Client)
    assert_type(wheel_rail(y=3, speed=2e4, Fz=8e4), WheelRailSolution)
    assert_type(wheel_rail(WheelRailSetup(), speed=2e4, Fz=8e4, wear=EnergyWear(1, source="x")).wear("rail"), PassageWear)
    wheel_rail(y=3, Fz=8e4)  # type: ignore[call-arg]
    assert_type(contact_files.run("x.inp"), contact_files.SolvedCases)
    assert_type(contact_files.run("x.inp", client).compare("x.out").agrees, bool)
    assert_type(contact_files.run("x.inp")[0].patches[0].forces.Fn, float)
    solve(Paraboloid(50, 50), "steel", Fn=100)  # type: ignore[arg-type]
    solve(Paraboloid(50, 50), steel, Fm=100)  # type: ignore[call-arg]
    creep_curve(problem, psi=1)  # type: ignore[call-arg]
    assert_type(client.health(), str)
    assert_type(client.session(problem), Session)
    assert_type(session.step(Fn=1.0), StepSolution)
    client.solve(grid=problem.grid, upper=problem.upper, gap=Paraboloid(1, 2), Fn=1, fields=[], timeout=3)
    client.session(grid=problem.grid, upper=problem.upper, lease=3)
    problem.replace(Fn=1, model="hertz")
    client.solve(grid=problem.grid, aproach=1)  # type: ignore[call-arg]
    client.solve(grid=problem.grid, approach="deep")  # type: ignore[arg-type]
    client.solve(problem, timeot=1)  # type: ignore[call-arg]
    client.session(grid=problem.grid, uper=problem.upper)  # type: ignore[call-arg]
    client.session(grid=3)  # type: ignore[arg-type]
    client.get_ic(Material(1, 0), problem.grid, FemIcs(), timeot=1)  # type: ignore[call-arg]
    session.step(Fm=1)  # type: ignore[call-arg]
    problem.replace(modle="hertz")  # type: ignore[call-arg]
    problem.replace(model="herz")  # type: ignore[arg-type]
    WheelRailSetup().replace(dy="wide")  # type: ignore[arg-type]
    LocalDaemon().client(time_out=3)  # type: ignore[call-arg]
    client.solve(problem, fields="pressures")  # type: ignore[arg-type]
    client.step_many([(session, {"Fm": 1})])  # type: ignore[typeddict-unknown-key]
    client.step_many([(session, {"Fn": "much"})])  # type: ignore[typeddict-item]
    session.step(fields=["pressures"])  # type: ignore[list-item]

def wheels(client: Client, session: Session, wheel: WheelRailSession, state: WheelRailState) -> None:
    assert_type(client.wheel_rail_session(WheelRailSetup()), WheelRailSession)
    assert_type(wheel.step(state, fields="pressure"), WheelRailStepSolution)
    both: list[tuple[Session, StepInput] | tuple[WheelRailSession, WheelRailStepInput]]
    both = [(session, StepInput(Fn=1)), (wheel, WheelRailStepInput(state=state))]
    assert_type(client.step_many([(wheel, {"state": state})]), list[WheelRailStepSolution | StatusError])
    assert_type(client.step_many(both), list[StepSolution | WheelRailStepSolution | StatusError])
    wheel.step(Fn=1)  # type: ignore[call-arg]
    wheel.step(3)  # type: ignore[arg-type]

async def awaited(client: AsyncClient, problem: ContactProblem) -> None:
    assert_type(await client.solve(problem), ContactSolution)
    assert_type(await client.solve(grid=problem.grid, fields=[]), ContactSolution)
    assert_type(await client.solve_many([problem]), list[ContactSolution | StatusError])
    assert_type(await client.solve(Paraboloid(50, 50), steel, Fn=100), ContactSolution)
    assert_type(await client.creep_curve(problem, xi=1e-3), CreepCurve)
    assert_type(await client.health(), str)
    async with await client.session(problem) as session:
        assert_type(session, AsyncSession)
        assert_type(await session.step(Fn=1), StepSolution)
        assert_type(await client.step_many([(session, {"Fn": 1})]), list[StepSolution | StatusError])
        await session.step(Fm=1)  # type: ignore[call-arg]
    async for table in client.stored_ics():
        assert_type(table, StoredIc)
    await client.solve(problem, aproach=1)  # type: ignore[call-arg]
    await client.health(timeot=1)  # type: ignore[call-arg]
"""


@pytest.mark.parametrize(
    ("keywords", "kind"),
    [(ProblemFields, ContactProblem), (WheelRailFields, WheelRailSetup), (ClientOptions, Client)],
    ids=lambda one: one.__name__,
)
def test_keywords_are_those_of_what_they_make(keywords, kind):
    parameters = inspect.signature(kind).parameters.values()
    expected = {one.name: one.annotation for one in parameters if one.name != "endpoint"}
    assert {name: hint.__forward_arg__ for name, hint in keywords.__annotations__.items()} == expected


def test_calls_have_the_types_of_their_answers_and_wrong_ones_are_told():
    command = [sys.executable, "-m", "mypy", "--cache-dir", ROOT / "build" / "mypy", "-c", CALLS]
    checked = subprocess.run(command, cwd=ROOT / "client" / "python", capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout + checked.stderr
