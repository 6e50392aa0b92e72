"""Positions of the reference of a patch on the profiles of rail and wheel."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from ...values.generated.wheel_rail.forces import Wrench
from ...values.generated.wheel_rail.places import ContactReference
from ...values.generated.wheel_rail.result import WheelRailSolution
from ..problems.rails import RailContact

__all__ = ["along_axle", "moment_about_normal", "on_rail", "on_wheel"]

Vector = npt.NDArray[np.float64]


def on_wheel(contact: RailContact, solution: WheelRailSolution, reference: ContactReference) -> Vector:
    """Returns x, y and z in the axes of the wheel's profile; y is to the right, also for left wheels."""
    position, by, origin = contact.state.position, contact.state.wheel, solution.wheel_frame
    axes = _axes(by.yaw, by.roll) @ _axes(position.yaw, position.roll)
    return np.asarray(axes @ (_place(reference) - [origin.x, origin.y, origin.z]))


def on_rail(solution: WheelRailSolution, reference: ContactReference) -> tuple[float, float]:
    """Returns y and z in the axes of the rail's profile; y is to the right, also for left rails."""
    frame = solution.rail_frame
    y, z = reference.y - frame.y, reference.z - frame.z
    cos, sin = math.cos(frame.roll), math.sin(frame.roll)
    return y * cos + z * sin, z * cos - y * sin


def along_axle(contact: RailContact) -> float:
    """Returns y of the wheel's profile along the axle (mm)."""
    wheelset = contact.setup.wheelset
    assert wheelset is not None
    assert wheelset.flange_back_distance is not None and wheelset.flange_back_position is not None
    outwards = 1 if contact.setup.side == "right" else -1
    return outwards * (wheelset.flange_back_distance / 2 - wheelset.flange_back_position)


def moment_about_normal(force: Wrench, reference: ContactReference) -> float:
    """Returns the moment (N mm) about the normal of a contact at its reference, from a force and its moment about the
    track's origin.
    """
    moment = np.array([force.Mx, force.My, force.Mz]) - np.cross(_place(reference), [force.Fx, force.Fy, force.Fz])
    return float(moment[2] * math.cos(reference.angle) - moment[1] * math.sin(reference.angle))


def _place(reference: ContactReference) -> Vector:
    return np.array([reference.x, reference.y, reference.z])


def _axes(yaw: float, roll: float) -> Vector:
    """Returns axes as rows, rotated by yaw about z and then by roll about the rotated x."""
    yawed = np.array([[math.cos(yaw), math.sin(yaw), 0.0], [-math.sin(yaw), math.cos(yaw), 0.0], [0.0, 0.0, 1.0]])
    rolled = np.array([[1.0, 0.0, 0.0], [0.0, math.cos(roll), math.sin(roll)], [0.0, -math.sin(roll), math.cos(roll)]])
    return np.asarray(yawed @ rolled)
