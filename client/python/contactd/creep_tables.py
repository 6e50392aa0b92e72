"""Evaluates tables of creep forces: the full theory of steady rolling over ellipses, from a file (docs/creep-tables.md)."""

from __future__ import annotations

import importlib
import json
import os
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .calls.answer_warnings import give
from .errors import MissingExtra, TableFileError, invalid
from .transport.in_process import can_solve_here

__all__ = ["CreepForces", "CreepTable", "extension"]

Reals = npt.NDArray[np.float64]
_CONTACT = ("a", "b", "G", "mu", "Fn")
_CREEPAGES = ("xi", "eta", "phi")
_RESULTS = 29  #: Three forces, their derivatives by three creepages and by five numbers of the contact, two bounds.
_ROUNDING = 1e-9


@dataclass(frozen=True)
class CreepForces:
    """Forces on the upper body, with the signs of :class:`ContactSolution`: for small creepages they oppose these.

    Attributes:
        Fx: Longitudinal forces (N), of the shape of the inputs.
        Fy: Lateral forces (N).
        Mz: Moments about the normal at the centre (N mm).
        by_creepage: Derivatives of Fx, Fy and Mz by xi, eta and phi, of shape [..., 3, 3].
        by_contact: Derivatives by a, b, G, mu and Fn at constant creepages, of shape [..., 3, 5].
        force_bound: Bounds of the errors of Fx and of Fy (N). NaN if the table was not checked.
        moment_bound: Bounds of the errors of Mz (N mm), or NaN.
    """

    Fx: Any
    Fy: Any
    Mz: Any
    by_creepage: Reals
    by_contact: Reals
    force_bound: Any
    moment_bound: Any


class CreepTable:
    """A table of creep forces at one Poisson's ratio. Any thread may use it.

    The file is mapped. To replace it while a table is open, rename another file over it.

    Attributes:
        nu: Poisson's ratio.
        ratios: The smallest and the largest a/b.
        description: The description in the file: versions, recipe, seed, and the statement about errors.
    """

    def __init__(self, path: str | os.PathLike[str], nu: float | None = None) -> None:
        """Opens the file and checks its digest. Without `nu`, the first Poisson's ratio of the file is used.

        Raises InvalidArgument for a `nu` outside the table, TableFileError for a file that is not a table, is damaged,
        or cannot be read, and MissingExtra without the package contactd_local.
        """
        library = extension()
        given = None if nu is None else _array("nu", nu)
        if given is not None and given.ndim:
            raise invalid("nu", f"has {given.size} values; it must be one number")
        name = os.path.basename(os.fspath(path))
        try:
            self._table, self.nu, self.ratios, text = library.open_creep_table(os.path.abspath(path), given)
        except library.Error as error:
            raise TableFileError(str(error)) from None
        except ValueError as error:
            if not str(error).startswith("nu "):
                raise TableFileError(f"{name!r} is not the name of a file: {error}.") from None
            raise invalid("nu", str(error).removeprefix("nu ")) from None
        try:
            self.description: dict[str, Any] = dict(json.loads(text))
        except (ValueError, RecursionError, TypeError):
            raise TableFileError(f"{name} lacks the description that contactctl table build writes.") from None

    @property
    def statement(self) -> str | None:
        """The statement about errors by `contactctl table check`, or None if the table was not checked."""
        text = self.description.get("statement")
        return text if isinstance(text, str) else None

    def forces(
        self, a: npt.ArrayLike, b: npt.ArrayLike, G: npt.ArrayLike, mu: npt.ArrayLike, Fn: npt.ArrayLike,
        xi: npt.ArrayLike = 0.0, eta: npt.ArrayLike = 0.0, phi: npt.ArrayLike = 0.0,
    ) -> CreepForces:  # fmt: skip
        """Returns forces in steady rolling along +x. Arrays broadcast.

        Args:
            a: Semi-axis along the rolling direction (mm).
            b: Semi-axis across (mm).
            G: Shear modulus of the combined material (N/mm^2).
            mu: Coefficient of friction.
            Fn: Normal force (N).
            xi: Longitudinal creepage, a ratio.
            eta: Lateral creepage, a ratio.
            phi: Spin (1/mm).

        Raises InvalidArgument, which names the first invalid value, and warns of values in other units.
        """
        given = {
            name: _array(name, value)
            for name, value in zip((*_CONTACT, *_CREEPAGES), (a, b, G, mu, Fn, xi, eta, phi), strict=True)
        }
        try:
            arrays = np.broadcast_arrays(*given.values())
        except ValueError:
            shapes = ", ".join(f"{name} {value.shape}" for name, value in given.items() if value.ndim)
            raise invalid(
                "contacts", f"have shapes that do not broadcast: {shapes}. Give one shape, or numbers."
            ) from None
        for name in _CONTACT:
            _refuse(name, given[name], ~(given[name] > 0), "it must be positive")
        ratio = given["a"] / given["b"]
        low, high = self.ratios
        _refuse("a/b", ratio, (ratio < low * (1 - _ROUNDING)) | (ratio > high * (1 + _ROUNDING)), f"the table holds {low:.5g} to {high:.5g}; a lies along the rolling direction")  # fmt: skip
        _warn(given, np.abs(given["phi"]) * np.sqrt(given["a"] * given["b"]))
        found = extension().creep_table_forces(self._table, np.stack(arrays, axis=-1).tobytes())
        shape = arrays[0].shape
        results = np.frombuffer(found).reshape(*shape, _RESULTS).copy()
        Fx, Fy, Mz, force_bound, moment_bound = (
            results[..., i][()] for i in (0, 1, 2, 27, 28)
        )  # [()] makes numbers of arrays without axes
        by_creepage, by_contact = results[..., 3:12].reshape(*shape, 3, 3), results[..., 12:27].reshape(*shape, 3, 5)
        return CreepForces(Fx, Fy, Mz, by_creepage, by_contact, force_bound, moment_bound)


