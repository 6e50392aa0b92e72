"""Solves a ball on rubber bonded to steel, with decreasing thickness and Poisson's ratio 0.5: the errors of a
half-space model.

Run: layers.py [ENDPOINT]. Without an endpoint it solves in its own process (contactd-local), or starts its own daemon.
"""

import math
import sys
from contextlib import ExitStack

import contactd
from contactd import Client, Grid, Layer, LayeredBody, Material, Paraboloid, RigidBody

with ExitStack() as stack:
    client = stack.enter_context(Client(sys.argv[1]) if sys.argv[1:] else contactd.local())
    grid, ball, steel = Grid.centred(64, 64, 9, 9), Paraboloid(50, 50), Material(G=82000, nu=0.28)

    def press(name, lower):
        solution = client.solve(grid=grid, upper=RigidBody(), lower=lower, gap=ball, Fn=5)
        radius = math.sqrt(solution.area.contact / math.pi)
        print(f"{name:28} {solution.approach:9.5f} {radius:8.3f} {solution.pmax:9.3f}")

    print(f"{'rubber':28} {'approach':>9} {'radius':>8} {'pmax':>9}")
    for nu in (0.45, 0.5):
        press(f"half-space, nu {nu}", Material(G=1, nu=nu))
        for thickness in (10, 2, 0.5):
            press(f"{thickness:4} mm on steel, nu {nu}", LayeredBody([Layer(thickness, G=1, nu=nu)], base=steel))
