"""Materials by their names."""

import pytest

import contactd
from contactd import Material, materials
from contactd.values.wheel_rail.params import STEEL


@pytest.mark.parametrize("name", [name for name in materials.__all__ if name != "SOURCES"])
def test_a_material_has_a_source_that_states_its_constants(name):
    material, source = getattr(materials, name), materials.SOURCES[name]
    assert isinstance(material, Material)
    constant = f"G = {material.G:g}" if "G =" in source else f"E = {material.E:.6g}"
    assert f"{constant} N/mm^2, nu = {material.nu:g}" in source


def test_steel_is_that_of_wheels_and_rails():
    assert contactd.steel == STEEL
