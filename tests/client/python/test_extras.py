"""Tests methods of values that other parts of the package implement."""

import subprocess
import sys

import pytest

import contactd  # noqa: F401
from contactd.extras import FUNCTIONS
from contactd.values.registry import extra


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_method_finds_its_function(name):
    function = extra(name)
    assert callable(function)
    assert f"{function.__module__}:{function.__name__}" == FUNCTIONS[name]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_value_has_the_method(name):
    kind, method = name.split(".")
    kinds = [vars(module)[kind] for path, module in sys.modules.items() if path.startswith("contactd.values.") and kind in vars(module)]
    assert all(hasattr(one, method) for one in kinds)
    assert kinds


def test_parts_are_imported_when_they_are_first_used():
    code = (
        "import sys, contactd, contactd.wheel_rail\n"
        "late = ('contactd.pictures', 'contactd.xarray_datasets', 'contactd.aio', 'matplotlib', 'xarray', 'h5py', 'asyncio')\n"
        "assert not [name for name in late if name in sys.modules]"
    )
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
