"""Defines the cases that all interfaces answer alike, each once. Statements are those of contactd.h; driver.py defines
their words.

Every case is a separate contact. Numbers of arrays are sums of few powers of two, which are exact in every language:
"ramp" is base, scale, step, period: base + scale ((step i) mod period).
"""

from __future__ import annotations

from pathlib import Path

__all__ = ["CASES", "write"]

SPHERE = "grid 12 12 0.2 0.2 -1.2 -1.2; material both 200 0.42; paraboloid 50 50; approach 0.02"
WHEEL = "grid 15 15 1 1 -7.5 -7.5; material both 82000 0.28; paraboloid 460 300; Fn 50000"
UNLIKE = f"{SPHERE}; material lower 900 0.2"
SHIFT = "mu 0.4; shift 0.004 0 0"
STEADY = "mu 0.3; rolling steady 0.004 -0.001 0.002"
TRANSIENT = "mu 0.3; rolling transient 0.004 0 0"
CREEP = "mu 0.3; rolling steady 0.001 0.0005 0.0001"
STEEL_UNDER_A_RIGID_BODY = "grid 15 20 0.5 0.5 -3.75 -5; rigid upper; material lower 82000 0.28; gap 0.0009765625; Fn 3000"
GROOVE = f"{STEEL_UNDER_A_RIGID_BODY}; section lower groove 20 20 120 70; section_accuracy lower 0"
OUTLINE = (
    f"{STEEL_UNDER_A_RIGID_BODY}; outline lower -20 0; spline lower 0 -10 0.625 0 0.875 10 0.625 20 0; line lower 20 -30 0;"
    " line lower -20 -30 1; line lower -20 0 0; hole lower 5 -15; arc lower -5 -15 -5 0; arc lower 5 -15 -5 0;"
    " first_column lower 0 0 15; section_accuracy lower 0"
)
LINE = "grid 96 1 0.02 1 -0.96 -0.5; material both 200 0.42; paraboloid 50 inf; Fn 5"

