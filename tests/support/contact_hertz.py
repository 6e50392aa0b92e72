"""Makes a case of the CONTACT program with a closed form: an elliptic contact in full slip, and its printed results."""

from __future__ import annotations

from math import pi
from pathlib import Path

from contactd.values.hertz import Load, compliance_of, ellipse_of_axes

__all__ = ["INPUT", "printed", "write_case"]

FN, MU, AA, BB = 80e3, 0.3, 7.0, 5.5
INPUT = f"""3 MODULE
 203100 P-B-T-N-F-S
 022020 L-D-C-M-Z-E
 000001 H-G-I-A-O-W-R
 999 20 25 1 1e-5         MAXGS, MAXIN, MAXNR, MAXOUT, EPS
 {FN} 0.1 0. 0.           FN, CKSI, CETA, CPHI
 {MU} {MU}                FSTAT, FKIN
 0. 0.25 2000.            CHI, DQ, VELOC
 0.28 0.28 82000. 82000.  POISS, GG
 -3                       IPOTCN
 60 60 {AA} {BB} 1.1      MX, MY, AA, BB, SCALE
0 MODULE
"""


def printed(Fx: float = -MU * FN) -> str:
    """Returns the text of the .out file, from the formulas of Hertz and Coulomb."""
    approach = ellipse_of_axes(AA, BB, Load(FN, True, compliance_of((0.28, 0.28), (82000.0, 82000.0)))).approach
    pmax = 1.5 * FN / (pi * AA * BB)
    return f""" Case     1

    FN         FX         FY
    {FN:.4E} {Fx:.4E} 0.0000E+00
    FN/G       APPROACH   PMAX
    {FN / 82000:.6E} {approach:.6E} {pmax:.4E}
"""


def write_case(folder: Path) -> None:
    """Writes x.inp and x.out."""
    (folder / "x.inp").write_text(INPUT)
    (folder / "x.out").write_text(printed())
