"""The table of standard profiles names those of the schema, with two sources each."""

from typing import get_args

import pytest

from contactd.standard_profiles import OMITTED, STANDARDS
from contactd.wheel_rail import StandardName


def test_the_table_has_the_names_of_the_schema():
    assert list(STANDARDS) == list(get_args(StandardName))
    assert not STANDARDS.keys() & OMITTED.keys()


@pytest.mark.parametrize("name", STANDARDS)
def test_a_profile_has_two_sources_and_their_difference(name):
    of = STANDARDS[name]
    assert of.first and of.second and of.first != of.second
    assert of.of == ("wheel" if name == "S1002" else "rail")
    assert 0 < of.difference < 0.02
