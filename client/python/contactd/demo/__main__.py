"""Solves the Cattaneo problem in this process, prints it next to Hertz and Cattaneo, and draws it.

Run: python -m contactd.demo [PICTURE]. It takes a second, and needs no daemon if contactd-local is installed. Exit
status: 0 if forces and pressure are within 1 % of the closed form, 1 if not, 2 if something is missing or cannot be
written.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
import time
from pathlib import Path

from .._version import __version__
from ..errors import ContactdError
from ..local import local
from ..values.generated.friction import Friction
from ..values.generated.grid import Grid, Paraboloid
from ..values.generated.materials import Material
from .closed_form import Sphere

__all__ = ["main"]

SPHERE = Sphere(G=200, nu=0.42, radius=50, approach=0.02, mu=0.4, shift=0.00817)
GRID = Grid.centred(40, 40, 2.4, 2.4)
_ENDINGS = (".png", ".pdf", ".svg")
ACCURACY = 0.01  #: Relative, for 40 elements across. Cattaneo's solution also neglects lateral tractions.


def run(picture: Path) -> int:
    """Solves, prints and draws; returns the exit status."""
    with local() as client:
        began = time.perf_counter()
        solution = client.solve(
            grid=GRID,
            upper=Material(SPHERE.G, SPHERE.nu),
            gap=Paraboloid(SPHERE.radius, SPHERE.radius),
            approach=SPHERE.approach,
            friction=Friction(SPHERE.mu, (SPHERE.shift, 0)),
        )
        milliseconds = 1000 * (time.perf_counter() - began)
        how = "in this process" if client.endpoint == "local" else "by a private daemon"
    print(f"contactd {__version__}: a sphere of {SPHERE.radius:g} mm pressed {SPHERE.approach:g} mm into a plane, and shifted.")
    print(f"{GRID.nx} x {GRID.ny} elements, solved {how} in {milliseconds:.0f} ms.\n")
    print(f"{'':24}{'contactd':>12}{'closed form':>14}")
    compared = [
        ("Fn (N)", solution.Fn, SPHERE.normal_force),
        ("|Fx| (N)", abs(solution.Fx), SPHERE.tangential_force),
        ("pmax (N/mm^2)", solution.pmax, SPHERE.pmax),
    ]
    adhesion = math.pi * SPHERE.adhesion_radius**2
    for name, found, expected in [*compared, ("area of adhesion (mm^2)", solution.area.adhesion, adhesion)]:
        print(f"{name:24}{found:12.5f}{expected:14.5f}")
    from .picture import draw

    draw(picture, GRID, solution, SPHERE, f"{GRID.nx} x {GRID.ny} elements, coefficients of the half-space in closed form")
    print(f"\nThe picture: {picture}")
    return 0 if all(abs(found / expected - 1) <= ACCURACY for _, found, expected in compared) else 1


def main() -> int:
    """Reads the command line."""
    parser = argparse.ArgumentParser(prog="python -m contactd.demo", description=(__doc__ or "").split("\n\n")[0])
    parser.add_argument("picture", nargs="?", type=Path, default=Path("contactd-demo.png"), help="output file: PNG, PDF or SVG (contactd-demo.png)")
    picture = parser.parse_args().picture
    if picture.suffix.lower() not in _ENDINGS or picture.is_dir():
        parser.error(f"{picture}: the name of a picture must end in {', '.join(_ENDINGS)}")
    try:
        status = run(picture)
        sys.stdout.flush()
        return status
    except BrokenPipeError:  # The reader of the output has closed it.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    except (ContactdError, OSError) as error:
        print(f"The demo failed. {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
