"""Describes the line of a track: straight, or into a curve with a raised outer rail."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from railway.motion import Array, axes

NODE = 1000.0  # mm between points where integrals are stored
_X, _W = np.polynomial.legendre.leggauss(8)


@dataclass(frozen=True)
class Line:
    """Goes straight ahead, then into a curve to the right. Curvature and cant grow along the transition by 3 u^2 - 2
    u^3.

    The middle between the rails is at z = 0. All values are functions of the arc length s.

    Attributes:
        curvature: Curvature of the curve (1/mm); < 0 is to the left.
        cant: Height of the outer rail above the inner one in the curve (mm), >= 0.
        begin: Start of the transition (mm).
        transition: Length of the transition (mm), > 0.
        length: Length of the line (mm).
        gauge: Distance between the rails' middles (mm).
    """

    curvature: float = 0.0
    cant: float = 0.0
    begin: float = 0.0
    transition: float = 1.0
    length: float = 1e6
    gauge: float = 1500.0
    _nodes: Array = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        steps = np.arange(-10, int(np.ceil(self.length / NODE)) + 1) * NODE
        pieces = np.array([self._piece(float(start), NODE) for start in steps])
        nodes = np.concatenate([np.zeros((1, 2)), np.cumsum(pieces, axis=0)])
        object.__setattr__(self, "_nodes", nodes - nodes[10])

    def share(self, s: float) -> float:
        """Returns the fraction of curvature and cant at s, 0 to 1."""
        u = min(max((s - self.begin) / self.transition, 0.0), 1.0)
        return u * u * (3 - 2 * u)

    def heading(self, s: float) -> float:
        """Returns the heading of the line (rad)."""
        u = min(max((s - self.begin) / self.transition, 0.0), 1.0)
        beyond = max(s - self.begin - self.transition, 0.0)
        return self.curvature * (self.transition * (u**3 - u**4 / 2) + beyond)

    def roll(self, s: float) -> float:
        """Returns the roll of the track's plane (rad), positive if the outer rail is higher."""
        return float(np.sign(self.curvature) * self.cant / self.gauge * self.share(s))

    def place(self, s: float) -> Array:
        """Returns the position of the middle between the rails (mm), shape [3]. Raises ValueError beyond the line's
        end.
        """
        node = int(s // NODE)
        if not -10 <= node < len(self._nodes) - 11:
            raise ValueError(f"The position {s / 1000:g} m is outside the line, which extends from -10 m to {self.length / 1000:g} m.")
        x, y = self._nodes[node + 10] + self._piece(node * NODE, s - node * NODE)
        return np.array([x, y, 0.0])

    def axes(self, s: float) -> Array:
        """Returns the axes of the track as columns: along it, to the right, down."""
        return axes(self.roll(s), self.heading(s))

    def way_to(self, place: Array, guess: float) -> float:
        """Returns s of the cross-section that contains a position (mm)."""
        if self.curvature == 0:
            return float(place[0])
        s = guess
        for _ in range(3):  # Newton's method; the first step is exact on straight track
            heading = self.heading(s)
            forwards, across = np.array([np.cos(heading), np.sin(heading)]), np.array([-np.sin(heading), np.cos(heading)])
            away = np.asarray(place)[:2] - self.place(s)[:2]
            s += float(away @ forwards / (1 - self.curvature * self.share(s) * (away @ across)))
        return s

    def _piece(self, start: float, length: float) -> Array:
        """Returns the way in x and y from s = start on, by Gauss quadrature."""
        if self.curvature == 0:
            return np.array([length, 0.0])
        angles = np.array([self.heading(start + length * (1 + x) / 2) for x in _X])
        return length / 2 * np.array([_W @ np.cos(angles), _W @ np.sin(angles)])
