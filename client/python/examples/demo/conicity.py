"""Evaluates profiles like railway engineers: a table of equivalent conicity, and pictures of contacts and forces."""

from __future__ import annotations

import time
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from rail_pictures import INCLINATIONS, draw_conicities, draw_contacts, draw_creep_forces, draw_loci, draw_standards
from terminal import ProgressBar, say, section, styled, table

from contactd import Client, Progress
from contactd.wheel_rail import ConeProfile, EquivalentConicity, Rail60E1, WheelRailSetup

Check = tuple[bool, str]
AMPLITUDES = np.arange(1, 8.1, 0.25)


def show_profiles(client: Client, output: Path) -> list[Check]:
    section(
        2,
        "Equivalent conicity",
        "S1002 wheels on 60E1 rails, gauge 1435 mm, flange backs 1360 mm apart, radius 460 mm, roll neglected.",
        "Integrals over the kinematic motion, as in EN 15302. Brackets contain the harmonic approximation.",
    )
    start = time.perf_counter()
    conicities = {
        name: client.equivalent_conicity(WheelRailSetup(rail=Rail60E1(inclination)), AMPLITUDES)
        for name, inclination in INCLINATIONS.items()
    }
    seconds = time.perf_counter() - start
    whole = [k for k, amplitude in enumerate(AMPLITUDES) if amplitude == round(amplitude)]
    table(
        ["amplitude (mm)", *(f"rails at {name}" for name in conicities)],
        [[f"{AMPLITUDES[k]:g}", *(shown(of_rail[k]) for of_rail in conicities.values())] for k in whole],
    )
    say()
    say(f"{2 * len(AMPLITUDES)} conicities in {seconds:.1f} s.")
    draw_all(client, conicities, output.parent)
    return checks(client, conicities)


def shown(conicity: EquivalentConicity) -> str:
    return f"{conicity.integrated:.4f} ({conicity.harmonic:.4f})"


def draw_all(client: Client, conicities: dict[str, list[EquivalentConicity]], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    pictures = {
        "standard-profiles.png": lambda path: draw_standards(client, path),
        "contact-locus.png": lambda path: draw_loci(client, path),
        "equivalent-conicity.png": lambda path: draw_conicities(conicities, path),
        "wheel-rail-patches.png": lambda path: draw_contacts(client, path),
        "creep-forces.png": lambda path: draw_creep_forces(client, path),
    }
    with ProgressBar() as progress, plt.rc_context({"font.size": 11}):
        for count, (name, draw) in enumerate(pictures.items()):
            progress(Progress(name, count / len(pictures)))
            draw(folder / name)
    for name in pictures:
        say(f"The picture: {styled(str(folder / name), 'bold')}")


def checks(client: Client, conicities: dict[str, list[EquivalentConicity]]) -> list[Check]:
    cone = WheelRailSetup(wheel=ConeProfile(-0.05, ends=(-60, 60)))
    of_cone = [abs((found.integrated or 0) / 0.05 - 1) for found in client.equivalent_conicity(cone, range(1, 9))]
    (three,) = (found for found in conicities["1/40"] if found.amplitude == 3)
    contacts = client.wheelset_contacts(WheelRailSetup(), [-3, 3])
    mirrored = abs(contacts[0].radius_difference + contacts[1].radius_difference)
    return [
        (max(of_cone) <= 1e-9, f"{'a cone of 1/20 has 0.05, relative':42} {max(of_cone):8.1e}, at most 1e-09"),
        (abs((three.integrated or 0) - 0.18) <= 1e-3, f"{'S1002 at 3 mm, rails at 1/40':42} {three.integrated:8.4f}, known 0.18"),
        (mirrored <= 1e-6, f"{'shifts to both sides mirror, radii (mm)':42} {mirrored:8.1e}, at most 1e-06"),
    ]
