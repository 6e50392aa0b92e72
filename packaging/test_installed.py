"""Tests an installed daemon, or with "local" the installed in-process solver, through the installed client: closed
forms, and tables from the builder, one of them by its module for sections."""

import sys

from contactd import AnalyticIcs, Client, FemIcs, Friction, Grid, Material, Paraboloid, local

place = local(in_process=True) if sys.argv[1] == "local" else Client(sys.argv[1], timeout=120)
with place as client:
    for ics in (AnalyticIcs(), FemIcs(accuracy=0.02)):
        solution = client.solve(
            grid=Grid(40, 40, 0.06, 0.06) if isinstance(ics, AnalyticIcs) else Grid(12, 12, 0.2, 0.2),
            upper=Material(G=200, nu=0.42), ics=ics, gap=Paraboloid(Rx=50, Ry=50), approach=0.02,
            friction=Friction(mu=0.4, rigid_shift=(0.00817, 0)),
        )  # fmt: skip
        print(type(ics).__name__, f"Fn {solution.forces.Fn:.3f} N, Fx {solution.forces.Fx:.3f} N")
        assert solution.converged
        assert 8 < solution.forces.Fn < 10
        assert -3.6 < solution.forces.Fx < -2.8
    edge = FemIcs(body="longitudinally_uniform", section={"edge_block": {"width": 20, "height": 10}}, accuracy=1e-2)
    table = client.get_ic(Material(G=200, nu=0.42), Grid(5, 4, 0.5, 0.5), edge)
    print("section", f"stated error {table.evidence.section.error:.1e}")
    assert table["zz"][3, 3, 0] > table["zz"][0, 0, 0] > 0
