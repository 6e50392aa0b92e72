"""Provides LocalDaemon under the name that scripts import."""

from .local import LocalDaemon

__all__ = ["LocalDaemon"]
