"""Defines wheels on rails that all interfaces answer alike; wheel_driver.py defines their words. Statements are those
of contactd.h.

A wheel without statements is a right one, S1002 on 60E1 at 1/40, gauge 1435, of steel, with mu = 0.3.
"""

from __future__ import annotations

from pathlib import Path

__all__ = ["EVERYWHERE", "REFUSED", "WITHOUT_C", "write"]

COARSE = "elements 0.8 0.8 0"
ROLLS = "velocity 20000 0 0 0 0 -43.4; Fz 80000"
ASIDE = f"{COARSE}; {ROLLS}; position 3 0 0.0005 0.0072"
FLANGE = f"{COARSE}; {ROLLS}; position 7.5 0 0.0005 0.0168"
HERTZ = f"{COARSE}; model hertz; frictionless; Fz 80000"
ARCS = f"{COARSE}; cone wheel -0.05 -40 40; arc rail 300 0.05 -30 30; rail_origin 750 0; wheelset 1360 -70 450; {ROLLS}"
LEVEL = "points wheel -40 {0} 0 {0} 40 {0}; add_wheel_slice"
FLAT = "; ".join(f"{LEVEL.format(z)} {angle}" for angle, z in ((-0.1, 0), (-0.05, 0), (-0.03, -0.3), (0, -0.5), (0.03, -0.3), (0.05, 0), (0.1, 0)))
ON_FLAT = f"{ARCS}; arc rail 300 0 -30 30; {FLAT}"
POINTS = "points rail -30 8 -20 1.4 -10 0.2 0 0 10 0.2 20 1.4 30 8; rail_origin 750 0"

