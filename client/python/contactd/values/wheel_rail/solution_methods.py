"""Methods of answers of wheels on rails; `result` declares the fields."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from ...refusals import public
from ..dictionaries import Saved
from ..generated.wheel_rail.state import WheelRailState
from ..registry import extra
from ..representation import Rows, Shown
from .passage_wear import PassageWear
from .solved_states import state_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["WheelRailSolutionMethods", "WheelsetSolutionMethods"]


class WheelRailSolutionMethods(Saved, Shown):
    """Methods of a WheelRailSolution."""

    if not TYPE_CHECKING:  # It has no warnings otherwise.

        def __getattr__(self, name: str) -> Any:
            if name == "patches":
                raise AttributeError("this answer has no patches, because its step was called with patches=False")
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    @property
    def state(self) -> WheelRailState | None:
        """The solved state: position and motion of the wheelset. None for a solution from a file, and for a step of a
        session.
        """
        state: WheelRailState | None = state_of(self)
        return state

    @public
    def plot(self) -> Figure:
        """Draws wheel and rail in the cross-section with their contacts and forces, and the pressures of each patch
        that has them.

        The profiles are requested from the client of this solution, or from `contactd.default_client()` if that client
        is closed. For a solution from a file, contacts are drawn without profiles. Returns the figure. Needs matplotlib
        ("contactd[pictures]").
        """
        drawn: Figure = extra("WheelRailSolution.plot")(self)
        return drawn

    @public
    def wear(self, body: Literal["wheel", "rail"] | None = None, law: str | None = None) -> PassageWear:
        """Returns the wear of the wheel or the rail in this passage along its section, if the set-up has laws of wear::

            law = EnergyWear(6.75e-4, source="our twin-disc test")
            wear = contactd.wheel_rail(y=3, yaw=0.003, speed=20e3, Fz=80e3, wear=law).wear("wheel")
            print(wear.depth_per_km)

        `body` and the name of the `law` select one of several. Raises InvalidArgument if there is no such law, or more
        than one, and for a solution from a file, which has no profiles.
        """
        found: PassageWear = extra("WheelRailSolution.wear")(self, body, law)
        return found

    def _rows(self: Any) -> Rows:
        track = self.forces.track
        rows: Rows = [("z", self.z), ("Fx", track.Fx), ("Fy", track.Fy), ("Fz", track.Fz)]
        if self.contacts is not None:
            rows.append(("contacts", self.contacts))
        for patch in self.patches if self.contacts is None else ():
            at = patch.place.reference
            rows.append(("patch at y", f"{at.y:.2f}, {at.angle:.3f} rad, pmax {patch.solution.pmax:.5g}"))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self: Any) -> tuple[str, ...]:
        return (*self.warnings,)


class WheelsetSolutionMethods(Saved, Shown):
    """Methods of a WheelsetSolution."""

    def _rows(self: Any) -> Rows:
        rows: Rows = [("z", self.z), ("roll", self.roll)]
        for name, wheel in (("left", self.left), ("right", self.right)):
            track = wheel.forces.track
            rows.append((name, f"{len(wheel.patches)} patches, Fx {track.Fx:.5g}, Fy {track.Fy:.5g}, Fz {track.Fz:.5g}"))
        return [*rows, ("converged", "yes" if self.converged else "NO")]

    def _remarks(self: Any) -> tuple[str, ...]:
        return (*self.warnings, *self.left.warnings, *self.right.warnings)
