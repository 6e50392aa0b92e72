"""A wheel on a rail. For a rolling wheel, call the module as a function::

    solution = contactd.wheel_rail(y=3, speed=20e3, Fz=80e3)

The module contains the arguments of `Client.wheel_rail` and `Client.wheelset`: profiles, track, wheelset and its
position.

::

    from contactd import Client
    from contactd.wheel_rail import WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity

    setup = WheelRailSetup(side="right")  # S1002 on 60E1 at 1/40, gauge 1435, steel, mu = 0.3
    state = WheelRailState(
        position=WheelsetPosition(y=3),
        velocity=WheelsetVelocity(x=20e3, pitch=-20e3 / 460),
        Fz=80e3,
    )
    with Client("tcp://127.0.0.1:5555") as client:
        solution = client.wheel_rail(setup, state)
        print(solution.z, solution.forces.track.Fy, len(solution.patches))

Lengths are in mm, angles in rad, forces in N. Track coordinates have x forwards, y to the right, z down; see
docs/wheel-rail.md. Forces act on the rail. None is the daemon's default.
"""

from __future__ import annotations

import sys

from .callable_wheel_rail import WheelRailModule
from .values.generated.profile_shapes import (
    S1002,
    ArcProfile,
    ConeProfile,
    KinkRule,
    Profile,
    ProfileFile,
    ProfilePoints,
    Rail60E1,
    StandardName,
    StandardProfile,
)
from .values.generated.wheel_rail.forces import (
    WheelRailDerivatives,
    WheelRailForces,
    Wrench,
    WrenchesByPosition,
    WrenchesByVelocity,
)
from .values.generated.wheel_rail.places import (
    ContactPlace,
    ContactRadii,
    ContactReference,
    ContactRow,
    Creepages,
    OverlapRegion,
    RailPlace,
    WheelRailGeometry,
)
from .values.generated.wheel_rail.rigid_wheelset import (
    EquivalentConicity,
    PlacedProfiles,
    ProfileEvidence,
    ProfileOrigin,
    ProfilePlace,
    ProfileReading,
    ProfilesOfSides,
    RigidContact,
    WheelLandmarks,
    WheelsetContacts,
    WheelsetRoll,
)
from .values.generated.wheel_rail.setup import (
    Conformal,
    PatchRules,
    RailSprings,
    RigidSlipKind,
    Side,
    SlopeForces,
    Track,
    WheelRailFriction,
    WheelRailSetup,
    Wheelset,
    WheelSurface,
)
from .values.generated.wheel_rail.state import (
    RailDeviation,
    WheelDeviation,
    WheelRailState,
    WheelsetPosition,
    WheelsetState,
    WheelsetVelocity,
)
from .values.wheel_rail.solution import RailDeflection, WheelRailPatch, WheelRailSolution, WheelsetSolution

__all__ = [
    "S1002",
    "ArcProfile",
    "ConeProfile",
    "Conformal",
    "ContactPlace",
    "ContactRadii",
    "ContactReference",
    "ContactRow",
    "Creepages",
    "EquivalentConicity",
    "KinkRule",
    "OverlapRegion",
    "PatchRules",
    "PlacedProfiles",
    "Profile",
    "ProfileEvidence",
    "ProfileFile",
    "ProfileOrigin",
    "ProfilePlace",
    "ProfilePoints",
    "ProfileReading",
    "ProfilesOfSides",
    "Rail60E1",
    "RailDeflection",
    "RailDeviation",
    "RailPlace",
    "RailSprings",
    "RigidContact",
    "RigidSlipKind",
    "Side",
    "SlopeForces",
    "StandardName",
    "StandardProfile",
    "Track",
    "WheelDeviation",
    "WheelLandmarks",
    "WheelRailDerivatives",
    "WheelRailForces",
    "WheelRailFriction",
    "WheelRailGeometry",
    "WheelRailPatch",
    "WheelRailSetup",
    "WheelRailSolution",
    "WheelRailState",
    "WheelSurface",
    "Wheelset",
    "WheelsetContacts",
    "WheelsetPosition",
    "WheelsetRoll",
    "WheelsetSolution",
    "WheelsetState",
    "WheelsetVelocity",
    "Wrench",
    "WrenchesByPosition",
    "WrenchesByVelocity",
]

sys.modules[__name__].__class__ = WheelRailModule
