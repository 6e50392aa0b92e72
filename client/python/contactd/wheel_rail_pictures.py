"""Draws wheels on rails on your matplotlib axes.

::

    import matplotlib.pyplot as plt
    import numpy as np
    from contactd.wheel_rail_pictures import draw_conicity, draw_contact_locus

    profiles, contacts = client.placed_profiles(setup), client.wheelset_contacts(setup, np.arange(-8, 8.1, 0.5))
    figure, (locus, curve) = plt.subplots(1, 2)
    figure.colorbar(draw_contact_locus(locus, profiles, contacts), ax=locus, label="lateral shift (mm)")
    draw_conicity(curve, client.equivalent_conicity(setup, range(1, 9)), "1/40")

This module does not import matplotlib.
"""

from __future__ import annotations

from .pictures.profile import curvature_of, draw_curvature, draw_profile
from .pictures.profiles import draw_conicity, draw_contact_locus, draw_patches, placed_rail, placed_wheel

__all__ = [
    "curvature_of",
    "draw_conicity",
    "draw_contact_locus",
    "draw_curvature",
    "draw_patches",
    "draw_profile",
    "placed_rail",
    "placed_wheel",
]
