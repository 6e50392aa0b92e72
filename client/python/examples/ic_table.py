"""Computes influence coefficients of steel by finite elements, compared with the closed form of the half-space.

Run: ic_table.py [ENDPOINT]. Without an endpoint it starts its own daemon (`contactd` on PATH).
"""

import sys
from contextlib import ExitStack

from contactd import AnalyticIcs, Client, FemIcs, Grid, LocalDaemon, Material

with ExitStack() as stack:
    endpoint = sys.argv[1] if sys.argv[1:] else stack.enter_context(LocalDaemon()).endpoint
    client = stack.enter_context(Client(endpoint))
    steel, grid = Material(G=82000, nu=0.28), Grid(4, 4, 0.8, 0.8)
    exact = client.get_ic(steel, grid, AnalyticIcs())
    table = client.get_ic(steel, grid, FemIcs("paper-test3", L_over_h=80))
    print(f"{table.evidence.elements} elements, {table.evidence.dofs} unknowns, {table.origin}")
    print("A_zz (mm^3/N) along x      ", *(f"{value:.4e}" for value in table["zz"][0]))
    print("against the closed form (%)", *(f"{value:10.3f}" for value in 100 * (table["zz"] / exact["zz"] - 1)[0]))
