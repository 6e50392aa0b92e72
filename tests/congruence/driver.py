"""Runs the cases of cases.py through the Python client; telling.py defines the output of every driver.

Statements of a case hold until they are changed, as in C; those since the start are sent with each step.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from congruence.sections import Sections
from congruence.telling import ARRAYS, told
from contactd import (
    AnalyticIcs,
    Client,
    Estimate,
    FemIcs,
    Friction,
    Grid,
    KineticFriction,
    Layer,
    LayeredBody,
    LineContact,
    Material,
    Paraboloid,
    RigidBody,
    Rolling,
    SemiAxes,
    SolverSettings,
    StatusError,
    TableIcs,
    ViscoelasticBody,
)

CALLS = ("start", "step", "again", "save", "restore", "forget")


def answers(client: Client, cases: Path) -> Iterator[str]:
    """Returns the output of the driver of Python for the file `cases`."""
    case: Case | None = None
    for name, *words in map(str.split, cases.read_text().splitlines()):
        if name == "case":
            if case is not None:
                case.close()
            case = Case(client, words[0])
        elif name in CALLS:
            assert case is not None
            yield case.call(name, *words)
        else:
            getattr(case, name)(*words)
    assert case is not None
    case.close()


class Case(Sections):
    """Represents one contact: a method for each word of the file."""

    def __init__(self, client: Client, name: str) -> None:
        super().__init__()
        self.client, self.name = client, name
        self.session: Any = None
        self.opening: dict[str, Any] = {}
        self.load: dict[str, Any] = {}  # approach or Fn, derivatives
        self.gap_said: Any = None
        self.law: dict[str, Any] = {}  # mu, kinetic
        self.slip: Any = None
        self.is_rolling = False
        self.shifts: dict[str, Any] = {"rigid_shift": (0.0, 0.0)}
        self.rolls: dict[str, Any] = {}
        self.force: list[float | None] = [None, None]
        self.changed: set[str] = set()
        self.saved: dict[str, Any] = {}

    def close(self) -> None:
        if self.session is not None:
            self.session.close()

    # --- the set-up

    def grid(self, nx: str, ny: str, dx: str, dy: str, x0: str, y0: str) -> None:
        self.opening["grid"] = Grid(int(nx), int(ny), float(dx), float(dy), float(x0), float(y0))

    def _body(self, body: str, value: Any, suffix: str = "") -> None:
        for name in ("upper", "lower") if body == "both" else (body,):
            self.opening[name + suffix] = value

    def material(self, body: str, G: str, nu: str) -> None:
        self._body(body, Material(G=float(G), nu=float(nu)))

    def rigid(self, body: str) -> None:
        self._body(body, RigidBody())

    def half_space(self, body: str, load_shape: Any) -> None:
        self._body(body, AnalyticIcs(load_shape=load_shape), "_ics")

    def creep(self, body: str, f: str, tau: str) -> None:
        for name in ("upper", "lower") if body == "both" else (body,):
            material = self.opening[name]
            self._body(name, ViscoelasticBody(material.G, material.nu, float(f), float(tau)))

    def layers(self, body: str, load_shape: Any, base_G: str, base_nu: str, *layers: str) -> None:
        base = Material(G=float(base_G), nu=float(base_nu)) if float(base_G) else RigidBody()
        made = [Layer(*map(float, layers[i : i + 3])) for i in range(0, len(layers), 3)]
        self._body(body, LayeredBody(made, base))
        self._body(body, AnalyticIcs(load_shape=load_shape), "_ics")

    def fem(self, body: str, accuracy: str) -> None:
        self._body(body, FemIcs(accuracy=float(accuracy), load_shape="constant"), "_ics")

    def table(self, body: str, nx: str, ny: str, dx: str, dy: str, origin: str) -> None:
        x, y = np.meshgrid(np.arange(int(nx)), np.arange(int(ny)))
        values = np.zeros((3, 3, int(ny), int(nx)))
        for axis in range(3):
            values[axis, axis] = np.ldexp(float(origin), -2 * (x + y))
        table = TableIcs(values, float(dx), float(dy))
        if body == "pair":
            self.opening["ics"] = table
        else:
            self._body(body, table, "_ics")

    def line_contact(self, datum: str) -> None:
        self.opening["ics"] = AnalyticIcs(line_contact=LineContact(float(datum)))

    def model(self, model: str) -> None:
        self.opening["model"] = model

    def tolerance(self, solver: str, tolerance: str, iterations: str) -> None:
        self.opening[solver] = SolverSettings(float(tolerance), int(iterations))

    def accept_unconverged(self) -> None:
        self.opening["accept_unconverged"] = True

    def lease(self, seconds: str) -> None:
        self.opening["lease"] = float(seconds)

    def previous(self, *ramps: str) -> None:
        self.opening["previous"] = Estimate(*(self._ramp(*ramps[i : i + 4]) for i in (0, 4, 8)))

    # --- the load

    def _say(self, what: str) -> None:
        if self.session is not None:
            self.changed.add(what)

    def _ramp(self, base: str, scale: str, step: str, period: str) -> Any:
        grid = self.opening["grid"]
        turns = np.arange(grid.nx * grid.ny) * int(step) % int(period)
        return (float(base) + float(scale) * turns).reshape(grid.shape)

    def approach(self, value: str) -> None:
        self.load.update(approach=float(value), Fn=None)

    def Fn(self, value: str) -> None:
        self.load.update(Fn=float(value), approach=None)

    def derivatives(self, wanted: str) -> None:
        self.load["derivatives"] = bool(int(wanted))

    def _gap(self, gap: Any) -> None:
        self.gap_said = gap
        self._say("gap")

    def paraboloid(self, Rx: str, Ry: str) -> None:
        self._gap(Paraboloid(*(None if math.isinf(radius) else radius for radius in (float(Rx), float(Ry)))))

    def semi_axes(self, a: str, b: str) -> None:
        self._gap(SemiAxes(float(a), float(b)))

    def gap(self, scale: str) -> None:
        grid = self.opening["grid"]
        x, y = np.meshgrid(2 * np.arange(grid.nx) - grid.nx + 1, 2 * np.arange(grid.ny) - grid.ny + 1)
        self._gap(float(scale) * (x**2 + y**2))

    def gap_of(self, count: str) -> None:
        self._gap(np.zeros(int(count)))

    def mu(self, value: str) -> None:
        self.law["mu"] = float(value)
        self._say("law")

    def mu_array(self, *ramp: str) -> None:
        self.law["mu"] = self._ramp(*ramp)
        self._say("law")

    def kinetic(self, law: Any, mu: str, slip_velocity: str) -> None:
        self.law["kinetic"] = KineticFriction(float(mu), float(slip_velocity), law)
        self._say("law")

    def rigid_slip(self, *ramps: str) -> None:
        self.slip = (self._ramp(*ramps[:4]), self._ramp(*ramps[4:]))
        self._say("slip")

    def _move(self, said: dict[str, Any], **values: Any) -> None:
        said.update(values)
        self._say("motion")

    def shift(self, x: str, y: str, rotation: str) -> None:
        self.is_rolling = False
        self._move(self.shifts, rigid_shift=(float(x), float(y)), rotation=float(rotation))

    def duration(self, seconds: str) -> None:
        self._move(self.shifts, duration=float(seconds))

    def rolling(self, kind: str, xi: str, eta: str, phi: str) -> None:
        self.is_rolling = True
        self._move(self.rolls, kind=kind, xi=float(xi), eta=float(eta), phi=float(phi))

    def direction(self, chi: str, dq: str) -> None:
        self._move(self.rolls, chi=float(chi), dq=float(dq))

    def spin_offset(self, steps: str) -> None:
        self._move(self.rolls, spin_offset=float(steps))

    def rolling_steps(self, steps: str) -> None:
        self._move(self.rolls, steps=int(steps))

    def velocity(self, velocity: str) -> None:
        self._move(self.rolls, velocity=float(velocity))

    def Fx(self, force: str) -> None:
        self.force[0] = float(force)
        self._say("motion")

    def Fy(self, force: str) -> None:
        self.force[1] = float(force)
        self._say("motion")

    def clear_forces(self) -> None:
        self.force = [None, None]
        self._say("motion")

    # --- calls

    def _motion(self) -> dict[str, Any]:
        # A step also states that there is none, because the session may have been opened with one.
        force = tuple(self.force) if self.session is not None or any(f is not None for f in self.force) else None
        if self.is_rolling:
            return {"rolling": Rolling(**self.rolls, force=force)}
        return {**self.shifts, "force": force}

    def _start(self) -> None:
        fields = {**self.opening, **self.load}
        if self.gap_said is not None:
            fields["gap"] = self.gap_said
        if "mu" in self.law:
            fields["friction"] = Friction(**self.law, **self._motion(), rigid_slip=self.slip)
        self.session = self.client.session(**fields)

    def _step(self, again: bool) -> Any:
        said = dict(self.load)
        if "gap" in self.changed:
            said["gap"] = self.gap_said
        if self.changed & {"motion", "slip"}:
            motion = self._motion() if "motion" in self.changed else {}
            said["friction"] = Friction(**self.law, **motion, rigid_slip=self.slip)
        elif "law" in self.changed:
            said["mu"] = self.law["mu"]
        return self.session.step(**said, fields=ARRAYS, again=again)

    def call(self, name: str, *words: str) -> str:
        calls: dict[str, Callable[[], Any]] = {
            "start": self._start,
            "step": lambda: self._step(False),
            "again": lambda: self._step(True),
            "save": lambda: self.saved.update({words[0]: self.session.save()}),
            "restore": lambda: self.session.restore(self.saved[words[0]]),
            "forget": lambda: self.session.forget(self.saved[words[0]]),
        }
        try:
            answer = calls[name]()
        except StatusError as error:
            field = error.violations[0].field if error.violations else ""
            return f"{self.name} {name} refused {error.code} {error.reason} {field}"
        return " ".join([self.name, name, *(told(answer) if name in ("step", "again") else ())])
