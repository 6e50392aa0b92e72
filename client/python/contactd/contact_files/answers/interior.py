"""Displacements inside a half-space under tractions that are constant on elements (Johnson, Contact Mechanics, 3.1).

With R the distance to a point of the surface at X, Y, and z the depth, the potentials of equation (3.7) are integrals over
the elements. Their derivatives have closed forms, which are taken between the corners."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from ...values.grid import Grid

__all__ = ["interior_displacements"]

Floats = npt.NDArray[np.float64]

_TINY = 1e-300
_AT_ONCE = 2_000_000  #: points times elements


def interior_displacements(grid: Grid, tractions: Floats, points: Floats, nu: float, G: float) -> Floats:
    """Displacements at `points`, shape [n, 3], x, y and the depth z >= 0; shape [n, 3] (mm), z into the body. `tractions`
    act on it along x, y and into it, shape [3, ny, nx]."""
    loaded = np.flatnonzero(np.any(tractions.reshape(3, -1) != 0, axis=0))
    forces = tractions.reshape(3, -1)[:, loaded]
    x = np.broadcast_to(grid.x[None, :], grid.shape).ravel()[loaded]
    y = np.broadcast_to(grid.y[:, None], grid.shape).ravel()[loaded]
    piece = max(1, _AT_ONCE // max(1, len(loaded)))
    found = np.zeros((len(points), 3))
    for start in range(0, len(points), piece):
        at = points[start : start + piece]
        offsets = at[:, :1] - x[None, :], at[:, 1:2] - y[None, :], at[:, 2:3] + 0 * x[None, :]
        found[start : start + piece] = _displacements(offsets, (grid.dx, grid.dy), forces, nu)
    return np.asarray(found / (4 * np.pi * G), dtype=np.float64)


def _displacements(offsets: tuple[Floats, Floats, Floats], size: tuple[float, float], forces: Floats, nu: float) -> Floats:
    total = {name: np.zeros(offsets[0].shape) for name in _NAMES}
    for sx in (-1, 1):
        for sy in (-1, 1):
            # The offset from a point of the element falls where that point moves along: the signs of both ends cancel.
            corner = _corner(offsets[0] + sx * size[0] / 2, offsets[1] + sy * size[1] / 2, offsets[2])
            for name, value in zip(_NAMES, corner):
                total[name] += sx * sy * value
    px, py, pn = forces
    z, t = offsets[2], total
    psi = px * t["x"] + py * t["y"] + pn * t["one"]
    psi_x = px * t["xx"] + py * t["xy"] - pn * t["x3"]
    psi_y = px * t["xy"] + py * t["yy"] - pn * t["y3"]
    psi_z = -px * t["x3"] - py * t["y3"] - pn * t["z3"]
    psi1_x = px * t["w_xx"] + py * t["w_xy"] + pn * t["x"]
    psi1_y = px * t["w_xy"] + py * t["w_yy"] + pn * t["y"]
    ux = 2 * px * t["one"] - pn * t["x"] + 2 * nu * psi1_x - z * psi_x
    uy = 2 * py * t["one"] - pn * t["y"] + 2 * nu * psi1_y - z * psi_y
    uz = pn * t["one"] + (1 - 2 * nu) * psi - z * psi_z
    return np.stack([part.sum(axis=1) for part in (ux, uy, uz)], axis=1)


#: Integrals of 1/R, of X/(R(R+z)) and its derivatives, of the second derivatives of z ln(R+z) - R, and of X/R^3 alike.
_NAMES = ("one", "x", "y", "xx", "yy", "xy", "w_xx", "w_yy", "w_xy", "x3", "y3", "z3")


def _corner(x: Floats, y: Floats, z: Floats) -> tuple[Floats, ...]:
    r = np.sqrt(x * x + y * y + z * z)
    log_x, log_y, log_z = _log(x, r, y, z), _log(y, r, x, z), np.log(np.maximum(r + z, _TINY))
    solid = np.arctan(x * y / _away(z * r))
    at_x, at_y = _angle(x, y, z, r), _angle(y, x, z, r)
    one = x * log_y + y * log_x - z * solid
    return (
        one, y * log_z + z * log_y + x * at_x, x * log_z + z * log_x + y * at_y, at_x, at_y, log_z,
        -x * log_y + z * at_x, -y * log_x + z * at_y, z * log_z - r, -log_y, -log_x, solid,
    )  # fmt: skip


def _log(a: Floats, r: Floats, b: Floats, z: Floats) -> Floats:
    """ln(a + r) without loss of digits where a < 0."""
    across = np.sqrt(b * b + z * z)
    return np.where(across > 0, np.arcsinh(a / _away(across)) + np.log(_away(across)), np.log(_away(a + r)))


def _angle(x: Floats, y: Floats, z: Floats, r: Floats) -> Floats:
    return np.asarray(np.arctan(y / _away(x)) - np.arctan(y * z / _away(x * r)))


def _away(value: Floats) -> Floats:
    return np.asarray(np.where(value == 0, _TINY, value))
