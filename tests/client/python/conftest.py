"""Fixtures of tests of the Python client."""

from integration.conftest import background  # noqa: F401
