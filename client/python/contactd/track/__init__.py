"""Rolls a wheel over a track with mass: forces by roughness, flats, joints and crossings, in time.

::

    from contactd.track import Flat, Hertz, Ring, Wheel, named_track, roll, third_octaves

    ring = Ring(named_track("R1"))
    wheel = Wheel(mass=600, load=100e3)
    run = roll(ring, wheel, Hertz(9.29e10), speed=20, duration=0.1, irregularities=[Flat(0.05, 0.46, at=0.3)])
    print(run.force.max(), run.evidence.losses)

All values are in N, m, kg and s, and deflections are positive downwards. Contact problems of contactd keep their mm.
docs/track.md describes the models, their assumptions, and two tutorials. contactd.pictures.track draws runs and
receptances.
"""

from __future__ import annotations

from .irregularities import DippedJoint, Flat, Irregularity, Record, height_at
from .laws import ContactLaw, Hertz, Law, WheelRailLaw
from .lumped import P2Forces, p1_force, p1_hertz, p2_force, p2_forces
from .parameters import Rail, Track, named_track
from .ring import Ring
from .rolling import roll
from .run import Evidence, Run, read_run
from .spectra import third_octaves
from .wheel import SuspendedMass, Wheel, WheelMode

__all__ = [
    "ContactLaw",
    "DippedJoint",
    "Evidence",
    "Flat",
    "Hertz",
    "Irregularity",
    "Law",
    "P2Forces",
    "Rail",
    "Record",
    "Ring",
    "Run",
    "SuspendedMass",
    "Track",
    "Wheel",
    "WheelMode",
    "WheelRailLaw",
    "height_at",
    "named_track",
    "p1_force",
    "p1_hertz",
    "p2_force",
    "p2_forces",
    "read_run",
    "roll",
    "third_octaves",
]