def extension() -> Any:
    """Returns the module contactd_local. Raises MissingExtra without it, because only its compiled code reads tables."""
    if not can_solve_here():
        raise MissingExtra("Tables of creep forces", "contactd_local", "local", "python3-contactd-local")
    return importlib.import_module("contactd_local")


def _array(name: str, value: npt.ArrayLike) -> Reals:
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "fiu":
            raise TypeError
        array = array.astype(np.float64)
    except (TypeError, ValueError):
        raise invalid(name, f"is {value!r:.60}; it must be a real number or an array of real numbers") from None
    _refuse(name, array, ~np.isfinite(array), "it must be finite")
    return array


def _refuse(name: str, values: Reals, wrong: npt.NDArray[np.bool_], cure: str) -> None:
    if wrong.any():
        at = tuple(int(i) for i in np.argwhere(wrong)[0])
        raise invalid(name + (str(list(at)) if at else ""), f"is {values[at]:.6g}; {cure}")


def _warn(given: dict[str, Reals], sliding: Reals) -> None:
    """Warns of values that are probably in other units. The limits are those of contact solves."""
    doubts = (
        ("xi", given["xi"], 0.5, "Give creepages as ratios, not in percent."),
        ("eta", given["eta"], 0.5, "Give creepages as ratios, not in percent."),
        ("mu", given["mu"], 2, "Give friction as a ratio, not in percent."),
        ("G", given["G"], 1e6, "Give it in N/mm^2, not in Pa."),
        ("phi sqrt(ab)", sliding, 1, "Give the spin in 1/mm (rad per mm rolled), not in 1/m."),
    )
    reached = [(name, float(np.abs(values).max(initial=0)), limit, cure) for name, values, limit, cure in doubts]
    give(
        f"{name} reaches {largest:.3g}, which no rolling contact has. {cure}"
        for name, largest, limit, cure in reached
        if largest > limit
    )
