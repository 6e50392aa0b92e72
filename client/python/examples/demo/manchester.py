"""Describes the Manchester contact benchmark, case A-2.2: a wheelset with S1002 wheels on 60E1 rails at 1/40 that
moves 10 mm to the right and yaws by 2.4 mrad/mm, with results printed by an established program.

Fz = 10 kN a wheel, G = 82000 N/mm^2, nu = 0.28, mu = 0.3, 2000 mm/s, elements of 0.2 x 0.2 mm.
"""

from __future__ import annotations

from dataclasses import dataclass

from contactd.wheel_rail import (
    S1002,
    Rail60E1,
    WheelRailFriction,
    WheelRailSetup,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)

MU, FZ = 0.3, 10000.0
YAW = 0.0024  # rad for each mm


@dataclass(frozen=True)
class Known:
    """Holds the printed results: height of the wheelset (mm), forces on the rail in track coordinates (N), position of
    the contact (mm), its angle (rad), normal force (N), largest pressure (N/mm^2).
    """

    z: float
    Fx: float
    Fy: float
    y_contact: float
    angle: float
    Fn: float
    pmax: float


#: Shift y (mm), roll (rad), pitch rate (rad/s).
POSITIONS = [
    (0.0, 0.0, -4.3481181),
    (1.0, -5.049e-05, -4.3465752),
    (2.0, -0.0001128, -4.3459197),
    (3.0, -0.0001803, -4.3451503),
    (4.0, -0.0002557, -4.344093),
    (5.0, -0.0003554, -4.3353637),
    (6.0, -0.0006272, -4.3293718),
    (7.0, -0.006393, -4.2635629),
    (8.0, -0.008606, -4.2534857),
    (9.0, -0.01010113, -4.2477561),
    (10.0, -0.01126431, -4.2436375),
]

#: Results of each wheel, for each position.
KNOWN = {
    "left": [
        Known(0.1981, 0.2783, -36.24, -751.8726, 0.029, 9997.0, 338.3),
        Known(0.184, 829.2, -3070.0, -755.244, 0.0176, 10050.0, 423.9),
        Known(0.153, 546.3, -3096.0, -756.5056, 0.0134, 10040.0, 465.9),
        Known(0.1145, 460.5, -3084.0, -757.2358, 0.011, 10030.0, 498.8),
        Known(0.068, 436.6, -3073.0, -757.6645, 0.0096, 10030.0, 527.2),
        Known(0.0019, 837.8, -2977.0, -757.8958, 0.0088, 10030.0, 552.8),
        Known(-0.1957, 973.1, -2929.0, -758.021, 0.0084, 10020.0, 578.5),
        Known(-4.5803, 2327.0, -1964.0, -758.6092, 0.0064, 10010.0, 666.7),
        Known(-6.2606, 2310.0, -1998.0, -758.2223, 0.0077, 10020.0, 701.1),
        Known(-7.3913, 2257.0, -2080.0, -757.6922, 0.0095, 10020.0, 725.3),
        Known(-8.2662, 2196.0, -2169.0, -757.0975, 0.0115, 10020.0, 744.0),
    ],
    "right": [
        Known(0.1981, 0.2783, 36.24, 751.8726, -0.029, 9997.0, 338.3),
        Known(0.1839, -814.3, -2142.0, 741.9908, -0.0696, 9827.0, 741.3),
        Known(0.1529, -517.3, -2095.0, 740.9147, -0.0806, 9799.0, 744.8),
        Known(0.1143, -417.5, -1988.0, 739.9698, -0.0923, 9774.0, 713.2),
        Known(0.0676, -379.6, -1833.0, 738.7381, -0.1078, 9745.0, 664.4),
        Known(0.0015, -763.3, 131.6, 727.0855, -0.2905, 9619.0, 1556.0),
        Known(-0.1961, -880.0, 1401.0, 725.1371, -0.4176, 9709.0, 1149.0),
        Known(-4.5809, -2079.0, 10490.0, 719.0445, -1.0634, 14030.0, 2622.0),
        Known(-6.2615, -2070.0, 8493.0, 719.8316, -0.9501, 12720.0, 2634.0),
        Known(-7.3919, -2014.0, 7213.0, 720.4903, -0.8676, 11970.0, 2640.0),
        Known(-8.2668, -1947.0, 6235.0, 721.088, -0.7992, 11440.0, 2643.0),
    ],
}

SETUPS = {
    side: WheelRailSetup(
        side=side, wheel=S1002(), rail=Rail60E1(1 / 40), friction=WheelRailFriction(MU), dx=0.2, dy=0.2
    )
    for side in ("left", "right")
}


def state_at(y: float, roll: float, pitch: float) -> WheelRailState:
    position = WheelsetPosition(y=y, roll=roll, yaw=YAW * y)
    return WheelRailState(position=position, velocity=WheelsetVelocity(x=2000, pitch=pitch), Fz=FZ)
