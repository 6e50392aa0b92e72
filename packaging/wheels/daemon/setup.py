"""What it runs on: it brings its own glibc, so that the machine's may be as old as its kernel lets it be."""

from setuptools import setup

setup(options={"bdist_wheel": {"plat_name": "manylinux_2_17_x86_64"}})
