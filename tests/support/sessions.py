"""Sessions shared by several tests."""

from __future__ import annotations

from typing import Any

from contactd import Client, Friction, Grid, Material, Paraboloid, Rolling, Session

from .raw import Answer, RawClient

GRID = Grid.centred(20, 20, 2.4, 2.4)
#: Parameters of session.open.
OPEN = {
    "grid": {"nx": 20, "ny": 20, "dx": 0.12, "dy": 0.12},
    "bodies": {"upper": {"G": 200, "nu": 0.42}},
    "ics": {"source": "analytic"},
    "gap": {"paraboloid": {"Rx": 50, "Ry": 50}},
    "approach": 0.02,
    "friction": {"mu": 0.4, "rigid_shift": [0.001, 0]},
}
#: The answer of a fake daemon to session.step, and a valid name.
STEP = {
    "step": 1, "approach": 0.02, "forces": {"Fn": 9, "Fx": 0, "Fy": 0, "Mz": 0}, "pmax": 4,
    "area": {"contact": 3, "adhesion": 1, "slip": 2}, "elements": {"contact": 3, "adhesion": 1, "slip": 2, "border": 0},
    "converged": True, "evidence": {"normal": {"iterations": 6, "residual": 0, "converged": True, "seconds": 0}},
}  # fmt: skip
NAME = "0123456789abcdef" * 2
#: A step that takes minutes.
ENDLESS = Friction(mu=0.4, rolling=Rolling(kind="transient", xi=1e-3, steps=100_000))


def opened(step: int = 0, name: str = NAME) -> dict[str, Any]:
    """The answer of a fake daemon to session.open."""
    return {"session": name, "lease_seconds": 60, "step": step, "ics": {}, "bytes": 1}


def open_session(client: Client, **changes: Any) -> Session:
    fields = {"grid": GRID, "upper": Material(200, 0.42), "gap": Paraboloid(50, 50), "approach": 0.02}
    return client.session(**{**fields, "friction": Friction(mu=0.4, rigid_shift=(0, 0)), **changes})


def take(raw: RawClient, session: str, step: int, **changes: Any) -> Answer:
    return raw.ask("session.step", {"session": session, "step": step, **changes})
