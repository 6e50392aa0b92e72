"""Provides small input files of the CONTACT program, one for each rule of its conventions."""

from __future__ import annotations

import numpy as np

__all__ = ["END", "OWN", "PROFILES"]


def basic(
    *, digits="203100", second="022020", third="0000301", solver="999 20 25 1 1e-6", motion="50000. 0.0005 0. 0.0001",
    friction="0.3 0.3", step="0. 0.5 20000.", bodies="0.28 0.28 82000. 82000.", area="-3\n15 15 6. 4. 1.1", more="",
):  # fmt: skip
    """Describes steady rolling of an ellipse of 6 by 4 mm under 50 kN."""
    lines = ["3 MODULE", digits, second, third, solver, motion, friction, step, bodies, area, more]
    return "\n".join(line for line in lines if line) + "\n"


def rails(
    *, digits="1203100", second="0022033", friction="0.3 0.3", track="14. 0 1435. 0.", rail="'rail.txt' 0 1. 0. -1",
    wheel="'wheel.txt' 0 1. 0. -1", position="0. 1. 10000. 0. 0.001 0.", velocity="2000. 0. 0. 0. 0. -4.348", more="",
):  # fmt: skip
    """Describes a right wheel that rolls under 10 kN."""
    lines = ["1 MODULE", digits, second, "0000301", "999 20 25 1 1e-6", friction, more, "0.28 0.28 82000. 82000.",
             "0.5 0.5 1. 90d 8. 4.", track, rail, "0. 0. 0. 0. 0. 0.", "1360. -70. 460.", wheel, position, velocity]  # fmt: skip
    return "\n".join(line for line in lines if line) + "\n"


END = "0 MODULE\n"
_DISSIMILAR, _FALLS, _LAYER = "0.28 0.20 82000. 41000.", "0.2 0.15 300. 0.02 2000.\n0. 1.", "0.28 0.28 82000. 82000.\n8200. 0.06"
_SHIFT = "3 MODULE\n{}01100\n122020\n0100301\n50000. {} 0. 0.\n0.28 0.28 82000. 82000.\n-3\n15 15 6. 4. 1.1\n"
_RECTANGLE = "1\n15 15 -4. -4. 0.5 0.5\n1 1\n1e-3 0. 2e-3 0. 0. 0."
_GRID, _LIGHT = "1\n15 15 -4. -4. 0.5 0.5", "5000. 0.0005 0. 0.0001"
_YIELDS = f"{_LAYER} 100. 1000."
_KINKS = "'wheel.txt' 0 1. 0. -1 1\n0 150d 5d 1d {}"


def _planform(kind, values):
    return f"{_GRID}\n1 {kind}\n1e-3 0. 2e-3 0. 0. 0.\n{values}"


