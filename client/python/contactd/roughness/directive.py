"""The contact filters of EU law: table G-2 of annex II to Directive 2002/49/EC, as amended by Delegated Directive (EU)
2021/1226, annex, point 20(b).

The numbers are those of two public copies that agree in all values: the data file of NoiseModelling (Université Gustave
Eiffel) and the tables of phonometry (jmrplens/phonometry). They are kept as published: -1.3 dB at 40 mm for 50 kN and
920 mm does not fit its neighbours.
"""

from __future__ import annotations

import numpy as np

from .spectra import Spectrum, nominal

__all__ = ["DIRECTIVE_2002_49"]

_WAVELENGTHS = np.array([nominal(band) for band in range(-3, 32)])  # 2000 to 0.8 mm
_LEVELS = {
    (50, 360): "0 0 0 -.1 -.2 -.3 -.6 -1 -1.8 -3.2 -5.4 -8.7 -12.2 -16.7 -17.7 -17.8 -20.7 -22.1 -22.8 -24 -24.5 -24.7 -27 -27.8",
    (50, 680): "0 0 -.1 -.2 -.3 -.7 -1.2 -2 -4.1 -6 -9.2 -13.8 -17.2 -17.7 -18.6 -21.5 -22.3 -23.1 -24.4 -24.5 -25 -28 -28.8 -29.6",
    (50, 920): "0 -.1 -.1 -.3 -.6 -1.1 -1.3 -3.5 -5.3 -8 -12 -16.8 -17.7 -18 -21.5 -21.8 -22.8 -24 -24.5 -25 -27.3 -28.1 -28.9 -29.7",
    (25, 920): "0 0 0 -.1 -.3 -.5 -1.1 -1.8 -3.3 -5.3 -7.9 -12.8 -16.8 -17.7 -18.2 -20.5 -22 -22.8 -24.2 -24.5 -25 -27.4 -28.2 -29",
    (100, 920): "-.1 -.2 -.3 -.6 -1 -1.8 -3.2 -5.4 -8.7 -12.2 -16.7 -17.7 -17.8 -20.7 -22.1 -22.8 -24 -24.5 -24.7 -27 -27.8 -28.6 -29.4 -30.2",
}  # fmt: skip
#: The filters in dB by wheel load (kN) and wheel diameter (mm). They are 0 from 2000 to 200 mm.
DIRECTIVE_2002_49 = {
    column: Spectrum(_WAVELENGTHS, np.array([0.0] * 11 + [float(word) for word in levels.split()])) for column, levels in _LEVELS.items()
}
