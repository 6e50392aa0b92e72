"""Methods of answers of wheels on rails, whose fields are in `result`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from ...refusals import public
from ..dictionaries import Saved
from ..registry import extra
from ..representation import Rows, Shown
from .passage_wear import PassageWear
from .solved_states import state_of
from .state import WheelRailState

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["WheelRailSolutionMethods", "WheelsetSolutionMethods"]


class WheelRailSolutionMethods(Saved, Shown):
    """Methods of a WheelRailSolution."""

    if not TYPE_CHECKING:  # which has none to report otherwise

        def __getattr__(self, name: str) -> Any:
            if name == "patches":
                raise AttributeError("patches were left out of this answer, as its step said by patches=False")
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    @property
    def state(self) -> WheelRailState | None:
        """The state that was solved: where the wheelset was, and how it moved. None of a solution from a file, and of a step
        of a session."""
        state: WheelRailState | None = state_of(self)
        return state

    @public
    def plot(self) -> Figure:
        """Draws wheel and rail across the track with their contacts and forces, and beside them the pressures of each patch
        that has them.

        The profiles are asked for at the client that gave this solution, or at `contactd.default_client()` where that one is
        closed; of a solution from a file, contacts are drawn without them. Returns the figure. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Figure = extra("WheelRailSolution.plot")(self)
        return drawn

    @public
    def wear(self, body: Literal["wheel", "rail"] | None = None, law: str | None = None) -> PassageWear:
        """Wear of the wheel or the rail in this passage, along its section, where the set-up has laws of wear::

            law = EnergyWear(6.75e-4, source="our twin-disc test")
            wear = contactd.wheel_rail(y=3, yaw=0.003, speed=20e3, Fz=80e3, wear=law).wear("wheel")
            print(wear.depth_per_km)

        `body` and the name of the `law` choose among several. Raises InvalidArgument where there is no such law, or not just
        one, and for a solution from a file, whose profiles are not known.
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
