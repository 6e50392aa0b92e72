"""LocalDaemon under the name that scripts import it from."""

from .local import LocalDaemon

__all__ = ["LocalDaemon"]
