"""From wear of contacts to worn profiles: what a collective of states takes off a wheel or a rail, step by step.

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

The loop with dynamics is in `contactd.wear.dynamics`. docs/damage.md tells the way from depths to profiles, and what of it is assumption. The functions that take no client are
those of the way: `deposit`, `exponential_step`, `smoothed`, `Section.worn`.
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
