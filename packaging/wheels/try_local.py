"""Solves in process with the installed package: try_local.py; with `tables` it also builds a finite-element table, twice."""

import sys

import contactd_local

import contactd
from contactd import FemIcs, Grid, LocalDaemon, Material, Paraboloid
from contactd.local import InProcessClient

RUBBER, STEEL = Material(G=200, nu=0.42), Material(G=82000, nu=0.28)
GRID = Grid(6, 6, 0.8, 0.8)

assert contactd_local.__version__ == contactd.__version__
with contactd.local() as client:
    assert isinstance(client, InProcessClient)
    solution = client.solve(grid=Grid.centred(40, 40, 2.4, 2.4), upper=RUBBER, gap=Paraboloid(50, 50), approach=0.02)
    # Hertz: Fn = 4/3 E* sqrt(R) delta^(3/2), with E* = G/(1 - nu) of two equal bodies.
    assert abs(solution.Fn / (4 / 3 * 200 / (1 - 0.42) * 50**0.5 * 0.02**1.5) - 1) < 0.01
    if "tables" in sys.argv:
        tables = [client.get_ic(STEEL, GRID, FemIcs(accuracy=1e-3))]
        with LocalDaemon() as daemon, daemon.client() as other:
            tables.append(other.get_ic(STEEL, GRID, FemIcs(accuracy=1e-3)))
            assert "contactd_daemon" in str(daemon.process.args)
        for table in tables:
            assert table.origin == "built"
            assert table.evidence.errors.zz.largest < 1e-3
        assert (tables[0].array == tables[1].array).all(), "one builder, one table"
print(f"wheel test: {contactd_local.__file__} solves" + (", and tables are built" if "tables" in sys.argv else ""))
