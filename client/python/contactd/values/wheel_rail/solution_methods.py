"""Methods of answers of wheels on rails, whose fields are in `result`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...refusals import public
from ..dictionaries import Saved
from ..registry import extra
from ..representation import Rows, Shown

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

    @public
    def plot(self) -> Figure:
        """Draws wheel and rail across the track with their contacts and forces, and beside them the pressures of each patch
        that has them.

        The profiles are asked for at the client that gave this solution (`Client.wheel_rail`); where it is closed, or the
        solution comes from a file, contacts are drawn without them. Returns the figure. Needs matplotlib ("contactd[pictures]").
        """
        drawn: Figure = extra("WheelRailSolution.plot")(self)
        return drawn

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
