"""The wheels of a vehicle as FMUs: the seam of railway/wheels.py once more, by FMPy's co-simulation. docs/fmu.md has the
variables. Needs FMPy (`pip install fmpy`)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from types import TracebackType
from typing import Any

import fmpy
import numpy as np
from fmpy import fmi1, fmi2, fmi3
from railway.motion import axes
from railway.wheels import OnWheelset
from runs import STEP

from contactd import InvalidArgument
from contactd.wheel_rail import WheelRailSetup, WheelRailState

MODELS = ("full", "hertz", "fastsim")  # as the FMU's enumeration has them
WRENCH = ("Fx", "Fy", "Fz", "Mx", "My", "Mz")
ANSWERS = (*WRENCH, "power")


class FmuWheels:
    """An instance of contactd_wheel for each wheel; either version of FMI.

    An FMU takes steps of time. A wheel carries nothing from one to the next, so each evaluation of the integrator is one, of
    whichever size, and none need be taken back.
    """

    def __init__(self, archive: Path, setups: Sequence[WheelRailSetup]) -> None:
        description = described(archive)
        with ExitStack() as stack:
            folder = stack.enter_context(TemporaryDirectory(prefix="contactd-bogie-"))
            fmpy.extract(str(archive), folder)
            self._wheels = [
                stack.enter_context(_Wheel(folder, description, parameters_of(setup))) for setup in setups
            ]
            self._open = stack.pop_all()

    def __call__(self, states: Sequence[WheelRailState]) -> list[OnWheelset]:
        answers = [wheel.step(inputs_of(state)) for wheel, state in zip(self._wheels, states, strict=True)]
        return [_on_wheelset(answer, state) for answer, state in zip(answers, states)]

    def __enter__(self) -> FmuWheels:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._open.close()


class _Wheel:
    """One instance, whose variables go by their names."""

    def __init__(self, folder: str, description: Any, parameters: Mapping[str, float]) -> None:
        self._variables = {variable.name: variable for variable in description.modelVariables}
        self._is_fmi2 = description.fmiVersion == "2.0"
        self._given: list[str] = []
        self._slave = self._instantiated(folder, description)
        self._answers = [self._variables[name].valueReference for name in ANSWERS]
        self._time = 0.0
        if self._is_fmi2:
            self._slave.setupExperiment(startTime=0.0)
        for name, value in parameters.items():
            self._set([name], [value])
        self._slave.enterInitializationMode()
        self._slave.exitInitializationMode()

    def _instantiated(self, folder: str, description: Any) -> Any:
        def tell(*reported: Any) -> None:  # FMI 2 and 3 tell different things before the sentence
            sentence = reported[-1].decode()
            self._given.append(sentence % () if self._is_fmi2 else sentence)  # a format, in FMI 2

        # Not by fmpy.instantiate_fmu: what instances of FMI 2 log, it tells to the logger given last, whether that still
        # lives or not.
        names = {
            "guid": description.guid, "modelIdentifier": description.modelName, "unzipDirectory": folder,
            "instanceName": description.modelName,
        }  # fmt: skip
        if not self._is_fmi2:
            slave = fmi3.FMU3Slave(**names)
            slave.instantiate(logMessage=tell)
            return slave
        callbacks = fmi2.fmi2CallbackFunctions()
        callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(tell)
        callbacks.allocateMemory = fmi2.defaultCallbacks.allocateMemory
        callbacks.freeMemory = fmi2.defaultCallbacks.freeMemory
        slave = fmi2.FMU2Slave(**names)
        slave.instantiate(callbacks=callbacks)
        return slave

    def step(self, inputs: Mapping[str, float]) -> list[float]:
        """ANSWERS."""
        self._set(list(inputs), list(inputs.values()))
        try:
            self._slave.doStep(self._time, STEP)
        except fmi1.FMICallException as error:
            sentence = self._given[-1] if self._given else str(error)
            # Nothing else that can go wrong has part in the motion, such as the limit of a step.
            raise (InvalidArgument if "no elastic contact" in sentence else RuntimeError)(sentence) from None
        self._time += STEP
        get = self._slave.getReal if self._is_fmi2 else self._slave.getFloat64
        answers: list[float] = get(self._answers)
        return answers

    def _set(self, names: Sequence[str], values: Sequence[float]) -> None:
        """Sets all of them that are of one type."""
        references, kind = [self._variables[name].valueReference for name in names], self._variables[names[0]].type
        if kind == "Enumeration":
            kind = "Integer" if self._is_fmi2 else "Int64"
        getattr(self._slave, f"set{kind}")(references, values)

    def __enter__(self) -> _Wheel:
        return self

    def __exit__(self, *of_an_error: object) -> None:
        self._slave.terminate()
        self._slave.freeInstance()


def described(archive: Path) -> Any:
    """Its model description. Raises ValueError where the file is no contactd_wheel."""
    try:
        description = fmpy.read_model_description(str(archive))
    except Exception as error:
        raise ValueError(f"{archive} is no FMU that can be read: {error}") from None
    if description.modelName != "contactd_wheel":
        raise ValueError(f"{archive} is {description.modelName}; it must be contactd_wheel")
    return description


def parameters_of(setup: WheelRailSetup) -> dict[str, float]:
    """Parameters of one of SETUPS; what these leave out is the same by default. Raises ValueError where a set-up says more."""
    given = {name for name, value in vars(setup).items() if value is not None}
    if more := given - {"side", "model", "friction", "dx", "dy"}:
        raise ValueError(f"the set-up says {', '.join(sorted(more))}, of which FmuWheels tells its FMUs nothing")
    return {
        "side": 0 if setup.side == "left" else 1, "model": MODELS.index(setup.model), "friction.mu": setup.friction.mu,
        "elements.dx": setup.dx, "elements.dy": setup.dy,
        "vertical": 1,  # by the height
        "coordinates": 2,  # of the wheelset
    }  # fmt: skip


def inputs_of(state: WheelRailState) -> dict[str, float]:
    """Those that `wheel_state` gives."""
    position, velocity, rail = state.position, state.velocity, state.rail
    return {
        **{f"position.{name}": getattr(position, name) for name in ("y", "z", "roll", "yaw")},
        **{f"velocity.{name}": getattr(velocity, name) for name in ("x", "y", "z", "roll", "yaw", "pitch")},
        "deviation.y": rail.y, "deviation.z": rail.z,
        "deviation_rate.y": rail.y_velocity, "deviation_rate.z": rail.z_velocity,
    }  # fmt: skip


def _on_wheelset(answer: Sequence[float], state: WheelRailState) -> OnWheelset:
    """Forces on the wheelset by an answer: its forces act on the rail."""
    force, moment = -np.array(answer[:3]), -np.array(answer[3:6])
    return OnWheelset(axes(state.position.roll, state.position.yaw) @ force, moment, answer[6])