EVERYWHERE = {
    # positions
    "in-the-middle": f"{COARSE}; {ROLLS}; solve",
    "aside": f"{ASIDE}; solve",
    "on-its-flange": f"{FLANGE}; solve",
    "a-left-wheel": f"{ASIDE}; side left; solve",
    "at-a-height": f"{COARSE}; velocity 20000 0 0 0 0 -43.4; position 0 0.3 0 0; solve",
    "above-its-rail": f"{COARSE}; position 0 -3 0 0; solve",
    "beside-its-rail": f"{COARSE}; position 200 0 0 0; Fz 10000; solve",
    "backwards": f"{COARSE}; Fz 60000; velocity -20000 0 0 0 0 43.4; solve",
    "at-rest": f"{COARSE}; Fz 60000; solve",
    "a-rail-that-deviates": f"{ASIDE}; deviation 1.5 0.5 0.01; deviation_rate 20 5 0.02; solve",
    "a-position-and-the-next": f"{ASIDE}; solve; position 3.5 0 0.0004 0.007; solve; side left; solve",
    # profiles, tracks, wheelsets
    "another-rail": f"{ASIDE}; rail_60e1 0.05; solve",
    "another-track": f"{ASIDE}; track 1430 14 0.01; solve",
    "another-wheelset": f"{ASIDE}; wheelset 1358 -70 500; solve",
    "a-cone-on-an-arc": f"{ARCS}; solve",
    "points": f"{COARSE}; {POINTS}; {ROLLS}; solve",
    "a-roller": f"{COARSE}; roller 600; roller_pitch 33; velocity 0 0 0 0 0 -43.4; Fz 60000; solve",
    "a-rail-that-varies": f"{ARCS}; add_slice -100; arc rail 200 0.05 -30 30; add_slice 100; x 20; solve",
    # out-of-round wheels, rails on springs
    "on-its-flat": f"{ON_FLAT}; solve; pitch_angle 0.02; solve; pitch_angle 6.3; position 1 0 0 0.002; solve",
    "round-again": f"{ON_FLAT}; pitch_angle 0.01; solve; clear_wheel_slices; solve",
    "a-left-wheel-with-a-flat": f"side left; {ON_FLAT}; pitch_angle -0.03; derivatives 1; solve",
    "on-springs": f"{FLANGE}; springs 10000 100000; solve; track 1434 14 0; solve; springs 0 50000; solve; springs 0 0; solve",
    "on-springs-with-forces": f"{ASIDE}; springs 20000 200000; rail_forces -2000 1000; deviation 0.5 0.1 0; derivatives 1; solve",
    "on-springs-at-a-height": f"{COARSE}; velocity 20000 0 0 0 0 -43.4; springs 0 200000; position 0 0.5 0 0; solve",
    "a-flat-on-springs": f"{ON_FLAT}; springs 20000 100000; solve; model fastsim; Fx 3000; solve",
    # bodies, models, friction
    "another-wheel-material": f"{ASIDE}; material wheel 60000 0.3; solve",
    "a-rigid-rail": f"{ASIDE}; rigid rail; solve",
    "hertz": f"{HERTZ}; solve",
    "fastsim": f"{ASIDE}; model fastsim; solve",
    "without-friction": f"{ASIDE}; frictionless; solve",
    "less-friction-on-the-flange": f"{FLANGE}; mu_by_angle 0 -0.8 0.1 -0.2 0.3; solve; mu_by_angle 1 -0.8 0.1 -0.2 0.3; solve",
    "friction-that-falls": f"{ASIDE}; kinetic exponential 0.15 500; solve",
    # options
    "elements-that-are-no-squares": f"{ASIDE}; elements 0.6 0.9 0.5; solve",
    "patch-rules": f"{FLANGE}; patch_rules 1.5 6 2 10 0.25; solve",
    "a-bilinear-wheel": f"{ASIDE}; bilinear 1; solve",
    "slip-of-the-surfaces": f"{FLANGE}; slip_of_surfaces 1; solve",
    "search-on-a-mesh": f"{ASIDE}; mesh_search 1; solve",
    "a-curved-contact": f"{FLANGE}; conformal rotated; solve",
    "derivatives": f"{ASIDE}; derivatives 1; solve",
    "a-longitudinal-force": f"{ASIDE}; Fx -4000; solve; clear_forces; Fz 60000; solve",
    "tolerances": f"{ASIDE}; tolerance tangential 1e-3 50; tolerance force 1e-4 20; solve",
    "too-few-solves": f"{ASIDE}; tolerance force 1e-9 1; solve",
    # bad input
    "no-gauge": f"{ASIDE}; track 0 14 0; solve",
    "a-gauge-within-the-rail": f"{ASIDE}; track 40 14 0; solve",
    "degrees": f"{ASIDE}; position 0 0 2 0; solve",
    "far-inside-its-rail": f"{COARSE}; position 0 10 0 0; solve",
    "a-force-that-pulls": f"{ASIDE}; Fz -1; solve",
    "friction-below-zero": f"{ASIDE}; mu -0.1; solve",
    "hertz-with-friction": f"{ASIDE}; model hertz; solve",
    "one-slice": f"{ARCS}; add_slice 0; solve",
    "points-that-cross": f"{COARSE}; points rail -10 0 10 1 10 0 -10 1 -20 3; {ROLLS}; solve",
    "one-wheel-slice": f"{ASIDE}; add_wheel_slice 0; solve",
    "wheel-slices-in-degrees": f"{ASIDE}; add_wheel_slice 0; add_wheel_slice 90; solve",
    "a-spring-that-pushes": f"{ASIDE}; springs -1 0; solve",
    "a-force-on-a-rigid-rail": f"{ASIDE}; rail_forces 0 100; solve",
    "rules-in-no-order": f"{ASIDE}; patch_rules 1.5 4 8 12 0.3; solve",
}
REFUSED = {name for name in EVERYWHERE if list(EVERYWHERE).index(name) >= list(EVERYWHERE).index("no-gauge")}

#: Calls that contactd.h does not support: the search alone, and sessions that the caller steps.
WITHOUT_C = {
    "where-it-touches": f"{ASIDE}; geometry; position 7.5 0 0.0005 0.0168; geometry; side left; geometry",
    "where-it-would-touch": f"{COARSE}; position 0 -3 0 0; geometry",
    "a-session": f"{ASIDE}; open; step; position 3.2 0 0.0005 0.0072; step; mu 0.2; step",
    "a-session-of-fastsim": f"{ASIDE}; model fastsim; open; step; Fx -3000; step",
}


def write(path: Path, cases: dict[str, str]) -> Path:
    """Returns the cases as lines, which all drivers read."""
    lines = [f"case {name}\n" + "\n".join(part.strip() for part in text.split(";")) for name, text in cases.items()]
    path.write_text("\n".join(lines) + "\n")
    return path
