"""Writes the cases in the words of contactd.h, for the drivers of C and Fortran: a line is a call, or sets a field by
its path.

set PATH NUMBER, word PATH KEYWORD, clear PATH, array PATH NUMBERS, table PATH NX NY DX DY NUMBERS, and columns NY DIRECTION Y Z,
those of the lower body's section. What a case says of both bodies is said of each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from congruence.cases import CASES
from congruence.driver import CALLS
from congruence.sections import SHAPES

__all__ = ["write_paths"]


def write_paths(path: Path) -> Path:
    lines: list[str] = []
    for name, text in CASES.items():
        case = Case()
        lines.append(f"case {name}")
        for part in text.split(";"):
            word, *words = part.split()
            lines += [part.strip()] if word in CALLS else getattr(case, word)(*words)
    path.write_text("\n".join(lines) + "\n")
    return path


def numbers(values: object) -> str:
    return " ".join(repr(float(value)) for value in np.asarray(values).ravel())


def settings(above: str, **values: str) -> list[str]:
    return [f"set {above}.{name} {value}" for name, value in values.items()]


class Case:
    """Translates a case: a method for each word returns its lines."""

    def __init__(self) -> None:
        self.motion = ""
        self.grid_size = (0, 0)
        self.curves: dict[str, str] = {}  # outline to which parts are added, by its body
        self.parts = 0
        self.holes = 0

    # --- the set-up

    def grid(self, nx: str, ny: str, dx: str, dy: str, x0: str, y0: str) -> list[str]:
        self.grid_size = int(nx), int(ny)
        return settings("grid", nx=nx, ny=ny, dx=dx, dy=dy, x0=x0, y0=y0)

    def material(self, body: str, G: str, nu: str) -> list[str]:
        return [line for above in bodies(body) for line in settings(above, G=G, nu=nu)]

    def rigid(self, body: str) -> list[str]:
        return [f"set {above}.rigid 1" for above in bodies(body)]

    def half_space(self, body: str, load_shape: str) -> list[str]:
        return [f"word {above}.ics.load_shape {load_shape}" for above in bodies(body)]

    def creep(self, body: str, f: str, tau: str) -> list[str]:
        return [line for above in bodies(body) for line in settings(f"{above}.viscoelastic", f=f, tau=tau)]

    def layers(self, body: str, load_shape: str, base_G: str, base_nu: str, *layers: str) -> list[str]:
        lines = []
        for above in bodies(body):
            base = f"{above}.ics.base"
            lines += [f"clear {above}", f"word {above}.ics.body layered", f"word {above}.ics.load_shape {load_shape}"]
            lines += settings(base, G=base_G, nu=base_nu) if float(base_G) else [f"set {base}.rigid 1"]
            lines.append(f"array {above}.ics.layers {' '.join(layers)}")
        return lines

    def fem(self, body: str, accuracy: str) -> list[str]:
        ics = [f"{above}.ics" for above in bodies(body)]
        return [line for above in ics for line in (f"word {above}.source fem", f"set {above}.accuracy {accuracy}")]

    def table(self, body: str, nx: str, ny: str, dx: str, dy: str, origin: str) -> list[str]:
        x, y = np.meshgrid(np.arange(int(nx)), np.arange(int(ny)))
        values = np.zeros((3, 3, int(ny), int(nx)))
        for axis in range(3):
            values[axis, axis] = np.ldexp(float(origin), -2 * (x + y))
        above = ["ics"] if body == "pair" else [f"{one}.ics" for one in bodies(body)]
        return [f"table {path} {nx} {ny} {dx} {dy} {numbers(values)}" for path in above]

    def line_contact(self, datum: str) -> list[str]:
        return [f"set ics.line_contact.datum {datum}"]

    def model(self, model: str) -> list[str]:
        return [f"word model {model}"]

    def tolerance(self, solver: str, tolerance: str, iterations: str) -> list[str]:
        return settings(f"settings.{solver}", tolerance=tolerance, max_iterations=iterations)

    def accept_unconverged(self) -> list[str]:
        return ["set accept_unconverged 1"]

    def previous(self, *ramps: str) -> list[str]:
        names = ("pressure", "traction_x", "traction_y")
        return [f"array previous.{name} {self._ramp(*ramps[4 * i : 4 * i + 4])}" for i, name in enumerate(names)]

    # --- sections

    def _section(self, body: str) -> list[str]:
        ics = f"bodies.{body}.ics"
        return [f"clear {ics}", f"word {ics}.source fem", f"word {ics}.body longitudinally_uniform"]

    def section(self, body: str, shape: str, *values: str) -> list[str]:
        above = f"bodies.{body}.ics.section.{shape}"
        lines = self._section(body)
        for name, value in zip(SHAPES[shape], values, strict=True):
            is_word = name == "support"
            lines.append(f"word {above}.support {('cut', 'foot')[int(value)]}" if is_word else f"set {above}.{name} {value}")
        return lines

    def section_place(self, body: str, size: str, turn: str) -> list[str]:
        return [line for above in bodies(body) for line in settings(f"{above}.ics.section", size=size, turn=turn)]

    def section_accuracy(self, body: str, accuracy: str) -> list[str]:
        if float(accuracy):
            return self.fem(body, accuracy)
        return [f"word {above}.ics.source analytic" for above in bodies(body)]

    def outline(self, body: str, y: str, z: str) -> list[str]:
        self.holes = 0
        return [*self._section(body), *self._curve(body, "outside", y, z)]

    def hole(self, body: str, y: str, z: str) -> list[str]:
        self.holes += 1
        return self._curve(body, f"holes[{self.holes - 1}]", y, z)

    def _curve(self, body: str, curve: str, y: str, z: str) -> list[str]:
        self.parts = 0
        self.curves[body] = f"bodies.{body}.ics.section.outline.{curve}"
        return settings(f"{self.curves[body]}.start", y=y, z=z)

    def _part(self, body: str, clamped: str, lines: Callable[[str], list[str]]) -> list[str]:
        part = f"{self.curves[body]}.parts[{self.parts}]"
        self.parts += 1
        return [*lines(part), f"set {part}.clamped {clamped}"]

    def line(self, body: str, y: str, z: str, clamped: str) -> list[str]:
        return self._part(body, clamped, lambda part: settings(f"{part}.line.to", y=y, z=z))

    def arc(self, body: str, y: str, z: str, radius: str, clamped: str) -> list[str]:
        return self._part(body, clamped, lambda part: [f"array {part}.arc {y} {z} {radius}"])

    def spline(self, body: str, clamped: str, *points: str) -> list[str]:
        return self._part(body, clamped, lambda part: [f"array {part}.spline.through {' '.join(points)}"])

    def first_column(self, body: str, carrier: str, part: str, begin: str) -> list[str]:
        return settings(f"bodies.{body}.ics.section.outline", carrier=carrier, part=part, **{"from": begin})

    def profile(self, body: str, kind: str, curvature: str, smoothing: str, depth: str, begin: str) -> list[str]:
        above = f"bodies.{body}.ics.section.profile_section"
        points = numbers([(y, y * y * float(curvature)) for y in range(-34, 35)])
        return [
            *self._section(body),
            f"word {above}.kind {kind}",
            f"array {above}.profile.points {points}",
            f"set {above}.profile.smoothing_length {smoothing}",
            *settings(above, depth=depth, **{"from": begin}),
        ]

    def columns(self, direction: str, y: str, z: str) -> list[str]:
        return [f"columns {self.grid_size[1]} {direction} {y} {z}"]

    def flat_columns(self, direction: str, y: str, z: str) -> list[str]:
        frames = numbers([(row, 0, 0) for row in range(self.grid_size[1])])
        return [f"array columns.frames {frames}", f"set columns.direction {direction}", f"array columns.origin {y} {z}"]

    # --- the load

    def _ramp(self, base: str, scale: str, step: str, period: str) -> str:
        turns = np.arange(self.grid_size[0] * self.grid_size[1]) * int(step) % int(period)
        return numbers(float(base) + float(scale) * turns)

    def approach(self, value: str) -> list[str]:
        return [f"set approach {value}"]

    def Fn(self, value: str) -> list[str]:
        return [f"set Fn {value}"]

    def derivatives(self, wanted: str) -> list[str]:
        return [f"set derivatives {wanted}"]

    def paraboloid(self, Rx: str, Ry: str) -> list[str]:
        return settings("gap.paraboloid", Rx=Rx, Ry=Ry)

    def semi_axes(self, a: str, b: str) -> list[str]:
        return settings("gap.semi_axes", a=a, b=b)

    def gap(self, scale: str) -> list[str]:
        nx, ny = self.grid_size
        x, y = np.meshgrid(2 * np.arange(nx) - nx + 1, 2 * np.arange(ny) - ny + 1)
        return [f"array gap.array {numbers(float(scale) * (x**2 + y**2))}"]

    def gap_of(self, count: str) -> list[str]:
        return [f"array gap.array {numbers(np.zeros(int(count)))}"]

    def mu(self, value: str) -> list[str]:
        return [f"set friction.mu {value}"]

    def mu_array(self, *ramp: str) -> list[str]:
        return [f"array friction.mu {self._ramp(*ramp)}"]

    def kinetic(self, law: str, mu: str, slip_velocity: str) -> list[str]:
        return [f"word friction.kinetic.law {law}", *settings("friction.kinetic", mu=mu, slip_velocity=slip_velocity)]

    def rigid_slip(self, *ramps: str) -> list[str]:
        names = enumerate("xy")
        return [f"array friction.rigid_slip.{name} {self._ramp(*ramps[4 * i : 4 * i + 4])}" for i, name in names]

    def _is_now(self, motion: str) -> Iterator[str]:
        if self.motion and self.motion != motion:
            yield f"clear friction.{self.motion}"
        self.motion = motion

    def shift(self, x: str, y: str, rotation: str) -> list[str]:
        return [*self._is_now("rigid_shift"), f"array friction.rigid_shift {x} {y}", f"set friction.rotation {rotation}"]

    def duration(self, seconds: str) -> list[str]:
        return [f"set friction.duration {seconds}"]

    def rolling(self, kind: str, xi: str, eta: str, phi: str) -> list[str]:
        above = "friction.rolling"
        return [*self._is_now("rolling"), f"word {above}.kind {kind}", *settings(above, xi=xi, eta=eta, phi=phi)]

    def direction(self, chi: str, dq: str) -> list[str]:
        return settings("friction.rolling", chi=chi, dq=dq)

    def spin_offset(self, steps: str) -> list[str]:
        return settings("friction.rolling", spin_offset=steps)

    def rolling_steps(self, steps: str) -> list[str]:
        return settings("friction.rolling", steps=steps)

    def velocity(self, velocity: str) -> list[str]:
        return settings("friction.rolling", velocity=velocity)

    def _force(self) -> str:
        return "friction.rolling.force" if self.motion == "rolling" else "friction.force"

    def Fx(self, force: str) -> list[str]:
        return [f"set {self._force()}.Fx {force}"]

    def Fy(self, force: str) -> list[str]:
        return [f"set {self._force()}.Fy {force}"]

    def clear_forces(self) -> list[str]:
        return [f"clear {self._force()}"]


def bodies(body: str) -> list[str]:
    return ["bodies.upper", "bodies.lower"] if body == "both" else [f"bodies.{body}"]
