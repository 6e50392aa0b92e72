"""Computes worn profiles of wheels and rails, step by step, from the wear of contacts in a set of weighted states.

::

    from contactd import Client, EnergyWear, WearLaw
    from contactd.wear import WearStudy, WeightedState, evolve

    study = WearStudy(
        setup=WheelRailSetup(),
        states=[WeightedState(WheelRailState(...), weight=0.8), ...],
        wears="wheel",
        law=WearLaw("energy", "a twin-disc test of ours", "lower", (0, 10), energy=EnergyWear(6.75e-4)),
        until=1000,  # km
    )
    with Client("tcp://127.0.0.1:5555") as client:
        for step in evolve(client, study):
            print(step.distance, step.area, step.points)

`contactd.wear.dynamics` contains the loop with vehicle dynamics. docs/damage.md describes the computation of profiles
from depths and its assumptions. `deposit`, `exponential_step`, `smoothed` and `Section.worn` are its parts that need no
client.
"""

from __future__ import annotations

from .evolution import evolve
from .filters import critical_depth, exponential_step, smoothed, smoothing_length
from .measures import RailWear, WheelGauge, conicities, rail_wear, wheel_gauge
from .places import rows_on_rail, rows_on_wheel
from .record import read_record, write_record
from .section import Section, deposit
from .states import WeightedState, read_states
from .steps import StepFatigue, WornStep
from .study import WearStudy

__all__ = [
    "RailWear",
    "Section",
    "StepFatigue",
    "WearStudy",
    "WeightedState",
    "WheelGauge",
    "WornStep",
    "conicities",
    "critical_depth",
    "deposit",
    "evolve",
    "exponential_step",
    "rail_wear",
    "read_record",
    "read_states",
    "rows_on_rail",
    "rows_on_wheel",
    "smoothed",
    "smoothing_length",
    "wheel_gauge",
    "write_record",
]