#: Texts of cases.
OWN: dict[str, str] = {
    "steady rolling": basic(),
    "one outer iteration of dissimilar bodies": basic(bodies=_DISSIMILAR),
    "outer iterations that reach MAXOUT": basic(bodies=_DISSIMILAR, solver="999 20 25 2 1e-6"),
    "iterations that reach MAXGS": basic(solver="3 20 25 1 1e-6"),
    "bodies that hardly differ": basic(bodies="0.28 0.2803 82000. 82000."),
    "a line with rows beyond its ends, by its curvature": basic(area="-4\n15 12 0.005 8. 1.5"),
    "a line with rows beyond its ends, by its width": basic(area="-5\n15 12 0.4 8. 1.3"),
    "a force beyond friction": basic(digits="203110", motion="5000. 1.2 0. 0.", area=_RECTANGLE),
    "two forces beyond friction": basic(digits="203120", motion="5000. 0.9 -0.9 0.", area=_RECTANGLE),
    "falling friction from adhesion": basic(second="422020", friction=_FALLS),
    "falling friction from full slip": basic(second="422020", third="0400301", friction=_FALLS, solver="999 20 25 1 1e-6\n-1 0.5"),
    "a layer that shears": basic(second="022420", bodies=f"{_LAYER} 0. 0."),
    "stresses and displacements below the surface": basic(digits="203103", bodies=_DISSIMILAR, more="1 0\n9\n2 2 3\n-1. 2.\n0. 3.\n-2. 0.5 1.5\n0"),
    "shifts one after the other, the last one repeated": (basic(digits="201100", step="") + _SHIFT.format("0", 0.002) + _SHIFT.format("3", 0.004)),
    "elements that a conic leaves": basic(motion=_LIGHT, area=_planform(2, "1. 0. 1. 0. 0. -4.")),
    "elements in two rectangles": basic(motion=_LIGHT, area=_planform(3, "-3. -0.4 -3. 3. 0.4 3. -3. 3.")),
    "patches that share their displacements": basic(motion=_LIGHT, area=_planform(4, "2\n-3. -0.4 -3. 3.\n0.4 3. -3. 3.\n0.7")),
    "a profile across": basic(motion=_LIGHT, area=f"{_GRID}\n2 1\n3 0. 500. -4. 4.\n0.03 0. 0.03"),
    "waves": basic(motion=_LIGHT, area=f"{_GRID}\n3 1\n1e-3 1. 0. 1e-3 2. 0. 500. 250."),
    "spin along x alone": basic(second="022022"),
    "spin along y alone": basic(second="022023"),
    "spin along x alone in a shift": basic(digits="201100", second="022022", step="", motion="50000. 0.002 0. 0.001 1. 2."),
    "a centre of spin": basic(motion="50000. 0.0005 0. 0.0001 2. -1."),
    "a centre of spin with a force": basic(digits="203110", motion="50000. 0.5 0. 0.0001 2. -1."),
    "spin half a step ahead": basic(step="0. 0.5 20000. 0.5"),
    "a direction that steady rolling does not take": basic(step="30d 0.5 20000."),
    "a direction that ConvexGS takes": basic(third="0200301", solver="999 20 25 1 1e-6\n0.9 1. 0 1.", step="30d 0.5 20000."),
    "friction by rows": basic(second="3022020", friction="", more="\n".join(f"{0.2 + 0.01 * row} {0.2 + 0.01 * row}" for row in range(15))),
    "a force as a share of friction by rows": basic(
            digits="203110", second="3022020", friction="", motion="50000. 0.1 0. 0.0001",
            more="\n".join(f"{0.2 + 0.01 * row} {0.2 + 0.01 * row}" for row in range(15)),
        ),
    "a thin sheet": basic(digits="213100", bodies="0.28 0.28 82000. 82000.\n1e-6"),
    "a shift that goes on with more elements elsewhere": (basic(digits="201100", step="", motion="5000. 0.002 0. 0.", area=_RECTANGLE)
        + "3 MODULE\n001100\n122020\n0100301\n5000. 0.002 0. 0.\n0.28 0.28 82000. 82000.\n"
        + "1\n17 16 -4.6 -4. 0.5 0.5\n1 1\n1e-3 0. 2e-3 0. 0. 0.\n"),
    "shifts of Hertz's elements under another load": (basic(digits="201100", step="", area="-1\n15 15 1e-3 2e-3 1.3")
        + "3 MODULE\n001100\n122020\n0100301\n55000. 0.004 0. 0.\n0.28 0.28 82000. 82000.\n-1\n15 15 1e-3 2e-3 1.3\n"),
    "a layer that yields and goes on": (basic(digits="201100", second="022420", step="", motion="50000. 0.01 0. 0.", bodies=_YIELDS)
        + f"3 MODULE\n001100\n122420\n0100301\n50000. -0.004 0.004 0.\n{_YIELDS}\n-3\n15 15 6. 4. 1.1\n"),
    "a layer that yields in transient rolling": (basic(digits="202100", second="022420", step="0. 0.8 20000.", motion="50000. 0.01 0. 0.", bodies=_YIELDS)
        + f"3 MODULE\n002100\n122420\n0100301\n50000. 0.01 0. 0.\n0. 0.8 20000.\n{_YIELDS}\n-3\n15 15 6. 4. 1.1\n"),
    "no friction": basic(digits="200100", step=""),
    "FASTSIM": basic(digits="233100", second="022320", bodies="0.28 0.28 82000. 82000.\n1. 1. 1."),
    "a wheel on a rail": rails(),
    "a wheel that rolls, yaws and rolls over": rails(position="0. 3. 10000. 0.01 0.02 0."),
    "a longitudinal force": rails(digits="1203110", velocity="2000. 0. 0. 0. 0. -500."),
    "kinks without a width": rails(wheel=_KINKS.format("0.")),
    "kinks with a width": rails(wheel=_KINKS.format("3.")),
    "friction along the track, between laws of which one does not fall": rails(second="2422033", friction="2\n-500. 0.3 0. 0. 0. 0.\n500. 0.15 0.15 300. 0.02 2000.\n0. 1.", position="100. 1. 10000. 0. 0.001 0."),
    "friction along the track, by two terms with a memory": rails(second="2322033", friction="2\n-500. 0.2 0.1 500. 0. 0.\n500. 0.15 0. 0. 0.15 300.\n0.002 1.", position="-300. 1. 10000. 0. 0.001 0."),
    "friction by the angle of each row": rails(second="1042033", friction="2\n-10d 0.1 0.1\n10d 0.4 0.4"),
}  # fmt: skip


def _profile(y, z):
    return "".join(f"{a:.4f} {b:.6f}\n" for a, b in zip(y, z))


_Y = np.linspace(-40, 40, 161)
#: Files named in the texts: a rail of 300 mm radius, and a cone with a bend.
PROFILES = {"rail.txt": _profile(_Y, _Y**2 / 600), "wheel.txt": _profile(_Y[::-1], np.where(_Y > 10, -0.025 * _Y - 0.1 * (_Y - 10), -0.025 * _Y)[::-1])}
