"""Runs the cases of wheel_cases.py through the Python client; wheel_telling.py defines the output of every driver."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from congruence.telling import ARRAYS
from congruence.wheel_telling import told, told_geometry
from contactd import Client, KineticFriction, Material, RigidBody, SolverSettings, StatusError
from contactd.wheel_rail import (
    S1002,
    ArcProfile,
    ConeProfile,
    PatchRules,
    ProfilePoints,
    Rail60E1,
    RailDeviation,
    RailSprings,
    Track,
    WheelRailFriction,
    WheelRailSetup,
    WheelRailState,
    Wheelset,
    WheelsetVelocity,
)

CALLS = ("solve", "geometry", "open", "step")
STEEL = Material(G=82000, nu=0.28)


def wheel_answers(client: Client, cases: Path) -> Iterator[str]:
    """Returns the output of the driver of Python for the file `cases`."""
    wheel: Wheel | None = None
    for word, *rest in map(str.split, cases.read_text().splitlines()):
        if word == "case":
            if wheel is not None:
                wheel.close()
            wheel = Wheel(client, rest[0])
        elif word in CALLS:
            assert wheel is not None
            yield wheel.call(word)
        else:
            getattr(wheel, word)(*rest)
    assert wheel is not None
    wheel.close()


class Wheel:
    """Represents one wheel: a method for each word of the file."""

    def __init__(self, client: Client, name: str) -> None:
        self._client, self.name = client, name
        self.session: Any = None
        self._setup = WheelRailSetup(upper=STEEL, lower=STEEL)
        self._state = WheelRailState()
        self._profiles: dict[str, Any] = {"wheel": S1002(), "rail": Rail60E1(1 / 40)}

    def close(self) -> None:
        if self.session is not None:
            self.session.close()

    # --- the set-up

    def _set(self, **fields: Any) -> None:
        self._setup = self._setup.replace(**fields)

    def side(self, side: Any) -> None:
        self._set(side=side)

    def _profile(self, body: str, profile: Any) -> None:
        self._profiles[body] = profile
        self._set(**{body: profile})

    def rail_60e1(self, inclination: str) -> None:
        self._profile("rail", Rail60E1(float(inclination)))

    def arc(self, body: str, radius: str, slope: str, begin: str, end: str) -> None:
        self._profile(body, ArcProfile(float(radius), float(slope), (float(begin), float(end))))

    def cone(self, body: str, slope: str, begin: str, end: str) -> None:
        self._profile(body, ConeProfile(float(slope), (float(begin), float(end))))

    def points(self, body: str, *numbers: str) -> None:
        values = [*map(float, numbers)]
        self._profile(body, ProfilePoints([*zip(values[::2], values[1::2])]))

    def add_slice(self, x: str) -> None:
        self._set(rail_slices=[*(self._setup.rail_slices or ()), (float(x), self._profiles["rail"])])

    def add_wheel_slice(self, angle: str) -> None:
        self._set(wheel_slices=[*(self._setup.wheel_slices or ()), (float(angle), self._profiles["wheel"])])

    def clear_wheel_slices(self) -> None:
        self._set(wheel_slices=None)

    def _place(self, **fields: Any) -> None:
        self._set(track=replace(self._setup.track or Track(), **fields))

    def track(self, gauge: str, height: str, cant: str) -> None:
        self._place(gauge=float(gauge), gauge_height=float(height), cant=float(cant), rail_origin=None)

    def rail_origin(self, y: str, z: str) -> None:
        self._place(rail_origin=(float(y), float(z)))

    def roller(self, radius: str) -> None:
        self._place(roller_radius=float(radius))

    def springs(self, *stiffnesses: str) -> None:
        y, z = (float(stiffness) or None for stiffness in stiffnesses)
        self._place(springs=None if y is None and z is None else RailSprings(y=y, z=z))

    def wheelset(self, distance: str, position: str, radius: str) -> None:
        self._set(wheelset=Wheelset(float(distance), float(position), float(radius)))

    def _body(self, body: str, value: Any) -> None:
        self._set(**{"upper" if body == "rail" else "lower": value})

    def material(self, body: str, G: str, nu: str) -> None:
        self._body(body, Material(G=float(G), nu=float(nu)))

    def rigid(self, body: str) -> None:
        self._body(body, RigidBody())

    def model(self, model: Any) -> None:
        self._set(model=model)

    def mu(self, mu: str) -> None:
        self._set(friction=replace(self._setup.friction or WheelRailFriction(), mu=float(mu), along_profile=False))

    def mu_by_angle(self, along: str, *numbers: str) -> None:
        values = [*map(float, numbers)]
        pairs = [*zip(values[::2], values[1::2])]
        self._set(friction=replace(self._setup.friction or WheelRailFriction(), mu=pairs, along_profile=along == "1"))

    def kinetic(self, law: Any, mu: str, velocity: str) -> None:
        falling = KineticFriction(float(mu), float(velocity), law)
        self._set(friction=replace(self._setup.friction or WheelRailFriction(), kinetic=falling))

    def frictionless(self) -> None:
        self._set(friction=None)

    def elements(self, dx: str, dy: str, dq: str) -> None:
        self._set(dx=float(dx), dy=float(dy), dq=float(dq))

    def patch_rules(self, *rules: str) -> None:
        angle, separate, combine, turn, step = map(float, rules)
        self._set(patches=PatchRules(angle, separate, combine, turn, step))

    def bilinear(self, on: str) -> None:
        self._set(wheel_surface="bilinear" if on == "1" else "exact")

    def slip_of_surfaces(self, on: str) -> None:
        self._set(rigid_slip="surfaces" if on == "1" else "plane")

    def mesh_search(self, on: str) -> None:
        self._set(patches=replace(self._setup.patches or PatchRules(), search="mesh" if on == "1" else "locus"))

    def conformal(self, conformal: Any) -> None:
        self._set(conformal=conformal)

    def tolerance(self, solver: Any, tolerance: str, iterations: str) -> None:
        self._set(**{solver: SolverSettings(float(tolerance), int(iterations))})

    # --- the state

    def _move(self, **fields: Any) -> None:
        self._state = replace(self._state, **fields)

    def position(self, y: str, z: str, roll: str, yaw: str) -> None:
        self._move(position=replace(self._state.position, y=float(y), z=float(z), roll=float(roll), yaw=float(yaw)))

    def x(self, x: str) -> None:
        self._move(position=replace(self._state.position, x=float(x)))

    def pitch_angle(self, pitch: str) -> None:
        self._move(position=replace(self._state.position, pitch=float(pitch)))

    def velocity(self, *values: str) -> None:
        x, y, z, roll, yaw, pitch = map(float, values)
        self._move(velocity=WheelsetVelocity(x=x, y=y, z=z, roll=roll, yaw=yaw, pitch=pitch))

    def deviation(self, y: str, z: str, roll: str) -> None:
        self._move(rail=replace(self._state.rail, y=float(y), z=float(z), roll=float(roll)))

    def deviation_rate(self, y: str, z: str, roll: str) -> None:
        rates = {"y_velocity": float(y), "z_velocity": float(z), "roll_velocity": float(roll)}
        self._move(rail=RailDeviation(**{**vars(self._state.rail), **rates}))

    def rail_forces(self, Fy: str, Fz: str) -> None:
        self._move(rail=replace(self._state.rail, Fy=float(Fy), Fz=float(Fz)))

    def roller_pitch(self, pitch: str) -> None:
        self._move(roller_pitch=float(pitch))

    def Fz(self, force: str) -> None:
        self._move(Fz=float(force))

    def Fx(self, force: str) -> None:
        self._move(Fx=float(force))

    def clear_forces(self) -> None:
        self._move(Fz=None, Fx=None)

    def derivatives(self, wanted: str) -> None:
        self._move(derivatives=wanted == "1")

    # --- calls

    def _answer(self, call: str) -> Iterator[str]:
        if call == "solve":
            yield from told(self._client.wheel_rail(self._setup, self._state, fields=ARRAYS, gap=True))
        elif call == "geometry":
            (geometry,) = self._client.wheel_rail_geometry(self._setup, [self._state])
            yield from told_geometry(geometry)
        elif call == "open":
            self.session = self._client.wheel_rail_session(self._setup, accept_unconverged=True)
        else:
            step = self.session.step(self._state, friction=self._setup.friction, fields=ARRAYS, gap=True)
            yield from (str(step.step), *told(step))

    def call(self, name: str) -> str:
        try:
            return " ".join([self.name, name, *self._answer(name)])
        except StatusError as error:
            field = error.violations[0].field if error.violations else ""
            return f"{self.name} {name} refused {error.code} {error.reason} {field}"
