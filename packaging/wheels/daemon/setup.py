"""Sets the platform of the wheel. The wheel contains its own glibc, so that of the machine may be as old as its kernel
supports."""

from setuptools import setup

setup(options={"bdist_wheel": {"plat_name": "manylinux_2_17_x86_64"}})
