"""Uses FMUs as the wheels of a vehicle, with FMPy: the same interface as railway/wheels.py. docs/fmu.md lists the
variables.
"""

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

MODELS = ("full", "hertz", "fastsim")  # in the order of the FMU's enumeration
WRENCH = ("Fx", "Fy", "Fz", "Mx", "My", "Mz")
ANSWERS = (*WRENCH, "power")


class FmuWheels:
    """Holds an instance of contactd_wheel for each wheel, for either version of FMI.

    An FMU makes time steps. A wheel has no state between steps, so each evaluation of the integrator is a step of any
    size, and no step must be undone.
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
    """Represents one instance, with its variables by name."""

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
        def tell(*reported: Any) -> None:  # FMI 2 and 3 have different arguments before the message
            sentence = reported[-1].decode()
            self._given.append(sentence % () if self._is_fmi2 else sentence)  # a format, in FMI 2

        # Not by fmpy.instantiate_fmu, which passes messages of FMI 2 instances to the last logger, even if that no
        # longer exists.
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
            # Other errors, such as the limit of a step, do not affect the motion.
            raise (InvalidArgument if "elastic contact allows" in sentence else RuntimeError)(sentence) from None
        self._time += STEP
        get = self._slave.getReal if self._is_fmi2 else self._slave.getFloat64
        answers: list[float] = get(self._answers)
        return answers

    def _set(self, names: Sequence[str], values: Sequence[float]) -> None:
        """Sets all variables of one type."""
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
    """Returns its model description. Raises ValueError if the file is not a contactd_wheel."""
    try:
        description = fmpy.read_model_description(str(archive))
    except Exception as error:
        raise ValueError(f"{archive} is not a readable FMU: {error}") from None
    if description.modelName != "contactd_wheel":
        raise ValueError(f"{archive} is {description.modelName}; it must be contactd_wheel")
    return description


def parameters_of(setup: WheelRailSetup) -> dict[str, float]:
    """Returns the parameters of one of SETUPS; others have the same defaults. Raises ValueError for unsupported
    settings.
    """
    given = {name for name, value in vars(setup).items() if value is not None}
    if more := given - {"side", "model", "friction", "dx", "dy"}:
        raise ValueError(f"the set-up contains {', '.join(sorted(more))}, which FmuWheels does not pass to its FMUs")
    return {
        "side": 0 if setup.side == "left" else 1, "model": MODELS.index(setup.model), "friction.mu": setup.friction.mu,
        "elements.dx": setup.dx, "elements.dy": setup.dy,
        "vertical": 1,  # by the height
        "coordinates": 2,  # of the wheelset
    }  # fmt: skip


def inputs_of(state: WheelRailState) -> dict[str, float]:
    """Returns the inputs in `wheel_state`."""
    position, velocity, rail = state.position, state.velocity, state.rail
    return {
        **{f"position.{name}": getattr(position, name) for name in ("y", "z", "roll", "yaw")},
        **{f"velocity.{name}": getattr(velocity, name) for name in ("x", "y", "z", "roll", "yaw", "pitch")},
        "deviation.y": rail.y, "deviation.z": rail.z,
        "deviation_rate.y": rail.y_velocity, "deviation_rate.z": rail.z_velocity,
    }  # fmt: skip


def _on_wheelset(answer: Sequence[float], state: WheelRailState) -> OnWheelset:
    """Returns the forces on the wheelset; those of an answer act on the rail."""
    force, moment = -np.array(answer[:3]), -np.array(answer[3:6])
    return OnWheelset(axes(state.position.roll, state.position.yaw) @ force, moment, answer[6])
