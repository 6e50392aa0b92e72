"""Where the reference of a patch lies on the profiles of rail and wheel."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from ...values.wheel_rail.forces import Wrench
from ...values.wheel_rail.places import ContactReference
from ...values.wheel_rail.result import WheelRailSolution
from ..problems.rails import RailContact

__all__ = ["moment_about_normal", "on_rail", "on_wheel", "rail_frame", "wheel_frame"]

Vector = npt.NDArray[np.float64]

_SLIGHTLY = 1e-9  #: weight of what is only likely


def on_wheel(contact: RailContact, z: float, reference: ContactReference) -> Vector:
    """x, y and z in the axes of the wheel's profile, of left wheels with y to the right, too."""
    origin, axes = _wheel(contact, z)
    return np.asarray(axes @ (_place(reference) - origin))


def on_rail(contact: RailContact, solution: WheelRailSolution, reference: ContactReference) -> tuple[float, float]:
    """y and z in the axes of the rail's profile, of left rails with y to the right, too."""
    y0, z0, turned = rail_frame(contact, solution)
    y, z = reference.y - y0, reference.z - z0
    return y * math.cos(turned) + z * math.sin(turned), z * math.cos(turned) - y * math.sin(turned)


def rail_frame(contact: RailContact, solution: WheelRailSolution) -> tuple[float, float, float]:
    """y and z of the origin of the rail's profile in the track's axes, and by how much it is turned about x (rad)."""
    turned = _rail_rotation(contact)
    return *_origin(contact, solution, turned), turned


def wheel_frame(contact: RailContact, z: float) -> tuple[list[float], float]:
    """x, y, z, roll and yaw of the wheel's profile in the track's axes, and its y along the axle."""
    origin, axes = _wheel(contact, z)
    roll, yaw = math.atan2(axes[1, 2], axes[2, 2]), math.atan2(axes[0, 1], axes[0, 0])
    return [*map(float, origin), roll, yaw], _on_axle(contact)[1]


def moment_about_normal(force: Wrench, reference: ContactReference) -> float:
    """The moment (N mm) about the normal of a contact at its reference, of a force with its moment about the track's
    origin."""
    moment = np.array([force.Mx, force.My, force.Mz]) - np.cross(_place(reference), [force.Fx, force.Fy, force.Fz])
    return float(moment[2] * math.cos(reference.angle) - moment[1] * math.sin(reference.angle))


def _wheel(contact: RailContact, z: float) -> tuple[Vector, Vector]:
    """The origin of the wheel's profile in the track's axes, and as rows its axes, with the deviations of a flexible
    wheelset."""
    position, by = contact.state.position, contact.state.wheel
    radius, along_axle = _on_axle(contact)
    wheelset = _axes(position.yaw, position.roll)
    in_wheelset = np.array([by.x, along_axle + by.y, radius + by.z])
    origin = np.array([0.0, position.y, z - radius]) + wheelset.T @ in_wheelset
    return origin, np.asarray(_axes(by.yaw, by.roll) @ wheelset)


def _outwards(contact: RailContact) -> int:
    return 1 if contact.setup.side == "right" else -1


def _place(reference: ContactReference) -> Vector:
    return np.array([reference.x, reference.y, reference.z])


def _axes(yaw: float, roll: float) -> Vector:
    """Rows are axes that were turned by yaw, and then by roll."""
    yawed = np.array([[math.cos(yaw), math.sin(yaw), 0.0], [-math.sin(yaw), math.cos(yaw), 0.0], [0.0, 0.0, 1.0]])
    rolled = np.array([[1.0, 0.0, 0.0], [0.0, math.cos(roll), math.sin(roll)], [0.0, -math.sin(roll), math.cos(roll)]])
    return np.asarray(rolled @ yawed)


def _on_axle(contact: RailContact) -> tuple[float, float]:
    """The nominal radius, and where the wheel's profile lies along the axle."""
    wheelset = contact.setup.wheelset
    assert wheelset is not None and wheelset.nominal_radius is not None
    assert wheelset.flange_back_distance is not None and wheelset.flange_back_position is not None
    return wheelset.nominal_radius, _outwards(contact) * (wheelset.flange_back_distance / 2 - wheelset.flange_back_position)


def _rail_rotation(contact: RailContact) -> float:
    cant = 0.0 if contact.setup.track is None else contact.setup.track.cant or 0.0
    return contact.state.rail.roll - _outwards(contact) * cant


def _origin(contact: RailContact, solution: WheelRailSolution, turned: float) -> tuple[float, float]:
    """The origin of the rail's profile in the track's axes. Where the gauge says where the rail lies, its moments tell: those
    about the track's origin and about the profile's differ by the arm, which has no x."""
    track, rail = contact.setup.track, contact.state.rail
    assert track is not None
    if track.rail_origin is not None:
        sunk = solution.rail_deflection
        y, z = rail.y + (sunk.y if sunk else 0.0), rail.z + (sunk.z if sunk else 0.0)
        return _outwards(contact) * track.rail_origin[0] + y, track.rail_origin[1] + z
    rows, sides = [], []
    for patch in solution.patches:
        about_track, about_rail = patch.forces.track, patch.forces.rail
        my = about_rail.My * math.cos(turned) - about_rail.Mz * math.sin(turned)
        mz = about_rail.Mz * math.cos(turned) + about_rail.My * math.sin(turned)
        rows += [[about_track.Fz, -about_track.Fy], [0.0, about_track.Fx], [-about_track.Fx, 0.0]]
        sides += [about_track.Mx - about_rail.Mx, about_track.My - my, about_track.Mz - mz]
    largest = max((abs(row[0]) for row in rows), default=1.0)
    # Without tangential forces the arm is known up to what is along the force; the profile's top is about its origin.
    found, *_ = np.linalg.lstsq(np.array([*rows, [0.0, _SLIGHTLY * largest]]), np.array([*sides, 0.0]), rcond=None)
    return float(found[0]), float(found[1])
