"""Makes the module contactd.wheel_rail callable: solves a wheel rolling on its rail."""

from __future__ import annotations

from collections.abc import Iterable
from types import ModuleType

from .calls.caller import ProgressCallback
from .refusals import public
from .transport.shared_client import shared_client
from .values.generated.wear_laws import WearRequest
from .values.generated.wheel_rail.setup import WheelRailSetup
from .values.solution import Fields
from .values.stated_wear import StatedLaw, wear_request
from .values.wheel_rail.rolling_state import pure_rolling
from .values.wheel_rail.solution import WheelRailSolution

__all__ = ["WheelRailModule"]


class WheelRailModule(ModuleType):
    """Represents the callable module `contactd.wheel_rail`."""

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
        """Solves the contact of a wheel that rolls on its rail, with the default client::

            solution = contactd.wheel_rail(y=3, speed=20e3, Fz=80e3)  # S1002 on 60E1 at 1/40, 3 mm to the right
            print(solution.forces.track, solution.state)
            solution.plot()

        `setup` contains profiles, track, material and friction. If None: S1002 on 60E1 at 1/40, gauge 1435 mm, steel,
        mu = 0.3. The position of the wheelset is given by `y` (mm, to the right), `yaw` and `roll` (rad). It moves
        forwards at `speed` (mm/s). Prescribe either its height `z` (mm, down) or the vertical force `Fz` of the wheel
        on the rail (N).

        By default the wheel rolls purely on its nominal radius, like a wheelset on straight track: the pitch rate is
        -speed/nominal_radius (rad/s). A wheel whose contact has another radius then has a longitudinal creepage.
        `pitch_rate` sets another rate. `Fx` (N, on the rail) prescribes the longitudinal force instead, and the rate is
        computed; ``Fx=0`` is a freely rolling wheel. On a roller, the wheelset does not move along the track, and the
        roller's surface moves at `speed`. `state` of the answer is the solved state.

        `wear` contains laws of wear for wheel and rail, such as ``EnergyWear(6.75e-4, source="our test")``. `wear` of
        the answer then returns the removed material on each profile. `fields`, `gap`, the other arguments and the
        errors are those of Client.wheel_rail.
        """
        setup = WheelRailSetup() if setup is None else setup
        if wear is not None:
            setup = setup.replace(wear=wear_request(wear))
        state = pure_rolling(setup, speed=speed, y=y, yaw=yaw, roll=roll, z=z, Fz=Fz, Fx=Fx, pitch_rate=pitch_rate)
        solution: WheelRailSolution = shared_client().wheel_rail(
            setup, state, fields=fields, gap=gap, timeout=timeout, on_progress=on_progress, progress=progress
        )
        return solution
