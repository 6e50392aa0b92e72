"""Simulates the bogie in Exudyn: rigid bodies, Exudyn's springs, and the contacts as forces on the wheelsets'
coordinates.

Exudyn's node RigidBodyRxyz rotates about its first axis, then the second, then the third. With z, x and y of the track
as these axes, the rotations are yaw, roll and pitch, in contactd's order. Needs Exudyn 1.13 or newer (`pip install
exudyn`).
"""

from __future__ import annotations

import exudyn as exu
import numpy as np
from equations import Equations
from exudyn.itemInterface import (
    LoadMassProportional,
    MarkerBodyMass,
    MarkerBodyPosition,
    NodeRigidBodyRxyz,
    ObjectConnectorSpringDamper,
    ObjectGenericODE2,
    ObjectRigidBody,
    SensorNode,
)
from railway.motion import GRAVITY, Array, axes
from rolling import PITCH, PLACE, RATES, ROLL, VELOCITY, YAW

TO_EXUDYN = np.array([2, 0, 1])  # (x, y, z) of the track -> (z, x, y)
TO_TRACK = np.array([1, 2, 0])


def integrate(equations: Equations, state: Array, duration: float, step: float) -> tuple[Array, Array]:
    """Returns times (s) and states, shapes [n] and [n, 12 bodies], by Exudyn's explicit fourth-order Runge-Kutta
    solver.
    """
    system = exu.SystemContainer()
    mbs = system.AddSystem()
    bodies = state.reshape(-1, 12)
    nodes, objects = _add_bodies(mbs, equations, bodies)
    _add_springs(mbs, equations, objects)
    _add_contacts(mbs, equations, nodes, bodies)
    kinds = exu.OutputVariableType.Coordinates, exu.OutputVariableType.Coordinates_t
    sensors = [
        mbs.AddSensor(SensorNode(nodeNumber=node, storeInternal=True, writeToFile=False, outputVariableType=kind))
        for node in nodes
        for kind in kinds
    ]
    mbs.Assemble()

    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(duration / step)
    settings.timeIntegration.endTime = duration
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = step
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    measured = [mbs.GetSensorStoredData(sensor) for sensor in sensors]
    times = measured[0][:, 0]
    states = np.empty((len(times), len(state)))
    for row in range(len(times)):
        found = [_state(measured[2 * i][row, 1:], measured[2 * i + 1][row, 1:]) for i in range(len(nodes))]
        states[row] = np.concatenate(found)
    return times, states


def _add_bodies(mbs: exu.MainSystem, equations: Equations, states: Array) -> tuple[list[int], list[int]]:
    nodes, objects = [], []
    for body, state in zip(equations.vehicle.bodies, states):
        coordinates, velocities = _coordinates(state)
        node = mbs.AddNode(NodeRigidBodyRxyz(initialCoordinates=coordinates, initialVelocities=velocities))
        inertia = [*np.array(body.inertia)[TO_EXUDYN], 0, 0, 0]
        found = mbs.AddObject(ObjectRigidBody(nodeNumber=node, mass=body.mass, inertia=inertia))
        mass = mbs.AddMarker(MarkerBodyMass(bodyNumber=found))
        mbs.AddLoad(LoadMassProportional(markerNumber=mass, loadVector=[GRAVITY, 0, 0]))
        nodes.append(node)
        objects.append(found)
    return nodes, objects


def _add_springs(mbs: exu.MainSystem, equations: Equations, objects: list[int]) -> None:
    for spring in equations.vehicle.springs:
        ends = [
            mbs.AddMarker(MarkerBodyPosition(bodyNumber=objects[body], localPosition=np.array(point)[TO_EXUDYN]))
            for body, point in zip(spring.ends, spring.points)
        ]
        mbs.AddObject(
            ObjectConnectorSpringDamper(
                markerNumbers=ends,
                referenceLength=equations.vehicle.length_at_rest(spring),
                stiffness=spring.stiffness,
                damping=spring.damping,
                force=spring.preload,
            )
        )


def _add_contacts(mbs: exu.MainSystem, equations: Equations, nodes: list[int], bodies: Array) -> None:
    """Adds one object for all wheelsets, so that all wheels are solved at once, and once per evaluation."""
    count = equations.vehicle.wheelsets

    def forces(mbs, time, item, q, q_t):  # type: ignore[no-untyped-def]
        moving = np.concatenate([
            np.array([_state(q[6 * i : 6 * i + 6], q_t[6 * i : 6 * i + 6]) for i in range(count)]), bodies[count:]
        ])  # fmt: skip
        rails = equations.rolling(moving)
        found = np.empty((count, 6))
        for i, (force, moment) in enumerate(zip(rails.forces, rails.moments)):
            rotated = axes(moving[i, ROLL], moving[i, YAW])
            found[i] = *force[TO_EXUDYN], moment[2], moment @ rotated[:, 0], moment @ rotated[:, 1]
        return found.ravel()

    none = np.zeros((6 * count, 6 * count))
    mbs.AddObject(ObjectGenericODE2(nodeNumbers=nodes[:count], massMatrix=none, forceUserFunction=forces))


def _coordinates(body: Array) -> tuple[Array, Array]:
    """Returns Exudyn's coordinates of the state of a body: position and angles, and their rates."""
    yaw_rate = body[RATES][2] / np.cos(body[ROLL])
    pitch_rate = body[RATES][1] - yaw_rate * np.sin(body[ROLL])
    angles = body[YAW], body[ROLL], body[PITCH]
    rates = yaw_rate, body[RATES][0], pitch_rate
    return np.array([*body[PLACE][TO_EXUDYN], *angles]), np.array([*body[VELOCITY][TO_EXUDYN], *rates])


def _state(q: Array, q_t: Array) -> Array:
    """Returns the state of a body for Exudyn's coordinates."""
    q, q_t = np.asarray(q), np.asarray(q_t)
    yaw, roll, pitch = q[3:]
    rates = q_t[4], q_t[5] + q_t[3] * np.sin(roll), q_t[3] * np.cos(roll)
    return np.array([*q[:3][TO_TRACK], roll, pitch, yaw, *q_t[:3][TO_TRACK], *rates])
