"""Runs the FMUs of this build with FMPy, with the same calls for FMI 2 and FMI 3."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from support.daemons import BIN

#: The archives, and the folder where ./dev has installed FMPy and other importers for this build.
FOLDER = BIN.parent / "fmu"
_CACHE = BIN.parent / "CMakeCache.txt"
_FOUND = (
    re.search(r"^CONTACTD_FMI_HEADERS:PATH=(.+)/fmpy/c-code$", _CACHE.read_text(), re.M) if _CACHE.exists() else None
)
PACKAGES = Path(_FOUND[1]) if _FOUND else None
if PACKAGES:
    sys.path.append(str(PACKAGES))  # after Debian's own

KINDS = ("contactd_contact", "contactd_wheel")
VERSIONS = (2, 3)
#: Type -> suffix of FMPy's functions.
_CALLS = {"Enumeration": {2: "Integer", 3: "Int64"}}
Value = float | int | bool | str


def archive(kind: str, fmi: int) -> Path:
    return FOLDER / f"{kind}_fmi{fmi}.fmu"


class Fmu:
    """An instance. Its log is a list of (status, category, sentence)."""

    def __init__(self, kind: str, fmi: int, folder: Path, *, logging: bool = False, name: str = "one") -> None:
        import fmpy

        self.fmi = fmi
        self.description = fmpy.read_model_description(str(archive(kind, fmi)))
        self.variables = {variable.name: variable for variable in self.description.modelVariables}
        self.log: list[tuple[int, str, str]] = []
        self.time = 0.0
        folder = folder / f"{kind}_fmi{fmi}"
        if not folder.exists():
            fmpy.extract(str(archive(kind, fmi)), str(folder))
        self.slave = (self._fmi2 if fmi == 2 else self._fmi3)(kind, str(folder), name, logging)

    def _arguments(self, kind: str, folder: str, name: str) -> dict[str, str]:
        return {"guid": self.description.guid, "modelIdentifier": kind, "unzipDirectory": folder, "instanceName": name}

    def _fmi2(self, kind: str, folder: str, name: str, logging: bool) -> Any:
        from fmpy import fmi2

        def logger(_environment: Any, _name: bytes, status: int, category: bytes, message: bytes) -> None:
            # Sentences are formats without arguments. FMPy's own proxy for these sends all of them to the last
            # instance.
            self.log.append((status, category.decode(), message.decode() % ()))

        callbacks = fmi2.fmi2CallbackFunctions()
        callbacks.logger = fmi2.fmi2CallbackLoggerTYPE(logger)
        callbacks.allocateMemory = fmi2.defaultCallbacks.allocateMemory
        callbacks.freeMemory = fmi2.defaultCallbacks.freeMemory
        slave = fmi2.FMU2Slave(**self._arguments(kind, folder, name))
        slave.instantiate(callbacks=callbacks, loggingOn=logging)
        return slave

    def _fmi3(self, kind: str, folder: str, name: str, logging: bool) -> Any:
        from fmpy import fmi3

        def logger(_environment: Any, status: int, category: bytes, message: bytes) -> None:
            self.log.append((status, category.decode(), message.decode()))

        slave = fmi3.FMU3Slave(**self._arguments(kind, folder, name))
        slave.instantiate(logMessage=logger, loggingOn=logging)
        return slave

    def __enter__(self) -> Fmu:
        return self

    def __exit__(self, *_: object) -> None:
        self.slave.freeInstance()

    def _call(self, what: str, name: str) -> Any:
        of = self.variables[name].type
        return getattr(self.slave, what + _CALLS.get(of, {}).get(self.fmi, of))

    def reference(self, name: str) -> int:
        return self.variables[name].valueReference

    def set(self, values: Mapping[str, Value]) -> None:
        for name, value in values.items():
            self._call("set", name)([self.reference(name)], [value])

    def get(self, names: Iterable[str] | str) -> Any:
        """Returns a list, or the value of one variable."""
        if isinstance(names, str):
            return self._call("get", names)([self.reference(names)])[0]
        return [self.get(name) for name in names]

    def outputs(self) -> dict[str, Value]:
        return {name: self.get(name) for name, variable in self.variables.items() if variable.causality == "output"}

    def enter(self, values: Mapping[str, Value] | None = None) -> None:
        """Starts the instance, and leaves it in the initialization."""
        if self.fmi == 2:
            self.slave.setupExperiment(startTime=0)
        self.set(values or {})
        self.slave.enterInitializationMode()

    def start(self, values: Mapping[str, Value] | None = None) -> Fmu:
        self.enter(values)
        self.slave.exitInitializationMode()
        return self

    def step(self, values: Mapping[str, Value] | None = None, size: float = 1e-3) -> dict[str, Value]:
        """Returns the outputs after one step."""
        self.set(values or {})
        self.slave.doStep(self.time, size)
        self.time += size
        return self.outputs()

    def go_back(self, state: Any, time: float) -> None:
        self.slave.setFMUState(state)
        self.time = time

    def derivatives(self, of: Iterable[str], by: str) -> list[float]:
        found: list[float] = self.slave.getDirectionalDerivative(
            [self.reference(name) for name in of], [self.reference(by)], [1.0]
        )
        return found
