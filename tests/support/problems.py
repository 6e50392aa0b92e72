"""Materials, grids and coefficients shared by several tests."""

from __future__ import annotations

from contactd import ContactProblem, FemIcs, Friction, Grid, Material, Paraboloid, Rolling

STEEL = Material(G=82000, nu=0.28)
GRID = Grid(6, 6, 0.8, 0.8)
#: A table that is built in about a tenth of a second.
QUICK = FemIcs("paper-test2", order=1, L_over_h=40)
#: A table that takes a minute, to be observed, cancelled and killed.
LONG = FemIcs("paper-test1", order=2, L_over_h=1000)

#: The Cattaneo problem of the paper, section 4, with analytic coefficients on 40 x 40 elements.
CATTANEO = ContactProblem(
    grid=Grid.centred(40, 40, 2.4, 2.4),
    upper=Material(G=200, nu=0.42),
    gap=Paraboloid(Rx=50, Ry=50),
    approach=0.02,
    friction=Friction(mu=0.4, rigid_shift=(0.00817, 0)),
)

#: A problem that runs until it is cancelled: a hundred thousand steps of rolling take hours. An unreachable tolerance
#: would not do, because an iteration may stop with an update of exactly zero.
ENDLESS = CATTANEO.replace(
    grid=Grid.centred(320, 320, 2.4, 2.4),
    friction=Friction(mu=0.4, rolling=Rolling(kind="transient", xi=1e-3, steps=100_000)),
)

#: The same as CATTANEO, as parameters on the wire.
CATTANEO_PARAMS = {
    "grid": {"nx": 40, "ny": 40, "dx": 0.06, "dy": 0.06},
    "bodies": {"upper": {"G": 200, "nu": 0.42}},
    "ics": {"source": "analytic"},
    "gap": {"paraboloid": {"Rx": 50, "Ry": 50}},
    "approach": 0.02,
    "friction": {"mu": 0.4, "rigid_shift": [0.00817, 0]},
}
