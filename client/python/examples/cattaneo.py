"""Solves the Cattaneo problem of the paper (section 4): a sphere is pressed on a plane, then shifted.

Run: cattaneo.py [ENDPOINT], e.g. tcp://127.0.0.1:5555. Without an endpoint it solves in its own process
(contactd-local), or starts its own daemon.
"""

import sys
from contextlib import ExitStack

import contactd
from contactd import Client, Friction, Grid, Material, Paraboloid

with ExitStack() as stack:
    client = stack.enter_context(Client(sys.argv[1], timeout=60) if sys.argv[1:] else contactd.local())
    solution = client.solve(
        grid=Grid.centred(40, 40, 2.4, 2.4),
        upper=Material(G=200, nu=0.42),
        gap=Paraboloid(Rx=50, Ry=50),
        approach=0.02,
        friction=Friction(mu=0.4, rigid_shift=(0.00817, 0)),
    )
    print(f"Fz {solution.Fn:.6f} N, Fx {solution.Fx:.6f} N, pmax {solution.pmax:.6f} N/mm^2")
    print(f"{solution.elements.adhesion} elements in adhesion, {solution.elements.slip} in slip")
