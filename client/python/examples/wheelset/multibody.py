"""Simulates the wheelset in Exudyn: a rigid body, Exudyn's springs and dampers, and the contact as a user function.

Exudyn's node RigidBodyRxyz rotates about its first axis, then the second, then the third. With z, x and y of the track
as these axes, the rotations are yaw, roll and pitch, in contactd's order. Needs Exudyn 1.13 or newer (`pip install
exudyn`).
"""

from __future__ import annotations

import exudyn as exu
import numpy as np
from exudyn.itemInterface import (
    LoadForceVector,
    MarkerBodyPosition,
    MarkerBodyRigid,
    NodeRigidBodyRxyz,
    ObjectConnectorCartesianSpringDamper,
    ObjectConnectorRigidBodySpringDamper,
    ObjectGround,
    ObjectRigidBody,
    SensorBody,
)
from railway.motion import GRAVITY, Array, Motion, axes
from runge_kutta import Wheelset
from vehicle import frame_load

TO_EXUDYN = np.array([2, 0, 1])  # (x, y, z) of the track -> (z, x, y)
TO_TRACK = np.array([1, 2, 0])


def integrate(wheelset: Wheelset, state: Array, duration: float, step: float) -> tuple[Array, Array]:
    """Integrates like runge_kutta.integrate, with Exudyn's explicit fourth-order Runge-Kutta solver.

    Contact is stiff, but not singular: steps of a millisecond need no implicit method, which would solve the contact
    for every column of its Jacobian.
    """
    system = exu.SystemContainer()
    mbs = system.AddSystem()
    body = _add_body(mbs, wheelset, state)
    _add_suspension(mbs, wheelset, body)
    _add_contact(mbs, wheelset, body)
    sensors = [
        mbs.AddSensor(SensorBody(bodyNumber=body, storeInternal=True, writeToFile=False, outputVariableType=variable))
        for variable in (
            exu.OutputVariableType.Displacement, exu.OutputVariableType.Rotation,
            exu.OutputVariableType.Velocity, exu.OutputVariableType.AngularVelocity,
        )
    ]  # fmt: skip
    mbs.Assemble()

    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(duration / step)
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = step
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    return _states(wheelset, *(mbs.GetSensorStoredData(sensor) for sensor in sensors))


def _add_body(mbs: exu.MainSystem, wheelset: Wheelset, state: Array) -> int:
    vehicle = wheelset.vehicle
    motion = wheelset.motion(0, state)
    rates = (motion.yaw_rate / np.cos(motion.roll), motion.roll_rate)
    node = mbs.AddNode(
        NodeRigidBodyRxyz(
            initialCoordinates=[*state[:3][TO_EXUDYN], motion.yaw, motion.roll, 0],
            initialVelocities=[*state[5:8][TO_EXUDYN], *rates, motion.pitch_rate - rates[0] * np.sin(motion.roll)],
        )
    )
    inertia = [vehicle.inertia, vehicle.inertia, vehicle.inertia_axle]
    body = mbs.AddObject(ObjectRigidBody(nodeNumber=node, mass=vehicle.mass, inertia=[*inertia, 0, 0, 0]))
    centre = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body))
    down = vehicle.mass * GRAVITY + 2 * frame_load(vehicle)
    mbs.AddLoad(LoadForceVector(markerNumber=centre, loadVector=[down, 0, 0]))
    return int(body)


def _add_suspension(mbs: exu.MainSystem, wheelset: Wheelset, body: int) -> None:
    vehicle = wheelset.vehicle
    frame = mbs.AddObject(ObjectGround())
    for y in (-vehicle.half_base, vehicle.half_base):
        ends = [
            mbs.AddMarker(MarkerBodyPosition(bodyNumber=frame, localPosition=[wheelset.rest, 0, y])),
            mbs.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=[0, 0, y])),
        ]
        mbs.AddObject(
            ObjectConnectorCartesianSpringDamper(
                markerNumbers=ends,
                stiffness=np.array(vehicle.stiffness)[TO_EXUDYN],
                damping=np.array(vehicle.damping)[TO_EXUDYN],
            )
        )


def _add_contact(mbs: exu.MainSystem, wheelset: Wheelset, body: int) -> None:
    def reaction(mbs, time, item, displacement, rotation, velocity, angular_velocity, *unused):  # type: ignore[no-untyped-def]
        motion = _motion(wheelset, time, displacement, rotation, velocity, angular_velocity)
        force, moment = wheelset.contact(motion)
        moment = axes(motion.roll, motion.yaw) @ moment
        # Exudyn expects the tension of a spring: the force on its end at the frame.
        return -np.concatenate([force[TO_EXUDYN], moment[TO_EXUDYN]])

    ends = [mbs.AddMarker(MarkerBodyRigid(bodyNumber=number)) for number in (mbs.AddObject(ObjectGround()), body)]
    mbs.AddObject(ObjectConnectorRigidBodySpringDamper(markerNumbers=ends, springForceTorqueUserFunction=reaction))


def _motion(wheelset: Wheelset, time: float, place: Array, angles: Array, velocity: Array, rates: Array) -> Motion:
    """Returns the motion in Exudyn's axes, with rates about fixed axes."""
    x, y, z = (float(value) for value in np.asarray(place)[TO_TRACK])
    vx, vy, vz = (float(value) for value in np.asarray(velocity)[TO_TRACK])
    yaw, roll = float(angles[0]), float(angles[1])
    roll_rate, pitch_rate, yaw_rate = (float(value) for value in axes(roll, yaw).T @ np.asarray(rates)[TO_TRACK])
    speed = wheelset.speed
    return Motion(wheelset.gone + speed * time + x, y, z, roll, yaw, vx + speed, vy, vz, roll_rate, pitch_rate, yaw_rate)


def _states(wheelset: Wheelset, *measured: Array) -> tuple[Array, Array]:
    times = measured[0][:, 0]
    states = np.empty((len(times), 11))
    for row, time in enumerate(times):
        motion = _motion(wheelset, time, *(values[row, 1:] for values in measured))
        distance, *place, vx, vy, vz, roll_rate, pitch_rate, yaw_rate = motion
        pitch_rate += wheelset.speed / wheelset.vehicle.radius
        ahead = distance - wheelset.gone - wheelset.speed * time
        states[row] = (ahead, *place, vx - wheelset.speed, vy, vz, roll_rate, pitch_rate, yaw_rate)
    return times, states
