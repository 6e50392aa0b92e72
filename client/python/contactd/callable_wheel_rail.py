"""The module contactd.wheel_rail as a function: a wheel that rolls on its rail, in one call."""

from __future__ import annotations

from collections.abc import Iterable
from types import ModuleType

from .calls.caller import ProgressCallback
from .refusals import public
from .transport.shared_client import shared_client
from .values.solution import Fields
from .values.stated_wear import StatedLaw, wear_request
from .values.wear_laws import WearRequest
from .values.wheel_rail.rolling_state import pure_rolling
from .values.wheel_rail.setup import WheelRailSetup
from .values.wheel_rail.solution import WheelRailSolution

__all__ = ["WheelRailModule"]


class WheelRailModule(ModuleType):
    """The module `contactd.wheel_rail`, which can be called."""

    @public
    def __call__(
        self,
        setup: WheelRailSetup | None = None,
        /,
        *,
        speed: float,
        y: float = 0.0,
        yaw: float = 0.0,
        roll: float = 0.0,
        z: float | None = None,
        Fz: float | None = None,
        Fx: float | None = None,
        pitch_rate: float | None = None,
        wear: WearRequest | StatedLaw | Iterable[StatedLaw] | None = None,
        fields: Fields | None = None,
        gap: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> WheelRailSolution:
        """The contact of a wheel that rolls on its rail, by the default client::

            solution = contactd.wheel_rail(y=3, speed=20e3, Fz=80e3)  # S1002 on 60E1 at 1/40, 3 mm to the right
            print(solution.forces.track, solution.state)
            solution.plot()

        `setup` has profiles, track, material and friction; None: S1002 on 60E1 at 1/40, gauge 1435 mm, steel, mu = 0.3. The
        wheelset stands at `y` (mm, to the right), `yaw` and `roll` (rad), and moves forwards at `speed` (mm/s). Its height is
        `z` (mm, down), or that at which the wheel presses with `Fz` (N).

        It rolls purely on its nominal radius: the pitch rate is -speed/nominal_radius (rad/s), as of a wheelset that
        runs straight. A wheel that touches on another radius then has a longitudinal creepage. `pitch_rate` gives another
        rate; with `Fx` (N, on the rail) the rate that brings this force is found, with ``Fx=0`` that of a wheel that rolls
        freely. On a roller the wheelset stays where it is, and the roller turns at `speed`. `state` of the answer is the state
        that was solved.

        `wear` has the laws by which wheel and rail wear, such as ``EnergyWear(6.75e-4, source="our test")``; `wear` of the
        answer places what they take off. `fields`, `gap` and the rest are as for Client.wheel_rail, whose
        errors it raises.
        """
        setup = WheelRailSetup() if setup is None else setup
        if wear is not None:
            setup = setup.replace(wear=wear_request(wear))
        state = pure_rolling(setup, speed=speed, y=y, yaw=yaw, roll=roll, z=z, Fz=Fz, Fx=Fx, pitch_rate=pitch_rate)
        solution: WheelRailSolution = shared_client().wheel_rail(
            setup, state, fields=fields, gap=gap, timeout=timeout, on_progress=on_progress, progress=progress
        )
        return solution
