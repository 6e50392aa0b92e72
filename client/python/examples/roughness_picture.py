"""Draws the picture of docs/roughness.md: third octaves of an artificial record before and after two contact filters.

Run: roughness_picture.py PICTURE; needs contactd-local and matplotlib.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

import contactd
from contactd.materials import steel
from contactd.pictures.canvas import COLOURS
from contactd.pictures.roughness import draw_levels
from contactd.roughness import (
    ISO_3095_2013,
    ContactFilter,
    Record,
    Spectrum,
    hertz_weights,
    lines_of,
    rolled,
    wheel_rail_weights,
)
from contactd.wheel_rail import WheelRailSetup, WheelRailState


def record_at_the_limit(samples: int = 15_000) -> Record:
    """Returns random heights whose third octaves are those of the limit of ISO 3095, in steps of 1 mm."""
    waves = np.fft.rfftfreq(samples, 1.0)
    band = ISO_3095_2013.wavelengths[::-1]
    density = 10 ** (ISO_3095_2013.levels[::-1] / 10) * 1e-6 * band / (10**0.05 - 10**-0.05)
    squares = np.zeros(len(waves))
    squares[1:] = np.exp(np.interp(np.log(1 / waves[1:]), np.log(band), np.log(density))) * waves[1]
    squares[waves < 1 / 400] = 0
    phases = np.exp(2j * np.pi * np.random.default_rng(1).random(len(waves)))
    return Record(1.0, np.fft.irfft(np.sqrt(squares / 2) * samples * phases, samples))


def main() -> None:
    if len(sys.argv) != 2:
        raise SystemExit("usage: roughness_picture.py PICTURE")
    with contactd.local() as client:
        setup = WheelRailSetup(dx=0.25, dy=0.25, friction=None)
        solution = client.wheel_rail(setup, WheelRailState(Fz=50e3), fields=["pressure"])
        wide = ContactFilter(wheel_rail_weights(client, setup, solution))
    filters = {"Hertz, 460 and 300 mm": ContactFilter(hertz_weights(50e3, 460, 300, steel)), "S1002 on 60E1": wide}
    lines = lines_of(rolled(record_at_the_limit()))
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.4), layout="constrained")
    after = {name: one.filtered(lines).third_octaves() for name, one in filters.items()}
    draw_levels(left, {**after, "record": lines.third_octaves()}, ISO_3095_2013)
    waves = np.geomspace(250, 2.5, 200)
    for one, colour in zip(filters.values(), COLOURS):
        right.semilogx(waves, one.levels(waves), color=colour, lw=0.7)
    bands = {name: Spectrum(lines.third_octaves().wavelengths, one.third_octaves(lines).levels) for name, one in filters.items()}
    draw_levels(right, bands, label="contact filter (dB), isotropic roughness")
    figure.savefig(sys.argv[1], dpi=110)


if __name__ == "__main__":
    main()
