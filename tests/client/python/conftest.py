"""Fixtures of tests of the Python client."""

from integration.conftest import background, shared_daemon  # noqa: F401