CASES = {
    # normal contact
    "approach": f"{SPHERE}; start; step",
    "force": f"{SPHERE}; Fn 5; start; step",
    "approach-and-force": f"{SPHERE}; start; step; Fn 5; step; approach 0.01; step",
    "nothing-touches": f"{SPHERE}; approach -0.01; start; step; approach 0.01; step",
    "no-force": f"{SPHERE}; Fn 0; start; step",
    "semi-axes": f"{SPHERE}; semi_axes 0.9 0.7; start; step; semi_axes 0.7 0.9; step",
    "semi-axes-under-force": f"{SPHERE}; semi_axes 0.9 0.7; Fn 6; start; step",
    "gap-of-its-own": f"{SPHERE}; gap 0.000244140625; start; step; gap 0.00048828125; step",
    "ellipse-off-centre": f"{SPHERE}; grid 12 12 0.2 0.2 -1.3 -1.0; paraboloid 40 60; start; step",
    "elements-that-are-no-squares": f"{SPHERE}; grid 10 16 0.25 0.15 -1.25 -1.2; start; step",
    "at-the-border": f"{SPHERE}; approach 0.04; start; step",
    "flat-bodies": f"{SPHERE}; gap 0; approach 0.001; start; step",
    "radii-that-change": f"{WHEEL}; start; step; paraboloid 400 350; step; Fn 60000; step",
    # bodies and coefficients
    "bodies-that-differ-without-friction": f"{UNLIKE}; start; step",
    "a-rigid-body": f"{SPHERE}; rigid lower; start; step",
    "hat-functions": f"{SPHERE}; half_space both bilinear; start; step",
    "a-rigid-body-and-hat-functions": f"{SPHERE}; rigid upper; half_space lower bilinear; start; step",
    "a-table-of-the-pair": f"{SPHERE}; table pair 12 12 0.2 0.2 0.0009765625; start; step",
    "a-table-of-a-body": f"{SPHERE}; table upper 12 12 0.2 0.2 0.0009765625; {SHIFT}; start; step",
    "a-rubber-layer": f"{SPHERE}; layers upper constant 0 0 0.5 20 0.5; start; step",
    "coatings-that-shift": f"{SPHERE}; layers both bilinear 200 0.42 0.05 800 0.3 0.2 100 0.45; {SHIFT}; start; step; step",
    "a-layer-that-rolls": f"{WHEEL}; layers lower constant 82000 0.28 0.5 40000 0.3; {CREEP}; start; step",
    "cylinders-that-creep": f"{LINE}; line_contact 20; creep both 1 0.25; mu 0.3; rolling steady 0.001 0 0; velocity 4; start;"
    " step; velocity 1; step; velocity 4; step",
    "a-ball-that-creeps": f"{UNLIKE}; creep lower 2 0.125; mu 0.3; rolling steady 0.004 -0.001 0; velocity 4; start; step",
    "a-line": f"{LINE}; line_contact 20; start; step",
    "a-line-that-rolls": f"{LINE}; line_contact 20; mu 0.3; rolling steady 0.001 0 0; start; step",
    # sections, and curved columns
    "a-groove": f"{GROOVE}; columns 0 0 0; start; step",
    "a-groove-that-rolls": f"{GROOVE}; columns 0 0.5 -0.25; {CREEP}; start; step; Fn 2500; step",
    "a-groove-that-shifts": f"{GROOVE}; columns 0.125 0 0; mu 0.4; shift 0.004 0.002 0.0001; start; step; step",
    "half-a-groove-twice-as-large": f"{GROOVE}; section lower groove 40 40 240 140; section_place lower 0.5 0.125;"
    " section_accuracy lower 0; columns 0.125 0 0; start; step",
    "a-rail-head-from-aside": f"{STEEL_UNDER_A_RIGID_BODY}; section lower rail_60e1 0.025 1 16; section_accuracy lower 0;"
    " columns 0.25 20 0; start; step",
    "a-rim": f"{STEEL_UNDER_A_RIGID_BODY}; section lower rim_s1002 60 3; section_accuracy lower 0; columns 3.140625 0 0; start; step",
    "a-disc-in-a-hole": f"{GROOVE}; material upper 200 0.42; section lower plate_hole 25 200; section upper disc 24 2;"
    " section_accuracy both 0; columns 0 0 0; start; step",
    "an-edge": f"{STEEL_UNDER_A_RIGID_BODY}; paraboloid 50 50; section lower edge_block 100 50 1; section_accuracy lower 0;"
    f" {CREEP}; start; step",
    "an-outline-with-a-hole": f"{OUTLINE}; columns 0 0 0; start; step",
    "a-measured-profile": f"{STEEL_UNDER_A_RIGID_BODY}; profile lower rail 0.001953125 5 40 -5; section_accuracy lower 0;"
    f" columns 0 0 0; {CREEP}; start; step",
    "columns-of-half-spaces": f"{WHEEL}; gap 0.0009765625; flat_columns 0 0 0; {CREEP}; start; step",
    # shifts
    "shift": f"{SPHERE}; {SHIFT}; start; step",
    "shift-there-and-back": f"{SPHERE}; {SHIFT}; start; step; step; shift -0.006 0.001 0.001; step; step",
    "shift-and-rotation": f"{SPHERE}; mu 0.4; shift 0.001 -0.002 0.004; start; step; Fn 6; step",
    "all-slips": f"{SPHERE}; mu 0.1; shift 0.05 0 0; start; step",
    "no-friction-worth-it": f"{SPHERE}; mu 0; shift 0.05 0 0; start; step",
    "shift-under-a-force": f"{SPHERE}; mu 0.4; shift 0 0 0; Fx -1.5; start; step; Fx -2; step; clear_forces; step",
    "shift-under-both-forces": f"{SPHERE}; mu 0.4; shift 0.001 0 0; Fx -1.5; Fy 0.5; start; step; step",
    "shift-of-steel": f"{WHEEL}; mu 0.3; shift 0.01 0.005 0; start; step; step",
    "shift-of-bodies-that-differ": f"{UNLIKE}; mu 0.4; shift 0.002 0 0; start; step; step",
    "shift-under-force-of-bodies-that-differ": f"{UNLIKE}; mu 0.4; shift 0 0 0; Fx -1; start; step",
    "friction-by-element": f"{SPHERE}; mu_array 0.25 0.0078125 7 12; shift 0.004 0 0; start; step",
    "friction-that-falls": f"{SPHERE}; mu 0.4; kinetic exponential 0.1 0.01; duration 0.5; shift 0.004 0 0; start; step",
    "friction-that-falls-linearly": f"{SPHERE}; mu 0.4; kinetic linear 0.2 0.05; shift 0.004 0.001 0; start; step",
    "slip-of-the-elements": f"{SPHERE}; mu 0.4; shift 0 0 0; rigid_slip 0.0009765625 0.0001220703125 5 7 0 0.00006103515625 3 5;"
    " start; step",
    "friction-that-comes-later": f"{SPHERE}; start; step; {SHIFT}; step; mu 0.2; step",
    # rolling
    "steady-rolling": f"{SPHERE}; {STEADY}; start; step",
    "creepages-that-change": f"{WHEEL}; {CREEP}; start; step; rolling steady 0.0012 0.0004 0.0001; step; Fn 48000; step",
    "spin": f"{WHEEL}; mu 0.3; rolling steady 0 0 0.0004; start; step; spin_offset 0.16666666666666666; step",
    "direction-and-step": f"{SPHERE}; {STEADY}; direction 0.5 0.15; start; step; direction 0.25 0.1; step",
    "velocity": f"{WHEEL}; {CREEP}; velocity 30000; start; step",
    "rolling-under-a-force": f"{SPHERE}; {STEADY}; Fx -1; start; step; step",
    "rolling-under-forces-that-come": f"{SPHERE}; {STEADY}; start; step; Fx -1; step; {STEADY}; Fy 0.2; step",
    "transient-rolling": f"{SPHERE}; {TRANSIENT}; rolling_steps 2; start; step; step; step",
    "transient-rolling-from-rest": f"{WHEEL}; mu 0.3; rolling transient 0.002 0.001 0; start; step; step; step",
    "transient-rolling-that-changes": f"{SPHERE}; {TRANSIENT}; start; step; rolling transient -0.004 0 0.002; step; Fn 5; step",
    "rolling-of-bodies-that-differ": f"{UNLIKE}; {STEADY}; start; step",
    "rolling-with-friction-that-falls": f"{SPHERE}; {STEADY}; kinetic exponential 0.1 0.01; start; step",
    "rolling-and-then-a-shift": f"{SPHERE}; {STEADY}; start; step; shift 0.002 0 0; step",
    # histories
    "a-history": f"{SPHERE}; previous 1 0 0 1 0.125 0 0 1 -0.125 0 0 1; {SHIFT}; start; step",
    "a-history-of-rolling": f"{SPHERE}; previous 1 0.03125 7 12 0.125 0 0 1 0 0.015625 5 7; {TRANSIENT}; start; step",
    # steps that are reset, saved and restored
    "save-and-restore": f"{SPHERE}; {SHIFT}; start; step; save 1; step; step; restore 1; step",
    "two-states": f"{SPHERE}; {TRANSIENT}; start; save 1; step; save 2; step; restore 2; step; restore 1; step; forget 1; step",
    "a-step-again": f"{SPHERE}; {SHIFT}; start; step; again; shift 0.002 0.001 0; again; step",
    "a-step-again-after-one-that-failed": f"{SPHERE}; {SHIFT}; start; step; Fx 1000; step; clear_forces; again; step",
    # quick models
    "hertz": f"{WHEEL}; model hertz; start; step; Fn 60000; step; approach 0.05; step",
    "hertz-semi-axes": f"{WHEEL}; model hertz; semi_axes 6 4; start; step",
    "hertz-with-a-shift": f"{WHEEL}; model hertz; mu 0.3; shift 0.01 0 0; start; step",
    "hertz-that-rolls": f"{WHEEL}; model hertz; {CREEP}; rolling steady 0.001 0.0005 0; start; step",
    "fastsim": f"{WHEEL}; model fastsim; {CREEP}; start; step; rolling steady 0.002 0 0.0004; step",
    "fastsim-under-forces": f"{WHEEL}; model fastsim; {CREEP}; Fx -5000; Fy -2000; start; step",
    "fastsim-of-bodies-that-differ": f"{WHEEL}; material lower 41000 0.3; model fastsim; {CREEP}; start; step",
    # derivatives
    "derivatives-of-normal-contact": f"{WHEEL}; derivatives 1; start; step; approach 0.06; step",
    "derivatives-of-a-shift": f"{SPHERE}; {SHIFT}; derivatives 1; start; step; step",
    "derivatives-of-steady-rolling": f"{WHEEL}; {CREEP}; derivatives 1; start; step; derivatives 0; step",
    "derivatives-of-transient-rolling": f"{SPHERE}; {TRANSIENT}; derivatives 1; start; step; approach 0.021; step",
    "derivatives-of-hertz": f"{WHEEL}; model hertz; derivatives 1; start; step",
    "derivatives-of-fastsim": f"{WHEEL}; model fastsim; {CREEP}; derivatives 1; start; step",
    "derivatives-of-bodies-that-differ": f"{UNLIKE}; {STEADY}; derivatives 1; start; step",
    # solvers that stop too early
    "tolerances": f"{SPHERE}; {SHIFT}; tolerance normal 1e-4 100; tolerance tangential 1e-3 50; start; step",
    "a-step-that-does-not-converge": f"{SPHERE}; {SHIFT}; tolerance tangential 1e-12 1; start; step",
    "a-step-that-counts-all-the-same": f"{SPHERE}; {SHIFT}; tolerance tangential 1e-12 1; accept_unconverged; start; step; step",
    # bad input
    "no-elements": f"{SPHERE}; grid 0 12 0.2 0.2 0 0; start",
    "elements-without-size": f"{SPHERE}; grid 12 12 0.2 -0.2 0 0; start",
    "a-material-that-there-is-not": f"{SPHERE}; material lower 200 0.7; start",
    "a-modulus-of-zero": f"{SPHERE}; material upper 0 0.3; start",
    "two-rigid-bodies": f"{SPHERE}; rigid both; start",
    "a-radius-of-zero": f"{SPHERE}; paraboloid 0 50; start",
    "a-semi-axis-below-zero": f"{SPHERE}; semi_axes 1 -1; start",
    "a-gap-of-another-size": f"{SPHERE}; gap_of 5; start",
    "an-approach-that-is-no-number": f"{SPHERE}; approach nan; start",
    "a-force-that-pulls": f"{SPHERE}; Fn -1; start",
    "friction-below-zero": f"{SPHERE}; mu -0.1; shift 0.004 0 0; start",
    "friction-that-is-infinite": f"{SPHERE}; {SHIFT}; start; mu inf; step",
    "friction-that-rises": f"{SPHERE}; {SHIFT}; kinetic linear 0.5 1; start",
    "a-step-backwards": f"{SPHERE}; {STEADY}; direction 0 -1; start",
    "a-spin-offset-beyond-the-next-step": f"{SPHERE}; {STEADY}; spin_offset 2; start",
    "no-steps-of-rolling": f"{SPHERE}; {TRANSIENT}; rolling_steps 0; start",
    "a-force-beyond-friction": f"{SPHERE}; mu 0.3; shift 0 0 0; Fx 1000000; start; step",
    "a-tolerance-of-two": f"{SPHERE}; tolerance outer 2 10; start",
    "a-table-that-is-too-small": f"{SPHERE}; table pair 1 1 0.2 0.2 0.001; start",
    "a-table-of-other-elements": f"{SPHERE}; table pair 12 12 0.3 0.2 0.001; start",
    "finite-elements-that-cannot-be": f"{SPHERE}; material upper 200 0.5; fem upper 0.01; start",
    "creep-that-shifts": f"{SPHERE}; creep both 1 0.125; {SHIFT}; start",
    "creep-that-takes-less-than-no-time": f"{SPHERE}; creep upper 1 -1; {STEADY}; start",
    "a-layer-without-thickness": f"{SPHERE}; layers upper constant 200 0.42 0 100 0.3; start",
    "a-layer-that-grows-when-pressed": f"{SPHERE}; layers lower constant 0 0 0.1 100 0.3 0.1 100 0.6; start",
    "a-section-past-its-corner": f"{STEEL_UNDER_A_RIGID_BODY}; section lower edge_block 9 50 1; section_accuracy lower 0; start",
    "a-disc-that-nothing-holds": f"{STEEL_UNDER_A_RIGID_BODY}; section lower disc 10 0; start",
    "an-outline-that-is-open": f"{STEEL_UNDER_A_RIGID_BODY}; outline lower 0 0; line lower 30 0 0; line lower 30 -20 1;"
    " line lower 0 -20 0; section_accuracy lower 0; start",
    "a-cut-above-its-profile": f"{STEEL_UNDER_A_RIGID_BODY}; profile lower rail 0.001953125 0 1 0; section_accuracy lower 0; start",
    "a-curved-section-without-columns": f"{GROOVE}; start",
    "columns-that-lie-elsewhere": f"{GROOVE}; flat_columns 0 0 0; start",
    "a-line-on-an-area": f"{SPHERE}; line_contact 10; start",
    "a-quick-model-with-a-gap-of-its-own": f"{SPHERE}; model hertz; gap 0.001; start; step",
    "a-quick-model-that-is-transient": f"{WHEEL}; model fastsim; mu 0.3; rolling transient 0.001 0 0; start; step",
    "a-bad-step-leaves-the-contact-where-it-was": f"{SPHERE}; {SHIFT}; start; step; mu -1; step; mu 0.4; step",
}


def write(path: Path) -> Path:
    """Returns the cases as lines, which all drivers read."""
    lines = [f"case {name}\n" + "\n".join(part.strip() for part in text.split(";")) for name, text in CASES.items()]
    path.write_text("\n".join(lines) + "\n")
    return path
