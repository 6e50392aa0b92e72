"""Sessions that several tests open."""

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
#: Takes minutes.
ENDLESS = Friction(mu=0.4, rolling=Rolling(kind="transient", xi=1e-3, steps=100_000))


def open_session(client: Client, **changes: Any) -> Session:
    fields = {"grid": GRID, "upper": Material(200, 0.42), "gap": Paraboloid(50, 50), "approach": 0.02}
    return client.session(**{**fields, "friction": Friction(mu=0.4, rigid_shift=(0, 0)), **changes})


def take(raw: RawClient, session: str, step: int, **changes: Any) -> Answer:
    return raw.ask("session.step", {"session": session, "step": step, **changes})
