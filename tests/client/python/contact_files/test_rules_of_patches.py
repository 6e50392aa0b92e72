"""Rules of patches of a case on rails."""

from __future__ import annotations

import math
from typing import Any

from contactd.contact_files.problems.rails import RailContact
from contactd.values.generated.profile_shapes import S1002, Rail60E1
from contactd.values.generated.wheel_rail.setup import PatchRules
from support.contact_cases import rail_case


def rules(**values: float) -> PatchRules:
    def profile(case: Any, name: str) -> Any:
        return Rail60E1(1 / 40) if name == "RAIL" else S1002()

    found = RailContact.of(rail_case(**values), profile, "exact").setup.patches
    assert found is not None
    return found


def test_distances_and_angles_of_zero_part_all_that_can_be_parted() -> None:
    found = rules(A_SEP=0.0, D_SEP=0.0, D_COMB=0.0, D_TURN=0.0)
    distances = found.distance_combine, found.distance_separate, found.distance_turn
    assert 0 < distances[0] < distances[1] < distances[2] < 1e-5
    assert 0 < found.angle_separate < 1e-5


def test_an_angle_beyond_half_a_turn_is_half_a_turn() -> None:
    found = rules(A_SEP=90.0, D_SEP=8.0, D_COMB=4.0, D_TURN=12.0)
    assert found.angle_separate == math.pi
    assert (found.distance_combine, found.distance_separate, found.distance_turn) == (4.0, 8.0, 12.0)
