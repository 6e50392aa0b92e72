"""Tables of invented numbers, for tests that do not depend on physics."""

import numpy as np

from contactd import AnalyticIcs, Grid, IcEvidence, IcTable, Material
from contactd.values.tables import IcSpec

NX, NY, DX, DY = 4, 3, 0.06, 0.11
SIGNS = {(i, j): tuple(-1 if (i == a) != (j == a) else 1 for a in (0, 1)) for i in range(3) for j in range(3)}


def made_up(seed=1, nx=NX, ny=NY):
    """Returns an array with the symmetry of tables."""
    array = np.random.default_rng(seed).uniform(0.1, 1, (3, 3, ny, nx)) * 1e-5
    for (i, j), (along_x, along_y) in SIGNS.items():
        if along_x < 0:
            array[i, j, :, 0] = 0
        if along_y < 0:
            array[i, j, 0, :] = 0
    return array


SOFT, CLOSED_FORM, ANALYTIC = Material(200, 0.42), AnalyticIcs(), IcEvidence("analytic")


def ic_table(seed=1, material=SOFT, ics=CLOSED_FORM, evidence=ANALYTIC, nx=NX, dx=DX):
    return IcTable("abc", "closed_form", IcSpec(material, Grid(nx, NY, dx, DY), ics), made_up(seed, nx), evidence)
