"""Provides fixtures of programs that use the C library."""

from integration.conftest import daemons, shared_daemon  # noqa: F401
