"""Presses a flat rough surface on an elastic half-space, and compares the area of contact and the stiffness with
published laws for small loads, for docs/roughness.md.

Run: rough_contact.py PICTURE [ELEMENTS]; needs contactd-local and matplotlib. The default is 512 elements a side.
"""

import math
import sys
import warnings

import matplotlib.pyplot as plt
import numpy as np

import contactd
from contactd import ContactProblem, ContactWarning, Grid
from contactd.materials import steel

HURST, SLOPE, SHORTEST = 0.8, 0.02, 8  #: of the surface: exponent, rms of the gradient, shortest wave in elements
LOADS = np.geomspace(0.003, 0.06, 8)  #: mean pressure over E* times the slope
MODULUS = steel.G / (1 - steel.nu)  #: E* of steel on steel
PERIMETER = (math.pi - 1 + math.log(2)) / 24  #: of the correction of the area; one source: Yastrebov, arXiv 1701.02727


def rough_surface(n: int, seed: int = 1) -> tuple[np.ndarray, float]:
    """Returns heights of an isotropic self-affine surface with elements of 1 mm, shape [n, n], and their rms."""
    kx, ky = np.meshgrid(2 * np.pi * np.fft.fftfreq(n), 2 * np.pi * np.fft.fftfreq(n))
    k = np.hypot(kx, ky)
    inside = (k >= 2 * np.pi * 4 / n) & (k <= 2 * np.pi / SHORTEST)
    size = np.where(inside, np.where(inside, k, 1.0) ** -(1 + HURST), 0)
    heights = np.fft.ifft2(size * np.fft.fft2(np.random.default_rng(seed).standard_normal((n, n)))).real
    slopes = [np.fft.ifft2(1j * wave * np.fft.fft2(heights)).real for wave in (kx, ky)]
    heights *= SLOPE / math.sqrt(float(np.mean(slopes[0] ** 2 + slopes[1] ** 2)))
    return heights - heights.mean(), float(heights.std())


def corrected_area(touching: np.ndarray) -> float:
    """Returns the area of contact (mm^2), less the part by which elements at its edges exceed it."""
    padded = np.pad(touching, 1)
    perimeter = sum(np.count_nonzero(np.diff(padded.astype(int), axis=axis)) for axis in (0, 1))
    return float(touching.sum() - PERIMETER * perimeter)


def main() -> None:
    if len(sys.argv) not in (2, 3):
        raise SystemExit("usage: rough_contact.py PICTURE [ELEMENTS]")
    n = int(sys.argv[2]) if len(sys.argv) == 3 else 512
    heights, rms = rough_surface(n)
    grid = Grid(n, n, 1.0, 1.0)
    warnings.simplefilter("ignore", ContactWarning)  # The body ends where the grid ends, so contact at its border is correct.
    areas, stiffnesses, forces = [], [], LOADS * MODULUS * SLOPE * n * n
    with contactd.local() as client:
        flat = client.solve(ContactProblem(grid, steel, np.zeros((n, n)), Fn=1.0), fields=["pressure"])
        for force in forces:
            problem = ContactProblem(grid, steel, heights.max() - heights, Fn=float(force))
            solution = client.solve(problem, fields=["pressure"])
            areas.append(corrected_area(solution.pressure > 0))
            punch = ContactProblem(grid, steel, np.where(solution.pressure > 0, 0.0, 1e3), Fn=1.0)
            # Roughness and half-space are in series.
            stiffnesses.append(1 / (client.solve(punch, fields=["pressure"]).approach - flat.approach))
            kappa = areas[-1] * MODULUS * SLOPE / force
            print(f"area {areas[-1] / n**2:.4f}  kappa {kappa:.3f}  stiffness times rms height over force {stiffnesses[-1] * rms / force:.3f}")
    left, right = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")[1]
    left.loglog(LOADS, np.array(areas) / n**2, "o-", label="computed")
    for kappa, name in ((math.sqrt(2 * math.pi), "kappa 2.51, Bush et al."), (math.sqrt(8 / math.pi), "kappa 1.60, Persson")):
        left.loglog(LOADS, kappa * LOADS, "--", lw=1, label=name)
    left.set(xlabel="mean pressure / (E* h'rms)", ylabel="area of contact / nominal area")
    right.semilogx(LOADS, np.array(stiffnesses) * rms / forces, "o-", label="computed")
    right.axhline(2, color="C1", ls="--", lw=1, label="2, Persson")
    right.set(xlabel="mean pressure / (E* h'rms)", ylabel="stiffness of the roughness times h rms / force", ylim=(0, 3))
    for axes in (left, right):
        axes.legend(frameon=False)
        axes.spines[["top", "right"]].set_visible(False)
    plt.savefig(sys.argv[1], dpi=110)


if __name__ == "__main__":
    main()
