"""Simulates a mass that hits an elastic half-space at an angle and bounces off, by co-simulation with a master that
repeats steps.

The master integrates the mass (velocity Verlet) and requests the forces at the end of each step from the session. If
the force changes too much in a step, it restores the session and halves the step. Friction has a history here: adhesion
and slip depend on the path.

Units: N, mm, s, and t for masses, so that energies are in mJ.

Run: cosimulation.py [ENDPOINT]. Without an endpoint it solves in its own process (contactd-local), or starts its own
daemon.
"""

import sys
from contextlib import ExitStack

import contactd
from contactd import Client, Friction, Grid, Material, Paraboloid

MASS = 5e-4  # t
LARGEST_CHANGE = 40.0  # N, of the force over one step

with ExitStack() as stack:
    client = stack.enter_context(Client(sys.argv[1]) if sys.argv[1:] else contactd.local())
    session = stack.enter_context(
        client.session(
            grid=Grid.centred(25, 25, 10, 10),
            upper=Material(G=200, nu=0.42),
            gap=Paraboloid(Rx=50, Ry=50),
            friction=Friction(mu=0.3, rigid_shift=(0, 0)),
        )
    )

    z, vz, vx = 0.02, -500.0, 120.0  # height of the surface of the mass (mm), velocities (mm/s)
    Fn = Fx = time = lost = 0.0
    dt, steps, steps_back, deepest = 1e-4, 0, 0, 0.0
    energy = 0.5 * MASS * (vx**2 + vz**2)
    touched = False
    while not (touched and Fn == 0):
        before = session.save()
        while True:
            dz = vz * dt + 0.5 * Fn / MASS * dt**2
            dx = vx * dt + 0.5 * Fx / MASS * dt**2
            contact = session.step(approach=-(z + dz), rigid_shift=(dx, 0))
            if abs(contact.Fn - Fn) <= LARGEST_CHANGE:
                break
            session.restore(before)
            dt, steps_back = 0.5 * dt, steps_back + 1
        session.forget(before)
        vz += 0.5 * dt * (Fn + contact.Fn) / MASS
        vx += 0.5 * dt * (Fx + contact.Fx) / MASS
        z, Fn, Fx, time, steps = z + dz, contact.Fn, contact.Fx, time + dt, steps + 1
        lost += contact.frictional_work
        deepest = max(deepest, -z)
        touched = touched or Fn > 0
        dt = min(1.3 * dt, 1e-4)

    left = 0.5 * MASS * (vx**2 + vz**2)
    print(f"{steps} steps, {steps_back} taken back, {1000 * time:.2f} ms")
    print(f"deepest approach {deepest:.4f} mm; leaves with vx {vx:.1f}, vz {vz:.1f} mm/s")
    print(f"energy (mJ): {energy:.3f} = {left:.3f} left + {lost:.3f} lost in friction + {energy - left - lost:.3f}")
